//! The linter.

fn main() -> std::process::ExitCode {
    shaderlint::cli::shaderlint()
}
