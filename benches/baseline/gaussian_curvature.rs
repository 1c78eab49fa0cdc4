//! Gaussian curvature of a vertex as its angle defect, K(v) = 2π − Σ θ over the corners at v.
//!
//! θ is the arc cosine of the normalised dot product of the two sides of the corner, at boundary
//! vertices too. In radians, integrated over the cell of the vertex.

use std::f64::consts::TAU;

use glam::DVec3;
use rayon::prelude::*;

use super::{Adjacency, Corner, GRAIN, corners_of};

/// Each vertex adds the angles of its own corners, as the formula is printed.
pub fn gather(positions: &[DVec3], adjacency: &Adjacency) -> Vec<f64> {
    (0..adjacency.n_vertices())
        .map(|v| at_vertex(positions, adjacency, v))
        .collect()
}

/// [`gather`] on all threads.
pub fn gather_parallel(positions: &[DVec3], adjacency: &Adjacency) -> Vec<f64> {
    (0..adjacency.n_vertices())
        .into_par_iter()
        .with_min_len(GRAIN)
        .map(|v| at_vertex(positions, adjacency, v))
        .collect()
}

/// Each face computes its three side lengths and its three angles once and subtracts them at its corners.
pub fn scatter(positions: &[DVec3], triangles: &[[u32; 3]]) -> Vec<f64> {
    let mut curvature = vec![TAU; positions.len()];
    for &triangle in triangles {
        let angles = angles_of_face(corners_of(positions, triangle));
        for (vertex, angle) in triangle.into_iter().zip(angles) {
            curvature[vertex as usize] -= angle;
        }
    }
    curvature
}

/// [`scatter`] on all threads: the angles of all faces first, then each vertex adds those of its corners,
/// so that no two threads write to the same place and the result does not depend on their number.
pub fn scatter_parallel(
    positions: &[DVec3],
    triangles: &[[u32; 3]],
    adjacency: &Adjacency,
) -> Vec<f64> {
    let angles: Vec<[f64; 3]> = triangles
        .par_iter()
        .with_min_len(GRAIN)
        .map(|&triangle| angles_of_face(corners_of(positions, triangle)))
        .collect();
    let angles = angles.as_flattened();
    (0..adjacency.n_vertices())
        .into_par_iter()
        .with_min_len(GRAIN)
        .map(|v| {
            let numbers = adjacency.corner_numbers(v);
            TAU - numbers
                .iter()
                .map(|&number| angles[number as usize])
                .sum::<f64>()
        })
        .collect()
}

/// The curvature of one vertex.
#[inline(always)]
pub fn at_vertex(positions: &[DVec3], adjacency: &Adjacency, vertex: usize) -> f64 {
    let x = positions[vertex];
    let mut sum = 0.0;
    for &Corner { next, previous } in adjacency.corners(vertex) {
        let a = positions[next as usize] - x;
        let b = positions[previous as usize] - x;
        sum += (a.dot(b) / (a.length() * b.length())).acos();
    }
    TAU - sum
}

/// The interior angles of a triangle, in the order of its corners.
#[inline(always)]
pub(super) fn angles_of_face([x, y, z]: [DVec3; 3]) -> [f64; 3] {
    let (xy, yz, zx) = (y - x, z - y, x - z);
    let (length_xy, length_yz, length_zx) = (xy.length(), yz.length(), zx.length());
    [
        (-xy.dot(zx) / (length_xy * length_zx)).acos(),
        (-yz.dot(xy) / (length_yz * length_xy)).acos(),
        (-zx.dot(yz) / (length_zx * length_yz)).acos(),
    ]
}
