//! [`EdgeMesh`]: a graph, as of a point cloud.

use std::fmt::{self, Debug};
use std::sync::Arc;

use rayon::prelude::*;

use super::MeshError;
use super::accessors::accessors;
use super::graph::{self, Point};
use crate::boundary::{BoundaryMatrix, Columns, MAX_EDGES, MAX_ELEMENTS};
use crate::complex::CellComplex;
use crate::element::{Edge, ElementKind, ElementSlice, Elements, Vertex};

/// A mesh of vertices and edges with the boundary matrix ∂¹: a graph, a curve network, the neighbours in a point cloud.
///
/// Only connectivity, no positions. A mesh never changes; clones share its memory.
///
/// **Numbering.** Vertices keep the order of the input. Edges are numbered lexicographically by their two vertices, the
/// smaller first, and oriented from the smaller vertex (tail) to the larger (head), except in a mesh made
/// [from a boundary matrix](Self::from_boundary_matrices), which keeps its own. An edge that is given twice, in either
/// direction, is one edge.
///
/// **Signs.** ∂¹(v, e) is −1 at the tail of e and +1 at its head.
///
/// Accessors panic if given an element that the mesh does not have, as indexing a slice does.
#[derive(Clone)]
pub struct EdgeMesh {
    complex: Arc<CellComplex>,
}

impl EdgeMesh {
    /// The mesh of edges given by their two vertices (numbers from 0), in either order.
    ///
    /// ```
    /// # use iheartmesh_runtime::{EdgeMesh, Edge, Vertex};
    /// let mesh = EdgeMesh::from_edges(4, &[[2, 1], [0, 1], [1, 2]])?;
    /// assert_eq!(mesh.n_edges(), 2);
    /// assert_eq!(mesh.edge_vertices(Edge::new(1)), [Vertex::new(1), Vertex::new(2)]);
    /// # Ok::<(), iheartmesh_runtime::MeshError>(())
    /// ```
    ///
    /// # Errors
    /// - [`MeshError::VertexOutOfRange`] if an edge names a vertex that is not below `n_vertices`;
    /// - [`MeshError::RepeatedVertex`] if both ends of one are the same vertex;
    /// - [`MeshError::TooManyElements`] if 32 bits cannot number the vertices, or the entries of ∂¹: more than 2³¹ − 1 edges
    ///   are given.
    ///
    /// Of several bad edges the first is reported.
    pub fn from_edges(n_vertices: usize, edges: &[[u32; 2]]) -> Result<EdgeMesh, MeshError> {
        check_count(ElementKind::Vertex, n_vertices)?;
        check_count(ElementKind::Edge, edges.len())?;
        for (element, &[a, b]) in edges.iter().enumerate() {
            let kind = ElementKind::Edge;
            if let Some(corner) = [a, b].iter().position(|&v| v as usize >= n_vertices) {
                return Err(MeshError::VertexOutOfRange {
                    kind,
                    element,
                    corner,
                    vertex: [a, b][corner],
                    n_vertices,
                });
            }
            if a == b {
                return Err(MeshError::RepeatedVertex {
                    kind,
                    element,
                    vertex: a,
                });
            }
        }
        let pairs = edges.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        Ok(Self::from_pairs(n_vertices, pairs))
    }

    /// The edges between each point and its `k` nearest others: two points are joined if either is among the `k` nearest
    /// of the other (Dong et al., *I♥MESH*, section 6). Of several points at the same distance those with the smaller
    /// numbers count as nearer. With fewer than `k` other points, all are joined.
    ///
    /// Uses a k-d tree and rayon's threads; the result does not depend on how many.
    ///
    /// # Errors
    /// [`MeshError::NotFinite`] for a point with a coordinate that is not finite, [`MeshError::TooManyElements`] if
    /// 32 bits cannot number the points, or if there are more than 2³¹ − 1 edges; these are counted before they are kept.
    pub fn from_k_nearest<P: Point>(points: &[P], k: usize) -> Result<EdgeMesh, MeshError> {
        Ok(Self::from_pairs(points.len(), graph::k_nearest(points, k)?))
    }

    /// The edges between all pairs of different points whose distance is at most `radius`.
    ///
    /// Uses a k-d tree and rayon's threads; the result does not depend on how many.
    ///
    /// # Errors
    /// Those of [`from_k_nearest`](Self::from_k_nearest), and [`MeshError::InvalidRadius`] unless `radius` is a number
    /// that is at least 0.
    pub fn from_radius<P: Point>(points: &[P], radius: f64) -> Result<EdgeMesh, MeshError> {
        Ok(Self::from_pairs(
            points.len(),
            graph::within_radius(points, radius)?,
        ))
    }

    /// The mesh of pairs, each with the smaller vertex first.
    fn from_pairs(n_vertices: usize, mut pairs: Vec<[u32; 2]>) -> EdgeMesh {
        pairs.par_sort_unstable();
        pairs.dedup();
        let columns = Columns {
            pointers: Vec::new(),
            width: 2,
            rows: pairs.into_flattened(),
            signs: Vec::new(),
        };
        let transpose = columns.transposed(n_vertices);
        EdgeMesh {
            complex: Arc::new(CellComplex::new(
                n_vertices,
                true,
                vec![(columns, transpose)],
            )),
        }
    }

    /// The mesh with this boundary matrix ∂¹ (vertices × edges), in either storage order of `sprs`. All numbers and
    /// orientations are those of the matrix.
    ///
    /// # Errors
    /// Those of [`CellComplex::from_boundary_matrices`].
    pub fn from_boundary_matrices(d1: &BoundaryMatrix) -> Result<EdgeMesh, MeshError> {
        let complex = Arc::new(CellComplex::from_boundary_matrices(&[d1])?);
        Ok(EdgeMesh { complex })
    }
}

accessors! {
    EdgeMesh, "matrix", complex: complex,
    vertices: "those without edges included",
    elements: [n_edges edges Edge 1 "edges"],
    boundary: "∂¹, vertices × edges.",
    transpose: "(∂¹)ᵀ, edges × vertices. Entries −1 and +1, compressed columns.",
    unsigned: "|∂¹|",
    which: "k is 1",
    euler: "|V| − |E|.",
}

/// At most as many elements of a kind as can be numbered.
pub(super) fn check_count(kind: ElementKind, count: usize) -> Result<(), MeshError> {
    let maximum = match kind {
        ElementKind::Edge => MAX_EDGES,
        _ => MAX_ELEMENTS,
    };
    match count > maximum {
        true => Err(MeshError::TooManyElements {
            kind,
            count,
            maximum,
        }),
        false => Ok(()),
    }
}
