//! Where a ball touches a solid with edges of its own: intersections, differences, shells.
//!
//! The solid is a tree of smooth faces. A ball may touch a face, an edge where two meet or a corner where three do;
//! each such place is found on the faces as they go on beyond the solid, and kept if it is on the solid
//! and no way along the solid leads nearer to the center.

use super::face::{Face, FaceKind};
use super::similarity::Similarity;
use super::tree::Tree;
use super::{Touches, meeting, polygon};
use crate::shape::revolution::winding;
use crate::{Bounds, Profile, Shape, Surface, Vec3};
use nalgebra::UnitVector3;
use smallvec::SmallVec;

/// Distance from a face at which a place counts as on it, over the radius of the ball [-].
const ON_FACE: f64 = 1.0e-7;
/// Sine of the angle up to which a way counts as along a face, or as across the way to the center [-].
const ALONG: f64 = 1.0e-6;

/// A solid with edges.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Carved {
    /// For centers inside of it.
    shape: Shape,
    /// Where the faces stand; most share one frame.
    frames: Vec<Similarity>,
    faces: Vec<Face>,
    tree: Tree,
}

/// One number for each face; most solids have few.
type Values = SmallVec<[f64; 16]>;

/// A face that the ball reaches, perhaps where it goes on beyond the solid.
struct Near {
    index: usize,
    /// As seen from the center.
    surface: Surface,
    /// Whether the ball reaches the part that can bound the solid.
    may_touch: bool,
}

impl Carved {
    pub(super) fn new(shape: &Shape) -> Self {
        let mut faces: Vec<Face> = Vec::new();
        let stand = Stand {
            placement: Similarity::identity(),
            moved: 0.0,
            is_reversed: false,
        };
        let tree = take_apart(shape, &stand, &mut faces);
        let mut frames: Vec<Similarity> = Vec::new();
        for face in &mut faces {
            let known = frames.iter().position(|frame| *frame == face.placement);
            face.frame = known.unwrap_or(frames.len());
            if known.is_none() {
                frames.push(face.placement);
            }
        }
        Self {
            shape: shape.clone(),
            frames,
            faces,
            tree,
        }
    }

    pub(super) fn offer(&self, center: Vec3, touches: &mut Touches) {
        let reach = touches.reach();
        let own: SmallVec<[Vec3; 4]> = self
            .frames
            .iter()
            .map(|frame| frame.inverse_point(center))
            .collect();
        let values: Values = self
            .faces
            .iter()
            .map(|face| face.distance_in_frame(own[face.frame]))
            .collect();
        let outside = self.tree.value(&values);
        if outside >= reach {
            return;
        }
        if outside <= 0.0 {
            touches.offer(self.shape.surface(center));
            return;
        }
        let near: SmallVec<[Near; 8]> = self
            .faces
            .iter()
            .enumerate()
            .filter(|(index, _)| values[*index].abs() < reach)
            .map(|(index, face)| Near {
                index,
                surface: face.surface(center),
                may_touch: face.may_be_within(reach, center),
            })
            .collect();
        if let [only] = &near[..] {
            // All other faces are on the same side of its foot as of the center.
            let mut at_foot = values;
            at_foot[only.index] = 0.0;
            if only.surface.distance > 0.0 && self.tree.value(&at_foot) == 0.0 {
                touches.offer(only.surface);
            }
            return;
        }
        let ball = Ball { center, reach };
        let touchable: SmallVec<[&Near; 8]> = near.iter().filter(|face| face.may_touch).collect();
        for face in &touchable {
            if face.surface.distance <= 0.0 {
                continue;
            }
            let foot = center - face.surface.distance * face.surface.normal;
            if self.is_nearest_about(foot, &ball, &near, &values) {
                touches.offer(face.surface);
            }
        }
        for (second, b) in touchable.iter().enumerate() {
            for (first, a) in touchable[..second].iter().enumerate() {
                let [one, other] = [&self.faces[a.index], &self.faces[b.index]];
                if !one.may_meet(other) {
                    continue;
                }
                self.offer_meeting(&[one, other], &ball, &near, &values, touches);
                for c in &touchable[..first] {
                    let third = &self.faces[c.index];
                    if third.may_meet(one) && third.may_meet(other) {
                        self.offer_meeting(&[one, other, third], &ball, &near, &values, touches);
                    }
                }
            }
        }
    }

    fn offer_meeting(
        &self,
        faces: &[&Face],
        ball: &Ball,
        near: &[Near],
        values: &[f64],
        touches: &mut Touches,
    ) {
        let along = if faces.len() == 2 { 0.0 } else { f64::INFINITY };
        meeting::for_each_nearest(faces, ball.center, ball.reach, |place| {
            if self.is_nearest_about(place, ball, near, values) {
                let way = ball.center - place;
                let distance = way.norm();
                touches.offer(Surface {
                    distance,
                    normal: way / distance,
                    principal_curvatures: [f64::INFINITY, along],
                });
            }
        });
    }

    /// Whether a place is on the solid and no other about it is nearer to the center.
    ///
    /// About the place the faces through it are planes, and the solid a wedge or a cone of them. What leads nearest to
    /// the center within that is straight to it, straight to it within one plane, or along the line of two.
    fn is_nearest_about(&self, place: Vec3, ball: &Ball, near: &[Near], values: &[f64]) -> bool {
        let tolerance = ON_FACE * ball.reach;
        let mut values = Values::from_slice(values);
        let mut met: SmallVec<[(usize, Vec3); 4]> = SmallVec::new();
        for face in near {
            let surface = self.faces[face.index].surface(place);
            values[face.index] = surface.distance;
            if surface.distance.abs() <= tolerance {
                values[face.index] = 0.0;
                met.push((face.index, surface.normal));
            }
        }
        if self.tree.value(&values) != 0.0 {
            return false;
        }
        let to_center = (ball.center - place).normalize();
        if let [(_, normal)] = met[..] {
            return normal.dot(&to_center) > 0.0;
        }
        for value in &mut values {
            *value = f64::INFINITY.copysign(*value);
        }
        let leads_nearer = |way: Vec3, values: &mut [f64]| {
            let length = way.norm();
            if length < ALONG || way.dot(&to_center) < ALONG * length {
                return false;
            }
            for (index, normal) in &met {
                values[*index] = normal.dot(&way) / length;
            }
            self.tree.value(values) <= ALONG
        };
        if leads_nearer(to_center, &mut values) {
            return false;
        }
        for (index, (_, normal)) in met.iter().enumerate() {
            if leads_nearer(to_center - to_center.dot(normal) * normal, &mut values) {
                return false;
            }
            for (_, other) in &met[..index] {
                let line = normal.cross(other);
                let line = line * line.dot(&to_center).signum();
                if line.norm() > ALONG && leads_nearer(line.normalize(), &mut values) {
                    return false;
                }
            }
        }
        true
    }
}

struct Ball {
    center: Vec3,
    reach: f64,
}

/// Where a part stands in the whole.
#[derive(Clone, Copy)]
struct Stand {
    placement: Similarity,
    /// How far its faces are moved outward.
    moved: f64,
    is_reversed: bool,
}

impl Stand {
    fn within(&self, inner: &Similarity) -> Self {
        Self {
            placement: self.placement.after(inner),
            ..*self
        }
    }

    fn reversed(&self) -> Self {
        Self {
            is_reversed: !self.is_reversed,
            ..*self
        }
    }

    fn face(&self, kind: FaceKind, own_bounds: &Bounds, faces: &mut Vec<Face>) -> Tree {
        // Faces that are moved toward each other meet elsewhere than they did: at sharp edges farther than they moved.
        let margin = 4.0 * self.moved.abs();
        faces.push(Face {
            kind,
            placement: self.placement,
            frame: 0,
            moved: self.moved,
            is_reversed: self.is_reversed,
            bounds: self.placement.bounds(own_bounds).grown(margin),
        });
        Tree::Face(faces.len() - 1)
    }
}

/// Adds the faces of a shape, and gives the tree that puts them together.
fn take_apart(shape: &Shape, stand: &Stand, faces: &mut Vec<Face>) -> Tree {
    match shape {
        Shape::Cuboid { half_sides } => cuboid(*half_sides, stand, faces),
        Shape::Cylinder {
            radius,
            half_length,
        } => turned(&frustum(*radius, *radius, *half_length), stand, faces),
        Shape::Cone {
            lower_radius,
            upper_radius,
            half_length,
        } => turned(
            &frustum(*lower_radius, *upper_radius, *half_length),
            stand,
            faces,
        ),
        Shape::Revolution {
            profile: Profile::Closed { corners },
        } => turned(corners, stand, faces),
        Shape::Union { of } => {
            let parts = of.iter().map(|part| take_apart(part, stand, faces));
            Tree::common(parts.collect(), !stand.is_reversed)
        }
        Shape::Intersection { of } => {
            let parts = of.iter().map(|part| take_apart(part, stand, faces));
            Tree::common(parts.collect(), stand.is_reversed)
        }
        Shape::Difference { of, minus } => {
            let kept = take_apart(of, stand, faces);
            let cut = take_apart(minus, &stand.reversed(), faces);
            Tree::common(vec![kept, cut], stand.is_reversed)
        }
        Shape::Shell { thickness, of } => {
            let outer = take_apart(of, stand, faces);
            let inside = Stand {
                moved: stand.moved - thickness * stand.placement.scale(),
                ..stand.reversed()
            };
            let hollow = take_apart(of, &inside, faces);
            Tree::common(vec![outer, hollow], stand.is_reversed)
        }
        Shape::Translated { by, of } => {
            take_apart(of, &stand.within(&Similarity::translation(*by)), faces)
        }
        Shape::Rotated { by, of } => {
            take_apart(of, &stand.within(&Similarity::rotation(*by)), faces)
        }
        Shape::Mirrored { point, normal, of } => {
            let mirror = Similarity::mirroring(*point, *normal);
            take_apart(of, &stand.within(&mirror), faces)
        }
        Shape::Scaled { by, of } => take_apart(of, &stand.within(&Similarity::scaling(*by)), faces),
        smooth => stand.face(FaceKind::Smooth(smooth.clone()), &smooth.bounds(), faces),
    }
}

fn cuboid(half_sides: Vec3, stand: &Stand, faces: &mut Vec<Face>) -> Tree {
    let mut sides = Vec::with_capacity(6);
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let normal = UnitVector3::new_unchecked(Vec3::ith(axis, sign));
            let point = half_sides[axis] * normal.into_inner();
            let mut bounds = Bounds::about_origin(half_sides);
            bounds.min[axis] = point[axis];
            bounds.max[axis] = point[axis];
            let plane = FaceKind::Smooth(Shape::HalfSpace { point, normal });
            sides.push(stand.face(plane, &bounds, faces));
        }
    }
    Tree::common(sides, stand.is_reversed)
}

fn frustum(lower_radius: f64, upper_radius: f64, half_length: f64) -> [[f64; 2]; 4] {
    [
        [0.0, -half_length],
        [lower_radius, -half_length],
        [upper_radius, half_length],
        [0.0, half_length],
    ]
}

fn turned(corners: &[[f64; 2]], stand: &Stand, faces: &mut Vec<Face>) -> Tree {
    let mut corners = corners.to_vec();
    if winding(&corners) < 0.0 {
        corners.reverse();
    }
    // A side without length has no direction.
    corners.dedup();
    let sides: Vec<Tree> = (0..corners.len())
        .map(|index| {
            let (start, end) = (corners[index], corners[(index + 1) % corners.len()]);
            if start[0] == 0.0 && end[0] == 0.0 {
                // A side on the axis bounds nothing: everywhere is inside of it.
                return Tree::All(vec![]);
            }
            let length = (end[0] - start[0]).hypot(end[1] - start[1]);
            let radius = start[0].max(end[0]);
            let bounds = Bounds {
                min: Vec3::new(-radius, -radius, start[1].min(end[1])),
                max: Vec3::new(radius, radius, start[1].max(end[1])),
            };
            let slope = FaceKind::Slope {
                start,
                normal: [(end[1] - start[1]) / length, (start[0] - end[0]) / length],
            };
            stand.face(slope, &bounds, faces)
        })
        .collect();
    let tree = polygon::tree(&corners, &|side| sides[side].clone());
    if stand.is_reversed {
        tree.reversed()
    } else {
        tree
    }
}
