//! The converter.

/// A shader is many small pieces of memory that live as long as it does.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> std::process::ExitCode {
    shaderlint::cli::shaderport()
}
