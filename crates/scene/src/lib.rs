//! Scene files: text in, a validated model out.
//!
//! One set of types under `spec` says what a scene may hold. The JSON Schema is made from them, and
//! the same schema checks a scene, so that what an editor completes is what is accepted.
//! A scene goes through three gates, each of which reports every mistake that it finds:
//! the schema (`walk`), the tables against each other (`resolve`), and the physics ([`pelletflow_sim::Model::new`]).

mod difference;
mod draft;
mod expect;
mod key_path;
mod lab_sheet;
mod measure;
mod mesh;
mod mistakes;
mod named;
mod number;
mod overrides;
mod quantity;
mod resolve;
mod scene;
mod schema;
mod setting;
mod source;
mod spec;
mod strength_card;
mod suggest;
mod template;
mod units;
mod walk;
mod written;

pub use difference::{Difference, differences};
pub use expect::{ExpectationOutcome, Expectations};
pub use lab_sheet::{LabSheet, LabSheetError};
pub use measure::{MeasureError, measure};
pub use mesh::{BakeReport, MeshReport, Rim};
pub use mistakes::{Mistake, Mistakes, Place, SceneError};
pub use overrides::{Override, OverrideError, parts_of};
pub use resolve::{OutputOptions, Strength};
pub use scene::Scene;
pub use schema::schema;
pub use setting::{Setting, SettingError};
pub use strength_card::{Provenance, StrengthCard, StrengthCardError, Tumble};
pub use suggest::instead;
pub use template::{TEMPLATES, Template};
pub use units::Kind;
pub use written::{text_of_file, text_of_tables};

#[cfg(test)]
mod contract;
