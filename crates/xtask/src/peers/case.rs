//! The cases, each with what it has to reach.

use super::code::Code;
use super::race::{Floor, Length};

/// A comparison.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Case {
    pub(crate) name: &'static str,
    pub(crate) kind: Kind,
    pub(crate) target: Target,
    /// Length of a run.
    pub(crate) length: Length,
    /// Whether it belongs to a quick pass.
    pub(crate) is_quick: bool,
}

/// What is compared.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Kind {
    /// The same scene in ours and in other codes.
    Codes {
        scene: &'static str,
        cores: usize,
        floor: Floor,
        codes: &'static [Code],
        accuracy: Accuracy,
    },
    /// Two threads over one.
    Threads { scene: &'static str },
    /// Time per pellet and step of a scene over that of another, or the inverse where it is a speed.
    Scenes {
        scene: &'static str,
        other: &'static str,
        figure: Figure,
    },
    /// Peak memory per pellet.
    Memory { scene: &'static str },
    /// Time of a step with one free pellet.
    FreePellet { scene: &'static str },
}

/// Which way a comparison of two scenes is told.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Figure {
    Speed,
    Cost,
}

/// What is wrong with an answer is measured by this.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Accuracy {
    /// Kinetic energy that a bed at rest has left.
    Rest,
    /// Difference of the pellets that left, counted over so many steps.
    Discharge { steps: u64 },
    /// Difference of the kinetic energies.
    Motion,
}

/// A bound of the measured figure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Target {
    /// At least so many times as fast.
    AtLeast(f64),
    /// At most so much, in a unit.
    AtMost(f64, &'static str),
}

impl Target {
    /// Whether a figure is within it.
    pub(crate) fn is_met(self, figure: f64) -> bool {
        match self {
            Self::AtLeast(least) => figure >= least,
            Self::AtMost(most, _) => figure <= most,
        }
    }
}

const HERTZ: &[Code] = &[
    Code::LammpsHertzHistory,
    Code::LammpsGranular,
    Code::Liggghts,
];
const HOOKE: &[Code] = &[Code::LammpsHookeHistory];

/// Steps over which pellets that leave are counted: half a second, a fifth of one for the large silo.
const COUNTED: [u64; 2] = [25_000, 10_000];

/// All cases, in the order of the table.
pub(crate) const ALL: [Case; 17] = [
    settled("settled-10k-1-core", "silo-10k", 1),
    settled("settled-50k-1-core", "silo-50k", 1),
    settled("settled-10k-2-cores", "silo-10k", 2),
    settled("settled-50k-2-cores", "silo-50k", 2),
    discharging("discharging-10k-1-core", "silo-10k", 1, COUNTED[0]),
    discharging("discharging-50k-1-core", "silo-50k", 1, COUNTED[1]),
    discharging("discharging-10k-2-cores", "silo-10k", 2, COUNTED[0]),
    discharging("discharging-50k-2-cores", "silo-50k", 2, COUNTED[1]),
    chute("chute-32k-1-core", 1),
    chute("chute-32k-2-cores", 2),
    resting("resting-50k-1-core", "jet-50k", 1),
    resting("resting-50k-2-cores", "jet-50k", 2),
    Case {
        name: "threads-50k",
        kind: Kind::Threads { scene: "silo-50k" },
        target: Target::AtLeast(1.8),
        length: Length {
            warm: 200,
            steps: 500,
        },
        is_quick: false,
    },
    Case {
        name: "sizes-1-to-10-100k",
        kind: Kind::Scenes {
            scene: "sizes-100k",
            other: "bed-100k",
            figure: Figure::Speed,
        },
        target: Target::AtLeast(0.5),
        length: Length {
            warm: 50,
            steps: 200,
        },
        is_quick: false,
    },
    Case {
        name: "cost-1000k-over-10k",
        kind: Kind::Scenes {
            scene: "bed-1000k",
            other: "bed-10k",
            figure: Figure::Cost,
        },
        target: Target::AtMost(2.0, ""),
        length: Length {
            warm: 10,
            steps: 50,
        },
        is_quick: false,
    },
    Case {
        name: "memory-1000k",
        kind: Kind::Memory { scene: "bed-1000k" },
        target: Target::AtMost(1000.0, "B"),
        length: Length { warm: 5, steps: 20 },
        is_quick: false,
    },
    Case {
        name: "free-pellet",
        kind: Kind::FreePellet {
            scene: "free-pellet",
        },
        target: Target::AtMost(0.2, "µs"),
        length: Length {
            warm: 0,
            steps: 1_000_000,
        },
        is_quick: true,
    },
];

const fn settled(name: &'static str, scene: &'static str, cores: usize) -> Case {
    Case {
        name,
        kind: Kind::Codes {
            scene,
            cores,
            floor: Floor::Closed,
            codes: HERTZ,
            accuracy: Accuracy::Rest,
        },
        target: Target::AtLeast(2.5),
        length: LONG,
        is_quick: is_small(scene),
    }
}

const fn discharging(name: &'static str, scene: &'static str, cores: usize, counted: u64) -> Case {
    Case {
        name,
        kind: Kind::Codes {
            scene,
            cores,
            floor: Floor::Opens,
            codes: HERTZ,
            accuracy: Accuracy::Discharge { steps: counted },
        },
        target: Target::AtLeast(2.5),
        // The bed begins to flow from the outlet on; the small one flows throughout before the end.
        length: Length {
            warm: 200,
            steps: if is_small(scene) { 2000 } else { 1000 },
        },
        is_quick: is_small(scene),
    }
}

const fn chute(name: &'static str, cores: usize) -> Case {
    Case {
        name,
        kind: Kind::Codes {
            scene: "chute-32k",
            cores,
            floor: Floor::Closed,
            codes: HOOKE,
            accuracy: Accuracy::Motion,
        },
        target: Target::AtLeast(1.5),
        // Pellets start with the mean of their layer and need about this long to scatter.
        length: Length {
            warm: 2000,
            steps: 1000,
        },
        is_quick: false,
    }
}

const fn resting(name: &'static str, scene: &'static str, cores: usize) -> Case {
    Case {
        name,
        kind: Kind::Codes {
            scene,
            cores,
            floor: Floor::Closed,
            codes: HERTZ,
            accuracy: Accuracy::Motion,
        },
        target: Target::AtLeast(10.0),
        length: LONG,
        is_quick: false,
    }
}

const LONG: Length = Length {
    warm: 500,
    steps: 1000,
};

/// Whether a scene has ten thousand pellets.
const fn is_small(scene: &str) -> bool {
    let name = scene.as_bytes();
    // `-10k` is at the end of the name.
    name[name.len() - 3] == b'1' && name[name.len() - 2] == b'0'
}

/// The cases of these names, or all, or the quick ones.
pub(crate) fn chosen(names: &[String], is_quick: bool) -> Vec<Case> {
    let is_asked = |case: &&Case| {
        if names.is_empty() {
            case.is_quick || !is_quick
        } else {
            names.iter().any(|name| name == case.name)
        }
    };
    ALL.iter().filter(is_asked).copied().collect()
}

/// Names of all cases.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    ALL.iter().map(|case| case.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quick_pass_has_the_small_cases_only() {
        let quick: Vec<_> = chosen(&[], true).iter().map(|case| case.name).collect();
        assert_eq!(quick.len(), 5, "{quick:?}");
        assert!(
            quick
                .iter()
                .all(|name| !name.contains("50k") && !name.contains("00k"))
        );
        assert_eq!(chosen(&[], false).len(), ALL.len());
        assert_eq!(chosen(&["threads-50k".into()], true)[0].name, "threads-50k");
    }

    #[test]
    fn a_target_bounds_from_its_side() {
        assert!(Target::AtLeast(2.5).is_met(2.5) && !Target::AtLeast(2.5).is_met(2.4));
        assert!(Target::AtMost(0.2, "µs").is_met(0.1) && !Target::AtMost(0.2, "µs").is_met(0.3));
    }
}
