//! `pelletflow inspect`.

use crate::args::InspectArguments;
use crate::exit::{Exit, Failure};
use crate::screen;
use crate::table::{self, bytes, count, number};
use pelletflow_log::{Inspection, RecordedHits, WorstHits};
use pelletflow_sim::{Hit, HitPartner};
use serde_json::{Value, json};

/// Shows what a recording holds.
pub(crate) fn inspect(arguments: &InspectArguments) -> Result<Exit, Failure> {
    if let Some(most) = arguments.worst {
        return worst(arguments, most as usize);
    }
    let inspection = pelletflow_log::inspect(&arguments.recording)?;
    if arguments.json {
        let json = serde_json::to_value(&inspection).expect("an inspection is plain data");
        screen::json(&json)?;
    } else {
        screen::result(&page(&inspection))?;
    }
    Ok(Exit::Done)
}

/// Lists the hardest hits.
fn worst(arguments: &InspectArguments, most: usize) -> Result<Exit, Failure> {
    let recorded = pelletflow_log::read_hits(&arguments.recording)?;
    let mut worst = WorstHits::new(most);
    for hit in &recorded.hits {
        worst.enter(hit);
    }
    if arguments.json {
        let rows = worst.as_slice().iter().map(|hit| hit_row(hit, &recorded));
        screen::json(&Value::Array(rows.collect()))?;
        return Ok(Exit::Done);
    }
    let rows = worst.as_slice().iter().zip(1..).map(|(hit, rank)| {
        [
            count(rank),
            format!("{:.4}", hit.peak_time),
            partner(hit, &recorded),
            hit.cause.name().to_owned(),
            number(hit.peak_force),
            number(hit.true_force()),
            number(hit.peak_pressure * 1.0e-6),
            number(hit.speed()),
            format!("{:.0}", hit.angle().to_degrees()),
            count(hit.steps),
            hit.place
                .iter()
                .map(|at| format!("{at:.3}"))
                .collect::<Vec<_>>()
                .join(", "),
        ]
    });
    let header = [
        "",
        "time [s]",
        "by",
        "cause",
        "force [N]",
        "true [N]",
        "pressure [MPa]",
        "speed [m/s]",
        "angle [°]",
        "steps",
        "place [m]",
    ];
    let mut page = table::listing(header, &[0, 1, 4, 5, 6, 7, 8, 9], rows);
    page.push_str(
        "\n\ntrue: of an arrival, what the two bodies alone make at their true stiffness; of a squeeze, the force as it was",
    );
    if recorded.is_cut_off {
        page.push_str("\nthe recording is cut off: hits after the cut are missing");
    }
    screen::result(&page)?;
    Ok(Exit::Done)
}

/// What a pellet met, by name.
fn partner(hit: &Hit, recorded: &RecordedHits) -> String {
    match hit.partner {
        HitPartner::Pellet { id, .. } => format!("pellet {id}"),
        HitPartner::Wall(wall) => recorded
            .walls
            .get(wall)
            .cloned()
            .unwrap_or_else(|| format!("wall {wall}")),
    }
}

fn hit_row(hit: &Hit, recorded: &RecordedHits) -> Value {
    json!({
        "time_s": hit.peak_time,
        "begin_s": hit.begin,
        "duration_s": hit.duration,
        "steps": hit.steps,
        "is_open": hit.is_open,
        "pellet": hit.pellet,
        "diameter_m": hit.diameter,
        "by": partner(hit, recorded),
        "cause": hit.cause.name(),
        "place_m": hit.place.as_slice(),
        "peak_force_n": hit.peak_force,
        "true_force_n": hit.true_force(),
        "peak_pressure_pa": hit.peak_pressure,
        "speed_m_per_s": hit.speed(),
        "angle_rad": hit.angle(),
        "normal_impulse_n_s": hit.normal_impulse,
        "tangential_impulse_n_s": hit.tangential_impulse,
        "lost_energy_j": hit.lost_energy,
    })
}

fn page(inspection: &Inspection) -> String {
    let mut sections = vec![overview(inspection)];
    let channels = inspection.channels.iter().map(|channel| {
        [
            channel.topic.clone(),
            channel.schema.clone(),
            count(channel.messages),
            bytes(channel.bytes),
            channel.first_s.map_or_else(String::new, number),
            channel.last_s.map_or_else(String::new, number),
        ]
    });
    let header = [
        "channel",
        "message",
        "count",
        "size",
        "first [s]",
        "last [s]",
    ];
    sections.push(table::listing(header, &[2, 3, 4, 5], channels));
    for (name, entries) in &inspection.metadata {
        let rows = entries
            .iter()
            .map(|(key, value)| [key.clone(), value.clone()]);
        let title = format!("metadata `{name}`");
        sections.push(table::listing([&title, ""], &[], rows));
    }
    let attachments = inspection.attachments.iter().map(|attachment| {
        [
            attachment.name.clone(),
            attachment.media_type.clone(),
            bytes(attachment.bytes),
        ]
    });
    let header = ["attachment", "type", "size"];
    sections.push(table::listing(header, &[2], attachments));
    sections.join("\n\n")
}

fn overview(inspection: &Inspection) -> String {
    let compression = match (&inspection.compression, inspection.compression_ratio) {
        (Some(name), Some(ratio)) => format!("{name}, {ratio:.1} to 1"),
        (Some(name), None) => name.clone(),
        (None, _) => "unknown".into(),
    };
    let end = if inspection.is_cut_off {
        "cut off: what is shown is before the cut"
    } else {
        "whole"
    };
    table::facts([
        (
            "file".into(),
            format!("{}, {end}", bytes(inspection.file_bytes)),
        ),
        ("written by".into(), inspection.library.clone()),
        (
            "simulated time".into(),
            format!("{} s", number(inspection.duration_s)),
        ),
        ("frames".into(), count(inspection.frames)),
        ("messages".into(), count(inspection.messages)),
        ("compression".into(), compression),
    ])
}
