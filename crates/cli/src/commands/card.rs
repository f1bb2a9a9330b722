//! `pelletflow card`.

mod answer;
mod drops;

use crate::args::card::CardArguments;
use crate::args::safe_speed::DistributionName;
use crate::commands::hit::bad_input;
use crate::commands::new::write_new;
use crate::exit::{Exit, Failure};
use crate::{file, screen};
use answer::Answer;
use drops::Drops;
use pelletflow_impact::{CrushFit, CrushTest, DropLevel, ImpactError, ScatterLaw};
use pelletflow_log::plot::{Axis, Chart, Series, SeriesStyle};
use pelletflow_scene::{LabSheet, Provenance, StrengthCard, Tumble};
use std::path::Path;

/// Laws that are fitted, in the order of the table.
const LAWS: [ScatterLaw; 2] = [ScatterLaw::LogNormal, ScatterLaw::Weibull];

/// Makes a strength card of sheets of the laboratory.
pub(crate) fn card(arguments: &CardArguments) -> Result<Exit, Failure> {
    let sheet = LabSheet::<CrushTest>::read(&arguments.crush, arguments.unit.as_deref())?;
    if sheet.test.diameters.is_some() && arguments.test_diameter.is_some() {
        return Err(bad_input(
            "the sheet has a column of diameters; leave --test-diameter out".into(),
        ));
    }
    let fits = LAWS.map(|law| sheet.test.fit(law));
    let [log_normal, weibull] = fits;
    let fits = [
        log_normal.map_err(|error| refused(&error))?,
        weibull.map_err(|error| refused(&error))?,
    ];
    let chosen = chosen(&fits, arguments.distribution);
    let drops = arguments
        .drop
        .as_deref()
        .map(|path| drops(path, arguments))
        .transpose()?;
    let answer = Answer {
        card: strength_card(arguments, &sheet, &fits[chosen], drops.as_ref()),
        fits,
        chosen,
        drops,
    };
    if let Some(path) = &arguments.plot {
        file::draw(path, &chart(&answer, &sheet.test)?)?;
    }
    if let Some(path) = &arguments.output {
        write_new(path, &answer.card.to_toml())?;
    }
    if arguments.json {
        screen::json(&answer.json()?)?;
    } else {
        screen::result(&answer.page(arguments.output.as_deref())?)?;
    }
    Ok(Exit::Done)
}

/// Which of the fits goes into the card.
fn chosen(fits: &[CrushFit; 2], distribution: Option<DistributionName>) -> usize {
    match distribution {
        Some(DistributionName::LogNormal) => 0,
        Some(DistributionName::Weibull) => 1,
        None => usize::from(fits[1].goodness.p_value > fits[0].goodness.p_value),
    }
}

fn drops(path: &Path, arguments: &CardArguments) -> Result<Drops, Failure> {
    let sheet = LabSheet::<Vec<DropLevel>>::read(path)?;
    Drops::new(sheet.test, &arguments.hit, arguments.damage_constant)
}

fn strength_card(
    arguments: &CardArguments,
    sheet: &LabSheet<CrushTest>,
    fit: &CrushFit,
    drops: Option<&Drops>,
) -> StrengthCard {
    let name_of = |path: &Path| {
        let name = path.file_name().unwrap_or(path.as_os_str());
        name.to_string_lossy().into_owned()
    };
    let file = name_of(&arguments.crush);
    let count = sheet.test.loads.len();
    let mut strength = fit.strength;
    strength.test_diameter = strength.test_diameter.or(arguments.test_diameter);
    let files = arguments.drop.iter().map(|path| name_of(path));
    let files: Vec<String> = std::iter::once(file.clone()).chain(files).collect();
    StrengthCard {
        name: arguments.name.clone().unwrap_or_else(|| {
            let stem = arguments.crush.file_stem();
            stem.map_or_else(|| file.clone(), |stem| stem.to_string_lossy().into_owned())
        }),
        source: format!("{count} pellets crushed, {}", files.join(", ")),
        strength,
        yield_pressure: arguments.yield_pressure,
        provenance: Some(Provenance {
            file: Some(file),
            date: sheet.date.clone(),
            method: Some("crushing between two plates, pellet by pellet".into()),
            fit: Some("maximum likelihood; intervals of 95 % from pivots".into()),
            center_interval: Some([fit.center.low, fit.center.high]),
            shape_interval: Some([fit.shape.low, fit.shape.high]),
            goodness: Some(fit.goodness),
        }),
        fracture_energy: drops.and_then(Drops::fracture_energy),
        drops: drops.map(|drops| drops.levels.clone()).unwrap_or_default(),
        tumble: arguments.tumble.map(|tumble_index| Tumble {
            tumble_index,
            abrasion_index: arguments.abrasion,
        }),
    }
}

/// The loads in order over the share of pellets that broke under them, and the distribution of the card.
fn chart(answer: &Answer, test: &CrushTest) -> Result<Chart, Failure> {
    let strength = &answer.card.strength;
    let mean = test.mean_diameter();
    let reduced = test.loads.iter().enumerate().map(|(index, load)| {
        let diameters = test.diameters.as_ref();
        let diameter = diameters.map_or(0.0, |diameters| diameters[index]);
        mean.map_or(*load, |_| load / strength.size_effect(diameter))
    });
    let mut loads: Vec<f64> = reduced.collect();
    loads.sort_by(f64::total_cmp);
    let count = loads.len() as f64;
    let least = 0.5 * loads.first().copied().unwrap_or_default();
    let greatest = 1.2 * loads.last().copied().unwrap_or_default();
    let diameter = strength.test_diameter.unwrap_or(1.0);
    let curve = (0..=200)
        .map(|step| {
            let load = least + (greatest - least) * f64::from(step) / 200.0;
            let share = strength
                .broken(load, diameter)
                .map_err(|error| refused(&error))?;
            Ok([load, share])
        })
        .collect::<Result<_, Failure>>()?;
    let points = loads
        .iter()
        .enumerate()
        .map(|(rank, load)| [*load, (rank as f64 + 0.5) / count])
        .collect();
    Ok(Chart {
        title: format!("Crushing load: {}", answer.card.name),
        x: Axis::linear("load [N]"),
        y: Axis::linear("share broken [-]"),
        series: vec![
            Series {
                label: answer.law_name().into(),
                points: curve,
                style: SeriesStyle::Line,
            },
            Series {
                label: "pellets".into(),
                points,
                style: SeriesStyle::Markers,
            },
        ],
    })
}

fn refused(error: &ImpactError) -> Failure {
    bad_input(error.to_string())
}
