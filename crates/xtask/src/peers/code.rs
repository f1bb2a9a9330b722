//! The codes that are compared with, each with the law that it works out.

/// A code with a law.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Code {
    /// LAMMPS, Hertz and Mindlin in the older style, with a damping of its own.
    LammpsHertzHistory,
    /// LAMMPS, Hertz and Mindlin in the newer style, damped as Tsuji et al. (1992).
    LammpsGranular,
    /// LAMMPS, springs with history.
    LammpsHookeHistory,
    /// LIGGGHTS, Hertz and Mindlin, damped as Tsuji et al.
    Liggghts,
}

/// A program that a code is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Program {
    Lammps,
    Liggghts,
}

impl Code {
    /// As the table calls it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::LammpsHertzHistory => "LAMMPS gran/hertz/history",
            Self::LammpsGranular => "LAMMPS granular",
            Self::LammpsHookeHistory => "LAMMPS gran/hooke/history",
            Self::Liggghts => "LIGGGHTS",
        }
    }

    /// The program that it is in.
    pub(crate) fn program(self) -> Program {
        match self {
            Self::LammpsHertzHistory | Self::LammpsGranular | Self::LammpsHookeHistory => {
                Program::Lammps
            }
            Self::Liggghts => Program::Liggghts,
        }
    }

    /// Name of its input files.
    pub(crate) fn file_stem(self) -> &'static str {
        match self {
            Self::LammpsHertzHistory => "lammps-hertz-history",
            Self::LammpsGranular => "lammps-granular",
            Self::LammpsHookeHistory => "lammps-hooke-history",
            Self::Liggghts => "liggghts",
        }
    }

    /// Whether its restitution is the one asked for, so that what it computes can be compared.
    pub(crate) fn has_the_same_law(self) -> bool {
        self != Self::LammpsHertzHistory
    }
}
