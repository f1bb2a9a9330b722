//! Every public quantity states its unit.
//!
//! A small scanner of the source text: it sees public fields, the fields of public enums and the results
//! of public functions, and asks for brackets, as in `[m/s]` or `[-]`, in the doc comment of each number.

use crate::sources::{read, root, source_files};

/// The crates that hold physics.
const CRATES: [&str; 5] = [
    "crates/core/src",
    "crates/impact/src",
    "crates/broadphase/src",
    "crates/sim/src",
    "crates/log/src",
];

/// Types that are physical quantities, alone or inside an `Option`, a `Vec`, an array or a reference.
const QUANTITIES: [&str; 5] = [
    "f64",
    "f32",
    "Vec3",
    "UnitVector3<f64>",
    "UnitQuaternion<f64>",
];

#[test]
fn every_public_quantity_states_its_unit() {
    let mut found = 0;
    let mut bare = Vec::new();
    for path in source_files(&CRATES) {
        for item in items(&read(&path)) {
            found += 1;
            if !states_unit(&item.doc) {
                let place = path.strip_prefix(root()).unwrap_or(&path).display();
                bare.push(format!("{place}:{}: {}", item.line, item.text));
            }
        }
    }
    assert!(found > 100, "the scanner sees only {found} quantities");
    assert!(bare.is_empty(), "no unit in:\n{}", bare.join("\n"));
}

#[test]
fn the_scanner_sees_fields_variants_and_results() {
    let text = "
/// Depth [m].
pub overlap: f64,
/// A name.
pub name: String,
/// Bare.
#[serde(default)]
pub bare: Option<[f64; 3]>,
/// Kinds.
pub enum Rate {
    /// By mass [kg/s].
    Mass(f64),
    /// By part.
    Part {
        /// Share [-].
        share: f64,
    },
}
/// See [`Rate`].
pub fn speed(
    &self,
    time: f64,
) -> Result<Vec3, Error> {
/// Not public.
pub(crate) fn hidden(&self) -> f64 {
#[cfg(test)]
mod tests {
    pub fn ignored() -> f64 {
";
    let seen: Vec<(usize, bool)> = items(text)
        .iter()
        .map(|item| (item.line, states_unit(&item.doc)))
        .collect();
    assert_eq!(
        seen,
        [(3, true), (8, false), (12, true), (16, true), (20, false)]
    );
}

/// A public quantity: where it stands, what it is, and what is said of it.
struct Item {
    line: usize,
    text: String,
    doc: String,
}

fn items(text: &str) -> Vec<Item> {
    let lines: Vec<&str> = text.lines().collect();
    let mut items = Vec::new();
    let mut doc = String::new();
    // The indent of the public enum that is open, where one is.
    let mut open_enum: Option<usize> = None;
    for (index, line) in lines.iter().enumerate() {
        let code = line.trim();
        let indent = line.len() - line.trim_start().len();
        if code == "#[cfg(test)]" {
            break;
        }
        if let Some(comment) = code.strip_prefix("///") {
            doc.push_str(comment);
            doc.push('\n');
            continue;
        }
        if code.starts_with("#[") {
            continue;
        }
        if code.starts_with("pub enum ") {
            open_enum = Some(indent);
        } else if code == "}" && open_enum == Some(indent) {
            open_enum = None;
        }
        if quantity_type(&lines[index..], open_enum.is_some())
            .is_some_and(|kind| is_quantity(&kind))
        {
            items.push(Item {
                line: index + 1,
                text: code.to_owned(),
                doc: doc.clone(),
            });
        }
        doc.clear();
    }
    items
}

/// The type of the field, the variant or the result that the first line begins.
fn quantity_type(lines: &[&str], in_enum: bool) -> Option<String> {
    let code = lines[0].trim();
    let public = code.strip_prefix("pub ");
    if public.is_some_and(|rest| rest.starts_with("fn ") || rest.starts_with("const fn ")) {
        let signature = lines
            .iter()
            .map(|line| line.trim())
            .scan(false, |ended, line| {
                let open = !*ended;
                *ended = line.ends_with(['{', ';']);
                open.then_some(line)
            })
            .collect::<Vec<_>>()
            .join(" ");
        let (_, result) = signature.rsplit_once(") -> ")?;
        return Some(result.trim_end_matches(['{', ';', ' ']).to_owned());
    }
    if let Some((_, kind)) = public.and_then(|rest| rest.split_once(": ")) {
        let kind = kind.split(" = ").next().unwrap_or(kind);
        return Some(kind.trim_end_matches([',', ';']).to_owned());
    }
    if !in_enum || public.is_some() {
        return None;
    }
    if let Some((_, kind)) = code.split_once(": ") {
        return Some(kind.trim_end_matches(',').to_owned());
    }
    let (_, kind) = code.strip_suffix("),")?.split_once('(')?;
    Some(kind.to_owned())
}

/// Whether a type is a number or a vector under its wrappings.
fn is_quantity(kind: &str) -> bool {
    if QUANTITIES.contains(&kind) {
        return true;
    }
    let kind = kind.trim_start_matches('&');
    if let Some(inner) = ["Option<", "Vec<", "Box<", "Result<"]
        .iter()
        .find_map(|wrapping| kind.strip_prefix(wrapping)?.strip_suffix('>'))
    {
        // Of a `Result` the first type counts; no quantity has a comma of its own.
        return is_quantity(inner.split(',').next().unwrap_or(inner));
    }
    kind.strip_prefix('[')
        .and_then(|kind| kind.strip_suffix(']'))
        .is_some_and(|inner| is_quantity(inner.split(';').next().unwrap_or(inner)))
        || QUANTITIES.contains(&kind)
}

/// Whether a doc comment holds brackets that are no link.
fn states_unit(doc: &str) -> bool {
    doc.match_indices('[').any(|(start, _)| {
        let rest = &doc[start + 1..];
        rest.find(']').is_some_and(|end| {
            let is_link = rest.starts_with('`') || rest[end + 1..].starts_with('(');
            end > 0 && !is_link
        })
    })
}
