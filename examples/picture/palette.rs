//! Colors, in linear light so that they can be added, and the scale of speed.

/// Red, green and blue in linear light, 0 to 1.
pub(crate) type Light = [f64; 3];

/// Where the scale begins: pellets at rest would swallow their own shading in the darkest ninth of Viridis.
const DARKEST: f64 = 1.0 / 9.0;

/// Color of a share of the scale.
pub(crate) fn on_scale(share: f64) -> Light {
    let place = DARKEST + (1.0 - DARKEST) * share.clamp(0.0, 1.0);
    colorous::VIRIDIS
        .eval_continuous(place)
        .into_array()
        .map(|channel| to_linear(f64::from(channel) / 255.0))
}

/// A wall's surface, and where it is cut.
pub(crate) const STEEL: Light = [0.60, 0.64, 0.69];
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
