//! Hits as a chart.

use super::Followed;
use crate::args::impact::View;
use pelletflow_impact::{Impact, ObliqueSample, Sample};
use pelletflow_log::plot::{Axis, Chart, Series, SeriesStyle};

/// Points of a fitted curve [-].
const CURVE_POINTS: u32 = 100;

/// The chart of a view.
pub(super) fn chart(title: &str, view: View, hits: &[Followed]) -> Chart {
    let over_time = |y: &str, value: fn(&Followed, &Sample, &ObliqueSample) -> f64| Chart {
        title: title.to_owned(),
        x: Axis::linear("time [ms]"),
        y: Axis::linear(y),
        series: hits
            .iter()
            .map(|hit| Series {
                label: hit.case.label.clone(),
                points: sliding(&hit.impact)
                    .map(|(sample, oblique)| [sample.time * 1.0e3, value(hit, sample, oblique)])
                    .collect(),
                style: SeriesStyle::Line,
            })
            .collect(),
    };
    match view {
        View::Force => Chart {
            title: title.to_owned(),
            x: Axis::linear("time [ms]"),
            y: Axis::linear("normal force [N]"),
            series: hits.iter().map(force).collect(),
        },
        View::Shape => shape(title, hits),
        View::TangentialSpeed => over_time("speed along the surface [m/s]", |_, _, oblique| {
            oblique.tangential_speed
        }),
        View::HorizontalSpeed => over_time("horizontal speed [m/s]", |hit, sample, oblique| {
            hit.case.arrival.horizontal_speed(sample, oblique)
        }),
        View::Spin => over_time("spin, rolling onward [rad/s]", |_, _, oblique| {
            -oblique.spin
        }),
        View::PeakForce => peak_force(title, hits),
    }
}

fn force(hit: &Followed) -> Series {
    Series {
        label: hit.case.label.clone(),
        points: hit
            .impact
            .samples
            .iter()
            .map(|sample| [sample.time * 1.0e3, sample.force])
            .collect(),
        style: SeriesStyle::Line,
    }
}

/// Samples of an oblique hit; none of another.
fn sliding(impact: &Impact) -> impl Iterator<Item = (&Sample, &ObliqueSample)> {
    let oblique = impact.rebound.iter().flat_map(|rebound| &rebound.samples);
    impact.samples.iter().zip(oblique)
}

fn shape(title: &str, hits: &[Followed]) -> Chart {
    let curve = |label: String, value: &dyn Fn(f64) -> f64| Series {
        label,
        points: taus().map(|tau| [tau, value(tau)]).collect(),
        style: SeriesStyle::Dashed,
    };
    let mut series = Vec::new();
    for Followed { case, impact } in hits {
        series.push(Series {
            label: case.label.clone(),
            points: impact
                .samples
                .iter()
                .map(|sample| {
                    [
                        sample.time / impact.outline.contact_time,
                        sample.force / impact.outline.peak_force,
                    ]
                })
                .collect(),
            style: SeriesStyle::Line,
        });
        let bell = impact.bell;
        let label = format!(
            "bell, ε {:.3}, τ {:.3}",
            bell.shape_parameter, bell.asymmetry
        );
        series.push(curve(label, &|tau| bell.value(tau)));
        let sine = impact.sine;
        let label = format!("sine to the {:.3}", sine.exponent);
        series.push(curve(label, &|tau| sine.value(tau)));
    }
    Chart {
        title: title.to_owned(),
        x: Axis::linear("time over contact time [-]"),
        y: Axis::linear("force over peak force [-]"),
        series,
    }
}

/// Evenly spaced shares of the contact time.
pub(super) fn taus() -> impl Iterator<Item = f64> {
    (0..=CURVE_POINTS).map(|index| f64::from(index) / f64::from(CURVE_POINTS))
}

fn peak_force(title: &str, hits: &[Followed]) -> Chart {
    let mut series: Vec<Series> = Vec::new();
    for Followed { case, impact } in hits {
        let point = [case.arrival.speed, impact.outline.peak_force];
        match series.iter_mut().find(|series| series.label == case.group) {
            Some(series) => series.points.push(point),
            None => series.push(Series {
                label: case.group.clone(),
                points: vec![point],
                style: SeriesStyle::LineWithMarkers,
            }),
        }
    }
    Chart {
        title: title.to_owned(),
        x: Axis::linear("speed of arrival [m/s]"),
        y: Axis::linear("peak force [N]"),
        series,
    }
}
