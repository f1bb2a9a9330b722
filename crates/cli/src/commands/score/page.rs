//! What `pelletflow score` prints.

use crate::table::{self, chosen, count, number};
use pelletflow_log::Breakage;
use pelletflow_log::breakage::{Group, Share};

/// Share below which no distribution can be believed [-].
const LEAST_SHARE: f64 = 1.0e-6;

/// Shares of pellets broken, and what they rest on.
pub(super) fn page(breakage: &Breakage, told: &str) -> String {
    let totals = [
        ("broken, by the forces of the run", Some(breakage.broken)),
        (
            "broken, by those at true stiffness",
            breakage.broken_at_true_stiffness,
        ),
        (
            "broken, if they yield first, at true stiffness",
            breakage.broken_yielding,
        ),
    ];
    let totals = totals
        .into_iter()
        .filter_map(|(name, broken)| broken.map(|broken| total(name, &broken)));
    let forces = if breakage.is_softened && breakage.broken_at_true_stiffness.is_some() {
        "at true stiffness"
    } else {
        "of the run"
    };
    let mut sections = vec![
        format!(
            "{told}\n{} pellets, {} hits, {} of them recorded in full",
            count(breakage.pellets),
            count(breakage.hits),
            count(breakage.hits_recorded),
        ),
        table::listing(["", "share", "interval", "pellets"], &[1, 2, 3], totals),
        format!("by the forces {forces}:"),
        listing("cause", &breakage.by_cause),
        listing("hit by", &breakage.by_wall),
        listing("size", &breakage.by_size),
    ];
    if !breakage.by_place.is_empty() {
        let title = format!(
            "place: middle of a cube of {} m [m]",
            chosen(breakage.cube_side_m)
        );
        let places = breakage.by_place.iter().map(|place| &place.group);
        sections.push(listing(&title, places));
    }
    let basis = breakage.confidence.map(|confidence| {
        format!(
            "interval: what the sample of the strength test leaves, {} %; ",
            chosen(100.0 * confidence)
        )
    });
    sections.push(format!(
        "{}the draw of {} strengths adds ± {} pellets (standard deviation)",
        basis.unwrap_or_default(),
        count(breakage.pellets),
        number((10.0 * breakage.luck_pellets).round() / 10.0)
    ));
    let warnings = breakage.warnings.iter();
    let warnings: Vec<String> = warnings
        .map(|warning| format!("warning: {warning}"))
        .collect();
    sections.push(warnings.join("\n"));
    sections.join("\n\n")
}

fn total(name: &str, broken: &Share) -> [String; 4] {
    let pellets = if broken.share < LEAST_SHARE {
        "0".into()
    } else {
        number(broken.pellets)
    };
    [
        name.to_owned(),
        percent(broken.share),
        between(broken),
        pellets,
    ]
}

fn listing<'a>(title: &str, groups: impl IntoIterator<Item = &'a Group>) -> String {
    let rows = groups.into_iter().map(|group| {
        [
            group.name.clone(),
            percent(group.broken.share),
            between(&group.broken),
            count(group.blows),
            number(group.worst_force_n),
        ]
    });
    let header = [title, "broken", "interval", "blows", "worst [N]"];
    table::listing(header, &[1, 2, 3, 4], rows)
}

fn between(broken: &Share) -> String {
    let [low, high] = broken.interval;
    format!("{} to {}", percent(low), percent(high))
}

/// A share as it stands in a table: what is next to nothing is no number.
fn percent(share: f64) -> String {
    if share > 0.0 && share < LEAST_SHARE {
        format!("< {} %", chosen(100.0 * LEAST_SHARE))
    } else {
        format!("{} %", number(100.0 * share))
    }
}
