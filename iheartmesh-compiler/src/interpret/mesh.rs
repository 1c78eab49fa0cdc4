//! Meshes as the interpreter sees them, and vectors over their elements.

use std::collections::BTreeMap;

use super::Value;
use crate::ir::{Boundary, Neighbor};
use crate::types::MeshId;

/// A mesh by its boundary matrices.
pub trait Mesh {
    /// The number of elements of a dimension: 0 for vertices, 1 for edges, 2 for faces, 3 for cells.
    fn count(&self, dimension: usize) -> usize;
    /// The entries of `∂ᵏ` for k = `dimension` that are not 0, by row (an element of dimension k − 1) and column (one of
    /// dimension k): each −1 or 1.
    fn boundary(&self, dimension: usize) -> Vec<(u32, u32, i8)>;
}

/// The entries of a boundary matrix that are not 0: row, column, value.
pub(super) fn entries(mesh: &dyn Mesh, boundary: Boundary) -> Vec<(u32, u32, i64)> {
    let entries = mesh.boundary(usize::from(boundary.dimension)).into_iter();
    let entries = entries.map(|(row, column, sign)| {
        let entry = match boundary.signed {
            true => i64::from(sign),
            false => 1,
        };
        match boundary.transposed {
            false => (row, column, entry),
            true => (column, row, entry),
        }
    });
    entries.collect()
}

/// The number of rows and of columns of a boundary matrix.
pub(super) fn shape(mesh: &dyn Mesh, boundary: Boundary) -> (usize, usize) {
    let k = usize::from(boundary.dimension);
    match boundary.transposed {
        false => (mesh.count(k - 1), mesh.count(k)),
        true => (mesh.count(k), mesh.count(k - 1)),
    }
}

/// The product of a boundary matrix and a chain; `None` where an entry is too large.
pub(super) fn product(
    mesh: &dyn Mesh,
    boundary: Boundary,
    chain: &BTreeMap<u32, i64>,
) -> Option<BTreeMap<u32, i64>> {
    let mut sums = BTreeMap::new();
    for (row, column, entry) in entries(mesh, boundary) {
        if let Some(factor) = chain.get(&column) {
            let sum: &mut i64 = sums.entry(row).or_insert(0);
            *sum = sum.checked_add(entry.checked_mul(*factor)?)?;
        }
    }
    Some(sums)
}

/// The elements whose entry is as asked for.
pub(super) fn where_entry(chain: &BTreeMap<u32, i64>, asked: impl Fn(i64) -> bool) -> Value {
    let found = chain.iter().filter(|(_, entry)| asked(**entry));
    Value::Set(found.map(|(id, _)| Value::Element(*id)).collect())
}

/// The least element beside two others.
pub(super) fn neighbor(
    meshes: &BTreeMap<MeshId, &dyn Mesh>,
    neighbor: Neighbor,
    a: u32,
    b: u32,
) -> Option<u32> {
    let (Neighbor::EdgeBetween(mesh)
    | Neighbor::VertexInFace(mesh, _)
    | Neighbor::FaceWith(mesh, _)
    | Neighbor::FaceWithout(mesh, _)) = neighbor;
    let entries = |dimension| -> BTreeMap<(u32, u32), i8> {
        let entries = meshes[&mesh].boundary(dimension).into_iter();
        entries
            .map(|(row, column, sign)| ((row, column), sign))
            .collect()
    };
    let of_edges = entries(1);
    let of_faces = match neighbor {
        Neighbor::EdgeBetween(_) => BTreeMap::new(),
        _ => entries(2),
    };
    let ends = |edge: u32| {
        of_edges
            .keys()
            .filter(move |(_, e)| *e == edge)
            .map(|(vertex, _)| *vertex)
    };
    let product =
        |face, edge, vertex| match (of_faces.get(&(edge, face)), of_edges.get(&(vertex, edge))) {
            (Some(s), Some(t)) => s * t,
            _ => 0,
        };
    match neighbor {
        Neighbor::EdgeBetween(_) => {
            let edges = of_edges.keys().map(|(_, edge)| *edge);
            edges
                .filter(|edge| ends(*edge).any(|v| v == a) && ends(*edge).any(|v| v == b))
                .min()
        }
        Neighbor::VertexInFace(_, sign) => {
            let edges = of_faces
                .keys()
                .filter(|(_, face)| *face == a)
                .map(|(edge, _)| *edge);
            let edges = edges.filter(|edge| product(a, *edge, b) == sign);
            edges.flat_map(ends).filter(|vertex| *vertex != b).min()
        }
        Neighbor::FaceWith(_, sign) | Neighbor::FaceWithout(_, sign) => {
            let is_with = matches!(neighbor, Neighbor::FaceWith(..));
            let faces = of_faces
                .keys()
                .filter(|(edge, _)| *edge == a)
                .map(|(_, face)| *face);
            faces
                .filter(|face| (product(*face, a, b) == sign) == is_with)
                .min()
        }
    }
}
