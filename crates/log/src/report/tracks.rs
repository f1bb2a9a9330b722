//! Pellets as tracks, in few bytes: what a page carries of its replay.
//!
//! A track is a pellet from its first frame to its last.
//! Positions are 16 bits within the box around all pellets, speed and force 8 bits.
//! Each value is told by its step from the frame before, low bytes apart from high ones, so that rest costs nothing.

use super::frames::ReplayFrame;
use crate::frames::PelletRecord;
use std::collections::BTreeMap;

/// Decades of force that a color scale spans, below the greatest [-].
pub(super) const FORCE_DECADES: f32 = 4.0;
/// Share of all speeds that the color scale spans [-]: one pellet that shoots off must not darken all others.
const SPEED_SHARE: f64 = 0.999;
/// Classes by which that share is found [-].
const SPEED_CLASSES: usize = 2000;

/// Scales of what is told in few bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scales {
    /// Box around all centers [m].
    pub(super) min: [f32; 3],
    pub(super) max: [f32; 3],
    /// Greatest radius [m].
    pub(super) radius: f32,
    /// Speed with the last color [m/s]; few are faster.
    pub(super) speed: f32,
    /// Greatest force [N].
    pub(super) force: f32,
}

/// Tracks of pellets.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Tracks {
    /// Number of each pellet, told by its step from the one before [-].
    ids: Vec<u32>,
    /// Radius over the greatest [1/65535].
    radii: Vec<u16>,
    /// First frame [-].
    firsts: Vec<u16>,
    /// Frames [-].
    lengths: Vec<u16>,
    /// Position along each axis, in steps [1/65535 of the box].
    positions: [Vec<u16>; 3],
    /// Speed, in steps [1/255].
    speeds: Vec<u8>,
    /// Logarithm of force, in steps [1/255].
    forces: Vec<u8>,
}

impl Scales {
    pub(super) fn of<'a>(frames: impl Iterator<Item = &'a ReplayFrame> + Clone) -> Self {
        let mut scales = Self {
            min: [f32::INFINITY; 3],
            max: [f32::NEG_INFINITY; 3],
            radius: f32::MIN_POSITIVE,
            speed: f32::MIN_POSITIVE,
            force: f32::MIN_POSITIVE,
        };
        for pellet in frames.clone().flat_map(|frame| &frame.pellets) {
            for axis in 0..3 {
                scales.min[axis] = scales.min[axis].min(pellet.position[axis]);
                scales.max[axis] = scales.max[axis].max(pellet.position[axis]);
            }
            scales.radius = scales.radius.max(pellet.radius);
            scales.speed = scales.speed.max(pellet.speed);
            scales.force = scales.force.max(pellet.force);
        }
        let mut classes = vec![0_u64; SPEED_CLASSES + 1];
        for pellet in frames.flat_map(|frame| &frame.pellets) {
            classes[(pellet.speed / scales.speed * SPEED_CLASSES as f32) as usize] += 1;
        }
        let wanted = SPEED_SHARE * classes.iter().sum::<u64>() as f64;
        let mut counted = 0;
        let class = classes.iter().position(|count| {
            counted += count;
            counted as f64 >= wanted
        });
        let share = class.map_or(1.0, |class| (class + 1) as f32 / SPEED_CLASSES as f32);
        scales.speed *= share.min(1.0);
        if scales.min[0] > scales.max[0] {
            (scales.min, scales.max) = ([0.0; 3], [0.0; 3]);
        }
        scales
    }

    fn place(&self, position: [f32; 3]) -> [u16; 3] {
        [0, 1, 2].map(|axis| {
            let length = (self.max[axis] - self.min[axis]).max(f32::MIN_POSITIVE);
            let share = (position[axis] - self.min[axis]) / length;
            (share * f32::from(u16::MAX)).round() as u16
        })
    }

    fn speed(&self, speed: f32) -> u8 {
        (speed / self.speed * f32::from(u8::MAX)).round() as u8
    }

    /// 0 stands for no force, and for one below the scale.
    fn force(&self, force: f32) -> u8 {
        let decades = (force / self.force).log10();
        ((1.0 + decades / FORCE_DECADES) * f32::from(u8::MAX)).round() as u8
    }
}

impl Tracks {
    pub(super) fn of<'a>(frames: impl Iterator<Item = &'a ReplayFrame>, scales: &Scales) -> Self {
        let mut pellets: BTreeMap<u32, Vec<(usize, &PelletRecord)>> = BTreeMap::new();
        for (index, frame) in frames.enumerate() {
            for pellet in &frame.pellets {
                pellets.entry(pellet.id).or_default().push((index, pellet));
            }
        }
        let mut tracks = Self::default();
        let mut last_id = 0;
        for (id, seen) in pellets {
            // One that was away for some frames has a track before and one after.
            for part in seen.chunk_by(|one, other| one.0 + 1 == other.0) {
                tracks.ids.push(id - last_id);
                last_id = id;
                tracks.push(part, scales);
            }
        }
        tracks
    }

    fn push(&mut self, part: &[(usize, &PelletRecord)], scales: &Scales) {
        let (first, pellet) = part[0];
        let radius = pellet.radius / scales.radius;
        self.radii
            .push((radius * f32::from(u16::MAX)).round() as u16);
        self.firsts.push(first as u16);
        self.lengths.push(part.len() as u16);
        let (mut place, mut speed, mut force) = ([0; 3], 0, 0);
        for (_, pellet) in part {
            let next = scales.place(pellet.position);
            for axis in 0..3 {
                self.positions[axis].push(folded(next[axis].wrapping_sub(place[axis])));
            }
            place = next;
            let next = scales.speed(pellet.speed);
            self.speeds.push(next.wrapping_sub(speed));
            speed = next;
            let next = scales.force(pellet.force);
            self.forces.push(next.wrapping_sub(force));
            force = next;
        }
    }

    /// Number of tracks [-].
    pub(super) fn len(&self) -> usize {
        self.ids.len()
    }

    /// Places of all tracks together [-].
    pub(super) fn points(&self) -> usize {
        self.speeds.len()
    }

    /// All of it as bytes, column by column.
    pub(super) fn write(&self, bytes: &mut Vec<u8>) {
        for plane in 0..4 {
            bytes.extend(self.ids.iter().map(|id| id.to_le_bytes()[plane]));
        }
        let words = [&self.radii, &self.firsts, &self.lengths];
        for column in words.into_iter().chain(&self.positions) {
            for plane in 0..2 {
                bytes.extend(column.iter().map(|word| word.to_le_bytes()[plane]));
            }
        }
        bytes.extend(&self.speeds);
        bytes.extend(&self.forces);
    }
}

/// Small steps forward and back become small numbers.
fn folded(step: u16) -> u16 {
    let step = step.cast_signed();
    ((step << 1) ^ (step >> 15)).cast_unsigned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pellet(id: u32, height: f32, speed: f32, force: f32) -> PelletRecord {
        PelletRecord {
            id,
            position: [0.0, 0.0, height],
            radius: 0.01,
            speed,
            force,
        }
    }

    fn frames(pellets: &[&[PelletRecord]]) -> Vec<ReplayFrame> {
        let frame = |(index, pellets): (usize, &&[PelletRecord])| ReplayFrame {
            time: index as f64,
            pellets: pellets.to_vec(),
            walls: Vec::new(),
        };
        pellets.iter().enumerate().map(frame).collect()
    }

    #[test]
    fn steps_add_up_to_the_places_within_half_a_step() {
        let heights = [1.0, 0.3, 0.31, -0.7, 0.999];
        let rows: Vec<[PelletRecord; 1]> = heights.map(|z| [pellet(4, z, 1.0, 1.0)]).into();
        let rows: Vec<&[PelletRecord]> = rows.iter().map(<[_; 1]>::as_slice).collect();
        let frames = frames(&rows);
        let scales = Scales::of(frames.iter());
        let tracks = Tracks::of(frames.iter(), &scales);
        let mut place = 0_u16;
        for (height, &step) in heights.iter().zip(&tracks.positions[2]) {
            let back = (step >> 1) ^ 0_u16.wrapping_sub(step & 1);
            place = place.wrapping_add(back);
            let found = scales.min[2] + 1.7 * f32::from(place) / f32::from(u16::MAX);
            // Half of 1.7 m over 65535, and single precision.
            assert!((found - height).abs() < 1.4e-5, "{found} for {height}");
        }
    }

    #[test]
    fn a_pellet_that_is_away_for_a_frame_has_two_tracks() {
        let here: &[_] = &[pellet(2, 0.0, 0.0, 0.0), pellet(9, 0.0, 0.0, 0.0)];
        let away: &[_] = &[pellet(2, 0.0, 0.0, 0.0)];
        let frames = frames(&[here, away, here]);
        let tracks = Tracks::of(frames.iter(), &Scales::of(frames.iter()));
        assert_eq!(tracks.ids, [2, 7, 0]);
        assert_eq!(tracks.firsts, [0, 0, 2]);
        assert_eq!(tracks.lengths, [3, 1, 1]);
        assert_eq!(tracks.points(), 5);
    }

    #[test]
    fn one_fast_pellet_does_not_stretch_the_scale_of_speed_and_force_is_told_by_decades() {
        let mut pellets: Vec<_> = (0..10_000).map(|id| pellet(id, 0.0, 1.0, 10.0)).collect();
        pellets.push(pellet(10_000, 0.0, 50.0, 1000.0));
        let frames = frames(&[&pellets]);
        let scales = Scales::of(frames.iter());
        assert!((scales.speed - 1.0).abs() < 0.05, "{}", scales.speed);
        assert_eq!(scales.speed(50.0), 255);
        assert_eq!(
            [1000.0, 10.0, 0.1, 0.0].map(|force| scales.force(force)),
            [255, 128, 0, 0]
        );
    }

    #[test]
    fn no_pellets_have_no_tracks() {
        let frames = frames(&[&[]]);
        let scales = Scales::of(frames.iter());
        assert_eq!(scales.min, [0.0; 3]);
        assert_eq!(Tracks::of(frames.iter(), &scales).len(), 0);
    }
}
