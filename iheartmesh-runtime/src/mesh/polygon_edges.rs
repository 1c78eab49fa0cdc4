//! From polygons to edges and boundary matrices.
//!
//! An edge is known by its two vertices, the smaller one first. All half-edges (one for each corner, to the next
//! corner) are put into one bucket for each smaller vertex by a counting sort, and each bucket, which holds about as
//! many half-edges as a vertex has edges, is sorted by the larger vertex. Walking the buckets in order meets the edges
//! in lexicographic order, and at each edge its faces in ascending order, so all four matrices are written in place:
//! nothing is hashed, searched or transposed.
//!
//! In parallel, each thread owns a range of smaller (for ∂¹ᵀ: larger) vertices and reads all half-edges, keeping its
//! own. The result does not depend on the number of threads.

use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

use rayon::prelude::*;

use crate::boundary::{BoundaryMatrix, Columns};
use crate::complex::CellComplex;

/// Most corners that a mesh may have: the number of a half-edge and its direction share 32 bits.
pub(crate) const MAX_CORNERS: usize = u32::MAX as usize >> 1;

/// Below this many corners threads cost more than they bring.
const MIN_PARALLEL_CORNERS: usize = 1 << 15;

/// Faces as vertex lists, already validated: face f has the corners `corners[starts[f]..starts[f + 1]]`.
pub(crate) struct Polygons<'a> {
    pub(crate) n_vertices: usize,
    pub(crate) starts: &'a [u32],
    pub(crate) corners: &'a [u32],
    pub(crate) all_triangles: bool,
}

/// The half-edges whose smaller vertex lies in a range, in the order of their edges.
struct Buckets {
    vertices: Range<usize>,
    /// For each vertex of the range, where its bucket starts in `half_edges`; and the end.
    starts: Vec<u32>,
    /// Larger vertex (32 bits), corner at which the half-edge starts (31 bits), whether it runs down (1 bit).
    half_edges: Vec<u64>,
    /// For each vertex of the range, how many edges the buckets before it hold; and the total.
    first_edges: Vec<u32>,
}

#[inline]
fn pack(larger: u32, corner: u32, downwards: bool) -> u64 {
    u64::from(larger) << 32 | u64::from(corner << 1) | u64::from(downwards)
}

#[inline]
fn larger_vertex(half_edge: u64) -> u32 {
    (half_edge >> 32) as u32
}

/// The complex of the polygons, edges numbered lexicographically and oriented from the smaller to the larger vertex.
pub(crate) fn complex(polygons: &Polygons) -> CellComplex {
    let n_threads = if polygons.corners.len() < MIN_PARALLEL_CORNERS {
        1
    } else {
        rayon::current_num_threads()
    };
    let ranges = split(polygons.n_vertices, n_threads.min(16));

    let buckets = map(ranges.clone(), |range| buckets(polygons, range));
    let edges = number_edges(polygons, &buckets);
    let first_edges = first_edges(&buckets, polygons.n_vertices);
    drop(buckets);

    let n_edges = edges.edge_faces.pointers.len() - 1;
    let n_faces = polygons.starts.len() - 1;
    let n_vertices = polygons.n_vertices;
    let parallel = n_threads > 1;
    let (edge_matrices, face_matrices) = join(
        parallel,
        || {
            let vertex_edges = vertex_edges(&edges.vertices, &first_edges, ranges);
            join(
                parallel,
                || edge_matrix(edges.vertices, n_vertices),
                || vertex_edges.into_matrix(n_edges),
            )
        },
        || {
            join(
                parallel,
                || face_matrix(polygons, edges.of_corner, n_edges, parallel),
                || edges.edge_faces.into_matrix(n_faces),
            )
        },
    );
    CellComplex::new(n_vertices, true, vec![edge_matrices, face_matrices])
}

fn join<A: Send, B: Send>(
    parallel: bool,
    first: impl FnOnce() -> A + Send,
    second: impl FnOnce() -> B + Send,
) -> (A, B) {
    if parallel {
        rayon::join(first, second)
    } else {
        (first(), second())
    }
}

/// `0..n` in at most `parts` consecutive ranges (at least one) of about equal length.
fn split(n: usize, parts: usize) -> Vec<Range<usize>> {
    let length = n.div_ceil(parts.max(1)).max(1);
    (0..n.div_ceil(length).max(1))
        .map(|part| part * length..n.min((part + 1) * length))
        .collect()
}

/// The results of all tasks in order; on this thread if there is only one.
fn map<T: Send, R: Send>(tasks: Vec<T>, run: impl Fn(T) -> R + Sync + Send) -> Vec<R> {
    if tasks.len() == 1 {
        tasks.into_iter().map(run).collect()
    } else {
        tasks.into_par_iter().map(run).collect()
    }
}

/// Calls `visit(corner, vertex at it, vertex at the next corner of the face)` for every half-edge.
#[inline]
fn for_each_half_edge(polygons: &Polygons, mut visit: impl FnMut(u32, u32, u32)) {
    if polygons.all_triangles {
        for (face, &[a, b, c]) in polygons.corners.as_chunks::<3>().0.iter().enumerate() {
            let corner = 3 * face as u32;
            visit(corner, a, b);
            visit(corner + 1, b, c);
            visit(corner + 2, c, a);
        }
    } else {
        for range in polygons.starts.windows(2) {
            let corners = &polygons.corners[range[0] as usize..range[1] as usize];
            for (offset, &vertex) in corners.iter().enumerate() {
                let next = corners.get(offset + 1).unwrap_or(&corners[0]);
                visit(range[0] + offset as u32, vertex, *next);
            }
        }
    }
}

fn buckets(polygons: &Polygons, vertices: Range<usize>) -> Buckets {
    let first_vertex = vertices.start as u32;
    let mut starts = vec![0_u32; vertices.len() + 1];
    for_each_half_edge(polygons, |_, tail, head| {
        // Vertices before the range wrap around to numbers past its end.
        if let Some(count) = starts[1..].get_mut(tail.min(head).wrapping_sub(first_vertex) as usize)
        {
            *count += 1;
        }
    });
    for i in 1..starts.len() {
        starts[i] += starts[i - 1];
    }

    let mut cursors = starts[..vertices.len()].to_vec();
    let mut half_edges = vec![0_u64; starts[vertices.len()] as usize];
    for_each_half_edge(polygons, |corner, tail, head| {
        if let Some(cursor) = cursors.get_mut(tail.min(head).wrapping_sub(first_vertex) as usize) {
            half_edges[*cursor as usize] = pack(tail.max(head), corner, head < tail);
            *cursor += 1;
        }
    });

    // The corners of a bucket ascend already, and they are distinct: sorting the packed numbers keeps them in order.
    let mut first_edges = cursors;
    first_edges.push(0);
    let mut n_edges = 0;
    for (first_edge, range) in first_edges.iter_mut().zip(starts.windows(2)) {
        *first_edge = n_edges;
        let bucket = &mut half_edges[range[0] as usize..range[1] as usize];
        sort(bucket);
        let mut last = None;
        for &half_edge in &*bucket {
            let larger = Some(larger_vertex(half_edge));
            n_edges += u32::from(larger != last);
            last = larger;
        }
    }
    first_edges[vertices.len()] = n_edges;
    Buckets {
        vertices,
        starts,
        half_edges,
        first_edges,
    }
}

/// Insertion sort in place for the short buckets of ordinary meshes, the library's sort for others.
#[inline]
fn sort(bucket: &mut [u64]) {
    if bucket.len() > 24 {
        return bucket.sort_unstable();
    }
    for i in 1..bucket.len() {
        let value = bucket[i];
        let mut hole = i;
        while hole > 0 && bucket[hole - 1] > value {
            bucket[hole] = bucket[hole - 1];
            hole -= 1;
        }
        bucket[hole] = value;
    }
}

/// The numbered edges.
struct Edges {
    /// Tail and head of each edge.
    vertices: Vec<u32>,
    /// ∂²ᵀ: the faces around each edge.
    edge_faces: Columns,
    /// The edge from each corner to the next corner of its face.
    of_corner: Vec<u32>,
}

/// What one range of buckets writes.
struct EdgeTask<'a> {
    buckets: &'a Buckets,
    first_edge: u32,
    first_half_edge: u32,
    vertices: &'a mut [u32],
    pointers: &'a mut [u32],
    faces: &'a mut [u32],
    signs: &'a mut [i8],
}

fn number_edges(polygons: &Polygons, buckets: &[Buckets]) -> Edges {
    let n_corners = polygons.corners.len();
    let n_edges: usize = buckets
        .iter()
        .map(|buckets| buckets.first_edges[buckets.vertices.len()] as usize)
        .sum();
    let mut vertices = vec![0; 2 * n_edges];
    let mut pointers = vec![0; n_edges + 1];
    let mut faces = vec![0; n_corners];
    let mut signs = vec![0; n_corners];
    // Each corner is written once, by whichever thread holds its half-edge: order does not matter.
    let of_corner: Vec<AtomicU32> = vec![0_u32; n_corners]
        .into_iter()
        .map(AtomicU32::new)
        .collect();

    let mut tasks = Vec::with_capacity(buckets.len());
    {
        let (mut vertices, mut faces, mut signs) =
            (&mut vertices[..], &mut faces[..], &mut signs[..]);
        let mut pointers = &mut pointers[1..];
        let (mut first_edge, mut first_half_edge) = (0, 0);
        for buckets in buckets {
            let n_edges = buckets.first_edges[buckets.vertices.len()];
            let n_half_edges = buckets.half_edges.len();
            tasks.push(EdgeTask {
                buckets,
                first_edge,
                first_half_edge,
                vertices: take(&mut vertices, 2 * n_edges as usize),
                pointers: take(&mut pointers, n_edges as usize),
                faces: take(&mut faces, n_half_edges),
                signs: take(&mut signs, n_half_edges),
            });
            first_edge += n_edges;
            first_half_edge += n_half_edges as u32;
        }
    }
    if polygons.all_triangles {
        map(tasks, |task| task.run(&of_corner, |corner| corner / 3));
    } else {
        let mut face_of_corner = Vec::with_capacity(n_corners);
        for (face, range) in polygons.starts.windows(2).enumerate() {
            face_of_corner.resize(range[1] as usize, face as u32);
        }
        map(tasks, |task| {
            task.run(&of_corner, |corner| face_of_corner[corner as usize])
        });
    }
    let of_corner = of_corner.into_iter().map(AtomicU32::into_inner).collect();
    Edges {
        vertices,
        edge_faces: Columns {
            pointers,
            rows: faces,
            signs,
        },
        of_corner,
    }
}

/// Cuts `length` items off the front of a slice.
fn take<'a, T>(slice: &mut &'a mut [T], length: usize) -> &'a mut [T] {
    let (front, back) = std::mem::take(slice).split_at_mut(length);
    *slice = back;
    front
}

impl EdgeTask<'_> {
    fn run(self, of_corner: &[AtomicU32], face_of_corner: impl Fn(u32) -> u32) {
        // Edges are counted from the start of this task; the first half-edge of each bucket opens an edge.
        let mut n_edges = 0;
        let buckets = self
            .buckets
            .starts
            .windows(2)
            .map(|range| range[0] as usize..range[1] as usize);
        for (vertex, bucket) in self.buckets.vertices.clone().zip(buckets) {
            let mut last = None;
            for position in bucket {
                let half_edge = self.buckets.half_edges[position];
                let larger = larger_vertex(half_edge);
                if last != Some(larger) {
                    last = Some(larger);
                    self.vertices[2 * n_edges] = vertex as u32;
                    self.vertices[2 * n_edges + 1] = larger;
                    n_edges += 1;
                }
                let corner = half_edge as u32 >> 1;
                of_corner[corner as usize]
                    .store(self.first_edge + n_edges as u32 - 1, Ordering::Relaxed);
                self.faces[position] = face_of_corner(corner);
                self.signs[position] = if half_edge & 1 == 0 { 1 } else { -1 };
                self.pointers[n_edges - 1] = self.first_half_edge + position as u32 + 1;
            }
        }
    }
}

/// For each vertex the first edge of which it is the smaller one; and the number of edges.
fn first_edges(buckets: &[Buckets], n_vertices: usize) -> Vec<u32> {
    let mut first_edges = Vec::with_capacity(n_vertices + 1);
    let mut n_edges = 0;
    for buckets in buckets {
        let (&total, counts) = buckets.first_edges.split_last().unwrap_or((&0, &[]));
        first_edges.extend(counts.iter().map(|count| count + n_edges));
        n_edges += total;
    }
    first_edges.push(n_edges);
    first_edges
}

/// ∂¹: each edge has −1 at its tail, the smaller vertex, and +1 at its head.
fn edge_matrix(vertices: Vec<u32>, n_vertices: usize) -> BoundaryMatrix {
    let n_edges = vertices.len() / 2;
    let pointers = (0..=n_edges as u32).map(|edge| 2 * edge).collect();
    let signs = [-1, 1].repeat(n_edges);
    Columns {
        pointers,
        rows: vertices,
        signs,
    }
    .into_matrix(n_vertices)
}

/// ∂¹ᵀ: around each vertex first the edges that end there (they start at a smaller vertex), then those that start.
fn vertex_edges(edge_vertices: &[u32], first_edges: &[u32], ranges: Vec<Range<usize>>) -> Columns {
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
        rows,
        signs,
    }
}

/// ∂²: the edges of each face, ascending, +1 where the face runs along the edge.
fn face_matrix(
    polygons: &Polygons,
    mut edges: Vec<u32>,
    n_edges: usize,
    parallel: bool,
) -> BoundaryMatrix {
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
    Columns {
        pointers: polygons.starts.to_vec(),
        rows: edges,
        signs,
    }
    .into_matrix(n_edges)
}
