//! Where a wall has a face, an edge, a tip and a corner that a pellet can meet freely.

use super::{GAP, Spot};
use crate::wall_contacts::effective_radius;
use crate::wall_shape::{Touchable, WallShape};
use pelletflow_core::{Bounds, Surface, Touches, TriangleMesh, Vec3};
use std::collections::BTreeMap;

/// Points about a solid at which it is looked at [-].
const SAMPLES: u32 = 4000;
/// Edges and tips of a mesh that are looked at [-].
const LOOKS: usize = 500;
/// Share of a length by which rounding may be off [-].
const ROUNDING: f64 = 1.0e-6;
/// Cosine between faces that count as square to each other [-].
const SQUARE: f64 = 1.0e-3;

/// A place on a wall and a pellet before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub(super) spot: Spot,
    /// The point of the wall that is nearest to the pellet [m].
    pub(super) at: Vec3,
    /// Center of the pellet [m].
    pub(super) start: Vec3,
    /// Direction from the wall to the pellet [-].
    pub(super) way_out: Vec3,
    /// Faces that are met at once [-].
    pub(super) faces: usize,
    /// Of the contact there [m].
    pub(super) effective_radius: f64,
}

/// The first place found for each spot, in the wall's frame, for a pellet of a radius [m]; of a baked mesh, on its triangles.
pub(super) fn find(
    shape: &WallShape,
    radius: f64,
    bounds: &Bounds,
) -> [Option<Place>; Spot::ALL.len()] {
    let shape = &shape.unbaked();
    let finder = Finder {
        shape,
        touchable: Touchable::new(shape),
        radius,
    };
    let mut found = [None; Spot::ALL.len()];
    let mut take = |place: Option<Place>| {
        if let Some(place) = place {
            found[place.spot as usize].get_or_insert(place);
        }
    };
    if let Some(mesh) = shape.mesh() {
        for (spot, at, way_out) in spots(mesh) {
            take(finder.single(spot, at, way_out));
            take(finder.corner(at + 0.5 * radius * way_out));
        }
        return found;
    }
    let about = shape.bounds().common(bounds).grown(2.0 * radius);
    for point in samples(&about) {
        let surface = shape.surface(point);
        if surface.distance > ROUNDING * radius {
            let at = point - surface.distance * surface.normal;
            take(finder.single(spot_of(&surface), at, surface.normal));
            take(finder.corner(point));
        }
    }
    found
}

struct Finder<'a> {
    shape: &'a WallShape,
    touchable: Touchable,
    radius: f64,
}

impl Finder<'_> {
    fn touches(&self, center: Vec3, reach: f64) -> Touches {
        let mut triangles = Vec::new();
        self.shape.is_near(center, reach, &mut triangles);
        self.touchable.touches(center, reach, &triangles)
    }

    /// A pellet before one point of the wall, if it meets that first and no other.
    fn single(&self, spot: Spot, at: Vec3, way_out: Vec3) -> Option<Place> {
        let gap = (1.0 + GAP) * self.radius;
        let start = at + gap * way_out;
        let touches = self.touches(start, (1.0 + 2.0 * GAP) * self.radius);
        let [touch] = touches.as_slice() else {
            return None;
        };
        let is_met = (touch.distance - gap).abs() < ROUNDING * self.radius
            && touch.normal.dot(&way_out) > 1.0 - ROUNDING;
        is_met.then_some(Place {
            spot,
            at,
            start,
            way_out,
            faces: 1,
            effective_radius: effective_radius(self.radius, touch),
        })
    }

    /// A pellet before a corner near a point, at the same distance from two or three flat faces square to each other.
    fn corner(&self, point: Vec3) -> Option<Place> {
        let touches = self.touches(point, 2.0 * self.radius);
        let normals = square_faces(touches.as_slice())?;
        let gap = (1.0 + GAP) * self.radius;
        let start = touches.as_slice().iter().fold(point, |at, touch| {
            at + (gap - touch.distance) * touch.normal
        });
        let again = self.touches(start, (1.0 + 2.0 * GAP) * self.radius);
        let is_met = again.as_slice().len() == normals.len()
            && square_faces(again.as_slice()).is_some()
            && again
                .as_slice()
                .iter()
                .all(|touch| (touch.distance - gap).abs() < ROUNDING * self.radius);
        let way_out = normals.iter().sum::<Vec3>().normalize();
        is_met.then(|| Place {
            spot: Spot::Corner,
            at: normals.iter().fold(start, |at, normal| at - gap * normal),
            start,
            way_out,
            faces: normals.len(),
            effective_radius: self.radius,
        })
    }
}

/// Normals of two or three flat faces, if they are square to each other.
fn square_faces(touches: &[Surface]) -> Option<Vec<Vec3>> {
    let is_flat = |touch: &Surface| touch.principal_curvatures == [0.0; 2];
    let is_square = |(index, touch): (usize, &Surface)| {
        touches[..index]
            .iter()
            .all(|other| other.normal.dot(&touch.normal).abs() < SQUARE)
    };
    let are_square = touches.iter().enumerate().all(is_square) && touches.iter().all(is_flat);
    ((2..=3).contains(&touches.len()) && are_square)
        .then(|| touches.iter().map(|touch| touch.normal).collect())
}

/// What of a solid is nearest, by the curvatures there.
fn spot_of(surface: &Surface) -> Spot {
    let sharp = surface
        .principal_curvatures
        .iter()
        .filter(|curvature| curvature.is_infinite())
        .count();
    [Spot::Face, Spot::Edge, Spot::Tip][sharp]
}

/// Points spread evenly over a box (Roberts 2018, the sequence R3).
fn samples(bounds: &Bounds) -> impl Iterator<Item = Vec3> + '_ {
    const SHARES: Vec3 = Vec3::new(
        0.819_172_513_396_164_4,
        0.671_043_606_703_789_2,
        0.549_700_477_901_970_2,
    );
    let sides = bounds.max - bounds.min;
    (1..=SAMPLES).map(move |index| {
        let share = (f64::from(index) * SHARES).map(f64::fract);
        bounds.min + sides.component_mul(&share)
    })
}

/// Faces, edges and tips of a mesh, the largest first, each with both ways from it.
fn spots(mesh: &TriangleMesh) -> Vec<(Spot, Vec3, Vec3)> {
    let mut faces = Vec::new();
    let mut edges: BTreeMap<[u32; 2], Vec3> = BTreeMap::new();
    let mut tips: BTreeMap<u32, Vec3> = BTreeMap::new();
    for (corners, triangle) in mesh.indices().iter().zip(mesh.triangles()) {
        let area = triangle.area_vector();
        let [a, b, c] = triangle.corners;
        faces.push((Spot::Face, (a + b + c) / 3.0, area));
        for side in 0..3 {
            let (from, to) = (corners[side], corners[(side + 1) % 3]);
            *edges.entry([from.min(to), from.max(to)]).or_default() += area.normalize();
            *tips.entry(from).or_default() += area.normalize();
        }
    }
    faces.sort_by(|a, b| b.2.norm().total_cmp(&a.2.norm()));
    faces.truncate(LOOKS);
    let at = |corner: u32| mesh.vertices()[corner as usize];
    let length = |ends: &[u32; 2]| (at(ends[0]) - at(ends[1])).norm();
    let mut longest: Vec<([u32; 2], Vec3)> = edges.into_iter().collect();
    longest.sort_by(|a, b| length(&b.0).total_cmp(&length(&a.0)));
    let of_edges = longest
        .iter()
        .take(LOOKS)
        .map(|([a, b], out)| (Spot::Edge, (at(*a) + at(*b)) / 2.0, *out));
    let of_tips = tips
        .iter()
        .take(LOOKS)
        .map(|(&tip, out)| (Spot::Tip, at(tip), *out));
    faces
        .into_iter()
        .chain(of_edges)
        .chain(of_tips)
        .filter(|(_, _, out)| out.norm() > ROUNDING)
        .flat_map(|(spot, at, out)| {
            let out = out.normalize();
            [(spot, at, out), (spot, at, -out)]
        })
        .collect()
}
