//! Fills: pellets without overlap before the first step, on a jittered lattice, put down one by one, or where they are told.

use crate::deposit::Deposit;
use crate::error::SetupError;
use crate::ledger::PelletTally;
use crate::model::Model;
use crate::random::{Draw, Purpose};
use crate::setup::{Fill, FillAmount, Seats};
use crate::state::{NewPellet, row, vector};
use crate::wall::WallNow;
use pelletflow_broadphase::{Grid, SphereRow};
use pelletflow_core::{Bounds, Shape, Vec3};

/// Distance of two seats over the largest diameter [-].
const SPACING: f64 = 1.04;
/// Greatest shift of a seat along each axis over the gap between two largest pellets [-]: two can never touch.
const JITTER: f64 = 0.4;
/// Seats in a region's box beyond which a fill is taken for a slip of the units [-].
const MOST_SEATS: f64 = 2.0e8;

/// The pellets of all fills, in the order of the scene.
///
/// # Errors
/// Every fill that does not fit, overlaps a wall or another fill.
pub(crate) fn place(model: &Model, walls: &[WallNow]) -> Result<Vec<NewPellet>, Vec<SetupError>> {
    let mut placed = Vec::new();
    let mut first_of_fill = Vec::new();
    let mut errors = Vec::new();
    for (index, fill) in model.setup().fills.iter().enumerate() {
        first_of_fill.push(placed.len());
        match place_one(model, walls, index, fill) {
            Ok(pellets) => placed.extend(pellets),
            Err(error) => errors.push(error),
        }
    }
    if errors.is_empty() {
        errors.extend(overlap_of_fills(model, &placed, &first_of_fill));
    }
    if errors.is_empty() {
        Ok(placed)
    } else {
        Err(errors)
    }
}

fn place_one(
    model: &Model,
    walls: &[WallNow],
    index: usize,
    fill: &Fill,
) -> Result<Vec<NewPellet>, SetupError> {
    let seed = model.setup().seed;
    let size = &model.setup().pellets[fill.pellets].size;
    let mut size_draw = Draw::new(seed, Purpose::FillSize(index), 0);
    let mut new = |position| {
        let radius = size.draw(&mut size_draw) / 2.0;
        NewPellet {
            kind: fill.pellets,
            radius,
            mass: model.mass(fill.pellets, radius),
            position,
            velocity: fill.velocity,
            spin: fill.spin,
        }
    };
    let placed = match &fill.seats {
        Seats::Deposit { region, amount } => {
            let mut place_draw = Draw::new(seed, Purpose::FillPlace(index), 0);
            let gravity = model.setup().gravity;
            let mut deposit = Deposit::new(region, gravity, size.max_diameter() / 2.0);
            let pellets = std::iter::from_fn(|| {
                let pellet = new(Vec3::zeros());
                let position = deposit.put(pellet.radius, &mut place_draw)?;
                Some(NewPellet { position, ..pellet })
            });
            up_to(*amount, pellets).map_err(|held| too_small(fill, *amount, held))?
        }
        Seats::Points(points) => points.iter().map(|&point| new(point)).collect(),
        Seats::Lattice { region, amount } => {
            let mut place_draw = Draw::new(seed, Purpose::FillPlace(index), 0);
            let largest = size.max_diameter();
            let shift = JITTER * (SPACING - 1.0) * largest;
            let jitter = Bounds {
                min: Vec3::repeat(-shift),
                max: Vec3::repeat(shift),
            };
            let seats = lattice(&fill.name, region, largest)?;
            let pellets = seats
                .map(|seat| new(seat + place_draw.point(&jitter)))
                .filter(|pellet| region.distance(pellet.position) <= -pellet.radius);
            up_to(*amount, pellets).map_err(|held| too_small(fill, *amount, held))?
        }
    };
    match placed
        .iter()
        .find_map(|pellet| overlap_with_wall(model, walls, fill, pellet))
    {
        Some(error) => Err(error),
        None => Ok(placed),
    }
}

/// The first pellets that make up an amount.
///
/// # Errors
/// What all of them make up, where that is less.
fn up_to(
    amount: FillAmount,
    pellets: impl Iterator<Item = NewPellet>,
) -> Result<Vec<NewPellet>, PelletTally> {
    let mut taken = Vec::new();
    let mut tally = PelletTally::default();
    let is_full = |tally: &PelletTally| match amount {
        FillAmount::Count(count) => tally.count >= count as u64,
        FillAmount::Mass(mass) => tally.mass >= mass,
    };
    for pellet in pellets {
        if is_full(&tally) {
            break;
        }
        tally.add(pellet.mass);
        taken.push(pellet);
    }
    if is_full(&tally) {
        Ok(taken)
    } else {
        Err(tally)
    }
}

/// Lattice points over a region's box, from the bottom up.
fn lattice(
    name: &str,
    region: &Shape,
    largest: f64,
) -> Result<impl Iterator<Item = Vec3>, SetupError> {
    let bounds = region.bounds().grown(-largest / 2.0);
    let spacing = SPACING * largest;
    let counts = ((bounds.max - bounds.min) / spacing).map(|steps| (steps.floor() + 1.0).max(0.0));
    if counts.product() > MOST_SEATS {
        return Err(SetupError::new(
            format!("fill.{name}.region"),
            format!(
                "the region has room for about {:.0e} pellets of {largest} m, more than {MOST_SEATS:.0e}; check the units of \
                 the region and of the diameter",
                counts.product()
            ),
        ));
    }
    // Centered, so that a symmetric region gets a symmetric bed.
    let first =
        bounds.min + (bounds.max - bounds.min - spacing * (counts - Vec3::repeat(1.0))) / 2.0;
    let [columns, rows, layers] = [counts.x as u64, counts.y as u64, counts.z as u64];
    Ok((0..layers).flat_map(move |layer| {
        (0..rows).flat_map(move |row| {
            (0..columns).map(move |column| {
                first + spacing * Vec3::new(column as f64, row as f64, layer as f64)
            })
        })
    }))
}

fn too_small(fill: &Fill, amount: FillAmount, held: PelletTally) -> SetupError {
    let asked = match amount {
        FillAmount::Count(count) => format!("{count} pellets"),
        FillAmount::Mass(mass) => format!("{mass} kg"),
    };
    SetupError::new(
        format!("fill.{}", fill.name),
        format!(
            "the region holds {} pellets ({:.4} kg) without overlap, but {asked} were asked for; enlarge the region or ask for less",
            held.count, held.mass
        ),
    )
}

/// Overlap that a fill may start with over the radius [-]: none on a lattice; points may come from a settled bed.
fn allowed_overlap_ratio(model: &Model, fill: &Fill) -> f64 {
    match fill.seats {
        Seats::Lattice { .. } | Seats::Deposit { .. } => 0.0,
        Seats::Points(_) => model.setup().limits.overlap_ratio,
    }
}

fn overlap_with_wall(
    model: &Model,
    walls: &[WallNow],
    fill: &Fill,
    pellet: &NewPellet,
) -> Option<SetupError> {
    let NewPellet {
        position, radius, ..
    } = *pellet;
    let allowed = allowed_overlap_ratio(model, fill) * radius;
    model
        .setup()
        .walls
        .iter()
        .zip(walls)
        .filter(|(_, now)| now.is_present)
        .map(|(wall, now)| (wall, radius - wall.shape.distance(now.pose.inverse_point(position))))
        .find(|(_, overlap)| *overlap > allowed)
        .map(|(wall, overlap)| {
            SetupError::new(
                seats_key(fill),
                format!(
                    "a pellet at ({:.4}, {:.4}, {:.4}) m overlaps wall `{}` by {overlap:.4} m; keep the region clear of every wall",
                    position.x, position.y, position.z, wall.name
                ),
            )
        })
}

/// Key of the scene that says where the pellets of a fill are put.
fn seats_key(fill: &Fill) -> String {
    let key = match fill.seats {
        Seats::Lattice { .. } | Seats::Deposit { .. } => "region",
        Seats::Points(_) => "at",
    };
    format!("fill.{}.{key}", fill.name)
}

fn overlap_of_fills(
    model: &Model,
    placed: &[NewPellet],
    first_of_fill: &[usize],
) -> Option<SetupError> {
    let rows: Vec<SphereRow> = placed
        .iter()
        .map(|pellet| {
            let position = model.periodic().map_or(pellet.position, |periodic| {
                periodic.wrapped(pellet.position)
            });
            row(position, pellet.radius)
        })
        .collect();
    let periodic = model.periodic();
    let grid = Grid::new(&rows, 0.0, periodic);
    let fill_of = |index: usize| {
        &model.setup().fills[first_of_fill.partition_point(|&first| first <= index) - 1]
    };
    (0..placed.len()).find_map(|index| {
        let mut overlapping = None;
        grid.for_each_within_reach(index, &mut |other| {
            let (a, b) = (&placed[index], &placed[other]);
            let between = vector(&rows[index]) - vector(&rows[other]);
            let nearest = periodic.map_or(between, |periodic| {
                Vec3::from(periodic.nearest(between.into()))
            });
            let overlap = a.radius + b.radius - nearest.norm();
            let allowed = [index, other].map(|pellet| allowed_overlap_ratio(model, fill_of(pellet)));
            if overlap > allowed[0].max(allowed[1]) * a.radius.min(b.radius) {
                overlapping = Some((other, overlap));
            }
        });
        overlapping.map(|(other, overlap)| {
            SetupError::new(
                seats_key(fill_of(index)),
                format!(
                    "its pellet {index} overlaps pellet {other}, of fill `{}`, by {overlap:.4} m; keep them apart",
                    fill_of(other).name
                ),
            )
        })
    })
}
