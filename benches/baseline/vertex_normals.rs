//! Unit normals of vertices as weighted sums over the faces around them.
//!
//! | weight | sum over the corners, with sides a (to the next vertex) and b (to the previous one) |
//! | --- | --- |
//! | [`Weight::Max`] | (a × b) / (‖a‖² ‖b‖²): N. Max, Weights for computing vertex normals, 1999 |
//! | [`Weight::Area`] | a × b |
//! | [`Weight::Angle`] | θ (a × b) / ‖a × b‖ with the interior angle θ |
//!
//! A vertex without faces has no normal: its value is NaN, as 0/0 is.

use glam::DVec3;
use rayon::prelude::*;

use super::gaussian_curvature::angles_of_face;
use super::{Adjacency, Corner, GRAIN, corners_of};

/// How much each face counts in the normals of its vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// The inverse squares of both sides: exact for vertices of polyhedra inscribed in a sphere.
    Max,
    /// The area of the face.
    Area,
    /// The interior angle of the face at the vertex.
    Angle,
}

/// Each vertex adds over its own corners.
pub fn gather(positions: &[DVec3], adjacency: &Adjacency, weight: Weight) -> Vec<DVec3> {
    // One loop for each weight, so that the choice is not made again at every corner.
    match weight {
        Weight::Max => gather_with(positions, adjacency, max_at_corner),
        Weight::Area => gather_with(positions, adjacency, DVec3::cross),
        Weight::Angle => gather_with(positions, adjacency, angle_at_corner),
    }
}

/// [`gather`] on all threads.
pub fn gather_parallel(positions: &[DVec3], adjacency: &Adjacency, weight: Weight) -> Vec<DVec3> {
    match weight {
        Weight::Max => gather_parallel_with(positions, adjacency, max_at_corner),
        Weight::Area => gather_parallel_with(positions, adjacency, DVec3::cross),
        Weight::Angle => gather_parallel_with(positions, adjacency, angle_at_corner),
    }
}

/// Each face computes its cross product and what its corners share once and adds it to them.
pub fn scatter(positions: &[DVec3], triangles: &[[u32; 3]], weight: Weight) -> Vec<DVec3> {
    match weight {
        Weight::Max => scatter_with(positions, triangles, max_of_face),
        Weight::Area => scatter_with(positions, triangles, area_of_face),
        Weight::Angle => scatter_with(positions, triangles, angle_of_face),
    }
}

/// [`scatter`] on all threads: the weights and the normals of all faces first, then each vertex adds.
///
/// For cheap weights the detour through memory costs more than it saves: [`gather_parallel`] is faster
/// there, and is what one would choose.
pub fn scatter_parallel(
    positions: &[DVec3],
    triangles: &[[u32; 3]],
    adjacency: &Adjacency,
    weight: Weight,
) -> Vec<DVec3> {
    match weight {
        Weight::Max => scatter_parallel_with(positions, triangles, adjacency, max_of_face),
        Weight::Area => scatter_parallel_with(positions, triangles, adjacency, area_of_face),
        Weight::Angle => scatter_parallel_with(positions, triangles, adjacency, angle_of_face),
    }
}

#[inline(always)]
fn max_at_corner(a: DVec3, b: DVec3) -> DVec3 {
    a.cross(b) / (a.length_squared() * b.length_squared())
}

#[inline(always)]
fn angle_at_corner(a: DVec3, b: DVec3) -> DVec3 {
    let angle = (a.dot(b) / (a.length() * b.length())).acos();
    angle * a.cross(b).normalize()
}

/// A direction shared by the three corners of a face, and what it counts at each of them.
type Shared = (DVec3, [f64; 3]);

#[inline(always)]
fn max_of_face([x, y, z]: [DVec3; 3]) -> Shared {
    let (xy, yz, zx) = (y - x, z - y, x - z);
    let (a, b, c) = (
        xy.length_squared(),
        yz.length_squared(),
        zx.length_squared(),
    );
    (xy.cross(yz), [1.0 / (a * c), 1.0 / (b * a), 1.0 / (c * b)])
}

#[inline(always)]
fn area_of_face([x, y, z]: [DVec3; 3]) -> Shared {
    ((y - x).cross(z - x), [1.0; 3])
}

#[inline(always)]
fn angle_of_face([x, y, z]: [DVec3; 3]) -> Shared {
    ((y - x).cross(z - x).normalize(), angles_of_face([x, y, z]))
}

#[inline(always)]
fn at_vertex(
    positions: &[DVec3],
    adjacency: &Adjacency,
    vertex: usize,
    at_corner: impl Fn(DVec3, DVec3) -> DVec3,
) -> DVec3 {
    let x = positions[vertex];
    let mut sum = DVec3::ZERO;
    for &Corner { next, previous } in adjacency.corners(vertex) {
        sum += at_corner(
            positions[next as usize] - x,
            positions[previous as usize] - x,
        );
    }
    sum.normalize()
}

fn gather_with(
    positions: &[DVec3],
    adjacency: &Adjacency,
    at_corner: impl Fn(DVec3, DVec3) -> DVec3,
) -> Vec<DVec3> {
    (0..adjacency.n_vertices())
        .map(|v| at_vertex(positions, adjacency, v, &at_corner))
        .collect()
}

fn gather_parallel_with(
    positions: &[DVec3],
    adjacency: &Adjacency,
    at_corner: impl Fn(DVec3, DVec3) -> DVec3 + Sync,
) -> Vec<DVec3> {
    (0..adjacency.n_vertices())
        .into_par_iter()
        .with_min_len(GRAIN)
        .map(|v| at_vertex(positions, adjacency, v, &at_corner))
        .collect()
}

fn scatter_with(
    positions: &[DVec3],
    triangles: &[[u32; 3]],
    of_face: impl Fn([DVec3; 3]) -> Shared,
) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; positions.len()];
    for &triangle in triangles {
        let (direction, weights) = of_face(corners_of(positions, triangle));
        for (vertex, weight) in triangle.into_iter().zip(weights) {
            normals[vertex as usize] += weight * direction;
        }
    }
    for normal in &mut normals {
        *normal = normal.normalize();
    }
    normals
}

fn scatter_parallel_with(
    positions: &[DVec3],
    triangles: &[[u32; 3]],
    adjacency: &Adjacency,
    of_face: impl Fn([DVec3; 3]) -> Shared + Sync,
) -> Vec<DVec3> {
    let shared: Vec<Shared> = triangles
        .par_iter()
        .with_min_len(GRAIN)
        .map(|&triangle| of_face(corners_of(positions, triangle)))
        .collect();
    (0..adjacency.n_vertices())
        .into_par_iter()
        .with_min_len(GRAIN)
        .map(|v| {
            let mut sum = DVec3::ZERO;
            for &number in adjacency.corner_numbers(v) {
                let (direction, weights) = &shared[number as usize / 3];
                sum += weights[number as usize % 3] * *direction;
            }
            sum.normalize()
        })
        .collect()
}
