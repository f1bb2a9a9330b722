//! Makes up the sheets of a laboratory in `examples/sheets`, always the same ones. Nothing in them was measured.
//!
//! ```text
//! cargo run -p pelletflow-impact --example lab_sheet loads > examples/sheets/loads.csv
//! cargo run -p pelletflow-impact --example lab_sheet drops > examples/sheets/drops.csv
//! ```

use pelletflow_impact::safe_speed::speed_of_fall;
use pelletflow_impact::{ImpactError, Scatter, Strength};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::io::{self, Write};

/// Pellets crushed, as many as ISO 4700 asks for [-].
const CRUSHED: usize = 60;

/// Heights of the drops [m].
const HEIGHTS: [f64; 4] = [5.0, 10.0, 20.0, 30.0];

/// Pellets dropped from each height [-].
const DROPPED: u32 = 60;

/// Median of the made-up fracture energy [J/kg] and the deviation of its logarithm [-].
const FRACTURE_ENERGY: (f64, f64) = (200.0, 0.6);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut random = ChaCha8Rng::seed_from_u64(4700);
    let mut output = io::stdout().lock();
    writeln!(
        output,
        "# made up by `cargo run -p pelletflow-impact --example lab_sheet`; nothing here was measured"
    )?;
    if std::env::args().nth(1).as_deref() == Some("drops") {
        return drops(&mut output, &mut random);
    }
    writeln!(
        output,
        "# a log-normal strength with a mean of 2.45 kN and a scatter of 30 % at 11.25 mm, that grows with the area"
    )?;
    writeln!(output, "load [kN],diameter [mm]")?;
    let strength = Strength {
        scatter: Scatter::log_normal_from_mean(2450.0, 0.3)?,
        test_diameter: Some(0.011_25),
        sample_size: None,
    };
    for _ in 0..CRUSHED {
        let diameter = 0.010 + 0.0025 * random.random::<f64>();
        let load = drawn(&strength, diameter, &mut random)?;
        writeln!(output, "{:.3},{:.1}", 1.0e-3 * load, 1.0e3 * diameter)?;
    }
    Ok(())
}

fn drops(
    output: &mut impl Write,
    random: &mut ChaCha8Rng,
) -> Result<(), Box<dyn std::error::Error>> {
    let (median, deviation) = FRACTURE_ENERGY;
    writeln!(
        output,
        "# a log-normal fracture energy with a median of {median} J/kg and a deviation of {deviation}"
    )?;
    writeln!(output, "height [m],dropped,broken")?;
    // A log-normal strength is a log-normal energy with another unit.
    let energy = Strength {
        scatter: Scatter::LogNormal { median, deviation },
        test_diameter: None,
        sample_size: None,
    };
    for height in HEIGHTS {
        let brought = 0.5 * speed_of_fall(height).powi(2);
        let mut broken = 0;
        for _ in 0..DROPPED {
            broken += u32::from(drawn(&energy, 1.0, random)? <= brought);
        }
        writeln!(output, "{height},{DROPPED},{broken}")?;
    }
    Ok(())
}

/// The strength of a pellet.
fn drawn(strength: &Strength, diameter: f64, random: &mut ChaCha8Rng) -> Result<f64, ImpactError> {
    let risk = random.random::<f64>().max(f64::MIN_POSITIVE);
    Ok(strength.load(risk, diameter)?.best)
}
