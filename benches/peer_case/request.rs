//! What is asked for on the command line.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::str::FromStr;

/// A verb and its keys.
pub(crate) struct Request {
    verb: String,
    values: BTreeMap<String, String>,
}

impl Request {
    /// Reads `verb key=value ...`.
    pub(crate) fn parse(words: &[String]) -> Result<Self, String> {
        let (verb, pairs) = words
            .split_first()
            .ok_or("no verb; expected describe, start or run")?;
        let values = pairs
            .iter()
            .map(|word| {
                word.split_once('=')
                    .map(|(key, value)| (key.to_owned(), value.to_owned()))
                    .ok_or_else(|| format!("`{word}` is no `key=value`"))
            })
            .collect::<Result<_, _>>()?;
        Ok(Self {
            verb: verb.clone(),
            values,
        })
    }

    pub(crate) fn verb(&self) -> &str {
        &self.verb
    }

    /// A text that has to be there.
    pub(crate) fn text(&self, key: &str) -> Result<&str, String> {
        self.values
            .get(key)
            .map(String::as_str)
            .ok_or_else(|| format!("`{key}=...` is missing"))
    }

    /// A number, or what stands for it where it is not given.
    pub(crate) fn number<T: FromStr>(&self, key: &str, otherwise: T) -> Result<T, String> {
        self.values.get(key).map_or(Ok(otherwise), |value| {
            value
                .parse()
                .map_err(|_| format!("`{key}={value}` is no number"))
        })
    }

    /// A path, where one is given.
    pub(crate) fn path(&self, key: &str) -> Option<PathBuf> {
        self.values.get(key).map(PathBuf::from)
    }

    /// Where beds at rest are kept between runs.
    pub(crate) fn folder(&self) -> Result<PathBuf, String> {
        self.text("folder").map(PathBuf::from)
    }
}
