//! The step at which each case breaks, beside theory.

use crate::case::{Case, Trial};
use crate::{bodies, motions, piles};
use pelletflow::log::plot::{Axis, Chart, Series, SeriesStyle};
use pelletflow::sim::Setup;
use std::path::Path;

/// Factor from one step of the sweep to the next [-].
const RATIO: f64 = std::f64::consts::SQRT_2;
/// The sweep goes from the default step to 32 times it, in powers of the ratio [-].
const POWERS: std::ops::RangeInclusive<i32> = 0..=10;
/// The picture, in the folder that cargo gives to tests.
const PICTURE: &str = "where-the-step-breaks.svg";

/// Ends of the lines of the picture, in Rayleigh times: the contacts of the cases last from one to ten [-].
const DECADE: [f64; 2] = [1.0, 10.0];
/// Largest stable step of a leapfrog over the time of an elastic contact [-]: 2/ω at the stiffest, where
/// ω = 4.03 over that time, from k = 15/8 m v²/δ² and a time of 2.943 δ/v at the greatest overlap δ.
const STABLE: f64 = 2.0 / 4.03;
/// Rayleigh times of the default step at most [-].
const RAYLEIGH_SHARE: f64 = 0.2;
/// Steps per contact of the default step at least [-].
const STEPS_PER_CONTACT: f64 = 12.3;

/// What the sweep found of a case.
struct Found {
    name: &'static str,
    rayleigh_time: f64,
    contact_time: f64,
    default_step: f64,
    /// The first step that breaks it [s] and what broke, if any does.
    broke: Option<(f64, String)>,
}

impl Found {
    fn of(case: &Case) -> Self {
        let mut found = Self {
            name: case.name,
            rayleigh_time: rayleigh_time(&(case.setup)()),
            contact_time: f64::NAN,
            default_step: f64::NAN,
            broke: None,
        };
        for power in POWERS {
            let factor = RATIO.powi(power);
            let Trial {
                step,
                contact_time,
                broke,
            } = case.run(1.0, factor);
            found.contact_time = contact_time;
            found.default_step = step / factor;
            if let Some(what) = broke {
                found.broke = Some((step, what));
                break;
            }
        }
        found
    }

    /// A step of this case, as a point of the picture.
    fn point(&self, step: f64) -> [f64; 2] {
        [
            self.contact_time / self.rayleigh_time,
            step / self.rayleigh_time,
        ]
    }
}

/// The shortest Rayleigh time of the pellets [s].
fn rayleigh_time(setup: &Setup) -> f64 {
    let times = setup.pellets.iter().map(|kind| {
        let material = setup.materials[kind.material].material;
        material.rayleigh_time(0.5 * kind.size.min_diameter())
    });
    times.fold(f64::INFINITY, f64::min)
}

#[test]
#[ignore = "minutes; `cargo xtask stress` runs it"]
#[expect(
    clippy::print_stdout,
    reason = "what a test found is told on its standard output"
)]
fn every_case_breaks_beyond_its_default_step() {
    let mut found = Vec::new();
    for case in bodies::CASES
        .iter()
        .chain(&piles::CASES)
        .chain(&motions::CASES)
    {
        let case = Found::of(case);
        let (step, what) = case.broke.clone().unzip();
        let line = serde_json::json!({
            "case": case.name,
            "rayleigh_time_s": case.rayleigh_time,
            "contact_time_s": case.contact_time,
            "default_step_s": case.default_step,
            "broken_step_s": step,
            "what": what,
        });
        println!("broke\t{line}");
        found.push(case);
    }
    let picture = Path::new(env!("CARGO_TARGET_TMPDIR")).join(PICTURE);
    let svg = drawn(&found)
        .to_svg()
        .expect("every step is more than nothing");
    std::fs::write(&picture, svg).expect("cargo gives the folder");
    println!("picture\t{}", picture.display());
    let broken: Vec<_> = found
        .iter()
        .filter(|case| matches!(&case.broke, Some((step, _)) if *step < 1.01 * case.default_step))
        .map(|case| case.name)
        .collect();
    assert!(broken.is_empty(), "broke at the default step: {broken:?}");
}

fn drawn(found: &[Found]) -> Chart {
    let markers = |label: &str, points| Series {
        label: label.into(),
        points,
        style: SeriesStyle::Markers,
    };
    let line = |label: &str, style, at: &dyn Fn(f64) -> f64| Series {
        label: label.into(),
        points: DECADE.map(|x| [x, at(x)]).into(),
        style,
    };
    Chart {
        title: "Where the step breaks".into(),
        x: Axis::logarithmic("time of the shortest contact by Hertz, in Rayleigh times [-]"),
        y: Axis::logarithmic("step, in Rayleigh times [-]"),
        series: vec![
            markers(
                "breaks",
                found
                    .iter()
                    .filter_map(|case| Some(case.point(case.broke.as_ref()?.0)))
                    .collect(),
            ),
            markers(
                "default",
                found
                    .iter()
                    .map(|case| case.point(case.default_step))
                    .collect(),
            ),
            line("one contact is unstable", SeriesStyle::Line, &|x| {
                STABLE * x
            }),
            line("12.3 steps per contact", SeriesStyle::Dashed, &|x| {
                x / STEPS_PER_CONTACT
            }),
            line("0.2 Rayleigh times", SeriesStyle::Dashed, &|_| {
                RAYLEIGH_SHARE
            }),
        ],
    }
}
