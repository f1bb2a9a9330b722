//! The scenes, by name.

use crate::{bed, chute, free, silo, sizes};
use pelletflow::core::Shape;
use pelletflow::sim::{Setup, StepRequest};
use serde_json::{Value, json};

/// A scene that codes are compared in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Scene {
    /// A silo, closed or open below.
    Silo {
        pellets: usize,
        /// Radius of its cylinder [m].
        radius: f64,
    },
    /// A settled silo, and a few pellets that fall on it.
    Jet { pellets: usize, radius: f64 },
    /// A flow down a rough slope without end.
    Chute,
    /// A bed without end: tiles of a settled one, so many along x and y.
    Bed { tiles: [usize; 2] },
    /// A bed without end of sizes from 1 to 10.
    Sizes,
    /// One pellet thrown up.
    Free,
}

/// Names and scenes.
const NAMES: [(&str, Scene); 10] = [
    ("silo-10k", SILO_10K),
    ("silo-50k", SILO_50K),
    ("jet-10k", jet(SILO_10K)),
    ("jet-50k", jet(SILO_50K)),
    ("chute-32k", Scene::Chute),
    ("bed-10k", Scene::Bed { tiles: [1, 1] }),
    ("bed-100k", Scene::Bed { tiles: [5, 2] }),
    ("bed-1000k", Scene::Bed { tiles: [10, 10] }),
    ("sizes-100k", Scene::Sizes),
    ("free-pellet", Scene::Free),
];
const SILO_10K: Scene = Scene::Silo {
    pellets: 10_000,
    radius: 0.15,
};
const SILO_50K: Scene = Scene::Silo {
    pellets: 50_000,
    radius: 0.25,
};

const fn jet(silo: Scene) -> Scene {
    match silo {
        Scene::Silo { pellets, radius } => Scene::Jet { pellets, radius },
        other => other,
    }
}

impl Scene {
    /// The scene of a name.
    pub(crate) fn named(name: &str) -> Result<Self, String> {
        let found = NAMES.iter().find(|(known, _)| *known == name);
        found.map(|(_, scene)| *scene).ok_or_else(|| {
            let known: Vec<&str> = NAMES.iter().map(|(known, _)| *known).collect();
            format!(
                "scene `{name}` is unknown; expected one of {}",
                known.join(", ")
            )
        })
    }

    /// The scene without pellets, its floor closed.
    pub(crate) fn setup(self) -> Setup {
        match self {
            Self::Silo { radius, .. } | Self::Jet { radius, .. } => silo::silo(0, radius),
            Self::Chute => chute::setup(chute::TILES),
            Self::Bed { tiles } => bed::setup(tiles),
            Self::Sizes => sizes::setup(),
            Self::Free => free::setup(),
        }
    }

    /// What another code has to know to set up the same, in SI units.
    pub(crate) fn describe(self) -> Value {
        let setup = self.setup();
        let material = &setup.materials[0].material;
        let pair = &setup.pairs[0].1;
        let step = match setup.step {
            StepRequest::Fixed(seconds) | StepRequest::Unchecked(seconds) => seconds,
            StepRequest::PeakForceError(_) => f64::NAN,
        };
        let bounds = &setup.domain.bounds;
        let place = match self {
            Self::Silo { radius, .. } | Self::Jet { radius, .. } => json!({
                "radius": radius,
                "outlet_radius": silo::OUTLET_RADIUS,
                "cone_height": silo::cone_height(radius),
            }),
            Self::Chute => chute::describe(&setup),
            Self::Bed { .. } | Self::Sizes | Self::Free => json!({}),
        };
        json!({
            "diameter": setup.pellets[0].size.max_diameter(),
            "density": material.density,
            "youngs_modulus": material.youngs_modulus,
            "poisson_ratio": material.poisson_ratio,
            "restitution": pair.restitution,
            "friction": pair.friction,
            "time_step": step,
            "skin": setup.skin,
            "gravity": setup.gravity.as_slice(),
            "box": [bounds.min.as_slice(), bounds.max.as_slice()],
            "place": place,
        })
    }

    /// The region that a settled bed is put down in.
    pub(crate) fn region(self) -> Shape {
        match self {
            Self::Silo { radius, .. } | Self::Jet { radius, .. } => silo::hollow(radius),
            Self::Sizes => sizes::region(),
            _ => bed::region(),
        }
    }
}
