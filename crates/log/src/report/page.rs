//! The page: its sections, and the template that holds them.

use super::broken::Broken;
use super::hits::HitFindings;
use super::html::{facts, filled, json, put, section, table};
use super::pass::Gathered;
use super::replay::Replay;
use super::{ReportRequest, charts};
use crate::figures::{count, number};
use crate::markup::escaped;

const TEMPLATE: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
/// What the page does, in the order in which it needs it.
const SCRIPTS: [&str; 5] = [
    include_str!("script/unpack.js"),
    include_str!("script/camera.js"),
    include_str!("script/shaders.js"),
    include_str!("script/scene.js"),
    include_str!("script/player.js"),
];

/// Hits in the table of the hardest [-].
const WORST: usize = 20;

/// All of a page but its replay.
pub(super) struct Fixed {
    title: String,
    notices: Vec<String>,
    figures: String,
    /// Which hits the replay marks, and whether it does so at first.
    marks: [&'static str; 2],
    before: String,
    after: String,
}

impl Fixed {
    pub(super) fn of(
        gathered: &Gathered,
        broken: Option<&Broken>,
        request: &ReportRequest,
    ) -> Self {
        let fact = |key: &str| gathered.facts.get(key).map_or("", String::as_str);
        let title = match fact("title") {
            "" => fact("scene"),
            title => title,
        };
        let mut notices = Vec::new();
        if gathered.is_cut_off {
            notices.push(format!(
                "The recording is cut off: this is what came before {} s. What followed is missing.",
                number(gathered.end)
            ));
        }
        Self {
            title: title.to_owned(),
            notices,
            figures: key_figures(gathered, broken),
            marks: match broken {
                Some(_) => [
                    "where pellets may break, the larger the likelier",
                    " checked",
                ],
                None => ["hardest hits on walls", ""],
            },
            before: plots(gathered),
            after: [
                hits(&gathered.hits, broken),
                events(gathered),
                run(gathered, request),
            ]
            .concat(),
        }
    }

    /// The page with a replay, from which something was left out.
    pub(super) fn page(&self, replay: &Replay, omissions: &[String]) -> String {
        let mut notices = String::new();
        for notice in &self.notices {
            put(
                &mut notices,
                format_args!("<p class=\"notice\">{}</p>", escaped(notice)),
            );
        }
        let shown = match omissions {
            [] => "The replay holds every frame and every pellet of the recording.".to_owned(),
            omissions => format!("The page shows {}.", omissions.join("; ")),
        };
        filled(
            TEMPLATE,
            &[
                ("title", &escaped(&self.title)),
                ("style", STYLE),
                ("version", env!("CARGO_PKG_VERSION")),
                ("notices", &notices),
                ("figures", &self.figures),
                ("shown", &escaped(&shown)),
                ("marks", self.marks[0]),
                ("marked", self.marks[1]),
                ("before", &self.before),
                ("after", &self.after),
                ("header", &json(&replay.header)),
                ("packed", &replay.packed),
                ("script", &SCRIPTS.concat()),
            ],
        )
    }
}

/// The run in a few numbers.
fn key_figures(gathered: &Gathered, broken: Option<&Broken>) -> String {
    let last = |topic: &str, name: &str| {
        let curves = gathered.curves.get(topic)?;
        let (_, curve) = curves.iter().find(|(found, _)| found == name)?;
        curve.points().last().map(|point| point[1])
    };
    let mut figures = vec![
        (
            format!("{} s", number(gathered.end)),
            "simulated".to_owned(),
        ),
        (
            count(gathered.frames.most_pellets() as u64),
            "pellets inside at most".to_owned(),
        ),
    ];
    if let Some(mass) = last("/ledger/mass", "discharged_kg").filter(|mass| *mass > 0.0) {
        figures.push((format!("{} kg", number(mass)), "discharged".to_owned()));
    }
    if let Some(lost) = last("/ledger/mass", "lost") {
        figures.push((count(lost as u64), "pellets lost".to_owned()));
    }
    if let Some(hit) = gathered.hits.worst.as_slice().first() {
        figures.push((
            format!("{} N", number(hit.peak_force)),
            "hardest hit".to_owned(),
        ));
    }
    figures.extend(broken.map(Broken::key_figure));
    let mut html = String::new();
    for (value, name) in figures {
        let (value, name) = (escaped(&value), escaped(&name));
        put(
            &mut html,
            format_args!("<div><dt>{name}</dt><dd>{value}</dd></div>"),
        );
    }
    html
}

fn plots(gathered: &Gathered) -> String {
    let mut meters = String::new();
    for (topic, curves) in &gathered.curves {
        if let Some(name) = topic.strip_prefix("/meters/") {
            meters.push_str(&charts::of_meter(name, curves));
        }
    }
    let ledgers = charts::of_ledgers(|topic| gathered.curves.get(topic).map(Vec::as_slice));
    let mut html = String::new();
    for (id, heading, charts) in [
        ("meters", "Flow and forces", meters),
        ("ledgers", "Mass and energy", ledgers),
    ] {
        if !charts.is_empty() {
            let body = format!("<div class=\"charts\">{charts}</div>");
            html.push_str(&section(id, heading, &body));
        }
    }
    html
}

fn hits(findings: &HitFindings, broken: Option<&Broken>) -> String {
    if findings.walls.is_none() {
        let body =
            "<p>The run did not follow hits: <code>output.hits</code> is false in its scene.</p>";
        return section("hits", "Hits", body);
    }
    let mut body = String::new();
    if findings.is_softened {
        body.push_str("<p class=\"notice\">Some material was softer in the run than it really is: look at the true forces.</p>");
    }
    let loads = broken.map(Broken::loads).unwrap_or_default();
    if let Some(chart) = findings.histogram(loads) {
        put(
            &mut body,
            format_args!(
                "<div class=\"charts\">{}<div>{}</div></div>",
                charts::figure("Hits by their greatest force", chart, None),
                by_partner(findings, broken),
            ),
        );
    }
    body.extend(broken.map(Broken::html));
    if findings.worst.as_slice().is_empty() {
        body.push_str("<p>No pellet was hit.</p>");
    } else {
        body.push_str("<h3>The hardest</h3><p>Press a moment to see it in the replay. True: of an arrival, what the two bodies alone make at their true stiffness; of a squeeze, the force as it was.</p>");
        body.push_str(&worst(findings));
    }
    section("hits", "Hits", &body)
}

fn by_partner(findings: &HitFindings, broken: Option<&Broken>) -> String {
    let rows: Vec<Vec<String>> = findings
        .by_partner()
        .into_iter()
        .map(|row| {
            let mut cells = vec![
                row.name,
                count(row.count),
                number(row.force),
                number(row.lost_energy),
            ];
            cells.extend(broken.map(|broken| broken.by(row.wall)));
            cells
        })
        .collect();
    let mut header = vec!["by", "hits", "hardest from [N]", "energy taken [J]"];
    if broken.is_some() {
        header.push("pellets broken");
    }
    table(&header, 1, &rows)
}

fn worst(findings: &HitFindings) -> String {
    let mut html = String::from(
        "<div class=\"wide\"><table><thead><tr><th>moment</th><th>pellet</th><th>by</th><th>cause</th><th class=\"number\">force [N]</th><th class=\"number\">true [N]</th><th class=\"number\">pressure [MPa]</th><th class=\"number\">speed [m/s]</th><th class=\"number\">angle [°]</th></tr></thead><tbody>",
    );
    for hit in findings.worst.as_slice().iter().take(WORST) {
        let at = hit.place;
        put(
            &mut html,
            format_args!(
                "<tr><td><button class=\"moment\" data-time=\"{}\" data-place=\"{} {} {}\">{:.4} s</button></td>",
                hit.peak_time, at.x, at.y, at.z, hit.peak_time
            ),
        );
        for cell in [
            hit.pellet.to_string(),
            findings.partner(hit),
            hit.cause.name().to_owned(),
        ] {
            put(&mut html, format_args!("<td>{}</td>", escaped(&cell)));
        }
        for cell in [
            number(hit.peak_force),
            number(hit.true_force()),
            number(hit.peak_pressure * 1.0e-6),
            number(hit.speed()),
            format!("{:.0}", hit.angle().to_degrees()),
        ] {
            put(&mut html, format_args!("<td class=\"number\">{cell}</td>"));
        }
        html.push_str("</tr>");
    }
    html.push_str("</tbody></table></div>");
    html
}

fn events(gathered: &Gathered) -> String {
    if gathered.events.is_empty() {
        return String::new();
    }
    let rows: Vec<Vec<String>> = gathered
        .events
        .iter()
        .map(|(time, text)| vec![text.clone(), format!("{time:.4}")])
        .collect();
    section(
        "events",
        "What happened",
        &table(&["event", "time [s]"], 1, &rows),
    )
}

fn run(gathered: &Gathered, request: &ReportRequest) -> String {
    let fact = |key: &str| gathered.facts.get(key).cloned().unwrap_or_default();
    let rows = [
        ("scene", fact("scene")),
        ("hash of the scene", fact("scene_hash")),
        ("written by", format!("pelletflow {}", fact("version"))),
        ("seed", fact("seed")),
        ("threads", fact("threads")),
        ("step", format!("{} s", short(&fact("step_s")))),
        ("reason of the step", fact("step_reason")),
        ("frames recorded", count(gathered.frames.seen() as u64)),
    ];
    let mut body = facts(&rows);
    if !request.checks.is_empty() {
        let rows: Vec<Vec<String>> = request
            .checks
            .iter()
            .map(|check| {
                let verdict = if check.is_met { "yes" } else { "no" };
                let cells = [&*check.key, &*check.expected, &*check.found, verdict];
                cells.map(str::to_owned).into()
            })
            .collect();
        body.push_str("<h3>What a right run shows</h3>");
        let header = ["quantity", "expected", "found", "met"];
        body.push_str(&table(&header, 4, &rows));
    }
    if !request.materials.is_empty() {
        let rows: Vec<Vec<String>> = request
            .materials
            .iter()
            .map(|(name, told)| vec![name.clone(), told.clone()])
            .collect();
        body.push_str("<h3>Materials</h3>");
        body.push_str(&table(&["material", "what is known of it"], 2, &rows));
    }
    let walls = gathered.walls.surfaces();
    if !walls.is_empty() {
        let rows: Vec<Vec<String>> = walls
            .iter()
            .map(|wall| {
                let kind = if wall.is_active {
                    "moves, runs or opens"
                } else {
                    "stays"
                };
                vec![wall.name.clone(), wall.material.clone(), kind.to_owned()]
            })
            .collect();
        body.push_str("<h3>Walls</h3>");
        body.push_str(&table(&["wall", "material", "what it does"], 3, &rows));
    }
    if let Some(scene) = &gathered.scene {
        put(
            &mut body,
            format_args!(
                "<details><summary>The scene as it was run</summary><pre><code>{}</code></pre></details>",
                escaped(scene)
            ),
        );
    }
    section("run", "The run", &body)
}

/// A number in words, with four significant digits.
fn short(text: &str) -> String {
    text.parse().map_or_else(|_| text.to_owned(), number)
}
