//! What a wall is made of: the one place that knows solids from meshes.

use pelletflow_broadphase::{BakedMesh, MeshTree};
use pelletflow_core::solid::MOST_TOUCHES;
use pelletflow_core::{Bounds, Shape, ShapeError, Solid, Surface, Touches, TriangleMesh, Vec3};
use std::sync::Arc;

/// Share of the size of a mesh by which its nearest triangle may lie beyond the nearest distance [-].
const ROUNDING: f64 = 1.0e-9;

/// What a wall is made of, in its own frame; a clone shares the triangles.
#[derive(Debug, Clone)]
pub enum WallShape {
    /// A solid by its signed distance.
    Solid(Shape),
    /// Thin sheets of triangles, touched from both sides.
    Mesh(Arc<MeshTree>),
    /// A closed sheet of triangles, touched at the nearest point by its grid of distances.
    Baked(Arc<BakedMesh>),
}

impl WallShape {
    /// A box about it [m].
    pub fn bounds(&self) -> Bounds {
        match self {
            Self::Solid(shape) => shape.bounds(),
            Self::Mesh(tree) => tree.mesh().bounds(),
            Self::Baked(baked) => baked.mesh().bounds(),
        }
    }

    /// Distance of a point [m]: negative inside a solid, never negative from a mesh, and of its triangles if it is baked [m].
    pub fn distance(&self, point: Vec3) -> f64 {
        match self {
            Self::Solid(shape) => shape.distance(point),
            Self::Mesh(tree) => tree.distance(point),
            Self::Baked(baked) => baked.tree().distance(point),
        }
    }

    /// The surface nearest to a point [m].
    ///
    /// # Panics
    /// Only for a mesh and a point that is not a number.
    pub fn surface(&self, point: Vec3) -> Surface {
        match self {
            Self::Solid(shape) => shape.surface(point),
            Self::Mesh(tree) => nearest_surface(tree, point),
            Self::Baked(baked) => nearest_surface(baked.tree(), point),
        }
    }

    /// Itself, but a baked mesh as its triangles.
    pub(crate) fn unbaked(&self) -> Self {
        match self {
            Self::Baked(baked) => Self::Mesh(Arc::clone(baked.tree())),
            shape => shape.clone(),
        }
    }

    /// Its triangles, where it is a mesh.
    pub fn mesh(&self) -> Option<&TriangleMesh> {
        match self {
            Self::Solid(_) => None,
            Self::Mesh(tree) => Some(tree.mesh()),
            Self::Baked(baked) => Some(baked.mesh()),
        }
    }

    /// The kind of its first part with a curved face; of a mesh, none.
    pub(crate) fn curved_part(&self) -> Option<&'static str> {
        match self {
            Self::Solid(shape) => shape.curved_part(),
            Self::Mesh(_) | Self::Baked(_) => None,
        }
    }

    /// Whether its numbers make a shape; a mesh has been made sure of before.
    pub(crate) fn validate(&self) -> Result<(), ShapeError> {
        match self {
            Self::Solid(shape) => shape.validate(),
            Self::Mesh(_) | Self::Baked(_) => Ok(()),
        }
    }

    /// Whether it is nearer than `reach` [m] to a point [m]; of a mesh, the triangles that are go to `triangles`.
    pub(crate) fn is_near(&self, point: Vec3, reach: f64, triangles: &mut Vec<u32>) -> bool {
        match self {
            Self::Solid(shape) => shape.distance(point) < reach,
            Self::Mesh(tree) => {
                let before = triangles.len();
                tree.triangles_near(point, reach, triangles);
                triangles.len() > before
            }
            Self::Baked(baked) => baked.is_near(point, reach),
        }
    }
}

impl WallShape {
    /// False only where no point of a ball of radius `reach` [m] about `point` [m] is on the surface or inside.
    pub(crate) fn may_be_near(&self, point: Vec3, reach: f64) -> bool {
        match self {
            Self::Solid(shape) => shape.distance(point) < reach,
            Self::Mesh(tree) => tree.distance(point) < reach,
            // Its bounds are all that is cheap: its distances are off by a share of a cell.
            Self::Baked(_) => true,
        }
    }
}

impl PartialEq for WallShape {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Solid(shape), Self::Solid(other)) => shape == other,
            (Self::Mesh(tree), Self::Mesh(other)) => tree.mesh() == other.mesh(),
            (Self::Baked(baked), Self::Baked(other)) => baked == other,
            _ => false,
        }
    }
}

impl From<Shape> for WallShape {
    fn from(shape: Shape) -> Self {
        Self::Solid(shape)
    }
}

impl From<TriangleMesh> for WallShape {
    fn from(mesh: TriangleMesh) -> Self {
        Self::Mesh(Arc::new(MeshTree::new(mesh)))
    }
}

impl From<BakedMesh> for WallShape {
    fn from(baked: BakedMesh) -> Self {
        Self::Baked(Arc::new(baked))
    }
}

/// The surface of triangles nearest to a point.
fn nearest_surface(tree: &MeshTree, point: Vec3) -> Surface {
    let reach = tree.distance(point) + ROUNDING * tree.mesh().size();
    let mut triangles = Vec::new();
    tree.triangles_near(point, reach, &mut triangles);
    let touches = tree.mesh().touches(&triangles, point, reach);
    *touches
        .as_slice()
        .first()
        .expect("the nearest triangle is within reach")
}

/// What a wall is made of, ready to be touched.
#[derive(Debug, Clone)]
pub(crate) enum Touchable {
    /// A solid taken apart.
    Solid(Solid),
    /// Triangles, of which a pellet is told those near it.
    Mesh(TriangleMesh),
    /// A grid of distances.
    Baked(Arc<BakedMesh>),
}

impl Touchable {
    pub(crate) fn new(shape: &WallShape) -> Self {
        match shape {
            WallShape::Solid(shape) => Self::Solid(Solid::new(shape)),
            WallShape::Mesh(tree) => Self::Mesh(tree.mesh().clone()),
            WallShape::Baked(baked) => Self::Baked(Arc::clone(baked)),
        }
    }

    /// Contacts that a pellet may have with it at the same time [-].
    pub(crate) fn most_touches(&self) -> usize {
        match self {
            Self::Solid(solid) if !solid.is_touched_at_many() => 1,
            Self::Baked(_) => 1,
            _ => MOST_TOUCHES,
        }
    }

    pub(crate) fn is_mesh(&self) -> bool {
        matches!(self, Self::Mesh(_))
    }

    /// Where a ball of radius `reach` [m] about `center` [m] touches; of a mesh, among the triangles named.
    pub(crate) fn touches(&self, center: Vec3, reach: f64, triangles: &[u32]) -> Touches {
        match self {
            Self::Solid(solid) => solid.touches(center, reach),
            Self::Mesh(mesh) => mesh.touches(triangles, center, reach),
            Self::Baked(baked) => {
                let mut touches = Touches::none(reach);
                if let Some(surface) = baked.surface_within(center, reach) {
                    touches.offer(surface);
                }
                touches
            }
        }
    }
}
