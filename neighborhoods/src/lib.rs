//! The standard neighbourhoods, written in the language itself.
//!
//! Every module here is an ordinary one: its source stands in a `.hlang` file next to this one, a formula imports from
//! it with `Faces from Neighborhoods(M)`, and Rust code may use the struct directly. A crate of your own publishes
//! neighbourhoods in the same way; the standard ones differ only in that no `use` is needed for them.
//!
//! | module | for |
//! | --- | --- |
//! | [`Neighborhoods`] | face meshes: what touches what, rings, the order of vertices around a face, flaps of edges, boundaries |
//! | [`PolygonNeighborhoods`] | the same under another name |
//! | [`TetrahedronNeighborhoods`] | cell meshes: what touches what, rings, the orientation of faces and cells, boundaries |
//! | [`TetrahderonNeighborhoods`] | the same, spelled as in the library of the paper |
//! | [`PointCloudNeighborhoods`] | edge meshes: what touches what, rings |
//!
//! ```
//! use iheartmesh_neighborhoods::Neighborhoods;
//! use iheartmesh_runtime::{Edge, FaceMesh, Vertex};
//!
//! //   3───2
//! //   │ ╲ │
//! //   0───1
//! let mesh = FaceMesh::from_triangles(4, &[[0, 1, 3], [1, 2, 3]])?;
//! let neighborhoods = Neighborhoods::new(&mesh)?;
//! assert_eq!(neighborhoods.VertexOneRing(Vertex::new(0)).len(), 2);
//! assert_eq!(neighborhoods.OppositeVertices(Edge::new(3)), (Vertex::new(0), Vertex::new(2)));
//! assert!(neighborhoods.try_OppositeVertices(Edge::new(0)).is_err()); // at the boundary
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! What each one is, in which order, and what happens at a boundary, is in `docs/neighborhoods.md`.

// The macro gives every call three paths: what the generated code runs on, where the macros are, and where the
// standard modules are. The facade cannot be named here, since it depends on this crate.
iheartmesh_macros::expand! {
    [::iheartmesh_runtime] [::iheartmesh_macros] [crate]

    /// Which elements of a face mesh touch which, and in which order.
    pub struct Neighborhoods = include "src/Neighborhoods.hlang";

    /// Which elements of a cell mesh touch which, and in which order.
    pub struct TetrahedronNeighborhoods = include "src/TetrahedronNeighborhoods.hlang";

    /// Which elements of an edge mesh touch which.
    pub struct PointCloudNeighborhoods = include "src/PointCloudNeighborhoods.hlang";
}

// names of the library of the paper
pub use {
    Neighborhoods as PolygonNeighborhoods, TetrahedronNeighborhoods as TetrahderonNeighborhoods,
};
