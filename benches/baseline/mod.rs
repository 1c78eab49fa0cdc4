//! What a careful person writes by hand: the yardstick for the generated code.
//!
//! Every quantity exists as a *gather* (each vertex reads its own neighbourhood, the form in which
//! papers print the formula) and as a *scatter* (each face or edge computes what its corners share
//! once and adds it to them, the form with the least arithmetic), each on one thread and on all
//! threads of the current `rayon` pool. The connectivity is computed beforehand, in [`Adjacency`] and
//! [`Edges`], and no function here searches, sorts or builds a set while it evaluates.
//!
//! The meshes are triangle meshes, oriented, with or without boundary, in which at most two faces
//! share an edge; [`Edges::new`] panics on anything else, because a benchmark must not silently
//! measure something different.

// Every program that includes this module uses only a part of it.
#![allow(dead_code, unused_imports)]

mod adjacency;
mod edges;
pub mod gaussian_curvature;
pub mod mean_curvature;
pub mod symmetric_dirichlet;
pub mod vertex_normals;

pub use adjacency::{Adjacency, Corner, Neighbour};
pub use edges::Edges;

/// Marks a face or a vertex that does not exist: the other side of a boundary edge.
pub const NONE: u32 = u32::MAX;

/// The least number of vertices, edges or faces that one parallel task handles.
const GRAIN: usize = 2048;

/// The positions of the three vertices of a face.
#[inline(always)]
fn corners_of(positions: &[glam::DVec3], [i, j, k]: [u32; 3]) -> [glam::DVec3; 3] {
    [
        positions[i as usize],
        positions[j as usize],
        positions[k as usize],
    ]
}
