//! What the numbers of breakage do not know.

use super::{BreakageRequest, Scored, confidence};
use crate::hits::RecordedHits;
use pelletflow_impact::StrengthLaw;

/// Fewest steps of a hit whose peak force holds to some percent [-].
const FEW_STEPS: u64 = 8;

/// Sentences about what is missing or uncertain.
pub(super) fn warnings(
    recorded: &RecordedHits,
    request: &BreakageRequest,
    scored: &Scored,
) -> Vec<String> {
    let mut warnings = Vec::new();
    if recorded.is_cut_off {
        warnings.push(format!(
            "the recording is cut off at {:.6} s: hits after that are missing, and so are those then open",
            recorded.end
        ));
    }
    let (has_force, has_damage) = match &request.law {
        StrengthLaw::Load(_) => (true, false),
        StrengthLaw::Energy(energy) => (false, energy.damage_constant.is_some()),
    };
    if recorded.is_softened && has_force {
        warnings.push(
            "the run is softened: force grows as the power 2/5 of the modulus; of arrivals believe the line at true stiffness"
                .into(),
        );
    }
    let coarse = scored
        .dealt(recorded)
        .zip(&scored.score.chances)
        .filter(|((_, hit), chance)| chance.best > 0.0 && hit.steps < FEW_STEPS)
        .count();
    if coarse > 0 {
        warnings.push(format!(
            "{coarse} of the blows that may break a pellet lasted fewer than {FEW_STEPS} steps: their force is uncertain by some percent"
        ));
    }
    let unrecorded: u64 = recorded
        .classes
        .values()
        .map(|class| class.count - class.kept)
        .sum();
    if has_damage && unrecorded > 0 {
        warnings.push(format!(
            "{unrecorded} weaker hits are not recorded in full and leave no damage here; lower `output.hits_above` to have them in it"
        ));
    }
    if confidence(&request.law).is_none() {
        warnings.push("no interval: the strength does not tell its sample size".into());
    }
    if has_force && request.yield_pressure.is_none() {
        warnings.push(
            "the force is that of a pellet that stays elastic: one that yields before it breaks feels less; give \
             `yield_pressure` in the card for the other end"
                .into(),
        );
    }
    warnings.push(
        "slow crushing is not an impact, and the force is that of the contact law: read the limits of breakage in the guide"
            .into(),
    );
    warnings
}
