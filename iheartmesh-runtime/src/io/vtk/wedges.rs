//! The two orders of the corners of a wedge.
//!
//! In VTK of today the normal of the triangle (0, 1, 2), by the right-hand rule, points towards the triangle (3, 4, 5), as
//! in its other prisms and in Gmsh; in the documentation of older versions, and in the files of programs that go by
//! it (meshio is one), it points away. A file does not say which order it has. So all wedges of a file are read in the order
//! in which more of them have a positive volume, and in that of today if it is the same; one that is inverted among others
//! stays so. Where prisms would be read in the wrong order, they are written as polyhedra.

use glam::DVec3;

/// Whether so many of the wedges with these corners have a negative volume in the order of today that they are of the other.
/// Corners that are no vertices are left out.
pub(super) fn are_reversed(wedges: impl Iterator<Item = [i64; 6]>, positions: &[DVec3]) -> bool {
    let positive: i64 = wedges
        .filter_map(|wedge| {
            let mut corners = [DVec3::ZERO; 6];
            for (corner, number) in corners.iter_mut().zip(wedge) {
                *corner = *positions.get(usize::try_from(number).ok()?)?;
            }
            Some(sign(six_volumes(&corners)))
        })
        .sum();
    positive < 0
}

/// Six times the volume of a wedge, whose quadrilaterals are divided along diagonals.
fn six_volumes(corners: &[DVec3; 6]) -> f64 {
    // both diagonals of each, so that the order of the corners does not matter: the mean of two divisions
    let from_first = |k: usize| corners[k] - corners[0];
    let triangle =
        |a: usize, b: usize, c: usize| from_first(a).dot(from_first(b).cross(from_first(c)));
    let quadrilateral = |a, b, c, d| {
        0.5 * (triangle(a, b, c) + triangle(a, c, d) + triangle(a, b, d) + triangle(b, c, d))
    };
    let around = quadrilateral(0, 1, 4, 3) + quadrilateral(1, 2, 5, 4) + quadrilateral(2, 0, 3, 5);
    triangle(0, 2, 1) + triangle(3, 4, 5) + around
}

/// −1, 0 or 1; 0 for what is not a number.
fn sign(x: f64) -> i64 {
    i64::from(x > 0.0) - i64::from(x < 0.0)
}
