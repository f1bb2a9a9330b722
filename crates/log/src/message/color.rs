//! Colors: speed on a perceptually uniform scale, walls by what they do.

use foxglove::messages::Color;

/// Viridis (van der Walt and Smith 2015) at ten even steps, as red, green and blue.
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

/// Color of a share of the scale, clamped to 0..1 [-].
pub(crate) fn on_scale(share: f64) -> Color {
    let place = share.clamp(0.0, 1.0) * (SCALE.len() - 1) as f64;
    let index = (place as usize).min(SCALE.len() - 2);
    let rest = place - index as f64;
    let [r, g, b] = [0, 1, 2]
        .map(|channel| SCALE[index][channel] * (1.0 - rest) + SCALE[index + 1][channel] * rest);
    Color { r, g, b, a: 1.0 }
}

/// A wall that stays.
pub(crate) const FIXED_WALL: Color = Color {
    r: 0.55,
    g: 0.60,
    b: 0.66,
    a: 0.25,
};

/// A wall that moves, runs or opens.
pub(crate) const ACTIVE_WALL: Color = Color {
    r: 0.90,
    g: 0.55,
    b: 0.20,
    a: 0.40,
};

/// Sharp edges.
pub(crate) const OUTLINE: Color = Color {
    r: 0.35,
    g: 0.38,
    b: 0.42,
    a: 0.9,
};
