//! `pelletflow report` writes one page that needs nothing else, and says what it leaves out.

mod common;

use common::{Call, call};
use pelletflow_log::figures::number;
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// Writes a scene of the hopper's first fifth of a second and runs it; its title would be a script.
fn recording(settings: &[&str]) -> TempDir {
    let directory = TempDir::new().expect("a directory");
    good(directory.path(), &["new", "hopper"]);
    let text = fs::read_to_string(directory.path().join("hopper.toml")).expect("a template");
    let scene = text.split("[expect]").next().expect("the scene itself");
    let scene = scene.to_owned() + "[expect]\n\"mass.lost\" = 0\n\"bodies.inserted\" = 7\n";
    fs::write(directory.path().join("hopper.toml"), scene).expect("writable");
    let mut arguments = vec!["run", "hopper.toml", "-o", "out", "-q"];
    for setting in [
        "time.end=0.2",
        "fill.bed.count=150",
        "scene.title=\"</script><script>alert('{{x}}')</script>\"",
    ]
    .iter()
    .chain(settings)
    {
        arguments.extend(["--set", setting]);
    }
    // One expectation is not met, so that the page has something to tell.
    assert_eq!(call(directory.path(), &arguments).code, 3);
    directory
}

fn good(directory: &Path, arguments: &[&str]) -> Call {
    let call = call(directory, arguments);
    assert_eq!(call.code, 0, "{arguments:?}: {}", call.error);
    call
}

fn page(directory: &Path, arguments: &[&str]) -> String {
    let told = good(
        directory,
        &[&["report", "out/run.mcap"], arguments].concat(),
    );
    assert!(told.output.contains("report.html"), "{}", told.output);
    fs::read_to_string(directory.join("out/report.html")).expect("a page")
}

#[test]
fn a_page_holds_every_section_and_asks_for_nothing() {
    let directory = recording(&[]);
    let page = page(directory.path(), &["--strength", "20N"]);
    for id in ["replay", "meters", "ledgers", "hits", "events", "run"] {
        assert!(page.contains(&format!("<section id=\"{id}\"")), "{id}");
    }
    assert!(page.contains("default-src 'none'"));
    for request in [
        "http://", "https://", "url(", "@import", "fetch(", "<link", "<img", "<iframe",
    ] {
        assert!(!page.contains(request), "{request}");
    }
    assert!(page.contains("The replay holds every frame and every pellet of the recording."));
    assert!(page.contains("every pellet breaks at 20 N. Of 150 pellets"));
    assert!(page.contains("<td>bodies.inserted</td><td>7</td><td>150</td><td>no</td>"));
    assert!(page.contains("Young&#39;s modulus"));
    assert!(page.len() < 1_000_000, "{}", page.len());
}

#[test]
fn a_page_tells_of_a_card_what_a_score_does() {
    let directory = recording(&["strength.load=\"1 N\""]);
    let card = "name = \"soft\"\nsource = \"made up\"\ntest_diameter = \"12 mm\"\nsample_size = 60\ndistribution = \"weibull\"\nscale = \"20 N\"\nmodulus = 3\n";
    fs::write(directory.path().join("soft.toml"), card).expect("writable");
    let asked = ["--strength", "soft.toml"];
    let page = page(directory.path(), &asked);
    let score = good(
        directory.path(),
        &[&["score", "out/run.mcap", "--json"], &asked[..]].concat(),
    );
    let score: Value = serde_json::from_str(&score.output).expect("JSON");
    let share = score["broken"]["share"].as_f64().expect("a share");
    assert!(share > 0.01 && share < 0.99, "{share}");
    assert!(page.contains(&format!("{} %", number(100.0 * share))));
    let walls = score["by_wall"].as_array().expect("a list");
    assert!(walls.len() > 1);
    for wall in walls {
        let name = wall["name"].as_str().expect("a name");
        let [pellets, worst] = ["pellets", "worst_force_n"].map(|key| wall[key].as_f64());
        let pellets = (100.0 * pellets.expect("a number")).round() / 100.0;
        let begin = format!(
            "<tr><td>hit by</td><td>{name}</td><td class=\"number\">{}</td>",
            number(pellets)
        );
        let row = page.split(&begin).nth(1);
        let row = row.and_then(|rest| rest.split("</tr>").next());
        let worst = number(worst.expect("a number"));
        assert!(row.is_some_and(|row| row.contains(&worst)), "{begin}");
    }
    for line in ["breaks 5 %", "breaks half"] {
        assert!(page.contains(line), "{line}");
    }
}

#[test]
fn nothing_of_a_scene_becomes_a_part_of_the_page() {
    let directory = recording(&[]);
    let page = page(directory.path(), &[]);
    assert!(!page.contains("<script>alert"));
    assert!(
        page.contains(
            "<h1>&lt;/script&gt;&lt;script&gt;alert(&#39;{{x}}&#39;)&lt;/script&gt;</h1>"
        )
    );
    // The two of data and the one that runs.
    assert_eq!(page.matches("<script").count(), 3);
    assert_eq!(page.matches("</script>").count(), 3);
}

#[test]
fn what_does_not_fit_is_left_out_and_said() {
    let directory = recording(&["output.frame_interval=\"0.1 ms\"", "fill.bed.count=400"]);
    let whole = page(directory.path(), &[]);
    let small = page(directory.path(), &["--max-size", "500kB"]);
    assert!(small.len() <= 500_000, "{}", small.len());
    // Frames are halved: less than half of a page is never left empty, however well they pack.
    assert!(small.len() > 250_000, "{}", small.len());
    assert!(whole.len() > small.len());
    assert!(
        small.contains("The page shows every "),
        "it does not say what it left out"
    );
}

#[test]
fn a_recording_that_is_cut_off_is_shown_as_far_as_it_is_whole() {
    let directory = recording(&[]);
    let path = directory.path().join("out/run.mcap");
    let bytes = fs::read(&path).expect("a recording");
    fs::write(&path, &bytes[..bytes.len() - 2000]).expect("writable");
    assert!(page(directory.path(), &[]).contains("The recording is cut off"));
}

#[test]
fn a_page_that_cannot_be_written_is_refused_with_the_cure() {
    let directory = recording(&["output.hits=false"]);
    fs::create_dir(directory.path().join("folder")).expect("writable");
    for (arguments, code, expected) in [
        (
            &["-o", "folder"][..],
            2,
            "folder is a directory; name a file in it",
        ),
        (
            &["-o", "nowhere/report.html"],
            4,
            "nowhere/report.html cannot be written",
        ),
        (&["--max-size", "1kB"], 2, "at least 500kB"),
        (&["--max-size", "much"], 2, "expected a size such as 8MB"),
        (&["--strength", "2 kg"], 2, "is a mass"),
        (&["--strength", "none.toml"], 2, "none.toml: cannot be read"),
        (&["--strength", "2 N", "--law", "energy"], 2, "give a card"),
        (&["--law", "energy"], 2, "--strength <LOAD|CARD>"),
    ] {
        let call = call(
            directory.path(),
            &[&["report", "out/run.mcap"], arguments].concat(),
        );
        assert!(
            call.error.contains(expected),
            "{arguments:?}: {}",
            call.error
        );
        assert_eq!(call.code, code, "{arguments:?}");
    }
    let page = page(directory.path(), &[]);
    assert!(page.contains("The run did not follow hits"));
}
