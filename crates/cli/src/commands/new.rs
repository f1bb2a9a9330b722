//! `pelletflow new`.

use crate::args::NewArguments;
use crate::exit::{Exit, Failure};
use crate::screen;
use crate::table;
use pelletflow_scene::TEMPLATES;
use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes a template, or lists all.
pub(crate) fn new(arguments: &NewArguments) -> Result<Exit, Failure> {
    let named = arguments.template.as_deref();
    let Some(template) = TEMPLATES.iter().find(|known| Some(known.name) == named) else {
        let rows = TEMPLATES
            .iter()
            .map(|template| [template.name.into(), template.description.into()]);
        screen::result(&table::listing(["template", "shows"], &[], rows))?;
        screen::remark("\nWrite one with: pelletflow new TEMPLATE");
        return Ok(Exit::Done);
    };
    let path = arguments
        .output
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("{}.toml", template.name)));
    if path == Path::new("-") {
        screen::result(template.text)?;
        return Ok(Exit::Done);
    }
    write_new(&path, template.text)?;
    let shown = path.display();
    screen::result(&format!(
        "{shown} written; go on with: pelletflow check {shown}"
    ))?;
    Ok(Exit::Done)
}

/// Writes a file that does not exist yet.
pub(crate) fn write_new(path: &Path, text: &str) -> Result<(), Failure> {
    OpenOptions::new()
        .write(true)
        .create_new(true)
        .open(path)
        .and_then(|mut file| file.write_all(text.as_bytes()))
        .map_err(|error| {
            let shown = path.display();
            if error.kind() == io::ErrorKind::AlreadyExists {
                let message =
                    format!("{shown} exists and is not overwritten; name another file with -o");
                Failure::new(Exit::BadInput, message)
            } else {
                let message =
                    format!("{shown} cannot be written: {error}; name another file with -o");
                Failure::new(Exit::InputOutput, message)
            }
        })
}
