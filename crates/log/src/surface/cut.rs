//! Intersections and differences: the triangles of each part, cut where the other part's surface is.

use super::Mesh;
use pelletflow_core::{Bounds, Shape, Vec3};

/// Smallest pieces of a cut, as a share of the smaller part's diagonal [-].
const FINEST_SHARE: f64 = 1.0 / 64.0;
/// Smallest pieces of a cut, as a share of the whole's diagonal at the least [-].
const FINEST_SHARE_OF_WHOLE: f64 = 1.0e-3;
/// Distance, as a share of the whole's diagonal, within which two surfaces count as the same [-].
const COINCIDENCE_SHARE: f64 = 1.0e-7;
/// Halvings of a piece of an edge to find where it crosses a surface [-].
const HALVINGS: usize = 40;

/// What all parts have in common.
pub(super) fn intersection(of: &[Shape], bounds: &Bounds) -> Mesh {
    let grid = Grid::over(bounds, of);
    of.iter()
        .enumerate()
        .map(|(index, part)| {
            let mut mesh = Mesh::of(part, bounds);
            for (other_index, other) in of.iter().enumerate() {
                if other_index != index {
                    // A face that two parts share is kept of the first alone.
                    let shift = if index < other_index { -1.0 } else { 1.0 };
                    let shift = shift * grid.coincidence;
                    mesh = grid.kept(&mesh, |point| other.distance(point) + shift);
                }
            }
            mesh
        })
        .collect()
}

/// `of` with `minus` cut away.
pub(super) fn difference(of: &Shape, minus: &Shape, bounds: &Bounds) -> Mesh {
    let grid = Grid::over(bounds, [of, minus]);
    // A face that both share is open: the cut goes through it.
    let outer = grid.kept(&Mesh::of(of, bounds), |point| {
        grid.coincidence - minus.distance(point)
    });
    let inner = grid.kept(&Mesh::of(minus, bounds), |point| {
        of.distance(point) + grid.coincidence
    });
    [outer, inner.inside_out()].into_iter().collect()
}

/// How finely a cut is made.
struct Grid {
    /// Longest side of a piece that a cut goes through [m].
    finest: f64,
    /// Distance within which two surfaces count as the same [m].
    coincidence: f64,
}

/// What came of a piece.
#[derive(PartialEq, Clone, Copy)]
enum Outcome {
    Kept,
    Dropped,
    Cut,
}

impl Grid {
    fn over<'a>(bounds: &Bounds, parts: impl IntoIterator<Item = &'a Shape>) -> Self {
        let diagonal = |bounds: &Bounds| (bounds.max - bounds.min).norm();
        let whole = diagonal(bounds);
        let smallest = parts
            .into_iter()
            .map(|part| diagonal(&part.bounds().common(bounds)))
            .filter(|length| length.is_finite())
            .fold(whole, f64::min);
        Self {
            finest: (smallest * FINEST_SHARE).max(whole * FINEST_SHARE_OF_WHOLE),
            coincidence: whole * COINCIDENCE_SHARE,
        }
    }

    /// The part of a mesh where `outside`, no steeper than a distance, is negative.
    fn kept(&self, mesh: &Mesh, outside: impl Fn(Vec3) -> f64) -> Mesh {
        let mut result = Mesh::default();
        for triangle in &mesh.triangles {
            self.cut_triangle(*triangle, &outside, &mut result);
        }
        for edge in &mesh.edges {
            self.cut_edge(*edge, &outside, &mut result.edges);
        }
        result
    }

    fn cut_triangle(
        &self,
        corners: [Vec3; 3],
        outside: &impl Fn(Vec3) -> f64,
        result: &mut Mesh,
    ) -> Outcome {
        let [a, b, c] = corners;
        let center = (a + b + c) / 3.0;
        let reach = corners
            .iter()
            .map(|corner| (corner - center).norm())
            .fold(0.0, f64::max);
        let at_center = outside(center);
        if at_center >= reach {
            return Outcome::Dropped;
        }
        if at_center <= -reach {
            result.triangles.push(corners);
            return Outcome::Kept;
        }
        let sides = [(b - a).norm(), (c - b).norm(), (a - c).norm()];
        let longest = (0..3)
            .reduce(|best, side| {
                if sides[side] > sides[best] {
                    side
                } else {
                    best
                }
            })
            .expect("a triangle has three sides");
        if sides[longest] <= self.finest {
            return split(corners, outside, result);
        }
        let [from, to, opposite] = [0, 1, 2].map(|corner| corners[(longest + corner) % 3]);
        let middle = (from + to) / 2.0;
        let (triangles, edges) = (result.triangles.len(), result.edges.len());
        let first = self.cut_triangle([from, middle, opposite], outside, result);
        let second = self.cut_triangle([middle, to, opposite], outside, result);
        match (first, second) {
            // Two whole halves are one whole again.
            (Outcome::Kept, Outcome::Kept) => {
                result.triangles.truncate(triangles);
                result.edges.truncate(edges);
                result.triangles.push(corners);
                Outcome::Kept
            }
            (Outcome::Dropped, Outcome::Dropped) => Outcome::Dropped,
            _ => Outcome::Cut,
        }
    }

    fn cut_edge(
        &self,
        [from, to]: [Vec3; 2],
        outside: &impl Fn(Vec3) -> f64,
        result: &mut Vec<[Vec3; 2]>,
    ) {
        let middle = (from + to) / 2.0;
        let length = (to - from).norm();
        let at_middle = outside(middle);
        if at_middle >= length / 2.0 {
            return;
        }
        if at_middle <= -length / 2.0 {
            result.push([from, to]);
        } else if length > self.finest {
            self.cut_edge([from, middle], outside, result);
            self.cut_edge([middle, to], outside, result);
        } else {
            match (outside(from) < 0.0, outside(to) < 0.0) {
                (true, true) => result.push([from, to]),
                (true, false) => result.push([from, crossing(from, to, outside)]),
                (false, true) => result.push([crossing(to, from, outside), to]),
                (false, false) => {}
            }
        }
    }
}

/// Cuts a small triangle along one straight line, which becomes an edge.
fn split(corners: [Vec3; 3], outside: &impl Fn(Vec3) -> f64, result: &mut Mesh) -> Outcome {
    let is_inside = corners.map(|corner| outside(corner) < 0.0);
    match is_inside.iter().filter(|&&inside| inside).count() {
        0 => return Outcome::Dropped,
        3 => {
            result.triangles.push(corners);
            return Outcome::Kept;
        }
        _ => {}
    }
    let mut polygon = Vec::with_capacity(4);
    let mut line = Vec::with_capacity(2);
    for here in 0..3 {
        let next = (here + 1) % 3;
        if is_inside[here] {
            polygon.push(corners[here]);
        }
        if is_inside[here] != is_inside[next] {
            let point = if is_inside[here] {
                crossing(corners[here], corners[next], outside)
            } else {
                crossing(corners[next], corners[here], outside)
            };
            polygon.push(point);
            line.push(point);
        }
    }
    result.push_polygon(&polygon);
    result.edges.push([line[0], line[1]]);
    Outcome::Cut
}

/// Where the way from inside to outside crosses the surface.
fn crossing(inside: Vec3, beyond: Vec3, outside: &impl Fn(Vec3) -> f64) -> Vec3 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        if outside(inside.lerp(&beyond, middle)) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    inside.lerp(&beyond, low)
}
