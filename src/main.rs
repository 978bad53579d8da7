use std::process::ExitCode;

/// More small jobs a second than with the C library's allocator, and less kept of large bodies: docs/decisions/sqlite-on-one-writer.md.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    plateau::cli::main()
}
