//! `--resume` and `--restart`: what is done with an earlier run.

use crate::args::RunArguments;
use crate::exit::{Exit, Failure};
use crate::screen;
use crate::table::number;
use pelletflow_log::{Earlier, FolderError, RunError, RunRequest, Summary};
use pelletflow_scene::differences;
use std::path::Path;

/// What there is to go on from, as far as the arguments ask for it.
pub(super) fn earlier(request: &RunRequest, arguments: &RunArguments) -> Result<Earlier, Failure> {
    if arguments.earlier.restart {
        pelletflow_log::discard(request.directory)?;
    }
    if !arguments.earlier.resume {
        // Before the pellets are placed, which may take a while.
        pelletflow_log::admit(request.directory)?;
        return Ok(Earlier::Nothing);
    }
    let earlier = pelletflow_log::earlier(request).map_err(|error| named(error, request))?;
    if !arguments.quiet {
        remark(&earlier, request.directory);
    }
    Ok(earlier)
}

/// Says where the run begins or goes on.
fn remark(earlier: &Earlier, directory: &Path) {
    match earlier {
        Earlier::Nothing => {
            let directory = directory.display();
            screen::remark(&format!(
                "{directory} holds no checkpoint: the run begins at the start"
            ));
        }
        Earlier::Unfinished(resumption) => {
            if let Some(damaged) = resumption.damaged() {
                screen::remark(&format!(
                    "{} is damaged: the run goes on from the checkpoint before",
                    damaged.display()
                ));
            }
            screen::remark(&format!(
                "goes on at t = {} s, step {}",
                number(resumption.time()),
                resumption.step()
            ));
        }
        Earlier::Finished(_) => {}
    }
}

/// What is said of a run that is over.
pub(super) fn finished(directory: &Path) -> String {
    format!(
        "{} holds a finished run: there is nothing to go on with; leave --resume out to run it again",
        directory.display()
    )
}

/// How to go on with a run that was interrupted.
pub(super) fn how_to(summary: &Summary, directory: &Path, arguments: &RunArguments) -> String {
    let set = arguments.set.iter().map(|value| format!("--set '{value}'"));
    let command: Vec<String> = [
        format!("pelletflow run {}", arguments.scene.display()),
        format!("-o {}", directory.display()),
    ]
    .into_iter()
    .chain(set)
    .chain(["--resume".to_owned()])
    .collect();
    format!(
        "interrupted at t = {} s; go on with: {}",
        number(summary.time.simulated_s),
        command.join(" ")
    )
}

/// Names what differs, where the run there is of another scene.
fn named(error: RunError, request: &RunRequest) -> Failure {
    let message = error.to_string();
    let RunError::Folder(ref folder) = error else {
        return error.into();
    };
    let FolderError::OtherScene {
        scene_text,
        changed_files,
        ..
    } = &**folder
    else {
        return error.into();
    };
    let keys = differences(scene_text, request.scene_text);
    let keys = keys.iter().map(ToString::to_string);
    let files = changed_files
        .iter()
        .map(|path| format!("the file {} has changed", path.display()));
    let mut lines: Vec<String> = keys.chain(files).collect();
    if lines.is_empty() {
        lines.push("only comments or the order of keys differ".into());
    }
    Failure::new(
        Exit::BadInput,
        format!("{message}\n  {}", lines.join("\n  ")),
    )
}
