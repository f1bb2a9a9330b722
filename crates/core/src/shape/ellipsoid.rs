//! A ball stretched along the axes.
//!
//! The nearest point of the surface is found by iteration to the last digits, so that the distance is exact.

use super::Surface;
use crate::Vec3;

/// Steps after which the iteration ends at the latest; it takes about five [-].
const MOST_STEPS: usize = 64;

pub(super) fn surface(half_axes: Vec3, point: Vec3) -> Surface {
    let share = share_of_half_axes(half_axes, point.abs());
    // The surface is mirrored in each plane of the axes, and so is its nearest point.
    let share = share.zip_map(&point, f64::copysign);
    let gradient = share.component_div(&half_axes);
    let normal = gradient.normalize();
    let nearest = share.component_mul(&half_axes);
    Surface {
        distance: (point - nearest).dot(&normal),
        normal,
        principal_curvatures: principal_curvatures(half_axes, gradient),
    }
}

/// The point of the surface nearest to `point` of the positive octant, each coordinate over its half-axis [-].
///
/// At the nearest point x the way to y is along the normal: y = x + t (x/a²), so xᵢ/aᵢ = aᵢ yᵢ / (aᵢ² + t), and the
/// squares of these add up to 1 (Eberly 2013, "Distance from a Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid").
/// The root is sought in s = t + a² ≥ 0, with a the least half-axis here, and with one over the length of the shares, which is nearly straight
/// and bends one way: Newton's steps rise from below and never pass the root (Moré & Sorensen 1983).
fn share_of_half_axes(half_axes: Vec3, point: Vec3) -> Vec3 {
    let least = half_axes.min();
    // As a product, so that nearly equal axes lose no digits.
    let beyond_least = half_axes.map(|axis| (axis - least) * (axis + least));
    let weighted = half_axes.component_mul(&point);
    let shares_at = |s: f64| {
        weighted.zip_map(&beyond_least, |weighted, beyond| {
            if weighted > 0.0 {
                weighted / (s + beyond)
            } else {
                0.0
            }
        })
    };
    let shares = shares_at(0.0);
    if shares.norm_squared() < 1.0 {
        // So near the middle of the flattest section that both its sides are as far: any will do.
        let mut shares = shares;
        shares[half_axes.imin()] = (1.0 - shares.norm_squared()).sqrt();
        return shares;
    }
    let mut s = (weighted - beyond_least).max().max(0.0);
    for _ in 0..MOST_STEPS {
        let shares = shares_at(s);
        let length = shares.norm();
        let slope = shares
            .zip_map(&beyond_least, |share, beyond| {
                if share > 0.0 {
                    share * share / (s + beyond)
                } else {
                    0.0
                }
            })
            .sum();
        let next = s + (length - 1.0) * length * length / slope;
        // Rounding alone would now move it back.
        if next <= s || !next.is_finite() {
            break;
        }
        s = next;
    }
    shares_at(s).normalize()
}

/// From the mean and the Gaussian curvature of the surface Σ xᵢ²/aᵢ² = 1 (Goldman 2005, section 4),
/// whose gradient is `gradient` = xᵢ/aᵢ² up to a factor of 2 [1/m].
fn principal_curvatures(half_axes: Vec3, gradient: Vec3) -> [f64; 2] {
    let bend = half_axes.map(|axis| 1.0 / (axis * axis));
    let steepness = gradient.norm();
    let normal = gradient / steepness;
    let along_normal = normal.component_mul(&normal);
    let mean = (bend.sum() - bend.dot(&along_normal)) / (2.0 * steepness);
    let others = Vec3::new(bend.y * bend.z, bend.z * bend.x, bend.x * bend.y);
    let gaussian = others.dot(&along_normal) / (steepness * steepness);
    let spread = (mean * mean - gaussian).max(0.0).sqrt();
    [mean + spread, mean - spread]
}
