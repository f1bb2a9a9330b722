//! What people write by hand: scenes, quantities, overrides, cards and sheets.

use pelletflow_impact::{CrushTest, DropLevel};
use pelletflow_scene::{Kind, LabSheet, Override, Scene, StrengthCard, TEMPLATES, measure};

/// Kinds that differ in how they are written.
const KINDS: [Kind; 7] = [
    Kind::Length,
    Kind::Pressure,
    Kind::MassFlow,
    Kind::CountRate,
    Kind::Angle,
    Kind::TurnRate,
    Kind::Share,
];

/// A scene, checked up to the model of a run.
pub(crate) fn scene(bytes: &[u8]) -> bool {
    Scene::parse(&lossy(bytes), "scene.toml", &[]).is_ok()
}

/// A quantity, as each kind of quantity.
pub(crate) fn quantity(bytes: &[u8]) -> bool {
    let text = lossy(bytes);
    let values: Vec<f64> = KINDS
        .iter()
        .filter_map(|kind| measure(&text, *kind).ok())
        .collect();
    assert!(values.iter().all(|value| value.is_finite()), "{text:?}");
    !values.is_empty()
}

/// Values set in a template, a line for each.
pub(crate) fn overrides(bytes: &[u8]) -> bool {
    let text = lossy(bytes);
    let sets: Result<Vec<Override>, _> = text.lines().map(str::parse).collect();
    let Ok(sets) = sets else {
        return false;
    };
    TEMPLATES
        .iter()
        .map(|template| Scene::parse(template.text, template.name, &sets))
        .any(|scene| scene.is_ok())
}

/// A strength card; one that is written again is read as the same.
pub(crate) fn card(bytes: &[u8]) -> bool {
    let Ok(card) = StrengthCard::parse(&lossy(bytes), "card.toml") else {
        return false;
    };
    let again = StrengthCard::parse(&card.to_toml(), "card.toml");
    assert_eq!(again, Ok(card));
    true
}

/// A sheet of the laboratory, of either test.
pub(crate) fn sheet(bytes: &[u8]) -> bool {
    let text = lossy(bytes);
    let loads = LabSheet::<CrushTest>::parse(&text, "loads.csv", None);
    let in_kilonewtons = LabSheet::<CrushTest>::parse(&text, "loads.csv", Some("kN"));
    let drops = LabSheet::<Vec<DropLevel>>::parse(&text, "drops.csv");
    loads.is_ok() || in_kilonewtons.is_ok() || drops.is_ok()
}

fn lossy(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
