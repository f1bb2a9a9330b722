//! `pelletflow schema`.

use crate::exit::{Exit, Failure};
use crate::screen;

/// Prints the JSON Schema of a scene.
pub(crate) fn schema() -> Result<Exit, Failure> {
    screen::json(&pelletflow_scene::schema())?;
    Ok(Exit::Done)
}
