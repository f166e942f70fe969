//! The `shaderport` program.

fn main() -> std::process::ExitCode {
    shaderlint::cli::shaderport()
}
