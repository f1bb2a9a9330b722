//! One load that breaks every pellet: no scatter at all.

/// Share that breaks under `load` [-].
pub(crate) fn share(strength: f64, load: f64) -> f64 {
    f64::from(load >= strength)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pellet_breaks_at_its_load_and_none_below() {
        assert_eq!(
            [2449.9, 2450.0, 2450.1].map(|load| share(2450.0, load)),
            [0.0, 1.0, 1.0]
        );
    }
}
