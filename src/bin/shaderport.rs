//! The converter.

fn main() -> std::process::ExitCode {
    shaderlint::cli::shaderport()
}
