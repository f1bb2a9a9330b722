//! Recordings and summaries out.
pub mod surface;
