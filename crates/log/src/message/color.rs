//! Colors: speed on a perceptually uniform scale, walls by what they do.

use foxglove::messages::Color;

/// Red, green and blue of a share of the scale of a recording, clamped to 0..1 [-].
pub fn color_on_scale(share: f64) -> [u8; 3] {
    colorous::VIRIDIS
        .eval_continuous(share.clamp(0.0, 1.0))
        .into_array()
}

/// Color of a share of the scale, clamped to 0..1 [-].
pub(crate) fn on_scale(share: f64) -> Color {
    let [r, g, b] = color_on_scale(share).map(|channel| f64::from(channel) / 255.0);
    Color { r, g, b, a: 1.0 }
}

/// A color as eight hexadecimal digits, as in style sheets.
pub(crate) fn in_words(color: Color) -> String {
    let digits = |channel: f64| (255.0 * channel).round() as u8;
    let [r, g, b, a] = [color.r, color.g, color.b, color.a].map(digits);
    format!("#{r:02x}{g:02x}{b:02x}{a:02x}")
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
