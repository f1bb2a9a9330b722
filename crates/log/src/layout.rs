//! `layout.json`: what Lichtblick and Foxglove show at once when the recording is opened with it.
//!
//! Without a layout these viewers hide every topic at first.

use crate::message::color;
use crate::tables::{unit_of, words_of};
use pelletflow_core::{Bounds, Vec3};
use pelletflow_sim::{MeterReading, Simulation};
use serde_json::{Map, Value, json};

/// Camera's way from what it looks at: to the side, and down by this angle from the zenith [deg].
const CAMERA_ANGLE_FROM_ZENITH: f64 = 70.0;
/// Camera's direction about the vertical [deg].
const CAMERA_ANGLE_ABOUT_VERTICAL: f64 = 30.0;
/// Camera's distance over the diagonal of what it looks at [-]: nearly all of a cube is seen, and a tower whole.
const CAMERA_DISTANCE: f64 = 1.2;
/// Vertical field of view [deg].
const FIELD_OF_VIEW: f64 = 45.0;
/// Share of the height of the scene's column that the log of the hardest hits has [%].
const LOG_SHARE: f64 = 18.0;
/// Width of a legend [px].
const LEGEND_WIDTH: u32 = 150;
/// The panel of what happened, as both viewers call it.
const LOG_PANEL: &str = "RosOut!hits";

/// What a layout is made for.
pub(crate) struct View<'a> {
    /// What the camera looks at [m].
    pub(crate) bounds: &'a Bounds,
    pub(crate) meters: &'a [MeterReading],
    /// Whether the hardest hits are told.
    pub(crate) has_hits: bool,
    /// Whether pellets are drawn as spheres while there are few.
    pub(crate) has_spheres: bool,
    /// Whether pellets may become too many for spheres.
    pub(crate) has_points: bool,
    /// Speed that has the last color [m/s].
    pub(crate) full_speed: f64,
}

/// The layout of a run.
pub(crate) fn layout(view: &View) -> String {
    let mut panels = Map::new();
    panels.insert("3D!scene".into(), scene_panel(view));
    let mut plots = Vec::new();
    for plot in plots_of(view.meters) {
        let id = format!("Plot!{}", plot.name);
        panels.insert(id.clone(), plot_panel(&plot));
        plots.push(id);
    }
    let mut scene = json!("3D!scene");
    if view.has_hits {
        panels.insert(
            LOG_PANEL.into(),
            titled(
                "Hardest hits so far",
                json!({ "topicToRender": "/hits/worst/log" }),
            ),
        );
        scene = json!({
            "direction": "column",
            "first": scene,
            "second": LOG_PANEL,
            "splitPercentage": 100.0 - LOG_SHARE,
        });
    }
    let value = json!({
        "configById": panels,
        "globalVariables": {},
        "userNodes": {},
        "playbackConfig": { "speed": 1.0 },
        "layout": {
            "direction": "row",
            "first": scene,
            "second": column(&plots),
            "splitPercentage": 68,
        },
    });
    format!("{value:#}\n")
}

/// A box about what is there when a run begins: pellets, and walls that end somewhere; all of the domain where nothing is.
pub(crate) fn bounds_of(simulation: &Simulation) -> Bounds {
    let setup = simulation.model().setup();
    let domain = &setup.domain.bounds;
    let pellets = simulation.pellets().map(|pellet| Bounds {
        min: pellet.position.add_scalar(-pellet.radius),
        max: pellet.position.add_scalar(pellet.radius),
    });
    let walls = simulation.walls().filter_map(|wall| {
        let bounds = setup.walls[wall.index].bounds(&wall.pose);
        bounds.is_finite().then(|| bounds.common(domain))
    });
    let seen = pellets
        .chain(walls)
        .fold(Bounds::nothing(), |seen, bounds| seen.merged(&bounds));
    if (seen.max - seen.min).iter().all(|&side| side > 0.0) {
        seen
    } else {
        *domain
    }
}

fn scene_panel(view: &View) -> Value {
    let Bounds { min, max } = *view.bounds;
    let target: Vec3 = (min + max) / 2.0;
    let distance = CAMERA_DISTANCE * (max - min).norm();
    let [slowest, fastest] = [0.0, 1.0].map(|share| color::in_words(color::on_scale(share)));
    json!({
        "followMode": "follow-none",
        "followTf": "world",
        "fixedFrame": "world",
        "cameraState": {
            "perspective": true,
            "distance": distance,
            "phi": CAMERA_ANGLE_FROM_ZENITH,
            "thetaOffset": CAMERA_ANGLE_ABOUT_VERTICAL,
            // Where the camera looks is told from the frame that it follows.
            "target": [0, 0, 0],
            "targetOffset": [target.x, target.y, target.z],
            "targetOrientation": [0, 0, 0, 1],
            "fovy": FIELD_OF_VIEW,
            "near": distance / 1000.0,
            "far": distance * 100.0,
        },
        "scene": {
            "backgroundColor": "#ffffff",
            // Axes and labels of the walls' frames are drawn far too large.
            "transforms": {
                "visible": false,
                "showLabel": false,
                "axisScale": 0,
                "enablePreloading": true,
            },
            "labelScaleFactor": 1,
        },
        "transforms": {},
        "layers": {},
        "topics": {
            "/equipment": { "visible": true },
            "/hits/worst": { "visible": true },
            "/pellets/spheres": { "visible": view.has_spheres },
            "/contacts": {
                "visible": false,
                "colorMode": "gradient",
                "colorField": "force",
                "gradient": [slowest, fastest],
                "pointShape": "circle",
                "pointSize": 6,
            },
            // Points stand in for spheres where there are too many pellets; seen from afar they would stick out of them.
            "/pellets": {
                "visible": view.has_points,
                "colorMode": "gradient",
                "colorField": "speed",
                "gradient": [slowest, fastest],
                "minValue": 0,
                "maxValue": view.full_speed,
                "pointShape": "circle",
                "pointSize": 6,
            },
        },
    })
}

/// A panel with a title, in the words of both viewers.
fn titled(title: &str, mut panel: Value) -> Value {
    for key in ["lichtblickPanelTitle", "foxglovePanelTitle"] {
        panel[key] = title.into();
    }
    panel
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
        "Pellets [-]",
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
    let first_unit = meter
        .values
        .first()
        .map_or("-", |(quantity, _)| unit_of(quantity));
    Plot {
        name: format!("meter-{}", meter.name),
        title: format!("{} [{first_unit}]", meter.name),
        curves: meter
            .values
            .iter()
            .map(|(quantity, _)| {
                let path = format!("/meters/{}.{quantity}", meter.name);
                (path, unit_of(quantity) == first_unit)
            })
            .collect(),
    }
}

fn plot_panel(plot: &Plot) -> Value {
    let paths: Vec<Value> = plot
        .curves
        .iter()
        .map(|(path, is_shown)| {
            let quantity = path.rsplit('.').next().unwrap_or(path);
            json!({
                "value": path,
                "label": words_of(quantity),
                "timestampMethod": "receiveTime",
                "enabled": is_shown,
            })
        })
        .collect();
    let panel = json!({
        "paths": paths,
        "showLegend": true,
        // Over the curves it would hide them.
        "legendDisplay": "left",
        "sidebarDimension": LEGEND_WIDTH,
        "isSynced": true,
        "xAxisVal": "timestamp",
    });
    titled(&plot.title, panel)
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
