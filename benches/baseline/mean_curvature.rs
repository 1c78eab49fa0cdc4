//! Mean curvature of a vertex from the dihedral angles of its edges, H(i) = ¼ Σ lᵢⱼ φᵢⱼ.
//!
//! φᵢⱼ = atan2(e · (n₁ × n₂), n₁ · n₂) with e the unit vector from i to j, n₁ the normal of the face that
//! traverses i → j and n₂ that of the other: positive on convex edges. Boundary edges add nothing.
//! Integrated over the cell of the vertex, with the unit of a length.

use glam::DVec3;
use rayon::prelude::*;

use super::{Adjacency, Edges, GRAIN, NONE, Neighbour, corners_of};

/// Each vertex visits its edges and computes both normals of each from the positions, as the formula is
/// printed: N(f) = ((xⱼ − xᵢ) × (xₖ − xᵢ)) / (‖xⱼ − xᵢ‖ ‖xₖ − xᵢ‖).
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

/// The normals once per face, lᵢⱼ φᵢⱼ once per edge, added at both ends.
///
/// The angle does not depend on the lengths of the normals, so they are not normalised.
pub fn scatter(positions: &[DVec3], triangles: &[[u32; 3]], edges: &Edges) -> Vec<f64> {
    let normals: Vec<DVec3> = triangles
        .iter()
        .map(|&triangle| normal_of_face(corners_of(positions, triangle)))
        .collect();
    let mut curvature = vec![0.0; positions.len()];
    for (&[a, b], &faces) in edges.ends.iter().zip(&edges.faces) {
        let share = at_edge(positions, &normals, [a, b], faces);
        curvature[a as usize] += share;
        curvature[b as usize] += share;
    }
    curvature
}

/// [`scatter`] on all threads: normals per face and values per edge as there; then each vertex adds the
/// values of its edges, found through `edges_of_vertices`, see [`edges_of_vertices`].
pub fn scatter_parallel(
    positions: &[DVec3],
    triangles: &[[u32; 3]],
    edges: &Edges,
    adjacency: &Adjacency,
    edges_of_vertices: &[u32],
) -> Vec<f64> {
    let normals: Vec<DVec3> = triangles
        .par_iter()
        .with_min_len(GRAIN)
        .map(|&triangle| normal_of_face(corners_of(positions, triangle)))
        .collect();
    let shares: Vec<f64> = edges
        .ends
        .par_iter()
        .zip(&edges.faces)
        .with_min_len(GRAIN)
        .map(|(&ends, &faces)| at_edge(positions, &normals, ends, faces))
        .collect();
    adjacency
        .neighbour_offsets
        .par_windows(2)
        .with_min_len(GRAIN)
        .map(|range| {
            let edges = &edges_of_vertices[range[0] as usize..range[1] as usize];
            edges.iter().map(|&edge| shares[edge as usize]).sum()
        })
        .collect()
}

/// The edges at each vertex, in the rows of [`Adjacency::neighbours`]; for [`scatter_parallel`].
pub fn edges_of_vertices(edges: &Edges, adjacency: &Adjacency) -> Vec<u32> {
    let mut cursor = adjacency.neighbour_offsets.clone();
    let mut rows = vec![NONE; edges.ends.len() * 2];
    for (edge, &ends) in edges.ends.iter().enumerate() {
        for vertex in ends {
            let slot = &mut cursor[vertex as usize];
            rows[*slot as usize] = edge as u32;
            *slot += 1;
        }
    }
    rows
}

#[inline(always)]
fn at_vertex(positions: &[DVec3], adjacency: &Adjacency, vertex: usize) -> f64 {
    let x = positions[vertex];
    let mut sum = 0.0;
    for &Neighbour {
        vertex,
        opposite_forward,
        opposite_backward,
    } in adjacency.neighbours(vertex)
    {
        if opposite_forward == NONE || opposite_backward == NONE {
            continue;
        }
        let along = positions[vertex as usize] - x;
        let to_forward = positions[opposite_forward as usize] - x;
        let to_backward = positions[opposite_backward as usize] - x;
        let length = along.length();
        let normal_forward = along.cross(to_forward) / (length * to_forward.length());
        let normal_backward = to_backward.cross(along) / (to_backward.length() * length);
        let sine = (along / length).dot(normal_forward.cross(normal_backward));
        sum += length * sine.atan2(normal_forward.dot(normal_backward));
    }
    0.25 * sum
}

/// The normal of a triangle, with twice its area as length.
#[inline(always)]
fn normal_of_face([x, y, z]: [DVec3; 3]) -> DVec3 {
    (y - x).cross(z - x)
}

/// ¼ l φ of one edge, 0 on the boundary.
#[inline(always)]
fn at_edge(positions: &[DVec3], normals: &[DVec3], [a, b]: [u32; 2], faces: [u32; 2]) -> f64 {
    let [forward, backward] = faces;
    if forward == NONE || backward == NONE {
        return 0.0;
    }
    let along = positions[b as usize] - positions[a as usize];
    let (n1, n2) = (normals[forward as usize], normals[backward as usize]);
    // Both arguments of the arc tangent carry the factor l ‖n₁‖ ‖n₂‖, which it cancels.
    let length = along.length();
    0.25 * length * along.dot(n1.cross(n2)).atan2(length * n1.dot(n2))
}
