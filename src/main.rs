use std::process::ExitCode;

/// A job's pieces are made on one thread and dropped on another, which the C library's allocator makes each wait for.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    plateau::cli::main()
}
