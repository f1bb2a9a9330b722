//! The chances of blows to break pellets add up, are worked out fast, and count damage as the theory does.

use pelletflow_impact::damage::damage;
use pelletflow_impact::{
    Blow, Chance, FractureEnergy, MedianEnergy, Scatter, Score, Strength, StrengthLaw, score,
};

const MASS: f64 = 3.44e-3;

const DAMAGED: FractureEnergy = FractureEnergy {
    median: MedianEnergy::OfAnySize(100.0),
    deviation: 0.5,
    truncation: None,
    damage_constant: Some(5.0),
    sample_size: Some(60),
};

fn blow(pellet: u32, force: f64, energy: f64) -> Blow {
    Blow {
        pellet,
        diameter: 0.012,
        mass: MASS,
        force,
        energy,
    }
}

fn by_load(scatter: Scatter, sample_size: Option<u32>) -> StrengthLaw {
    StrengthLaw::Load(Strength {
        scatter,
        test_diameter: None,
        sample_size,
    })
}

fn weibull() -> StrengthLaw {
    let scatter = Scatter::Weibull {
        scale: 2700.0,
        modulus: 4.0,
    };
    by_load(scatter, Some(60))
}

fn scored(law: &StrengthLaw, blows: &[Blow]) -> Score {
    score(law, blows).expect("good blows")
}

/// The chance of each blow, by the strength as the test found it [-].
fn best(score: &Score) -> Vec<f64> {
    score.chances.iter().map(|chance| chance.best).collect()
}

/// A fixed sequence of numbers from 0 to 1 without pattern: the fractions of multiples of the golden ratio.
fn spread(index: u32) -> f64 {
    (f64::from(index) * 0.618_033_988_749_894_9).fract()
}

#[test]
fn the_chances_of_a_life_add_up_to_the_share_under_its_greatest_force() {
    let blows: Vec<Blow> = (0..2000)
        .map(|index| blow(index % 7, 3000.0 * spread(index), 0.0))
        .collect();
    let score = scored(&weibull(), &blows);
    for pellet in 0..7 {
        let greatest = blows.iter().filter(|blow| blow.pellet == pellet);
        let greatest = greatest.map(|blow| blow.force).fold(0.0, f64::max);
        let exact = 1.0 - (-(greatest / 2700.0_f64).powi(4)).exp();
        let life = blows.iter().zip(&score.chances);
        let life = life.filter(|(blow, _)| blow.pellet == pellet);
        let sum: f64 = life.map(|(_, chance)| chance.best).sum();
        // A sum of 300 differences, each rounded.
        assert!((sum - exact).abs() < 1.0e-13, "{pellet}: {sum} {exact}");
    }
}

#[test]
fn groups_of_any_kind_add_up_to_the_total_and_so_do_their_bounds() {
    let blows: Vec<Blow> = (0..5000)
        .map(|index| blow(index % 97, 2500.0 * spread(index), 0.3 * spread(3 * index)))
        .collect();
    for law in [weibull(), StrengthLaw::Energy(DAMAGED)] {
        let score = scored(&law, &blows);
        let total = score.broken();
        for count in [1, 3, 11] {
            let mut parts = vec![Chance::default(); count];
            for (index, &chance) in score.chances.iter().enumerate() {
                parts[index * index % count] += chance;
            }
            let sum: f64 = parts.iter().map(|part| part.broken().best).sum();
            assert!((sum / total.best - 1.0).abs() < 1.0e-12);
        }
        assert!(total.low < total.best && total.best < total.high && total.high <= 97.0);
    }
}

#[test]
fn a_fixed_load_breaks_each_pellet_once_at_the_first_blow_that_reaches_it() {
    let law = by_load(Scatter::Fixed(1000.0), None);
    let blows = [999.0, 1000.0, 5000.0].map(|force| blow(0, force, 0.0));
    assert_eq!(best(&scored(&law, &blows)), [0.0, 1.0, 0.0]);
}

#[test]
fn larger_pellets_bear_the_force_that_their_area_says() {
    let law = StrengthLaw::Load(Strength {
        scatter: Scatter::LogNormal {
            median: 2450.0,
            deviation: 0.3,
        },
        test_diameter: Some(0.012),
        sample_size: None,
    });
    let large = Blow {
        diameter: 0.024,
        ..blow(0, 4.0 * 2450.0, 0.0)
    };
    assert!((best(&scored(&law, &[large]))[0] - 0.5).abs() < 1.0e-12);
}

/// Share of two thousand strengths, each followed by itself with the exact damage, that a life breaks blow by blow.
fn one_by_one(law: &FractureEnergy, ratios: &[f64]) -> Vec<f64> {
    const COUNT: u32 = 2000;
    let constant = law.damage_constant.expect("a law with damage");
    let mut broken = vec![0.0; ratios.len()];
    for number in 0..COUNT {
        let share = (f64::from(number) + 0.5) / f64::from(COUNT);
        let mut strength = quantile(law.deviation, share);
        for (index, &energy) in ratios.iter().enumerate() {
            if energy >= strength {
                broken[index] += 1.0 / f64::from(COUNT);
                break;
            }
            strength *= 1.0 - damage(energy / strength, constant);
        }
    }
    broken
}

/// Strength in medians below which a share lies, through the load of that risk of a log-normal strength of 1 N.
fn quantile(deviation: f64, share: f64) -> f64 {
    let strength = Strength {
        scatter: Scatter::LogNormal {
            median: 1.0,
            deviation,
        },
        test_diameter: None,
        sample_size: None,
    };
    strength.load(share, 1.0).expect("a share").best
}

#[test]
fn damage_breaks_what_two_thousand_pellets_followed_one_by_one_break() {
    let lives: [Vec<f64>; 5] = [
        vec![0.4; 30],
        (0..40).map(spread).collect(),
        (0..200).map(|index| 0.3 * spread(index)).collect(),
        (0..12).map(|index| 0.1 * f64::from(index)).rev().collect(),
        [vec![0.8], vec![0.02; 300]].concat(),
    ];
    for constant in [3.0, 5.0] {
        for deviation in [0.25, 0.8] {
            let law = FractureEnergy {
                deviation,
                damage_constant: Some(constant),
                sample_size: None,
                ..DAMAGED
            };
            for (number, ratios) in lives.iter().enumerate() {
                let blows: Vec<Blow> = ratios
                    .iter()
                    .map(|ratio| blow(0, 0.0, ratio * 100.0 * MASS))
                    .collect();
                let found = scored(&StrengthLaw::Energy(law), &blows);
                let exact = one_by_one(&law, ratios);
                let (mut sum, mut sum_exact) = (0.0, 0.0);
                for (one, other) in best(&found).iter().zip(&exact) {
                    sum += one;
                    sum_exact += other;
                    assert!(
                        (sum - sum_exact).abs() < 1.0e-2,
                        "γ {constant} σ {deviation} life {number}: {sum} {sum_exact}"
                    );
                }
            }
        }
    }
}

#[test]
fn damage_adds_up_where_without_it_the_second_equal_blow_breaks_nothing() {
    let blows = [0.6; 3].map(|ratio| blow(0, 0.0, ratio * 100.0 * MASS));
    let chances = best(&scored(&StrengthLaw::Energy(DAMAGED), &blows));
    assert!(chances.iter().all(|chance| *chance > 0.0));
    // The damage of a blow that falls short by little is near 1, so that the second breaks more than the third.
    assert!(chances[1] > chances[2]);
    let [little, without] = [Some(1.0e3), None].map(|damage_constant| FractureEnergy {
        damage_constant,
        ..DAMAGED
    });
    // A great constant leaves the damage to blows that nearly break.
    let chances = best(&scored(&StrengthLaw::Energy(little), &blows));
    assert!(chances[1] < 0.2 * chances[0], "{chances:?}");
    let chances = best(&scored(&StrengthLaw::Energy(without), &blows));
    assert_eq!(chances[1..], [0.0, 0.0]);
}

#[test]
fn luck_is_the_deviation_of_as_many_draws_as_there_are_pellets() {
    // Each of 400 pellets breaks by the same chance: the number broken is binomial.
    let blows: Vec<Blow> = (0..400).map(|pellet| blow(pellet, 2000.0, 0.0)).collect();
    let score = scored(&weibull(), &blows);
    let share = 1.0 - (-(2000.0_f64 / 2700.0).powi(4)).exp();
    let exact = (400.0 * share * (1.0 - share)).sqrt();
    assert!((score.luck / exact - 1.0).abs() < 1.0e-12, "{}", score.luck);
}

#[test]
fn a_blow_that_is_none_is_named_by_its_place() {
    let blows = [blow(0, 1.0, 0.0), blow(0, f64::NAN, 0.0)];
    let message = score(&weibull(), &blows)
        .expect_err("not a number")
        .to_string();
    assert!(
        message.contains("blow 1: force is NaN N; expected 0 or more"),
        "{message}"
    );
}

#[test]
fn pellets_without_blows_and_no_blows_at_all_break_nothing() {
    assert_eq!(scored(&weibull(), &[]).broken().high, 0.0);
}
