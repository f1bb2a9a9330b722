//! `pelletflow inspect`.

use crate::args::InspectArguments;
use crate::exit::{Exit, Failure};
use crate::screen;
use crate::table::{self, bytes, count, number};
use pelletflow_log::Inspection;

/// Shows what a recording holds.
pub(crate) fn inspect(arguments: &InspectArguments) -> Result<Exit, Failure> {
    let inspection = pelletflow_log::inspect(&arguments.recording)?;
    if arguments.json {
        let json = serde_json::to_value(&inspection).expect("an inspection is plain data");
        screen::json(&json)?;
    } else {
        screen::result(&page(&inspection))?;
    }
    Ok(Exit::Done)
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
