//! The matrices of numbered edges that do not come with their numbers: the edges around each vertex, those of each face.

use std::ops::Range;

use rayon::prelude::*;

use super::polygon_edges::{Polygons, map, take};
use crate::boundary::Columns;

/// ∂¹ᵀ: around each vertex first the edges that end there (they start at a smaller vertex), then those that start.
pub(super) fn vertex_edges(
    edge_vertices: &[u32],
    first_edges: &[u32],
    ranges: Vec<Range<usize>>,
) -> Columns {
    let edge_vertices = edge_vertices.as_chunks::<2>().0;
    let counts = map(ranges.clone(), |range| {
        let mut counts = vec![0_u32; range.len()];
        for &[_, head] in edge_vertices {
            if let Some(count) = counts.get_mut(head.wrapping_sub(range.start as u32) as usize) {
                *count += 1;
            }
        }
        counts
    });
    let mut pointers = Vec::with_capacity(first_edges.len());
    pointers.push(0);
    let mut end = 0;
    for (ending, starting) in counts.iter().flatten().zip(first_edges.windows(2)) {
        end += ending + starting[1] - starting[0];
        pointers.push(end);
    }

    let mut rows = vec![0; 2 * edge_vertices.len()];
    let mut signs = vec![0; 2 * edge_vertices.len()];
    let mut tasks = Vec::with_capacity(ranges.len());
    let (mut all_rows, mut all_signs) = (&mut rows[..], &mut signs[..]);
    for range in ranges {
        let length = (pointers[range.end] - pointers[range.start]) as usize;
        tasks.push((
            range,
            take(&mut all_rows, length),
            take(&mut all_signs, length),
        ));
    }
    map(tasks, |(range, rows, signs)| {
        let offset = pointers[range.start];
        let mut cursors: Vec<u32> = pointers[range.clone()]
            .iter()
            .map(|pointer| pointer - offset)
            .collect();
        for (edge, &[_, head]) in edge_vertices.iter().enumerate() {
            if let Some(cursor) = cursors.get_mut(head.wrapping_sub(range.start as u32) as usize) {
                rows[*cursor as usize] = edge as u32;
                *cursor += 1;
            }
        }
        for (vertex, cursor) in range.zip(cursors) {
            let start = (pointers[vertex] - offset) as usize;
            let (middle, end) = (cursor as usize, (pointers[vertex + 1] - offset) as usize);
            for (row, edge) in rows[middle..end].iter_mut().zip(first_edges[vertex]..) {
                *row = edge;
            }
            signs[start..middle].fill(1);
            signs[middle..end].fill(-1);
        }
    });
    Columns {
        pointers,
        width: 0,
        rows,
        signs,
    }
}

/// The entries of ∂²: the edges of each face, ascending, +1 where the face runs along the edge.
pub(super) fn face_edges(
    polygons: &Polygons,
    mut edges: Vec<u32>,
    parallel: bool,
) -> (Vec<u32>, Vec<i8>) {
    let mut signs = vec![0_i8; edges.len()];
    if polygons.all_triangles {
        let rows = edges.as_chunks_mut::<3>().0;
        let signs = signs.as_chunks_mut::<3>().0;
        let corners = polygons.corners.as_chunks::<3>().0;
        let run = |((rows, signs), corners): ((&mut [u32; 3], &mut [i8; 3]), &[u32; 3])| {
            let [a, b, c] = *corners;
            let mut sides = [(rows[0], a < b), (rows[1], b < c), (rows[2], c < a)];
            for (i, j) in [(0, 1), (1, 2), (0, 1)] {
                if sides[i].0 > sides[j].0 {
                    sides.swap(i, j);
                }
            }
            *rows = sides.map(|(edge, _)| edge);
            *signs = sides.map(|(_, along)| if along { 1 } else { -1 });
        };
        if parallel {
            rows.par_iter_mut()
                .zip(signs)
                .zip(corners)
                .with_min_len(1 << 12)
                .for_each(run);
        } else {
            rows.iter_mut().zip(signs).zip(corners).for_each(run);
        }
    } else {
        let mut sides: Vec<(u32, i8)> = Vec::new();
        for range in polygons.starts.windows(2) {
            let range = range[0] as usize..range[1] as usize;
            let corners = &polygons.corners[range.clone()];
            let next = corners[1..].iter().chain(corners.first());
            let along = corners
                .iter()
                .zip(next)
                .map(|(tail, head)| if tail < head { 1 } else { -1 });
            sides.clear();
            sides.extend(edges[range.clone()].iter().copied().zip(along));
            sides.sort_unstable();
            for (position, &(edge, sign)) in range.zip(&sides) {
                edges[position] = edge;
                signs[position] = sign;
            }
        }
    }
    (edges, signs)
}
