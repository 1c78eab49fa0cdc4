//! From cells to their faces.
//!
//! Each side of each cell is brought into one form: the cycle that starts at its smallest vertex and goes on to the
//! smaller of the two next to it, with the sign by which the side, seen from outside of the cell, differs from it. Sides
//! with the same form are one face. Sorting the sides by their vertices numbers the faces.

use rayon::prelude::*;

use super::polygon_edges::{self, Polygons};
use crate::boundary::Columns;
use crate::complex::CellComplex;

/// Faces of cells that are all triangles, or polygons.
pub(super) struct Sides {
    /// For each cell, where its sides start; and the end.
    pub(super) cells: Vec<u32>,
    /// For each side, where its corners start; and the end.
    pub(super) starts: Vec<u32>,
    /// The corners of all sides, in cyclic order, counter-clockwise seen from outside.
    pub(super) corners: Vec<u32>,
}

/// A complex with its faces as cycles of vertices.
pub(super) struct Faces {
    pub(super) complex: CellComplex,
    pub(super) starts: Vec<u32>,
    pub(super) corners: Vec<u32>,
}

/// The form of a side, in place: the smallest vertex first, then the smaller of its neighbours. Says whether the side
/// runs along it (+1) or against it (−1).
pub(super) fn normalize(corners: &mut [u32]) -> i8 {
    let smallest = (0..corners.len())
        .min_by_key(|&k| corners[k])
        .unwrap_or_default();
    corners.rotate_left(smallest);
    if corners[1] < corners[corners.len() - 1] {
        return 1;
    }
    corners[1..].reverse();
    -1
}

/// The complex of vertices, edges, faces and cells. All sides have at least three corners, all of them different, and no
/// cell has a side twice.
pub(super) fn complex(n_vertices: usize, sides: Sides) -> Faces {
    let n_sides = sides.starts.len() - 1;
    let mut corners = sides.corners;
    let triangles = sides
        .starts
        .windows(2)
        .all(|range| range[1] - range[0] == 3);
    let mut signs = vec![0_i8; n_sides];
    let mut slices: Vec<&mut [u32]> = Vec::with_capacity(n_sides);
    let mut rest = corners.as_mut_slice();
    for range in sides.starts.windows(2) {
        let (side, after) = rest.split_at_mut((range[1] - range[0]) as usize);
        slices.push(side);
        rest = after;
    }
    slices
        .into_par_iter()
        .zip(signs.par_iter_mut())
        .with_min_len(1 << 12)
        .for_each(|(side, sign)| *sign = normalize(side));

    let order = match triangles {
        true => order_of_triangles(&corners),
        false => order_of_polygons(&sides.starts, &corners),
    };
    let side = |k: u32| {
        let range = sides.starts[k as usize] as usize..sides.starts[k as usize + 1] as usize;
        &corners[range]
    };
    let mut face_of = vec![0_u32; n_sides];
    let (mut face_starts, mut face_corners) = (vec![0_u32], Vec::new());
    let mut last: Option<u32> = None;
    for &k in &order {
        if last.is_none_or(|last| side(last) != side(k)) {
            face_corners.extend_from_slice(side(k));
            face_starts.push(face_corners.len() as u32);
        }
        last = Some(k);
        face_of[k as usize] = face_starts.len() as u32 - 2;
    }
    drop(order);
    let n_faces = face_starts.len() - 1;

    let mut columns = Columns {
        pointers: sides.cells,
        width: 0,
        rows: face_of,
        signs,
    };
    for range in columns.pointers.windows(2) {
        let range = range[0] as usize..range[1] as usize;
        let mut column: Vec<(u32, i8)> = columns.rows[range.clone()]
            .iter()
            .copied()
            .zip(columns.signs[range.clone()].iter().copied())
            .collect();
        column.sort_unstable();
        for (place, (face, sign)) in range.zip(column) {
            columns.rows[place] = face;
            columns.signs[place] = sign;
        }
    }
    let transpose = columns.transposed(n_faces);
    let skeleton = polygon_edges::complex(Polygons {
        n_vertices,
        starts: match triangles {
            true => Vec::new(),
            false => face_starts.clone(),
        },
        corners: &face_corners,
        all_triangles: triangles,
    });
    Faces {
        complex: skeleton.with_cells(columns, transpose),
        starts: face_starts,
        corners: face_corners,
    }
}

/// The numbers of triangles, sorted by their vertices.
fn order_of_triangles(corners: &[u32]) -> Vec<u32> {
    let mut keys: Vec<([u32; 3], u32)> = corners
        .as_chunks::<3>()
        .0
        .iter()
        .enumerate()
        .map(|(k, side)| (*side, k as u32))
        .collect();
    keys.par_sort_unstable();
    keys.into_iter().map(|(_, k)| k).collect()
}

/// The numbers of polygons, sorted by their sorted vertices, then by their cycles.
fn order_of_polygons(starts: &[u32], corners: &[u32]) -> Vec<u32> {
    let mut sorted = corners.to_vec();
    for range in starts.windows(2) {
        sorted[range[0] as usize..range[1] as usize].sort_unstable();
    }
    let range = |k: u32| starts[k as usize] as usize..starts[k as usize + 1] as usize;
    let mut order: Vec<u32> = (0..starts.len() as u32 - 1).collect();
    order.par_sort_unstable_by(|&a, &b| {
        let key = |k: u32| (&sorted[range(k)], &corners[range(k)], k);
        key(a).cmp(&key(b))
    });
    order
}
