//! What messages promise, without a run.

use super::{color, hits, nanoseconds, pellets, series, spheres, timestamp};
use crate::recording::DrawnPellet;
use foxglove::messages::PointCloud;
use pelletflow_core::Vec3;
use pelletflow_sim::{Cause, Hit, HitPartner};
use prost::Message;

fn pellet(id: u32, speed: f64) -> DrawnPellet {
    DrawnPellet {
        id,
        position: Vec3::new(0.1 * f64::from(id), -2.5, 3.75),
        radius: 0.0075,
        speed,
        force: 12.5,
    }
}

#[test]
fn a_cloud_gives_back_what_went_in() {
    let bytes = pellets::message(1.5, &[pellet(3, 1.0), pellet(9, 2.0)]).encode_to_vec();
    let cloud = PointCloud::decode(bytes.as_slice()).expect("a cloud decodes");
    let records = pellets::pellets(&cloud).expect("its fields are ours");
    assert_eq!(records.len(), 2);
    assert_eq!(records[1].id, 9);
    // A thousandth of the radius.
    assert!((records[1].position[0] - 0.9).abs() < 7.5e-6);
    assert_eq!(records[1].position[1..], [-2.5, 3.75]);
    assert_eq!(records[1].radius, 0.0075);
    assert_eq!(records[1].speed, 2.0);
    assert_eq!(records[1].force, 12.5);
}

#[test]
fn what_is_told_of_a_pellet_is_off_by_less_than_can_be_seen() {
    let mut drawn = pellet(1, 1.0);
    for index in 1..2000 {
        let value = 1.07_f64.powi(index % 300 - 150) * f64::from(index);
        drawn.position = Vec3::new(
            1.0e-3 * f64::from(index),
            -0.37 * f64::from(index),
            1.0 / value,
        );
        (drawn.speed, drawn.force) = (value, 1.0e3 / value);
        let records =
            pellets::pellets(&pellets::message(0.0, &[drawn])).expect("its fields are ours");
        for axis in 0..3 {
            let off = (f64::from(records[0].position[axis]) - drawn.position[axis]).abs();
            // Beyond some meters, single precision is coarser.
            let single = drawn.position[axis].abs() * f64::from(f32::EPSILON);
            assert!(
                off < (1.0e-3 * drawn.radius).max(single),
                "{off} at {index}"
            );
        }
        for (found, told) in [
            (records[0].speed, drawn.speed),
            (records[0].force, drawn.force),
        ] {
            assert!(
                (f64::from(found) / told - 1.0).abs() < 1.3e-4,
                "{found} for {told}"
            );
        }
    }
    assert_eq!(
        pellets::pellets(&pellets::message(0.0, &[pellet(1, 0.0)])).expect("ours")[0].speed,
        0.0
    );
}

#[test]
fn a_cloud_without_a_field_names_it() {
    let mut cloud = pellets::message(0.0, &[pellet(1, 1.0)]);
    cloud.fields.retain(|field| field.name != "radius");
    let reason = pellets::pellets(&cloud).expect_err("a field is missing");
    assert!(reason.contains("`radius`"), "{reason}");
}

#[test]
fn spheres_have_their_diameter_and_keep_one_entity() {
    let first = spheres::message(0.0, &[pellet(1, 1.0)], 2.0);
    let second = spheres::message(0.1, &[pellet(1, 1.0), pellet(2, 1.0)], 2.0);
    assert_eq!(first.entities[0].id, second.entities[0].id);
    assert_eq!(spheres::removal(0.2).deletions[0].id, first.entities[0].id);
    let size = second.entities[0].spheres[1].size.expect("it has a size");
    assert_eq!([size.x, size.y, size.z], [0.015; 3]);
}

#[test]
fn the_color_scale_grows_lighter_all_the_way() {
    let lightness = |share: f64| {
        let color = color::on_scale(share);
        0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b
    };
    for step in 0..100 {
        let share = f64::from(step) / 100.0;
        assert!(lightness(share + 0.01) > lightness(share), "{share}");
    }
    assert_eq!(color::on_scale(7.0), color::on_scale(1.0));
    assert_eq!(color::on_scale(-1.0), color::on_scale(0.0));
}

#[test]
fn the_schema_of_a_meter_follows_its_names() {
    let schema = series::schema(
        "mass-flow",
        &[("mass_flow_kg_per_s", 0.0), ("mass_kg", 0.0)],
    );
    assert_eq!(schema.name, "pelletflow.MassFlow");
    assert_eq!(schema.encoding, "protobuf");
    let text = String::from_utf8_lossy(&schema.data);
    assert!(text.contains("mass_flow_kg_per_s") && text.contains("mass_kg"));
}

#[test]
fn the_first_value_of_a_row_is_read_back_and_another_message_has_none() {
    let bytes = series::encode(&[("inserted", 600.0), ("inside", 7.0)]);
    assert_eq!(series::first_value(&bytes), Some(600.0));
    assert_eq!(series::first_value(&bytes[..5]), None);
    let cloud = pellets::message(0.0, &[pellet(1, 1.0)]).encode_to_vec();
    assert_eq!(series::first_value(&cloud), None);
}

#[test]
fn a_row_is_read_back_with_its_names_and_another_message_is_not() {
    let row = [("mass_flow_kg_per_s", 4.5), ("mass_kg", -0.25)];
    let schema = series::schema("mass-flow", &row);
    let names = series::names(&schema.data).expect("a schema of ours");
    assert_eq!(names, ["mass_flow_kg_per_s", "mass_kg"]);
    let bytes = series::encode(&row);
    assert_eq!(series::decode(&bytes), Some(vec![4.5, -0.25]));
    assert_eq!(series::decode(&bytes[..12]), None);
    let cloud = pellets::message(0.0, &[pellet(1, 1.0)]).encode_to_vec();
    assert_eq!(series::decode(&cloud), None);
    assert_eq!(series::names(b"no schema"), None);
}

fn hit(partner: HitPartner, cause: Cause) -> Hit {
    // Each value is its own, and one that single precision holds.
    Hit {
        pellet: 41,
        diameter: 0.0125,
        mass: 0.007_812_5,
        partner,
        cause,
        is_open: true,
        begin: 1.5,
        duration: 0.25,
        steps: 17,
        peak_time: 1.625,
        place: Vec3::new(-0.5, 0.75, 3.0),
        peak_force: 812.5,
        sampled_force: 811.0,
        arrival_force: 900.0,
        arrival_pressure: 1.9e7,
        peak_pressure: 2.0e7,
        normal_impulse: 0.0625,
        tangential_impulse: 0.03125,
        lost_energy: 0.375,
        approach_speed: 5.5,
        sliding_speed: 1.25,
        effective_radius: 0.003_906_25,
    }
}

#[test]
fn hits_give_back_what_went_in() {
    let pellet = HitPartner::Pellet {
        id: 7,
        diameter: 0.015,
        mass: 0.00625,
    };
    let all = [
        hit(pellet, Cause::Collision),
        hit(HitPartner::Wall(3), Cause::Drop),
        hit(HitPartner::Wall(0), Cause::Squeeze),
    ];
    let bytes = hits::message(&all).encode_to_vec();
    let block = hits::Hits::decode(bytes.as_slice()).expect("a block decodes");
    assert_eq!(hits::hits(&block), Ok(all.to_vec()));
}

#[test]
fn hits_whose_columns_differ_in_length_are_refused() {
    let mut bytes = hits::message(&[hit(HitPartner::Wall(0), Cause::Drop)]).encode_to_vec();
    // One more value of field 6, the cause: packed, one byte, 9.
    bytes.extend([6 << 3 | 2, 1, 9]);
    let block = hits::Hits::decode(bytes.as_slice()).expect("a block decodes");
    let reason = hits::hits(&block).expect_err("a column is longer");
    assert!(reason.contains("differ in length"), "{reason}");
}

#[test]
fn time_is_kept_to_the_nanosecond() {
    assert_eq!(nanoseconds(12.345_678_901), 12_345_678_901);
    let stamp = timestamp(12.345_678_901);
    assert_eq!((stamp.sec(), stamp.nsec()), (12, 345_678_901));
}

#[test]
fn a_sketch_that_no_run_makes_is_refused() {
    let class = |force_class, count, kept| hits::HitClasses {
        wall: vec![0; 2],
        force_class: vec![8, force_class],
        least_force_n: vec![2.0; 2],
        count: vec![1, count],
        kept: vec![0, kept],
        normal_impulse_n_s: vec![0.0; 2],
        tangential_impulse_n_s: vec![0.0; 2],
        lost_energy_j: vec![0.0; 2],
        approach_energy_j: vec![0.0; 2],
    };
    assert!(hits::classes(&class(-8176, 4, 4)).is_ok());
    assert!(hits::classes(&class(8191, 4, 0)).is_ok());
    for (wrong, reason) in [
        (class(-8177, 4, 4), "its force class -8177 is none"),
        (class(8192, 4, 4), "its force class 8192 is none"),
        (class(0, 4, 5), "a class keeps 5 of its 4 hits"),
        (class(0, 1 << 53, 0), "it counts more than"),
        (class(0, u64::MAX, 0), "it counts more than"),
    ] {
        let found = hits::classes(&wrong).expect_err(reason);
        assert!(found.starts_with(reason), "{found}");
    }
}
