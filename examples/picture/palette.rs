//! Colors, in linear light so that they can be added, and the scale of speed.

/// Red, green and blue in linear light, 0 to 1.
pub(crate) type Light = [f64; 3];

/// Viridis (van der Walt and Smith 2015) at ten even steps, as a screen shows it.
const SCALE: [[f64; 3]; 10] = [
    [0.2670, 0.0049, 0.3294],
    [0.2814, 0.1558, 0.4692],
    [0.2450, 0.2877, 0.5373],
    [0.1906, 0.4071, 0.5561],
    [0.1476, 0.5117, 0.5570],
    [0.1197, 0.6185, 0.5363],
    [0.2080, 0.7187, 0.4729],
    [0.4310, 0.8085, 0.3465],
    [0.7099, 0.8688, 0.1693],
    [0.9932, 0.9062, 0.1439],
];

/// Color of a share of the scale.
pub(crate) fn on_scale(share: f64) -> Light {
    let place = share.clamp(0.0, 1.0) * (SCALE.len() - 1) as f64;
    let index = (place as usize).min(SCALE.len() - 2);
    let rest = place - index as f64;
    [0, 1, 2].map(|channel| {
        to_linear(SCALE[index][channel] * (1.0 - rest) + SCALE[index + 1][channel] * rest)
    })
}

/// A wall's surface, and where it is cut.
pub(crate) const STEEL: Light = [0.56, 0.60, 0.65];
pub(crate) const CUT_STEEL: Light = [0.10, 0.12, 0.15];
/// The picture's ground.
pub(crate) const PAPER: Light = [1.0, 1.0, 1.0];

pub(crate) fn scaled(light: Light, by: f64) -> Light {
    light.map(|channel| channel * by)
}

pub(crate) fn sum(a: Light, b: Light) -> Light {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn to_linear(screen: f64) -> f64 {
    if screen <= 0.040_45 {
        screen / 12.92
    } else {
        ((screen + 0.055) / 1.055).powf(2.4)
    }
}

/// As a screen wants it (the sRGB curve).
pub(crate) fn to_screen(light: Light) -> [u8; 3] {
    light.map(|linear| {
        let linear = linear.clamp(0.0, 1.0);
        let screen = if linear <= 0.003_130_8 {
            12.92 * linear
        } else {
            1.055 * linear.powf(1.0 / 2.4) - 0.055
        };
        (screen * 255.0).round() as u8
    })
}
