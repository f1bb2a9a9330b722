//! A scene as it is written, before anything of it is checked.

use crate::draft::with_overrides;
use crate::mistakes::SceneError;
use crate::overrides::Override;
use crate::source::{Source, text_of};
use serde_json::Value;
use std::path::Path;

/// The text of a scene file with what is set in it, not checked but for its being TOML.
///
/// # Errors
/// The file cannot be read or is no TOML, or a key that is set lies in what is no table.
pub fn text_of_file(path: &Path, overrides: &[Override]) -> Result<String, SceneError> {
    let text = Source::of_file(path)?;
    let mut source = Source::unchecked(&path.display().to_string(), &text)?;
    Ok(with_overrides(&mut source, overrides)?.0)
}

/// The text of a scene that is given as a table of values, in the same way; null stands for a key left out.
///
/// # Errors
/// It is no table, or a key that is set lies in what is no table.
pub fn text_of_tables(
    tables: &Value,
    name: &str,
    overrides: &[Override],
) -> Result<String, SceneError> {
    let mut source = Source::unchecked(name, &text_of(name, tables)?)?.without_lines();
    Ok(with_overrides(&mut source, overrides)?.0)
}
