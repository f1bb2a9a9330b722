//! `layout.json`: what Lichtblick and Foxglove show at once when the recording is opened with it.
//!
//! Without a layout these viewers hide every topic at first.

use pelletflow_core::{Bounds, Vec3};
use pelletflow_sim::MeterReading;
use serde_json::{Map, Value, json};

/// Camera's way from what it looks at: to the side, and down by this angle from the zenith [deg].
const CAMERA_ANGLE_FROM_ZENITH: f64 = 70.0;
/// Camera's direction about the vertical [deg].
const CAMERA_ANGLE_ABOUT_VERTICAL: f64 = 30.0;
/// Camera's distance over the diagonal of the scene [-].
const CAMERA_DISTANCE: f64 = 1.3;
/// Vertical field of view [deg].
const FIELD_OF_VIEW: f64 = 45.0;

/// The layout of a scene within `bounds`, where spheres are drawn of at most `spheres_up_to` pellets
/// and `full_speed` [m/s] has the last color.
pub(crate) fn layout(
    bounds: &Bounds,
    meters: &[MeterReading],
    spheres_up_to: usize,
    full_speed: f64,
) -> String {
    let mut panels = Map::new();
    panels.insert(
        "3D!scene".into(),
        scene_panel(bounds, spheres_up_to, full_speed),
    );
    let mut plots = Vec::new();
    for plot in plots_of(meters) {
        let id = format!("Plot!{}", plot.name);
        panels.insert(id.clone(), plot_panel(&plot));
        plots.push(id);
    }
    let value = json!({
        "configById": panels,
        "globalVariables": {},
        "userNodes": {},
        "playbackConfig": { "speed": 1.0 },
        "layout": {
            "direction": "row",
            "first": "3D!scene",
            "second": column(&plots),
            "splitPercentage": 68,
        },
    });
    format!("{value:#}\n")
}

fn scene_panel(bounds: &Bounds, spheres_up_to: usize, full_speed: f64) -> Value {
    let Bounds { min, max } = *bounds;
    let target: Vec3 = (min + max) / 2.0;
    let distance = CAMERA_DISTANCE * (max - min).norm();
    json!({
        "followMode": "follow-none",
        "followTf": "world",
        "fixedFrame": "world",
        "cameraState": {
            "perspective": true,
            "distance": distance,
            "phi": CAMERA_ANGLE_FROM_ZENITH,
            "thetaOffset": CAMERA_ANGLE_ABOUT_VERTICAL,
            "target": [target.x, target.y, target.z],
            "targetOffset": [0, 0, 0],
            "targetOrientation": [0, 0, 0, 1],
            "fovy": FIELD_OF_VIEW,
            "near": distance / 1000.0,
            "far": distance * 100.0,
        },
        "scene": {
            "backgroundColor": "#ffffff",
            // Axes and labels of the walls' frames are drawn far too large.
            "transforms": { "visible": false, "showLabel": false, "axisScale": 0 },
            "labelScaleFactor": 0,
        },
        "transforms": {},
        "layers": {},
        "topics": {
            "/equipment": { "visible": true },
            "/hits/worst": { "visible": true },
            "/pellets/spheres": { "visible": spheres_up_to > 0 },
            // Points hide inside the spheres, and stand in for them where there are too many pellets.
            "/pellets": {
                "visible": true,
                "colorMode": "colormap",
                "colorField": "speed",
                "colorMap": "turbo",
                "minValue": 0,
                "maxValue": full_speed,
                "pointShape": "circle",
                "pointSize": 6,
            },
        },
    })
}

/// A panel of curves over time.
struct Plot {
    name: String,
    title: String,
    /// Paths of the curves, and whether each is shown at first.
    curves: Vec<(String, bool)>,
}

fn plots_of(meters: &[MeterReading]) -> Vec<Plot> {
    let of_ledger = |which: &str, title: &str, fields: &[&str]| Plot {
        name: format!("ledger-{which}"),
        title: title.into(),
        curves: fields
            .iter()
            .map(|field| (format!("/ledger/{which}.{field}"), true))
            .collect(),
    };
    let mut plots: Vec<_> = meters.iter().map(of_meter).collect();
    plots.push(of_ledger(
        "mass",
        "Pellets",
        &["inside", "discharged", "lost"],
    ));
    plots.push(of_ledger(
        "energy",
        "Energy [J]",
        &["kinetic_j", "elastic_j", "residual_j"],
    ));
    plots
}

/// All quantities of a meter; those in the unit of the first are shown at first.
fn of_meter(meter: &MeterReading) -> Plot {
    let unit = |quantity: &str| quantity.rsplit('_').next().map(str::to_owned);
    let first_unit = meter
        .values
        .first()
        .and_then(|(quantity, _)| unit(quantity));
    Plot {
        name: format!("meter-{}", meter.name),
        title: meter.name.clone(),
        curves: meter
            .values
            .iter()
            .map(|(quantity, _)| {
                let path = format!("/meters/{}.{quantity}", meter.name);
                (path, unit(quantity) == first_unit)
            })
            .collect(),
    }
}

fn plot_panel(plot: &Plot) -> Value {
    let paths: Vec<Value> = plot
        .curves
        .iter()
        .map(|(path, is_shown)| {
            json!({ "value": path, "timestampMethod": "receiveTime", "enabled": is_shown })
        })
        .collect();
    json!({
        "title": plot.title,
        "paths": paths,
        "showLegend": true,
        "legendDisplay": "floating",
        "isSynced": true,
        "xAxisVal": "timestamp",
    })
}

/// Panels one above another, each as high as the others.
fn column(panels: &[String]) -> Value {
    match panels {
        [only] => json!(only),
        [first, rest @ ..] => json!({
            "direction": "column",
            "first": first,
            "second": column(rest),
            "splitPercentage": 100.0 / panels.len() as f64,
        }),
        [] => Value::Null,
    }
}
