//! A run beside the closed form of one lone hit.

use crate::breakage::{Breakage, BreakageRequest, Breaking, Group, wall_name};
use pelletflow_core::MaterialPair;
use pelletflow_impact::{Damping, ElasticImpact, Interval, Outlines, SafeSpeed, StrengthLaw};
use pelletflow_sim::{Cause, Setup};

/// The closed form for a hit of the kind that breaks most, at true stiffness.
#[derive(Debug, Clone, PartialEq)]
pub struct ClosedForm {
    /// What is hit.
    pub partner: String,
    /// Speed across the surface at which an elastic hit breaks the share asked for [m/s].
    pub speed: Interval,
    /// Greatest force of a damped hit over that of an elastic one [-].
    pub damped_share: f64,
}

/// What lies between the closed form and the run, factor by factor.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The closed form.
    pub closed_form: ClosedForm,
    /// The blows on this partner that break, whatever their cause.
    pub breaking: Breaking,
    /// Share of all breakage that blows on this partner make up [-].
    pub part: f64,
}

impl Comparison {
    /// Beside the partner that breaks most; none where the strength is no load, the bed's squeeze is the cause that breaks
    /// most, or the pellets are of several materials.
    pub(super) fn new(
        setup: &Setup,
        breakage: &Breakage,
        request: &BreakageRequest,
        risk: f64,
    ) -> Option<Self> {
        let StrengthLaw::Load(strength) = &request.law else {
            return None;
        };
        if worst(&breakage.by_cause)?.name == Cause::Squeeze.name() {
            return None;
        }
        let group = worst(&breakage.by_wall)?;
        let breaking = group.breaking?;
        let material = setup.pellets.first()?.material;
        if setup.pellets.iter().any(|kind| kind.material != material) {
            return None;
        }
        let names = setup.walls.iter().map(|wall| wall.name.clone());
        let names: Vec<String> = names.collect();
        let wall = (0..names.len()).find(|&wall| wall_name(&names, Some(wall)) == group.name);
        let other = wall.map_or(material, |wall| setup.walls[wall].material);
        let properties = setup.pair_properties(material, other)?;
        let [own, others] = [material, other].map(|index| setup.materials[index].true_material());
        let pair = MaterialPair::new(&own, &others, properties);
        let (radius, mass) = (0.5 * breaking.diameter_m, breaking.mass_kg);
        let hit = match wall {
            Some(_) => ElasticImpact::on_plane(&pair, radius, mass, 1.0),
            None => ElasticImpact::of_equals(&pair, radius, mass, 1.0),
        };
        let moduli = [hit.effective_youngs_modulus; 2];
        let safe = SafeSpeed::new(strength, risk, breaking.diameter_m, &hit, moduli).ok()?;
        let damping = Damping::Restitution(properties.restitution);
        let damped = Outlines::default().of(&hit, damping).ok()?;
        Some(Self {
            closed_form: ClosedForm {
                partner: group.name.clone(),
                speed: safe.speed,
                damped_share: damped.peak_force / hit.peak_force(),
            },
            breaking,
            part: group.broken.pellets / breakage.believed().pellets,
        })
    }

    /// How much faster a damped hit may be than an elastic one [-].
    pub fn damping_factor(&self) -> f64 {
        self.closed_form.damped_share.powf(-1.0 / 1.2)
    }

    /// How much faster a slanting hit may be than a square one: only the speed across the surface counts [-].
    pub fn slant_factor(&self) -> f64 {
        self.breaking.speed_m_per_s / self.breaking.normal_speed_m_per_s
    }

    /// What is left of the arrival speed in the run over the closed form with both: the spread of speeds and sizes, and that
    /// not every pellet meets this partner [-].
    pub fn spread_factor(&self) -> f64 {
        let expected = self.closed_form.speed.best * self.damping_factor() * self.slant_factor();
        self.breaking.speed_m_per_s / expected
    }
}

/// The group that breaks most.
fn worst(groups: &[Group]) -> Option<&Group> {
    groups
        .iter()
        .filter(|group| group.broken.pellets > 0.0)
        .max_by(|one, other| one.broken.pellets.total_cmp(&other.broken.pellets))
}
