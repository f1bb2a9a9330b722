//! One scene of the comparison with other codes, run once: `cargo xtask bench-peers` starts this program for each round.
//!
//! It takes a verb and then `key=value`: `describe`, `start` and `run`, each with `scene=NAME`; it prints one line of JSON.

#![expect(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program that another one reads"
)]

mod bed;
mod chute;
mod free;
mod places;
mod request;
mod run;
mod scene;
#[path = "../silo/mod.rs"]
mod silo;
mod sizes;
mod start;

use request::Request;
use scene::Scene;
use serde_json::{Value, json};
use std::process::ExitCode;

fn main() -> ExitCode {
    // `cargo bench` starts every bench without more than a flag of its own.
    let words: Vec<String> = std::env::args()
        .skip(1)
        .filter(|word| !word.starts_with("--"))
        .collect();
    if words.is_empty() {
        println!("one run of a scene for `cargo xtask bench-peers`; nothing to do by itself");
        return ExitCode::SUCCESS;
    }
    match Request::parse(&words).and_then(|request| answer(&request)) {
        Ok(answer) => {
            println!("{answer}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn answer(request: &Request) -> Result<Value, String> {
    let scene = Scene::named(request.text("scene")?)?;
    match request.verb() {
        "describe" => Ok(scene.describe()),
        "start" => {
            let pellets = start::pellets(scene, &request.folder()?)?;
            if let Some(path) = request.path("out") {
                places::write(&path, "", &pellets)?;
            }
            Ok(json!({ "pellets": pellets.len() }))
        }
        "run" => run::run(scene, request),
        verb => Err(format!(
            "verb `{verb}` is unknown; expected describe, start or run"
        )),
    }
}
