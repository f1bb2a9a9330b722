//! The picture: pixels, a few letters, the scale of speed, and the file.

use crate::palette::{Light, PAPER, on_scale, to_screen};
use std::error::Error;
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::Path;

const INK: Light = [0.04, 0.045, 0.055];
/// Size of a letter, and the way to the next one [px at scale 1].
const LETTER: [usize; 2] = [5, 7];
const ADVANCE: usize = 6;
/// Bar of the scale [px].
const BAR: [usize; 2] = [360, 14];

pub(crate) struct Canvas {
    size: [usize; 2],
    pixels: Vec<Light>,
}

impl Canvas {
    pub(crate) fn new(size: [usize; 2]) -> Self {
        Self {
            size,
            pixels: vec![PAPER; size[0] * size[1]],
        }
    }

    pub(crate) fn set(&mut self, [column, row]: [usize; 2], light: Light) {
        if column < self.size[0] && row < self.size[1] {
            self.pixels[row * self.size[0] + column] = light;
        }
    }

    /// Writes text about a column, from a row down, each dot `scale` pixels wide.
    pub(crate) fn centered_text(&mut self, text: &str, [column, row]: [usize; 2], scale: usize) {
        let width = text.chars().count() * ADVANCE * scale;
        let mut left = column.saturating_sub(width / 2);
        for letter in text.chars() {
            let rows = rows_of(letter);
            for y in 0..LETTER[1] * scale {
                for x in 0..LETTER[0] * scale {
                    if rows[y / scale] >> (LETTER[0] - 1 - x / scale) & 1 == 1 {
                        self.set([left + x, row + y], INK);
                    }
                }
            }
            left += ADVANCE * scale;
        }
    }

    /// Draws the scale from 0 to a speed [m/s] below a row.
    pub(crate) fn scale(&mut self, full_speed: f64, row: usize) {
        let left = (self.size[0] - BAR[0]) / 2;
        for x in 0..BAR[0] {
            let light = on_scale(x as f64 / (BAR[0] - 1) as f64);
            for y in 0..BAR[1] {
                self.set([left + x, row + 8 + y], light);
            }
        }
        for part in 0..=2 {
            let speed = full_speed * f64::from(part) / 2.0;
            let label = if part == 2 {
                format!("{speed:.1} m/s")
            } else {
                format!("{speed:.1}")
            };
            let column = left + BAR[0] * part as usize / 2;
            self.centered_text(&label, [column, row + 30], 2);
        }
    }

    /// Writes a PNG, and makes its directory.
    pub(crate) fn save(&self, path: &Path) -> Result<(), Box<dyn Error>> {
        if let Some(directory) = path.parent() {
            fs::create_dir_all(directory)?;
        }
        let file = BufWriter::new(File::create(path)?);
        let mut encoder = png::Encoder::new(file, self.size[0] as u32, self.size[1] as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let bytes: Vec<u8> = self.pixels.iter().copied().flat_map(to_screen).collect();
        encoder.write_header()?.write_image_data(&bytes)?;
        Ok(())
    }
}

/// The dots of a letter, row by row, the leftmost in the highest of five bits.
fn rows_of(letter: char) -> [u8; 7] {
    match letter {
        '0' => [14, 17, 19, 21, 25, 17, 14],
        '1' => [4, 12, 4, 4, 4, 4, 14],
        '2' => [14, 17, 1, 2, 4, 8, 31],
        '3' => [31, 2, 4, 2, 1, 17, 14],
        '4' => [2, 6, 10, 18, 31, 2, 2],
        '5' => [31, 16, 30, 1, 1, 17, 14],
        '6' => [6, 8, 16, 30, 17, 17, 14],
        '7' => [31, 1, 2, 4, 8, 8, 8],
        '8' => [14, 17, 17, 14, 17, 17, 14],
        '9' => [14, 17, 17, 15, 1, 2, 12],
        '.' => [0, 0, 0, 0, 0, 12, 12],
        '=' => [0, 0, 31, 0, 31, 0, 0],
        '/' => [0, 1, 2, 4, 8, 16, 0],
        't' => [8, 8, 28, 8, 8, 9, 6],
        's' => [0, 0, 14, 16, 14, 1, 30],
        'm' => [0, 0, 26, 21, 21, 21, 21],
        _ => [0; 7],
    }
}
