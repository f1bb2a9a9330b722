//! The commands, one file each.

pub(crate) mod accuracy;
pub(crate) mod card;
pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod export;
pub(crate) mod hit;
pub(crate) mod impact;
pub(crate) mod inspect;
pub(crate) mod materials;
pub(crate) mod new;
pub(crate) mod report;
pub(crate) mod run;
pub(crate) mod safe_speed;
pub(crate) mod schema;
pub(crate) mod score;
