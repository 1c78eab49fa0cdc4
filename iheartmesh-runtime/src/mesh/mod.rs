//! Meshes: a [`CellComplex`](crate::complex::CellComplex) with the constructors, accessors and queries of its kind.

mod error;
mod face;
mod polygon_edges;
mod queries;

pub use error::MeshError;
pub use face::FaceMesh;
