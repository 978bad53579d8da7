use std::process::ExitCode;

fn main() -> ExitCode {
    plateau::cli::main()
}
