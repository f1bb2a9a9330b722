//! The program `pelletflow`: all of it is in the library, so that the Python wheel has it too.

fn main() -> std::process::ExitCode {
    pelletflow_cli::main_from(std::env::args_os()).into()
}
