//! Where the pellets of a scene start: at rest or in steady flow, worked out once and kept.

use crate::places::{self, Place};
use crate::scene::Scene;
use crate::{bed, chute, free, silo, sizes};
use pelletflow::core::Vec3;
use pelletflow::sim::{Fill, FillAmount, Seats, StepRequest};
use std::path::Path;

/// Steps in which a bed that was put down comes to rest.
const SETTLING_STEPS: u64 = 20_000;
/// Pellets that fall on the bed [-].
const JET: [i32; 3] = [5, 5, 8];

/// The pellets of a scene, kept in a folder between runs.
pub(crate) fn pellets(scene: Scene, folder: &Path) -> Result<Vec<Place>, String> {
    match scene {
        Scene::Silo { pellets, .. } => kept(folder, "silo", scene, || settled(scene, pellets)),
        Scene::Jet { pellets, radius } => {
            let below = Scene::Silo { pellets, radius };
            let mut all = self::pellets(below, folder)?;
            let top = all.iter().map(|place| place.position.z).fold(0.0, f64::max);
            all.extend(jet(top));
            Ok(all)
        }
        Scene::Chute => kept(folder, "chute", scene, chute::flow),
        Scene::Bed { tiles } => {
            let tile = Scene::Bed { tiles: [1, 1] };
            let settled = kept(folder, "bed", tile, || settled(tile, bed::PELLETS))?;
            Ok(chute::tiled(&settled, tiles, bed::SIDE))
        }
        Scene::Sizes => kept(folder, "sizes", scene, || settled(scene, sizes::PELLETS)),
        Scene::Free => Ok(vec![free::pellet()]),
    }
}

/// What a file holds, where it is of the same scene; worked out and written where not.
fn kept(
    folder: &Path,
    name: &str,
    scene: Scene,
    work_out: impl FnOnce() -> Vec<Place>,
) -> Result<Vec<Place>, String> {
    let told = format!("# {scene:?} {} {}", settling(scene).0, scene.describe());
    let pellets = match scene {
        Scene::Silo { pellets, .. } => format!("-{pellets}"),
        _ => String::new(),
    };
    let path = folder.join(format!("{name}{pellets}.txt"));
    if let Some(places) = places::read(&path, &told)? {
        return Ok(places);
    }
    let places = work_out();
    places::write(&path, &told, &places)?;
    Ok(places)
}

/// A bed put down pellet by pellet and come to rest.
fn settled(scene: Scene, pellets: usize) -> Vec<Place> {
    let (steps, longer) = settling(scene);
    let mut setup = scene.setup();
    if let StepRequest::Fixed(seconds) = &mut setup.step {
        *seconds *= longer;
    }
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Deposit {
            region: scene.region(),
            amount: FillAmount::Count(pellets),
        },
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    }];
    let mut simulation = silo::simulation(setup, 0);
    simulation.advance(steps).expect("the bed settles");
    places::of(&simulation)
        .iter()
        .map(|place| Place::at_rest(place.position))
        .collect()
}

/// Number of steps in which a bed comes to rest, and their length over that of the scene [-].
fn settling(scene: Scene) -> (u64, f64) {
    match scene {
        // Its step is a tenth of the Rayleigh time of the smallest; a fifth is stable.
        Scene::Sizes => (SETTLING_STEPS, 2.0),
        _ => (SETTLING_STEPS, 1.0),
    }
}

/// Pellets a little apart that fall on a bed with a top [m], at 1 m/s.
fn jet(top: f64) -> impl Iterator<Item = Place> {
    let [columns, rows, layers] = JET;
    let spacing = 1.1 * silo::DIAMETER;
    let all = (0..layers)
        .flat_map(move |z| (0..rows).flat_map(move |y| (0..columns).map(move |x| [x, y, z])));
    all.map(move |[x, y, z]| Place {
        position: Vec3::new(
            spacing * f64::from(x - columns / 2),
            spacing * f64::from(y - rows / 2),
            top + spacing * f64::from(z + 1),
        ),
        velocity: -Vec3::z(),
    })
}
