//! Meshes: a [`CellComplex`](crate::complex::CellComplex) with the constructors, accessors and queries of its kind.

mod accessors;
mod cell;
mod cell_faces;
mod edge;
mod error;
mod face;
mod graph;
mod grid;
mod polygon_edges;
mod polygon_incidence;
mod polyhedra;
mod queries;

pub use cell::CellMesh;
pub use edge::EdgeMesh;
pub use error::MeshError;
pub use face::FaceMesh;
pub use graph::Point;
