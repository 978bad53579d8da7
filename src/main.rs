use std::process::ExitCode;

/// The service completes more small jobs a second with mimalloc than with the C library's allocator, and it keeps less
/// memory after large bodies. The measurements are in docs/decisions/sqlite-on-one-writer.md.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    plateau::cli::main()
}
