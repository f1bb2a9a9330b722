//! What the cases are put together from.

use crate::common::{GRAVITY, RADIUS, setup, wall};
use pelletflow::core::contact::TurningLaw;
use pelletflow::core::{
    Bounds, ContactLaws, Material, PairProperties, Profile, Shape, UnitVector3, Vec3,
};
use pelletflow::sim::{Domain, Fill, NamedMaterial, Seats, Setup, Wall};

/// Half of the paper's restitution is lost, and half a weight of friction.
pub(crate) const ROUGH: PairProperties = PairProperties {
    restitution: 0.5,
    friction: 0.5,
    rolling_friction: 0.05,
    ..PairProperties::ELASTIC
};

/// The paper's pellets under gravity, all pairs alike; what rolls is held, so that beds can rest.
pub(crate) fn scene(pair: PairProperties) -> Setup {
    let mut setup = setup(pair, pair);
    setup.gravity = GRAVITY;
    setup.laws = ContactLaws {
        rolling: TurningLaw::SpringDashpot,
        ..ContactLaws::default()
    };
    setup
}

/// Pellets of another Young's modulus [Pa].
pub(crate) fn with_modulus(mut setup: Setup, youngs_modulus: f64) -> Setup {
    let NamedMaterial { material, .. } = &mut setup.materials[crate::common::ORE];
    *material = Material {
        youngs_modulus,
        ..*material
    };
    setup
}

/// A wall about a point, which pushes along a direction.
pub(crate) fn plane(name: &str, point: Vec3, normal: Vec3) -> Wall {
    let normal = UnitVector3::new_normalize(normal);
    wall(name, Shape::HalfSpace { point, normal })
}

/// A closed box on a floor, its sides twice `half` [m] apart; the domain ends just outside.
pub(crate) fn in_vessel(mut setup: Setup, half: f64, height: f64) -> Setup {
    setup.walls.push(plane("floor", Vec3::zeros(), Vec3::z()));
    for (name, outward) in [
        ("left", -Vec3::x()),
        ("right", Vec3::x()),
        ("front", -Vec3::y()),
        ("back", Vec3::y()),
    ] {
        setup.walls.push(plane(name, half * outward, -outward));
    }
    setup
        .walls
        .push(plane("lid", height * Vec3::z(), -Vec3::z()));
    setup.domain = Domain::closed(Bounds {
        min: Vec3::new(-half, -half, 0.0) - Vec3::repeat(2.0 * RADIUS),
        max: Vec3::new(half, half, height) + Vec3::repeat(2.0 * RADIUS),
    });
    setup
}

/// Pellets of a kind at places, with one velocity.
pub(crate) fn pellets(name: &str, kind: usize, places: Vec<Vec3>, velocity: Vec3) -> Fill {
    Fill {
        name: name.into(),
        pellets: kind,
        seats: Seats::Points(places),
        velocity,
        spin: Vec3::zeros(),
    }
}

/// Places on a cubic lattice about an axis, from the lowest up, a little aside of each other from layer to layer [m].
pub(crate) fn lattice(counts: [u32; 3], spacing: f64, lowest: f64) -> Vec<Vec3> {
    let along = |index: u32, count: u32| (f64::from(index) - 0.5 * f64::from(count - 1)) * spacing;
    let mut places = Vec::new();
    for k in 0..counts[2] {
        // Straight columns would stand on end.
        let aside = 0.05 * spacing * f64::from(k % 3);
        for j in 0..counts[1] {
            for i in 0..counts[0] {
                places.push(Vec3::new(
                    along(i, counts[0]) + aside,
                    along(j, counts[1]) - 0.6 * aside,
                    lowest + f64::from(k) * spacing,
                ));
            }
        }
    }
    places
}

/// 27 pellets that fall into a vessel.
pub(crate) fn poured(setup: Setup, speed: f64) -> Setup {
    let mut setup = in_vessel(setup, 4.0 * RADIUS, 0.4);
    let places = lattice([3, 3, 3], 2.3 * RADIUS, 2.0 * RADIUS);
    setup.fills = vec![pellets("pour", 0, places, -speed * Vec3::z())];
    setup
}

/// A pipe of an inner radius along the z axis [m].
pub(crate) fn pipe(name: &str, radius: f64, half_length: f64) -> Wall {
    let (outer, end) = (radius + 2.0 * RADIUS, half_length);
    let profile = Profile::Closed {
        corners: vec![[radius, -end], [outer, -end], [outer, end], [radius, end]],
    };
    wall(name, Shape::Revolution { profile })
}
