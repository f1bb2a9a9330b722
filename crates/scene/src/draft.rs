//! A scene that has passed all gates but the physics.

use crate::key_path::KeyPath;
use crate::mistakes::{Findings, Mistakes, SceneError};
use crate::overrides::{Override, counting};
use crate::resolve::{MeshFile, Resolved, Unresolved, resolve};
use crate::schema::SCHEMA;
use crate::source::Source;
use crate::spec::SceneSpec;
use crate::walk::walk;
use serde::Deserialize;
use serde::de::IntoDeserializer;
use std::path::Path;
use toml_edit::Value;

/// A scene's text with its overrides, and what it says.
#[derive(Debug)]
pub(crate) struct Draft {
    pub(crate) source: Source,
    /// The text with the overrides in it.
    pub(crate) text: String,
    pub(crate) resolved: Resolved,
}

impl Draft {
    /// Reads a scene up to its setup.
    pub(crate) fn new(
        mut source: Source,
        name: &str,
        overrides: &[Override],
    ) -> Result<Self, SceneError> {
        let (text, mut scene) = with_overrides(&mut source, overrides)?;
        let mut findings = walk(&SCHEMA, &mut scene);
        // Another version has other keys: what else seems wrong would mislead.
        let version = KeyPath::of(["schema_version"]);
        if scene
            .as_inline_table()
            .is_some_and(|table| table.contains_key("schema_version"))
            && let Some(other) = findings.0.iter().find(|f| f.path == version)
        {
            let only = Findings(vec![other.clone()]);
            return Err(source.locate(only).into());
        }
        match SceneSpec::deserialize(scene.into_deserializer()) {
            Ok(spec) => match resolve(&spec, name, source.directory()) {
                Ok(resolved) if findings.is_empty() => {
                    return Ok(Self {
                        text: with_files_beside(text, &resolved.files),
                        source,
                        resolved,
                    });
                }
                Err(Unresolved::Wrong(later)) => findings.extend_elsewhere(later),
                Err(Unresolved::Unreadable(error)) if findings.is_empty() => return Err(error),
                // The first gate found more to mend.
                Ok(_) | Err(Unresolved::Unreadable(_)) => {}
            },
            // The walk has named the cause, unless schema and types disagree.
            Err(error) if findings.is_empty() => {
                findings.add(&KeyPath::root(), error.message().trim());
            }
            Err(_) => {}
        }
        Err(source.locate(findings).into())
    }
}

/// The text with every mesh named by where its copy lies beside a copy of the text.
fn with_files_beside(text: String, files: &[MeshFile]) -> String {
    let moved = |file: &&MeshFile| file.beside() != Path::new(&file.written);
    let moved: Vec<&MeshFile> = files.iter().filter(moved).collect();
    if moved.is_empty() {
        return text;
    }
    let mut document: toml_edit::DocumentMut = text.parse().expect("a scene that was read is TOML");
    for file in moved {
        document["walls"][&file.wall]["mesh"]["file"] =
            toml_edit::value(file.beside().display().to_string());
    }
    document.to_string()
}

/// The text with its overrides, and the same as one value.
pub(crate) fn with_overrides(
    source: &mut Source,
    overrides: &[Override],
) -> Result<(String, Value), Mistakes> {
    let mut document = source.document().clone().into_mut();
    if overrides.is_empty() {
        return Ok((source.text().to_owned(), as_value(document)));
    }
    let mut findings = Findings::default();
    for set in counting(overrides) {
        source.mark_overridden(set.path());
        set.apply(&mut document, &mut findings);
    }
    if findings.is_empty() {
        Ok((document.to_string(), as_value(document)))
    } else {
        Err(source.locate(findings))
    }
}

/// A document as one value.
pub(crate) fn as_value(document: toml_edit::DocumentMut) -> Value {
    document
        .into_item()
        .into_value()
        .expect("the root of a document is a table")
}
