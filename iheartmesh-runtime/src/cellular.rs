//! Cellular sets: elements of several dimensions together.

use crate::{Cell, Edge, Face, Set, Vertex};

/// Any collection of elements of one mesh: a set of vertices, a set of edges, one of faces and one of cells.
///
/// Nothing says that it is closed: a face may be in it without its edges. Source: *I♥MESH*, section 4.1.2.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CellularSet {
    /// Elements of dimension 0.
    pub vertices: Set<Vertex>,
    /// Elements of dimension 1.
    pub edges: Set<Edge>,
    /// Elements of dimension 2.
    pub faces: Set<Face>,
    /// Elements of dimension 3.
    pub cells: Set<Cell>,
}
