//! One moment of the scene, drawn.

use crate::camera::{Camera, Ray};
use crate::canvas::Canvas;
use crate::palette::{CUT_STEEL, Light, PAPER, STEEL, on_scale, scaled, sum};
use crate::pellets::{Ball, Pellets, center};
use crate::walls::Walls;
use pelletflow::core::{Bounds, Vec3};
use pelletflow::log::FrameRecord;
use pelletflow::sim::Setup;
use std::f64::consts::TAU;
use std::thread;

/// Rays per pixel along each side [-].
const SAMPLES: usize = 2;
/// Rays of skylight per sample [-].
const SKY_RAYS: usize = 5;
/// Share of the light that comes from the sky, and from the lamp [-].
const SKY: f64 = 0.62;
const LAMP: f64 = 0.75;
/// Width of the lamp, as the tangent of half its angle: wide lamps cast soft shadows [-].
const LAMP_WIDTH: f64 = 0.12;
/// Way of skylight that is watched, in diameters of the largest pellet [-].
const SKY_REACH: f64 = 5.0;

pub(crate) struct Panel<'a> {
    pellets: Pellets,
    walls: Walls<'a>,
    bounds: Bounds,
    full_speed: f64,
    sky_reach: f64,
}

/// A point that light falls on.
struct Spot {
    point: Vec3,
    normal: Vec3,
    color: Light,
}

impl<'a> Panel<'a> {
    /// The pellets and walls of a frame behind the middle of the bounds, as seen along y.
    pub(crate) fn new(
        setup: &'a Setup,
        frame: &FrameRecord,
        bounds: &Bounds,
        full_speed: f64,
    ) -> Self {
        let cut = f64::midpoint(bounds.min.y, bounds.max.y);
        let balls: Vec<Ball> = frame
            .pellets
            .iter()
            .map(|pellet| Ball {
                center: center(pellet),
                radius: f64::from(pellet.radius),
                speed: f64::from(pellet.speed),
            })
            .filter(|ball| ball.center.y >= cut)
            .collect();
        let radius = balls.iter().map(|ball| ball.radius).fold(0.0, f64::max);
        Self {
            pellets: Pellets::new(balls),
            walls: Walls::at(setup, frame.time, bounds, cut),
            bounds: *bounds,
            full_speed,
            sky_reach: 2.0 * SKY_REACH * radius,
        }
    }

    /// Draws into a rectangle of the canvas, its rows shared among all cores.
    pub(crate) fn render(&self, canvas: &mut Canvas, origin: [usize; 2], size: [usize; 2]) {
        let camera = Camera::at(&self.bounds, size);
        let threads = thread::available_parallelism().map_or(1, usize::from);
        let band = size[1].div_ceil(threads);
        let bands: Vec<Vec<Light>> = thread::scope(|scope| {
            let workers: Vec<_> = (0..threads)
                .map(|thread| {
                    let rows = (thread * band).min(size[1])..((thread + 1) * band).min(size[1]);
                    let camera = &camera;
                    scope.spawn(move || {
                        rows.flat_map(|row| (0..size[0]).map(move |column| [column, row]))
                            .map(|pixel| self.pixel(camera, pixel, size))
                            .collect()
                    })
                })
                .collect();
            workers
                .into_iter()
                .map(|worker| worker.join().expect("drawing does not panic"))
                .collect()
        });
        for (index, light) in bands.into_iter().flatten().enumerate() {
            let (column, row) = (index % size[0], index / size[0]);
            canvas.set([origin[0] + column, origin[1] + row], light);
        }
    }

    fn pixel(&self, camera: &Camera, [column, row]: [usize; 2], size: [usize; 2]) -> Light {
        let mut total = [0.0; 3];
        for sample in 0..SAMPLES * SAMPLES {
            let within = |index: usize| (index as f64 + 0.5) / SAMPLES as f64;
            let right = column as f64 + within(sample % SAMPLES) - size[0] as f64 / 2.0;
            let up = size[1] as f64 / 2.0 - row as f64 - within(sample / SAMPLES);
            let mut noise = Noise::new([column, row, sample]);
            total = sum(total, self.light(&camera.ray(right, up), &mut noise));
        }
        scaled(total, 1.0 / (SAMPLES * SAMPLES) as f64)
    }

    fn light(&self, ray: &Ray, noise: &mut Noise) -> Light {
        let Some(spot) = self.spot(ray) else {
            return PAPER;
        };
        let facing = if spot.normal.dot(&ray.direction) > 0.0 {
            -spot.normal
        } else {
            spot.normal
        };
        let open = (0..SKY_RAYS)
            .filter(|_| {
                let direction = (facing + noise.direction()).normalize();
                self.is_free(spot.point, facing, direction, self.sky_reach)
            })
            .count() as f64
            / SKY_RAYS as f64;
        let lamp = (Vec3::new(-0.55, -0.75, 0.85).normalize() + LAMP_WIDTH * noise.direction())
            .normalize();
        let cosine = facing.dot(&lamp).max(0.0);
        let lit = cosine > 0.0 && self.is_free(spot.point, facing, lamp, f64::INFINITY);
        let direct = if lit { cosine } else { 0.0 };
        let gleam = if lit {
            let half = (lamp - ray.direction).normalize();
            0.10 * facing.dot(&half).max(0.0).powi(40)
        } else {
            0.0
        };
        let shade = SKY * (0.12 + 0.88 * open) + LAMP * direct;
        sum(scaled(spot.color, shade), [gleam; 3])
    }

    /// What a ray meets first.
    fn spot(&self, ray: &Ray) -> Option<Spot> {
        let pellet = self.pellets.first_hit(ray, f64::INFINITY);
        let reach = pellet.map_or(f64::INFINITY, |(distance, _)| distance);
        if let Some(wall) = self.walls.first_hit(ray, reach) {
            return Some(Spot {
                point: ray.at(wall.distance),
                normal: wall.normal,
                color: if wall.is_cut { CUT_STEEL } else { STEEL },
            });
        }
        let (distance, ball) = pellet?;
        let point = ray.at(distance);
        Some(Spot {
            point,
            normal: (point - ball.center) / ball.radius,
            color: on_scale(ball.speed / self.full_speed),
        })
    }

    fn is_free(&self, point: Vec3, normal: Vec3, direction: Vec3, reach: f64) -> bool {
        // A little off the surface, which would otherwise shade itself.
        let ray = Ray {
            origin: point + 1.0e-3 * self.sky_reach * normal,
            direction,
        };
        self.pellets.first_hit(&ray, reach).is_none() && self.walls.is_free(&ray, reach)
    }
}

/// Numbers that look random but are the same in every run.
struct Noise(u64);

impl Noise {
    fn new(seed: [usize; 3]) -> Self {
        let mixed = seed.iter().fold(0x9E37_79B9_7F4A_7C15, |state: u64, part| {
            (state ^ *part as u64).wrapping_mul(0xBF58_476D_1CE4_E5B9)
        });
        Self(mixed)
    }

    /// The next number in 0..1 (SplitMix64; Steele, Lea and Flood 2014).
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A unit vector, every direction as likely.
    fn direction(&mut self) -> Vec3 {
        let z = 2.0 * self.next() - 1.0;
        let (sin, cos) = (TAU * self.next()).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        Vec3::new(radius * cos, radius * sin, z)
    }
}
