//! A triangle and the point of it that is nearest to another.

use crate::Vec3;

/// A triangle in space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Triangle {
    /// Corners [m].
    pub corners: [Vec3; 3],
}

/// What of a triangle a foot is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FootOn {
    /// Its face.
    Face,
    /// One of its edges.
    Edge,
    /// One of its corners.
    Corner,
}

/// The point of a triangle that is nearest to another point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Foot {
    /// Where it is [m].
    pub at: Vec3,
    /// What it is on.
    pub on: FootOn,
}

impl Triangle {
    /// A vector across the face, counterclockwise about the corners, as long as twice the area \[m²\].
    #[inline]
    pub fn area_vector(&self) -> Vec3 {
        let [a, b, c] = self.corners;
        (b - a).cross(&(c - a))
    }

    /// Distance of the longest side from the corner across [m].
    pub fn height(&self) -> f64 {
        let [a, b, c] = self.corners;
        let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
        if longest > 0.0 {
            self.area_vector().norm() / longest
        } else {
            0.0
        }
    }

    /// The point nearest to another (Ericson 2005, section 5.1.5) [m].
    #[inline]
    pub fn foot(&self, point: Vec3) -> Foot {
        let [a, b, c] = self.corners;
        let corner = |at| Foot {
            at,
            on: FootOn::Corner,
        };
        let edge = |from: Vec3, to: Vec3, share: f64| Foot {
            at: from + share * (to - from),
            on: FootOn::Edge,
        };
        let (ab, ac) = (b - a, c - a);
        let from_a = point - a;
        let (along_ab_at_a, along_ac_at_a) = (ab.dot(&from_a), ac.dot(&from_a));
        if along_ab_at_a <= 0.0 && along_ac_at_a <= 0.0 {
            return corner(a);
        }
        let from_b = point - b;
        let (along_ab_at_b, along_ac_at_b) = (ab.dot(&from_b), ac.dot(&from_b));
        if along_ab_at_b >= 0.0 && along_ac_at_b <= along_ab_at_b {
            return corner(b);
        }
        let beyond_ab = along_ab_at_a * along_ac_at_b - along_ab_at_b * along_ac_at_a;
        if beyond_ab <= 0.0 && along_ab_at_a >= 0.0 && along_ab_at_b <= 0.0 {
            return edge(a, b, along_ab_at_a / (along_ab_at_a - along_ab_at_b));
        }
        let from_c = point - c;
        let (along_ab_at_c, along_ac_at_c) = (ab.dot(&from_c), ac.dot(&from_c));
        if along_ac_at_c >= 0.0 && along_ab_at_c <= along_ac_at_c {
            return corner(c);
        }
        let beyond_ac = along_ab_at_c * along_ac_at_a - along_ab_at_a * along_ac_at_c;
        if beyond_ac <= 0.0 && along_ac_at_a >= 0.0 && along_ac_at_c <= 0.0 {
            return edge(a, c, along_ac_at_a / (along_ac_at_a - along_ac_at_c));
        }
        let beyond_bc = along_ab_at_b * along_ac_at_c - along_ab_at_c * along_ac_at_b;
        let (toward_c, toward_b) = (along_ac_at_b - along_ab_at_b, along_ab_at_c - along_ac_at_c);
        if beyond_bc <= 0.0 && toward_c >= 0.0 && toward_b >= 0.0 {
            return edge(b, c, toward_c / (toward_c + toward_b));
        }
        let whole = 1.0 / (beyond_ab + beyond_ac + beyond_bc);
        Foot {
            at: a + (beyond_ac * whole) * ab + (beyond_ab * whole) * ac,
            on: FootOn::Face,
        }
    }

    /// Distance of a point from the triangle, never negative [m].
    #[inline]
    pub fn distance(&self, point: Vec3) -> f64 {
        (point - self.foot(point).at).norm()
    }
}
