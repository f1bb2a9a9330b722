//! Recordings read as tables.

mod common;

use common::{GATE_OPENS, plan, record, run_into, setup, simulation};
use nalgebra::Point3;
use pelletflow_log::{
    Summary, Table, TableKind, Tables, Values, read_frames, read_hits, read_tables,
};
use pelletflow_sim::{ContactPartner, ContactView, HitPartner, HitRequest};
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;

/// Runs the hopper until the first pellets have left it, with its hits from `threshold` [N] on.
fn record_hits(directory: &Path, threshold: f64) -> Summary {
    let mut setup = setup(60);
    setup.hits = Some(HitRequest { threshold });
    run_into(directory, setup, &plan(0.4), 1000, &mut |_| {
        ControlFlow::Continue(())
    })
    .expect("the hopper runs to its end")
}

fn read(directory: &Path) -> Tables {
    read_tables(directory.join("run.mcap"), &TableKind::ALL).expect("the recording opens")
}

fn float64<'a>(table: &'a Table, column: &str) -> &'a [f64] {
    match &table.column(column).expect("the column is there").values {
        Values::Float64(values) => values,
        other => panic!("{column} is {other:?}"),
    }
}

fn float32<'a>(table: &'a Table, column: &str) -> &'a [f32] {
    match &table.column(column).expect("the column is there").values {
        Values::Float32(values) => values,
        other => panic!("{column} is {other:?}"),
    }
}

fn uint32<'a>(table: &'a Table, column: &str) -> &'a [u32] {
    match &table.column(column).expect("the column is there").values {
        Values::UInt32(values) => values,
        other => panic!("{column} is {other:?}"),
    }
}

/// The name in a row; none where it has none.
fn label<'a>(table: &'a Table, column: &str, row: usize) -> Option<&'a str> {
    let column = table.column(column).expect("the column is there");
    let Values::Label { labels, indices } = &column.values else {
        panic!("{column:?} holds no names");
    };
    column
        .is_known(row)
        .then(|| labels[indices[row] as usize].as_str())
}

#[test]
fn every_column_of_every_table_has_as_many_rows_and_a_unit_of_its_name() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record_hits(directory.path(), 1.0);
    let tables = read(directory.path());
    let names: Vec<_> = tables
        .tables
        .iter()
        .map(|table| table.name.as_str())
        .collect();
    assert_eq!(
        names,
        [
            "bodies",
            "contacts",
            "hits",
            "hit_classes",
            "meters/cone-load",
            "meters/outflow",
            "mass_ledger",
            "energy_ledger",
            "events",
            "walls",
            "wall_triangles",
            "wall_edges",
        ]
    );
    for table in &tables.tables {
        assert!(table.rows() > 0, "{}", table.name);
        for column in &table.columns {
            assert_eq!(column.values.len(), table.rows(), "{}", column.name);
            if let Some(known) = &column.is_known {
                assert_eq!(known.len(), table.rows(), "{}", column.name);
            }
        }
    }
    let unit = |table: &str, column: &str| {
        let table = tables.get(table).expect("the table is there");
        table.column(column).expect("the column is there").unit
    };
    assert_eq!(unit("bodies", "speed_m_per_s"), "m/s");
    assert_eq!(unit("meters/outflow", "mass_flow_kg_per_s"), "kg/s");
    assert_eq!(unit("meters/cone-load", "torque_x_nm"), "N·m");
    assert_eq!(unit("hits", "tangential_impulse_n_s"), "N·s");
    assert_eq!(unit("events", "text"), "-");
}

#[test]
fn bodies_are_the_frames_one_after_another() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.05);
    let tables = read(directory.path());
    let bodies = tables.get("bodies").expect("pellets are always recorded");
    let frames = read_frames(directory.path().join("run.mcap")).expect("it opens");
    let mut row = 0;
    for frame in frames {
        let frame = frame.expect("frames can be read");
        for pellet in frame.pellets {
            assert_eq!(float64(bodies, "time_s")[row], frame.time);
            assert_eq!(float32(bodies, "z_m")[row], pellet.position[2]);
            assert_eq!(float32(bodies, "force_n")[row], pellet.force);
            row += 1;
        }
    }
    assert_eq!(row, bodies.rows());
    assert_eq!(row, 6 * 60);
}

#[test]
fn hits_have_the_names_of_their_walls_and_a_partner_only_where_it_is_a_pellet() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record_hits(directory.path(), 1.0);
    let tables = read(directory.path());
    let table = tables.get("hits").expect("hits were followed");
    let recorded = read_hits(directory.path().join("run.mcap")).expect("hits were followed");
    assert_eq!(table.rows(), recorded.hits.len());
    let mut walls = 0;
    for (row, hit) in recorded.hits.iter().enumerate() {
        assert_eq!(float64(table, "peak_force_n")[row], hit.peak_force);
        assert_eq!(label(table, "cause", row), Some(hit.cause.name()));
        let partner = table.column("partner").expect("it is a column");
        match hit.partner {
            HitPartner::Wall(wall) => {
                walls += 1;
                assert_eq!(
                    label(table, "wall", row),
                    Some(recorded.walls[wall].as_str())
                );
                assert!(!partner.is_known(row));
            }
            HitPartner::Pellet { .. } => {
                assert_eq!(label(table, "wall", row), None);
                assert!(partner.is_known(row));
            }
        }
    }
    assert!(walls > 0, "pellets fall onto the cone");
    assert!(walls < table.rows(), "pellets meet each other");
}

#[test]
fn hit_classes_are_the_last_sketch_and_count_every_hit() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record_hits(directory.path(), 1.0);
    let tables = read(directory.path());
    let table = tables.get("hit_classes").expect("hits were followed");
    let recorded = read_hits(directory.path().join("run.mcap")).expect("hits were followed");
    let Values::UInt64(counts) = &table.column("count").expect("it is a column").values else {
        panic!("counts are whole");
    };
    let expected: u64 = recorded.classes.values().map(|class| class.count).sum();
    assert_eq!(counts.iter().sum::<u64>(), expected);
}

#[test]
fn meters_and_ledgers_end_where_the_summary_does() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let summary = record_hits(directory.path(), 1.0);
    let tables = read(directory.path());
    let last = |table: &str, column: &str| {
        let table = tables.get(table).expect("the table is there");
        *float64(table, column).last().expect("it has rows")
    };
    assert_eq!(last("mass_ledger", "inside_kg"), summary.mass.inside);
    assert_eq!(last("energy_ledger", "kinetic_j"), summary.energy.kinetic_j);
    assert_eq!(last("meters/outflow", "mass_kg"), summary.mass.discharged);
    assert!(summary.mass.discharged > 0.0, "the gate has opened");
}

#[test]
fn a_run_that_followed_no_hits_has_no_table_of_them_and_only_what_is_asked_for_is_read() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.05);
    let tables = read(directory.path());
    assert!(tables.get("hits").is_none());
    assert!(tables.get("hit_classes").is_none());
    assert_eq!(tables.facts["scene"], "hopper");
    let path = directory.path().join("run.mcap");
    let tables = read_tables(path, &[TableKind::Events]).expect("the recording opens");
    assert_eq!(tables.tables.len(), 1);
    let events = tables.get("events").expect("a run tells of its beginning");
    assert_eq!(label(events, "level", 0), Some("information"));
}

#[test]
fn of_a_recording_that_is_cut_off_the_tables_hold_the_beginning() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.05);
    let whole = read(directory.path());
    assert!(!whole.is_cut_off);
    let path = directory.path().join("run.mcap");
    let bytes = fs::read(&path).expect("a run leaves a recording");
    for share in 1..10 {
        fs::write(&path, &bytes[..bytes.len() * share / 10]).expect("a file can be written");
        let cut = read(directory.path());
        assert!(cut.is_cut_off, "{share}0 %");
        for table in &cut.tables {
            let all = whole.get(&table.name).expect("a cut adds no table");
            assert!(table.rows() <= all.rows());
            assert_eq!(table.columns.len(), all.columns.len());
        }
    }
}

#[test]
fn contacts_are_those_that_the_step_before_each_frame_found() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.3);
    let tables = read(directory.path());
    let contacts = tables.get("contacts").expect("they were asked for");
    let (time, mut row) = (float64(contacts, "time_s"), 0);
    let mut again = simulation(setup(60));
    again.show_contacts(true);
    for frame in read_frames(directory.path().join("run.mcap")).expect("it opens") {
        let frame = frame.expect("frames can be read");
        let steps = (frame.time / again.model().time_step().seconds).round() as u64;
        again
            .advance(steps - again.step_count())
            .expect("the hopper is sound");
        let mut expected: Vec<_> = again.contacts().into_iter().flatten().collect();
        expected.sort_unstable_by(ContactView::by_number);
        for contact in expected {
            assert_eq!(time[row], frame.time);
            assert_is_told(&contact, contacts, row);
            row += 1;
        }
    }
    assert_eq!(row, contacts.rows());
    let with_walls = (0..row).filter(|&row| label(contacts, "wall", row).is_some());
    let with_walls = with_walls.count();
    assert!(
        with_walls > 20 && row - with_walls > 20,
        "{with_walls} of {row}"
    );
}

/// A row of the table tells a contact, to the digits that are recorded.
fn assert_is_told(contact: &ContactView, table: &Table, row: usize) {
    assert_eq!(uint32(table, "pellet")[row], contact.pellet);
    let partner = table.column("partner").expect("it is there");
    let wall = label(table, "wall", row);
    match contact.partner {
        ContactPartner::Pellet(id) => {
            assert!(partner.is_known(row) && uint32(table, "partner")[row] == id);
            assert_eq!(wall, None);
        }
        ContactPartner::Wall(index) => {
            assert!(!partner.is_known(row));
            assert_eq!(wall, Some(["cone", "gate", "paddle"][index]));
        }
    }
    let value = |column: &str| f64::from(float32(table, column)[row]);
    for (axis, name) in ["x_m", "y_m", "z_m"].into_iter().enumerate() {
        // A thousandth of the radius.
        assert!((value(name) - contact.point[axis]).abs() < 1.0e-3 * contact.radius);
    }
    for (name, expected) in [
        ("normal_force_n", contact.normal_force),
        ("force_x_n", contact.force.x),
        ("force_y_n", contact.force.y),
        ("force_z_n", contact.force.z),
        ("overlap_m", contact.overlap),
    ] {
        // One part in eight thousand.
        let error = (value(name) - expected).abs();
        assert!(error <= 1.3e-4 * expected.abs(), "{name}: {error}");
    }
}

/// Rows of a wall.
fn rows_of<'a>(table: &'a Table, wall: &'a str) -> impl Iterator<Item = usize> + 'a {
    (0..table.rows()).filter(move |&row| label(table, "wall", row) == Some(wall))
}

/// Corners of the pieces of a wall [m].
fn pieces<'a, const N: usize>(
    table: &'a Table,
    wall: &'a str,
) -> impl Iterator<Item = [Point3<f64>; N]> + 'a {
    let corner = |row: usize, number: usize| {
        let along = |axis: &str| f64::from(float32(table, &format!("{axis}{number}_m"))[row]);
        Point3::new(along("x"), along("y"), along("z"))
    };
    rows_of(table, wall).map(move |row| std::array::from_fn(|index| corner(row, index + 1)))
}

#[test]
fn a_row_of_the_walls_is_a_change_of_one() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.1);
    let tables = read(directory.path());
    let walls = tables.get("walls").expect("walls are always recorded");
    let time = float64(walls, "time_s");
    let is_present = match &walls.column("is_present").expect("it is there").values {
        Values::Bool(values) => values,
        other => panic!("{other:?}"),
    };
    let rows = |wall| rows_of(walls, wall).collect::<Vec<_>>();
    let cone = rows("cone");
    assert_eq!(cone.len(), 1, "it stays");
    assert!(is_present[cone[0]] && time[cone[0]] == 0.0);

    let [before, after] = rows("gate")[..] else {
        panic!("it is there, and opens once");
    };
    assert!(is_present[before] && time[before] == 0.0);
    assert!(!is_present[after]);
    // Told by the first frame from then on.
    assert!((GATE_OPENS..GATE_OPENS + 0.01).contains(&time[after]));

    let paddle = rows("paddle");
    assert!(
        paddle.len() > 10,
        "it turns between any two of eleven frames"
    );
    for row in paddle {
        // It turns by 6 rad/s about an upright axis through the origin, in single precision.
        let half = 3.0 * time[row];
        let expected = [0.0, 0.0, 0.0, 0.0, 0.0, half.sin(), half.cos()];
        for (name, expected) in ["x_m", "y_m", "z_m", "qx", "qy", "qz", "qw"]
            .into_iter()
            .zip(expected)
        {
            let found = f64::from(float32(walls, name)[row]);
            assert!((found - expected).abs() < 1.0e-6, "{name} {found}");
        }
    }
}

#[test]
fn triangles_and_edges_of_a_box_have_its_surface_and_the_lengths_of_its_sides() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.01);
    let tables = read(directory.path());
    let table = |name| tables.get(name).expect("walls are always recorded");
    let sides = [0.2, 0.008, 0.04];
    let area: f64 = pieces::<3>(table("wall_triangles"), "paddle")
        .map(|[a, b, c]| 0.5 * (b - a).cross(&(c - a)).norm())
        .sum();
    let [a, b, c] = sides;
    let expected = 2.0 * (a * b + b * c + c * a);
    // Corners are rounded to single precision, 2e-8 m of half a meter, across sides of 8 mm.
    assert!((area / expected - 1.0).abs() < 1.0e-5, "{area} m²");
    let length: f64 = pieces::<2>(table("wall_edges"), "paddle")
        .map(|[from, to]| (to - from).norm())
        .sum();
    let expected = 4.0 * sides.iter().sum::<f64>();
    assert!((length / expected - 1.0).abs() < 1.0e-5, "{length} m");
}

#[test]
fn one_kind_of_walls_is_read_without_the_others() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.01);
    let path = directory.path().join("run.mcap");
    let tables = read_tables(path, &[TableKind::WallEdges]).expect("the recording opens");
    let names: Vec<_> = tables.tables.iter().map(|table| &table.name).collect();
    assert_eq!(names, ["wall_edges"]);
}
