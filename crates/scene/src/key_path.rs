//! Where a value stands in a scene: `walls.cone.shape.of[1].radius`.

use std::fmt;

/// One step down.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Segment {
    Key(String),
    Index(usize),
}

/// The way from the root of a scene to a value.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct KeyPath(Vec<Segment>);

impl KeyPath {
    pub(crate) fn root() -> Self {
        Self::default()
    }

    /// The path of keys such as `["walls", "cone"]`.
    pub(crate) fn of<'a>(keys: impl IntoIterator<Item = &'a str>) -> Self {
        Self(
            keys.into_iter()
                .map(|key| Segment::Key(key.to_owned()))
                .collect(),
        )
    }

    /// The path of a dotted key of the simulation, whose names hold no dot.
    pub(crate) fn dotted(key: &str) -> Self {
        Self::of(
            key.split('.')
                .map(|part| part.trim_matches('"'))
                .filter(|part| !part.is_empty()),
        )
    }

    pub(crate) fn key(&self, key: &str) -> Self {
        self.with(Segment::Key(key.to_owned()))
    }

    pub(crate) fn index(&self, index: usize) -> Self {
        self.with(Segment::Index(index))
    }

    fn with(&self, segment: Segment) -> Self {
        let mut longer = self.clone();
        longer.0.push(segment);
        longer
    }

    pub(crate) fn segments(&self) -> &[Segment] {
        &self.0
    }

    /// The last key, to speak of the value by: `diameter`.
    pub(crate) fn last_key(&self) -> &str {
        self.0
            .iter()
            .rev()
            .find_map(|segment| match segment {
                Segment::Key(key) => Some(key.as_str()),
                Segment::Index(_) => None,
            })
            .unwrap_or("scene")
    }

    /// Whether this path leads to `other` or to a table that holds it.
    pub(crate) fn leads_to(&self, other: &Self) -> bool {
        other.0.starts_with(&self.0)
    }

    /// The table by name that the path runs through: its first two keys.
    pub(crate) fn named_table(&self) -> Self {
        Self(self.0.iter().take(2).cloned().collect())
    }
}

impl fmt::Display for KeyPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, segment) in self.0.iter().enumerate() {
            match segment {
                Segment::Index(index) => write!(f, "[{index}]")?,
                Segment::Key(key) => {
                    if place > 0 {
                        f.write_str(".")?;
                    }
                    if key.is_empty() || key.contains(|letter: char| !is_bare(letter)) {
                        write!(f, "{key:?}")?;
                    } else {
                        f.write_str(key)?;
                    }
                }
            }
        }
        Ok(())
    }
}

/// Whether TOML lets a letter stand in a key without quotes.
fn is_bare(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || matches!(letter, '_' | '-')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_written_as_in_toml() {
        let path = KeyPath::of(["expect", "mass.lost"]).index(1).key("min");
        assert_eq!(path.to_string(), "expect.\"mass.lost\"[1].min");
        assert_eq!(path.last_key(), "min");
    }

    #[test]
    fn a_table_leads_to_what_it_holds_and_not_to_its_neighbors() {
        let wall = KeyPath::dotted("walls.cone");
        assert!(wall.leads_to(&KeyPath::dotted("walls.cone.material")));
        assert!(!wall.leads_to(&KeyPath::dotted("walls.bin")));
    }
}
