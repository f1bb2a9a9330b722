//! What a recording of a real run holds, read with the format's own crate.

mod common;

use common::{GATE_OPENS, SCENE_TEXT, plan, record, run_into, setup};
use foxglove::messages::{FrameTransforms, Log, PointCloud, SceneUpdate};
use foxglove::prost_types::FileDescriptorSet;
use mcap::{Message, MessageStream};
use pelletflow_log::{Progress, WORST_HITS, WorstHits, read_frames, read_hits};
use pelletflow_sim::{Hit, HitRequest, Setup};
use prost::Message as _;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;

fn messages(bytes: &[u8]) -> Vec<Message<'_>> {
    MessageStream::new(bytes)
        .expect("a recording is an MCAP file")
        .collect::<Result<_, _>>()
        .expect("every record of a recording can be read")
}

fn of_topic<'a>(messages: &'a [Message], topic: &str) -> Vec<&'a Message<'a>> {
    messages
        .iter()
        .filter(|message| message.channel.topic == topic)
        .collect()
}

fn recorded(directory: &Path, end_time: f64) -> Vec<u8> {
    record(directory, end_time);
    fs::read(directory.join("run.mcap")).expect("a run leaves a recording")
}

/// The named values of one of our own messages, by the schema in the file alone.
fn values(message: &Message) -> BTreeMap<String, f64> {
    let schema = message.channel.schema.as_ref().expect("it has a schema");
    let files = FileDescriptorSet::decode(schema.data.as_ref()).expect("the schema is protobuf");
    let mut data = message.data.as_ref();
    files.file[0].message_type[0]
        .field
        .iter()
        .map(|field| {
            let key = prost::encoding::decode_varint(&mut data).expect("a field has a key");
            assert_eq!(key >> 3, field.number() as u64, "fields are in order");
            assert_eq!(key & 7, 1, "every field is a double");
            let (value, rest) = data.split_first_chunk().expect("a double has eight bytes");
            data = rest;
            (field.name().to_owned(), f64::from_le_bytes(*value))
        })
        .collect()
}

#[test]
fn every_message_decodes_by_its_schema() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let bytes = recorded(directory.path(), 0.06);
    let mut topics = BTreeMap::new();
    for message in messages(&bytes) {
        let schema = message.channel.schema.as_ref().expect("it has a schema");
        let data = message.data.as_ref();
        match schema.name.as_ref() {
            "foxglove.PointCloud" => {
                PointCloud::decode(data).expect("a cloud");
            }
            "foxglove.SceneUpdate" => {
                SceneUpdate::decode(data).expect("a scene update");
            }
            "foxglove.FrameTransforms" => {
                FrameTransforms::decode(data).expect("transforms");
            }
            "foxglove.Log" => {
                Log::decode(data).expect("a log line");
            }
            name => {
                assert!(name.starts_with("pelletflow."), "{name}");
                assert!(!values(&message).is_empty());
            }
        }
        *topics.entry(message.channel.topic.clone()).or_insert(0) += 1;
    }
    let topics: Vec<_> = topics.keys().map(String::as_str).collect();
    assert_eq!(
        topics,
        [
            "/contacts",
            "/equipment",
            "/ledger/energy",
            "/ledger/mass",
            "/log",
            "/meters/cone-load",
            "/meters/outflow",
            "/pellets",
            "/pellets/spheres",
            "/tf",
        ]
    );
}

/// A run with every hit recorded in full.
fn recorded_with_hits(directory: &Path, end_time: f64) -> Vec<u8> {
    let setup = Setup {
        hits: Some(HitRequest { threshold: 0.0 }),
        ..setup(60)
    };
    let go_on = &mut |_: &Progress| ControlFlow::Continue(());
    run_into(directory, setup, &plan(end_time), 1000, go_on).expect("the hopper runs to its end");
    fs::read(directory.join("run.mcap")).expect("a run leaves a recording")
}

#[test]
fn the_layout_looks_at_what_is_there_and_lists_the_hardest_hits() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    recorded_with_hits(directory.path(), 0.01);
    let layout = fs::read_to_string(directory.path().join("layout.json")).expect("it is beside");
    let layout: Value = serde_json::from_str(&layout).expect("it is JSON");
    let panels = &layout["configById"];
    assert_eq!(panels["RosOut!hits"]["topicToRender"], "/hits/worst/log");
    assert_eq!(layout["layout"]["first"]["second"], "RosOut!hits");
    let camera = &panels["3D!scene"]["cameraState"];
    let target: Vec<f64> = (0..3)
        .filter_map(|axis| camera["targetOffset"][axis].as_f64())
        .collect();
    // The hopper stands about the z axis, and its pellets begin above it.
    assert!(target[0].abs() < 0.1 && target[1].abs() < 0.1, "{target:?}");
    assert!(target[2].abs() < 0.2, "{target:?}");
    let domain = setup(60).domain.bounds;
    let distance = camera["distance"].as_f64().expect("it is a number");
    assert!(distance < 1.2 * (domain.max - domain.min).norm());
    // Sixty pellets are drawn as spheres, out of which points would stick.
    let topics = &panels["3D!scene"]["topics"];
    assert_eq!(topics["/pellets/spheres"]["visible"], true);
    assert_eq!(topics["/pellets"]["visible"], false);
}

#[test]
fn log_times_never_go_back() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let bytes = recorded_with_hits(directory.path(), 0.3);
    let messages = messages(&bytes);
    assert!(!of_topic(&messages, "/hits/worst/log").is_empty());
    let times: Vec<u64> = messages.iter().map(|message| message.log_time).collect();
    assert!(times.is_sorted());
}

#[test]
fn the_hardest_hits_up_to_each_moment_are_marked_and_told() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let bytes = recorded_with_hits(directory.path(), 0.3);
    let messages = messages(&bytes);
    // Hits are told with the frame after them, and marked then.
    let hits = read_hits(directory.path().join("run.mcap")).expect("hits are recorded");
    let mut all = WorstHits::new(WORST_HITS);
    let mut told: Vec<String> = Vec::new();
    let words = of_topic(&messages, "/hits/worst/log");
    for message in of_topic(&messages, "/hits/worst") {
        let marks = SceneUpdate::decode(message.data.as_ref()).expect("it is marks");
        let ended = |hit: &&Hit| ((hit.begin + hit.duration) * 1.0e9) as u64 <= message.log_time;
        let mut hardest = WorstHits::new(WORST_HITS);
        for hit in hits.hits.iter().filter(ended) {
            hardest.enter(hit);
        }
        let expected = hardest.as_slice().iter().zip(1..);
        let expected: Vec<String> = expected
            .map(|(hit, rank)| format!("{rank}: {:.4} N", hit.peak_force))
            .collect();
        let entities = marks.entities.iter();
        let found: Vec<&str> = entities.map(|mark| &*mark.texts[0].text).collect();
        assert_eq!(found, expected, "{}", message.log_time);
        assert_eq!(marks.deletions.len(), 1);
        told = expected;
    }
    for hit in &hits.hits {
        all.enter(hit);
    }
    assert_eq!(told.len(), WORST_HITS);
    for hit in all.as_slice() {
        let moment = format!(
            "at {:.4} s: {:.4} N on pellet {}",
            hit.peak_time, hit.peak_force, hit.pellet
        );
        let is_told = words.iter().any(|message| {
            let line = Log::decode(message.data.as_ref()).expect("it is a line");
            line.message.contains(&moment)
        });
        assert!(is_told, "{moment}");
    }
}

#[test]
fn frames_come_once_each_at_the_step_nearest_to_their_time() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let summary = record(directory.path(), 0.055);
    let times: Vec<f64> = read_frames(directory.path().join("run.mcap"))
        .expect("the recording opens")
        .map(|frame| frame.expect("every frame can be read").time)
        .collect();
    let due = [0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.055];
    assert_eq!(times.len(), due.len(), "{times:?}");
    for (time, due) in times.iter().zip(due) {
        // Half a step, and log times are whole nanoseconds.
        assert!(
            (time - due).abs() <= summary.time.step_s / 2.0 + 1.0e-9,
            "{time} for {due}"
        );
    }
}

#[test]
fn an_end_on_a_frame_does_not_double_it() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.03);
    let frames = read_frames(directory.path().join("run.mcap"))
        .expect("the recording opens")
        .count();
    assert_eq!(frames, 4);
}

#[test]
fn frames_hold_every_pellet_once_in_order_of_its_number() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let bytes = recorded(directory.path(), 0.03);
    let messages = messages(&bytes);
    let ledgers = of_topic(&messages, "/ledger/mass");
    let frames = read_frames(directory.path().join("run.mcap")).expect("the recording opens");
    for (frame, ledger) in frames.zip(ledgers) {
        let frame = frame.expect("every frame can be read");
        assert_eq!(frame.pellets.len() as f64, values(ledger)["inside"]);
        assert!(frame.pellets.windows(2).all(|pair| pair[0].id < pair[1].id));
        for pellet in frame.pellets {
            assert!((pellet.radius - 0.0075).abs() < 1.0e-9);
            assert!(pellet.position[2] > -0.3 && pellet.position[2] < 0.4);
        }
    }
}

#[test]
fn a_gate_that_opens_is_taken_away_and_the_other_walls_are_sent_again() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let bytes = recorded(directory.path(), 0.06);
    let messages = messages(&bytes);
    let updates: Vec<_> = of_topic(&messages, "/equipment")
        .into_iter()
        .map(|message| {
            let update = SceneUpdate::decode(message.data.as_ref()).expect("a scene update");
            (message.log_time as f64 * 1.0e-9, update)
        })
        .collect();
    let names = |update: &SceneUpdate| -> Vec<String> {
        update.entities.iter().map(|wall| wall.id.clone()).collect()
    };
    assert_eq!(updates.len(), 2);
    assert_eq!(names(&updates[0].1), ["cone", "gate", "paddle"]);
    assert_eq!(names(&updates[1].1), ["cone", "paddle"]);
    assert_eq!(updates[1].1.deletions.len(), 1);
    assert_eq!(updates[1].1.deletions[0].id, "gate");
    // A step is far below a tenth of a millisecond.
    assert!(
        (updates[1].0 - GATE_OPENS).abs() < 1.0e-4,
        "{}",
        updates[1].0
    );
    let told = of_topic(&messages, "/log").into_iter().any(|message| {
        let line = Log::decode(message.data.as_ref()).expect("a log line");
        line.message == "wall `gate` is gone"
    });
    assert!(told);
}

#[test]
fn each_wall_is_drawn_in_its_own_frame_with_its_material() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let bytes = recorded(directory.path(), 0.01);
    let messages = messages(&bytes);
    let first = of_topic(&messages, "/equipment")[0];
    for wall in SceneUpdate::decode(first.data.as_ref())
        .expect("a scene update")
        .entities
    {
        assert_eq!(wall.frame_id, format!("walls/{}", wall.id));
        let metadata: Vec<_> = wall
            .metadata
            .iter()
            .map(|pair| (pair.key.as_str(), pair.value.as_str()))
            .collect();
        assert_eq!(
            metadata,
            [("name", wall.id.as_str()), ("material", "steel")]
        );
        assert!(wall.triangles[0].indices.len() >= 36);
        assert!(!wall.lines[0].points.is_empty());
    }
}

#[test]
fn a_turning_wall_has_its_turn_in_every_frame() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let bytes = recorded(directory.path(), 0.02);
    let messages = messages(&bytes);
    let transforms = of_topic(&messages, "/tf");
    assert_eq!(transforms.len(), 3);
    let last = FrameTransforms::decode(transforms[2].data.as_ref()).expect("transforms");
    let paddle = &last.transforms[2];
    assert_eq!(paddle.child_frame_id, "walls/paddle");
    let turn = paddle.rotation.as_ref().expect("it has a rotation");
    // 6 rad/s for 0.02 s, to within half a step of 10 µs.
    assert!((turn.z - (0.06_f64).sin()).abs() < 1.0e-4, "{}", turn.z);
}

#[test]
fn meters_come_at_their_rate_with_units_in_their_names() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let bytes = recorded(directory.path(), 0.15);
    let messages = messages(&bytes);
    let flow = of_topic(&messages, "/meters/outflow");
    assert_eq!(flow.len(), 31);
    assert!(values(flow[0]).contains_key("mass_flow_kg_per_s"));
    let load = of_topic(&messages, "/meters/cone-load");
    // The first pellets reach the cone after about a tenth of a second.
    let is_pressed = load
        .iter()
        .any(|message| values(message)["force_z_n"] < 0.0);
    assert!(is_pressed);
}

#[test]
fn spheres_are_left_out_above_their_count() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    run_into(directory.path(), setup(60), &plan(0.02), 59, &mut |_| {
        ControlFlow::Continue(())
    })
    .expect("the hopper runs to its end");
    let bytes = fs::read(directory.path().join("run.mcap")).expect("a run leaves a recording");
    assert!(of_topic(&messages(&bytes), "/pellets/spheres").is_empty());
}

#[test]
fn a_pellet_takes_twenty_eight_bytes_a_frame_before_compression() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let bytes = recorded(directory.path(), 0.01);
    let messages = messages(&bytes);
    for message in of_topic(&messages, "/pellets") {
        let cloud = PointCloud::decode(message.data.as_ref()).expect("a cloud");
        assert_eq!(cloud.data.len(), 60 * 28);
        // Field names and pose, once a frame.
        assert!(message.data.len() - cloud.data.len() < 250);
    }
}

#[test]
fn the_scene_and_the_layout_are_attached_and_beside_the_recording() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.01);
    let recording = directory.path().join("run.mcap");
    for name in ["scene.toml", "layout.json"] {
        let attached = pelletflow_log::read_attachment(&recording, name).expect("it is attached");
        let beside = fs::read_to_string(directory.path().join(name)).expect("it is beside");
        assert_eq!(attached, beside);
    }
    let scene = fs::read_to_string(directory.path().join("scene.toml")).expect("it is beside");
    assert_eq!(scene, SCENE_TEXT);
    let layout = fs::read_to_string(directory.path().join("layout.json")).expect("it is beside");
    let layout: Value = serde_json::from_str(&layout).expect("it is JSON");
    let panels = layout["configById"].as_object().expect("it has panels");
    assert_eq!(panels.len(), 5, "a scene, two meters and two ledgers");
    assert_eq!(
        panels["Plot!meter-outflow"]["paths"][0]["value"],
        "/meters/outflow.mass_flow_kg_per_s"
    );
}
