//! The text of a scene, and on which line of it a key stands.

use crate::key_path::{KeyPath, Segment};
use crate::mistakes::{Finding, Findings, Mistake, Mistakes, Place, SceneError};
use std::io::{self, Read};
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml_edit::{Document, Item, TableLike, TomlError};

/// Longest scene that is read [bytes]; more is not a scene.
const LONGEST: u64 = 16 << 20;

/// A scene's text as it was given.
#[derive(Debug, Clone)]
pub(crate) struct Source {
    /// Name of the file in messages.
    label: String,
    document: Document<String>,
    /// Keys that overrides have set.
    overridden: Vec<KeyPath>,
    /// Whether lines mean anything to the user; not where the text was made from other data.
    has_lines: bool,
    /// Folder of the file, from which its paths are seen.
    directory: PathBuf,
}

impl Source {
    /// Reads a file as text.
    pub(crate) fn read(path: &Path) -> io::Result<Result<String, Mistakes>> {
        // Opening a directory succeeds on some systems and fails later with another message.
        if path.is_dir() {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        let mut bytes = Vec::new();
        std::fs::File::open(path)?
            .take(LONGEST + 1)
            .read_to_end(&mut bytes)?;
        let label = path.display().to_string();
        if bytes.len() as u64 > LONGEST {
            return Ok(Err(whole(
                &label,
                format!(
                    "the file has more than {LONGEST} bytes; it is not what people write by hand"
                ),
            )));
        }
        Ok(String::from_utf8(bytes).map_err(|error| {
            let valid = error.utf8_error().valid_up_to();
            let line = line_of(&String::from_utf8_lossy(&error.as_bytes()[..valid]), valid);
            Mistakes::new(vec![Mistake {
                file: label,
                place: Place::Line { line, column: None },
                key: String::new(),
                message: format!("byte {valid} is not UTF-8; save the file as UTF-8 text"),
            }])
        }))
    }

    /// The text of a scene file.
    pub(crate) fn of_file(path: &Path) -> Result<String, SceneError> {
        let text = Self::read(path).map_err(|source| SceneError::Unreadable {
            path: path.to_owned(),
            source,
        })?;
        Ok(text?)
    }

    /// A text with lines that the user knows.
    pub(crate) fn new(label: &str, text: &str) -> Result<Self, Mistakes> {
        let source = Self::unchecked(label, text)?;
        if source.document.as_table().is_empty() {
            let message = "the scene is empty; `pelletflow new hopper` writes one to start from";
            return Err(whole(label, message.into()));
        }
        Ok(source)
    }

    /// A text that may still be empty.
    pub(crate) fn unchecked(label: &str, text: &str) -> Result<Self, Mistakes> {
        let document =
            Document::parse(text.to_owned()).map_err(|error| not_toml(label, text, &error))?;
        Ok(Self {
            label: label.into(),
            document,
            overridden: Vec::new(),
            has_lines: true,
            directory: PathBuf::new(),
        })
    }

    pub(crate) fn without_lines(mut self) -> Self {
        self.has_lines = false;
        self
    }

    /// Of a file in a folder.
    pub(crate) fn in_directory(mut self, directory: &Path) -> Self {
        directory.clone_into(&mut self.directory);
        self
    }

    pub(crate) fn directory(&self) -> &Path {
        &self.directory
    }

    pub(crate) fn document(&self) -> &Document<String> {
        &self.document
    }

    pub(crate) fn text(&self) -> &str {
        self.document.raw()
    }

    pub(crate) fn mark_overridden(&mut self, path: KeyPath) {
        self.overridden.push(path);
    }

    /// Puts lines to findings.
    pub(crate) fn locate(&self, findings: Findings) -> Mistakes {
        Mistakes::new(
            findings
                .0
                .into_iter()
                .map(|Finding { path, message }| Mistake {
                    file: self.label.clone(),
                    place: self.place(&path),
                    key: path.to_string(),
                    message,
                })
                .collect(),
        )
    }

    fn place(&self, path: &KeyPath) -> Place {
        // A missing key of a table that an override made is also the override's.
        // So is a table that is there for the override alone.
        let made = |key: &&KeyPath| path.leads_to(key) && !self.holds(path);
        let overridden = || self.overridden.iter();
        let key = overridden()
            .find(|key| key.leads_to(path))
            .or_else(|| overridden().find(made));
        if let Some(key) = key {
            return Place::Override(key.to_string());
        }
        match self.span(path) {
            Some(span) if self.has_lines => Place::Line {
                line: line_of(self.text(), span.start),
                column: None,
            },
            _ => Place::Whole,
        }
    }

    /// Whether the text has a value at a path.
    fn holds(&self, path: &KeyPath) -> bool {
        let mut item = Step::Item(self.document.as_item());
        for segment in path.segments() {
            match item.down(segment) {
                Some((_, next)) => item = next,
                None => return false,
            }
        }
        true
    }

    /// Span of a value's key, or of the nearest table that holds it.
    fn span(&self, path: &KeyPath) -> Option<Range<usize>> {
        let mut item = Step::Item(self.document.as_item());
        let mut span = None;
        for segment in path.segments() {
            let Some((found, next)) = item.down(segment) else {
                break;
            };
            span = found.or(span);
            item = next;
        }
        span
    }
}

/// TOML of a table of values; null stands for a key left out.
pub(crate) fn text_of(label: &str, value: &serde_json::Value) -> Result<String, Mistakes> {
    if !value.is_object() {
        return Err(whole(
            label,
            "a scene is a table; give a mapping of keys to values".into(),
        ));
    }
    toml_edit::ser::to_string_pretty(&without_null(value))
        .map_err(|error| whole(label, format!("this cannot be a scene: {error}")))
}

fn without_null(value: &serde_json::Value) -> serde_json::Value {
    use serde_json::Value;
    match value {
        Value::Object(table) => table
            .iter()
            .filter(|(_, value)| !value.is_null())
            .map(|(key, value)| (key.clone(), without_null(value)))
            .collect(),
        Value::Array(list) => list.iter().map(without_null).collect(),
        other => other.clone(),
    }
}

/// A place in the document: lists hold bare values, tables hold items.
enum Step<'d> {
    Item(&'d Item),
    Value(&'d toml_edit::Value),
}

impl<'d> Step<'d> {
    fn down(&self, segment: &Segment) -> Option<(Option<Range<usize>>, Step<'d>)> {
        match segment {
            Segment::Key(name) => {
                let table: &'d dyn TableLike = match self {
                    Self::Item(item) => item.as_table_like()?,
                    Self::Value(value) => value.as_inline_table()?,
                };
                let (key, item) = table.get_key_value(name)?;
                Some((key.span(), Step::Item(item)))
            }
            Segment::Index(index) => {
                let list = match self {
                    Self::Item(item) => item.as_array()?,
                    Self::Value(value) => value.as_array()?,
                };
                let value = list.get(*index)?;
                Some((value.span(), Step::Value(value)))
            }
        }
    }
}

fn line_of(text: &str, offset: usize) -> usize {
    1 + text[..offset.min(text.len())].matches('\n').count()
}

/// A mistake of the whole file.
pub(crate) fn whole(label: &str, message: String) -> Mistakes {
    Mistakes::new(vec![Mistake {
        file: label.into(),
        place: Place::Whole,
        key: String::new(),
        message,
    }])
}

fn not_toml(label: &str, text: &str, error: &TomlError) -> Mistakes {
    let offset = error.span().map_or(0, |span| span.start).min(text.len());
    let line_start = text[..offset].rfind('\n').map_or(0, |newline| newline + 1);
    let message = error.message().trim().replace('\n', "; ");
    Mistakes::new(vec![Mistake {
        file: label.into(),
        place: Place::Line {
            line: line_of(text, offset),
            column: Some(1 + text[line_start..offset].chars().count()),
        },
        key: String::new(),
        message: format!("this is not TOML: {message}"),
    }])
}
