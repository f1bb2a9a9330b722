//! A scene ready to run.

use crate::draft::Draft;
use crate::expect::Expectations;
use crate::key_path::KeyPath;
use crate::mesh::MeshReport;
use crate::mistakes::{Findings, Mistakes, SceneError};
use crate::overrides::Override;
use crate::resolve::{MeshFile, OutputOptions, Resolved, Strength};
use crate::source::Source;
use pelletflow_sim::{Model, RunPlan, Setup, SetupError};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use xxhash_rust::xxh3::Xxh3;

/// A validated scene: what to compute, how long, what to record and what to expect.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Short name: the file's without its ending.
    pub name: String,
    /// Title; the name where the scene gives none.
    pub title: String,
    /// The text as run, with the overrides in it.
    pub text: String,
    /// Hash of the text and of the files that it names, as 32 hexadecimal digits (xxh3).
    pub hash: String,
    /// The setup, in SI units.
    pub setup: Setup,
    /// The setup validated, with the time step.
    pub model: Model,
    /// How long and how often.
    pub plan: RunPlan,
    /// What is recorded.
    pub output: OutputOptions,
    /// What the pellets withstand, where it is given.
    pub strength: Option<Strength>,
    /// What a right run shows.
    pub expectations: Expectations,
    /// What was chosen for the user, in sentences.
    pub notes: Vec<String>,
    /// Files of meshes: where each lies, seen from the folder of the text, and what it holds.
    pub files: Vec<(PathBuf, Arc<[u8]>)>,
    /// What was found in them.
    pub meshes: Vec<MeshReport>,
    source: Source,
}

impl Scene {
    /// Reads and validates a scene file.
    ///
    /// # Errors
    /// The file cannot be read, or there are mistakes in it; all that were found.
    pub fn read(path: &Path, overrides: &[Override]) -> Result<Self, SceneError> {
        let text = Source::of_file(path)?;
        let name = path
            .file_stem()
            .map_or_else(|| "scene".into(), |stem| stem.to_string_lossy());
        let directory = path.parent().unwrap_or(Path::new(""));
        let source = Source::new(&path.display().to_string(), &text)?.in_directory(directory);
        Self::new(source, &name, overrides)
    }

    /// Validates a scene given as text; files that it names are sought in the working directory.
    ///
    /// # Errors
    /// The mistakes found in it.
    pub fn parse(text: &str, name: &str, overrides: &[Override]) -> Result<Self, SceneError> {
        let source = Source::new(name, text)?;
        Self::new(source, name, overrides)
    }

    /// Validates a scene given as a table of values, as from a dictionary; null stands for a key left out.
    ///
    /// # Errors
    /// The mistakes found in it; they have keys but no lines.
    pub fn from_value(
        value: &Value,
        name: &str,
        overrides: &[Override],
    ) -> Result<Self, SceneError> {
        let text = crate::source::text_of(name, value)?;
        let source = Source::new(name, &text)?.without_lines();
        Self::new(source, name, overrides)
    }

    /// Puts lines to mistakes that were found after the scene was read, such as fills that do not fit.
    pub fn locate(&self, errors: &[SetupError]) -> Mistakes {
        self.source.locate(findings(errors))
    }

    fn new(source: Source, name: &str, overrides: &[Override]) -> Result<Self, SceneError> {
        let Draft {
            source,
            text,
            resolved,
        } = Draft::new(source, name, overrides)?;
        let Resolved {
            title,
            setup,
            plan,
            output,
            strength,
            expectations,
            notes,
            files,
            meshes,
        } = resolved;
        let model = Model::new(setup.clone()).map_err(|errors| source.locate(findings(&errors)))?;
        Ok(Self {
            name: name.to_owned(),
            title,
            hash: hash(&text, &files),
            text,
            setup,
            model,
            plan,
            output,
            strength,
            expectations,
            notes,
            files: files
                .into_iter()
                .map(|file| (file.beside(), file.bytes))
                .collect(),
            meshes,
            source,
        })
    }
}

/// 32 hexadecimal digits over a text and the files that it names.
fn hash(text: &str, files: &[MeshFile]) -> String {
    let mut hasher = Xxh3::new();
    hasher.update(text.as_bytes());
    for file in files {
        hasher.update(&file.bytes);
    }
    format!("{:032x}", hasher.digest128())
}

fn findings(errors: &[SetupError]) -> Findings {
    let mut findings = Findings::default();
    for error in errors {
        findings.add(&KeyPath::dotted(&error.key), error.message.as_str());
    }
    findings
}
