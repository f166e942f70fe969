//! The `shaderlint` program.

fn main() -> std::process::ExitCode {
    shaderlint::cli::shaderlint()
}
