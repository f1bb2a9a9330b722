//! One setting of a scene that is varied: how fast pellets come in, or the value of a key.

use crate::overrides::{Override, OverrideError};
use crate::scene::Scene;
use pelletflow_core::Vec3;

/// What is varied, and how a value of it is set.
///
/// ```
/// use pelletflow_scene::Setting;
///
/// let angle = Setting::of_key("walls.plate.motion.angle", "deg");
/// assert_eq!(angle.set(30.0)?.to_string(), "walls.plate.motion.angle=\"30.0 deg\"");
/// # Ok::<(), pelletflow_scene::OverrideError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// Dotted key of the scene.
    pub key: String,
    /// Unit of its values, as it is written; empty for SI.
    pub unit: String,
    /// Direction of a velocity, whose size is varied.
    direction: Option<[f64; 3]>,
}

/// A scene that does not tell what is varied.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the scene has {} ways in for pellets; say which key is varied, for example {}", .ways_in.len(), example(.ways_in))]
pub struct SettingError {
    /// Keys of the velocities at which pellets come in.
    pub ways_in: Vec<String>,
}

fn example(ways_in: &[String]) -> String {
    if ways_in.is_empty() {
        "walls.plate.motion.angle".into()
    } else {
        format!("one of: {}", ways_in.join(", "))
    }
}

impl Setting {
    /// A key of a scene, or the velocity at which its pellets come in, where there is one way in and no key is given.
    ///
    /// Of a velocity the size is varied and the direction kept: straight down where it is none.
    ///
    /// # Errors
    /// No key is given, and the scene has no way in or several.
    pub fn of_scene(scene: &Scene, key: Option<&str>, unit: &str) -> Result<Self, SettingError> {
        let mut velocities = velocities(scene);
        let place = match key {
            Some(key) => velocities.iter().position(|(known, _)| known == key),
            None if velocities.len() == 1 => Some(0),
            None => {
                let ways_in = velocities.into_iter().map(|(key, _)| key).collect();
                return Err(SettingError { ways_in });
            }
        };
        let Some(place) = place else {
            return Ok(Self::of_key(key.unwrap_or_default(), unit));
        };
        let (key, direction) = velocities.swap_remove(place);
        Ok(Self {
            key,
            unit: if unit.is_empty() { "m/s" } else { unit }.into(),
            direction: Some(direction),
        })
    }

    /// A key whose value is one number.
    pub fn of_key(key: &str, unit: &str) -> Self {
        Self {
            key: key.into(),
            unit: unit.into(),
            direction: None,
        }
    }

    /// What gives a scene a value of it [the setting's unit].
    ///
    /// # Errors
    /// The key is no dotted key.
    pub fn set(&self, value: f64) -> Result<Override, OverrideError> {
        let written = |value: f64| {
            if self.unit.is_empty() {
                format!("{value:?}")
            } else {
                format!("\"{value:?} {}\"", self.unit)
            }
        };
        let text = match self.direction {
            Some(direction) => {
                let parts = direction.map(|part| written(part * value));
                format!("[{}]", parts.join(", "))
            }
            None => written(value),
        };
        format!("{}={text}", self.key).parse()
    }

    /// What it is called: of a velocity its size.
    pub fn name(&self) -> String {
        match self.direction {
            Some(_) => format!("size of {}", self.key),
            None => self.key.clone(),
        }
    }
}

/// Keys of the velocities at which pellets come in, and their directions; straight down where there is none.
fn velocities(scene: &Scene) -> Vec<(String, [f64; 3])> {
    let direction = |velocity: Vec3| {
        let along = velocity
            .try_normalize(0.0)
            .or_else(|| scene.setup.gravity.try_normalize(0.0))
            .unwrap_or(-Vec3::z());
        [along.x, along.y, along.z]
    };
    let fills = scene.setup.fills.iter();
    let fills = fills.map(|fill| {
        let key = format!("fill.{}.velocity", fill.name);
        (key, direction(fill.velocity))
    });
    let inlets = scene.setup.inlets.iter();
    let inlets = inlets.map(|inlet| {
        let key = format!("inlets.{}.velocity", inlet.name);
        (key, direction(inlet.velocity))
    });
    fills.chain(inlets).collect()
}
