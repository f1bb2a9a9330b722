//! What is wrong with a scene: each mistake with its file, line, key and cure.

use crate::key_path::KeyPath;
use std::fmt;
use std::io;
use std::path::PathBuf;

/// A mistake before its line is known.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Finding {
    pub(crate) path: KeyPath,
    pub(crate) message: String,
}

/// What one pass over a scene has found.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Findings(pub(crate) Vec<Finding>);

impl Findings {
    pub(crate) fn add(&mut self, path: &KeyPath, message: impl Into<String>) {
        self.0.push(Finding {
            path: path.clone(),
            message: message.into(),
        });
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Adds what a later pass found, but for tables in which this pass already found something:
    /// there the later pass worked with stand-ins.
    pub(crate) fn extend_elsewhere(&mut self, later: Self) {
        let tables: Vec<KeyPath> = self.0.iter().map(|f| f.path.named_table()).collect();
        let elsewhere = later
            .0
            .into_iter()
            .filter(|finding| !tables.iter().any(|table| table.leads_to(&finding.path)));
        self.0.extend(elsewhere);
    }
}

/// Where a mistake stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// A line of the file, counted from 1 [-], and a column where it is known [-].
    Line {
        /// The line [-].
        line: usize,
        /// The column in letters, counted from 1 [-].
        column: Option<usize>,
    },
    /// An override of the command line; its key.
    Override(String),
    /// Nowhere in particular.
    Whole,
}

/// One thing wrong with a scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mistake {
    /// The file, as it was named.
    pub file: String,
    /// Where in it.
    pub place: Place,
    /// Dotted key, such as `walls.cone.material`; empty where the whole file is meant.
    pub key: String,
    /// What is wrong, its value, the bound and the cure.
    pub message: String,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            Place::Line { line, column } => {
                write!(f, "{}:{line}:", self.file)?;
                if let Some(column) = column {
                    write!(f, "{column}:")?;
                }
            }
            Place::Override(key) => write!(f, "{}: --set {key}:", self.file)?,
            Place::Whole => write!(f, "{}:", self.file)?,
        }
        let is_named = matches!(&self.place, Place::Override(key) if *key == self.key);
        if !self.key.is_empty() && !is_named {
            write!(f, " {}:", self.key)?;
        }
        // Lines to add are set off, so that they can be copied.
        write!(f, " {}", self.message.replace('\n', "\n    "))
    }
}

/// Everything wrong with a scene, in order of the lines; never empty.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mistakes(Vec<Mistake>);

impl Mistakes {
    pub(crate) fn new(mut mistakes: Vec<Mistake>) -> Self {
        mistakes.sort_by_key(|mistake| match mistake.place {
            Place::Line { line, .. } => line,
            Place::Override(_) => 0,
            Place::Whole => usize::MAX,
        });
        mistakes.dedup();
        Self(mistakes)
    }

    /// The mistakes, one by one.
    pub fn iter(&self) -> std::slice::Iter<'_, Mistake> {
        self.0.iter()
    }

    /// How many there are [-].
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<'a> IntoIterator for &'a Mistakes {
    type Item = &'a Mistake;
    type IntoIter = std::slice::Iter<'a, Mistake>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl fmt::Display for Mistakes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, mistake) in self.0.iter().enumerate() {
            if index > 0 {
                f.write_str("\n\n")?;
            }
            write!(f, "{mistake}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Mistakes {}

/// A scene that cannot be had.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// The file could not be read.
    #[error("{}: {}", path.display(), reason(source))]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why not.
        source: io::Error,
    },
    /// The file was read, and something in it is wrong.
    #[error(transparent)]
    Invalid(#[from] Mistakes),
}

/// What a failed read means, with the cure.
fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => {
            "there is no such file; `pelletflow new hopper` writes a scene to start from".into()
        }
        io::ErrorKind::IsADirectory => "this is a directory; name a scene file in it".into(),
        io::ErrorKind::PermissionDenied => {
            "no permission to read it; change its mode or run as its owner".into()
        }
        _ => format!("cannot be read: {error}"),
    }
}
