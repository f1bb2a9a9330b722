//! How the faces of a solid bound it: a tree of "inside all" and "inside any".

/// A face by its number, or several trees together.
///
/// It holds no "outside": a shape that is cut away is turned inside out, face by face.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Tree {
    /// Inside one face.
    Face(usize),
    /// Inside all; of none, everywhere.
    All(Vec<Tree>),
    /// Inside any; of none, nowhere.
    Any(Vec<Tree>),
}

impl Tree {
    /// How far outside a point is, from how far it is outside each face; negative inside.
    pub(super) fn value(&self, faces: &[f64]) -> f64 {
        match self {
            Self::Face(index) => faces[*index],
            Self::All(of) => of
                .iter()
                .map(|tree| tree.value(faces))
                .fold(f64::NEG_INFINITY, f64::max),
            Self::Any(of) => of
                .iter()
                .map(|tree| tree.value(faces))
                .fold(f64::INFINITY, f64::min),
        }
    }

    /// The same of faces that are turned inside out.
    pub(super) fn reversed(self) -> Self {
        let all = |of: Vec<Self>| of.into_iter().map(Self::reversed).collect();
        match self {
            Self::Face(index) => Self::Face(index),
            Self::All(of) => Self::Any(all(of)),
            Self::Any(of) => Self::All(all(of)),
        }
    }

    /// Inside both or all of several; of what is turned inside out, any.
    pub(super) fn common(of: Vec<Self>, is_reversed: bool) -> Self {
        if is_reversed {
            Self::Any(of)
        } else {
            Self::All(of)
        }
    }
}
