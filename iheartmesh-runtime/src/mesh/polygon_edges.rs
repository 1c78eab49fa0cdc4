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

use super::polygon_incidence::{face_edges, vertex_edges};
use crate::boundary::Columns;
use crate::complex::CellComplex;

/// Most corners that a mesh may have: the number of a half-edge and its direction share 32 bits.
pub(crate) const MAX_CORNERS: usize = u32::MAX as usize >> 1;

/// Below this many corners threads cost more than they bring.
const MIN_PARALLEL_CORNERS: usize = 1 << 15;

/// Faces as vertex lists, already validated: face f has the corners `corners[starts[f]..starts[f + 1]]`, or the three from
/// `corners[3 * f]` where all are triangles.
pub(crate) struct Polygons<'a> {
    pub(crate) n_vertices: usize,
    /// May be empty if all are triangles.
    pub(crate) starts: Vec<u32>,
    pub(crate) corners: &'a [u32],
    pub(crate) all_triangles: bool,
}

/// The half-edges whose smaller vertex lies in a range, in the order of their edges.
struct Buckets {
    vertices: Range<usize>,
    /// For each vertex of the range, where its bucket starts in `half_edges`; and the end.
    starts: Vec<u32>,
    half_edges: Vec<HalfEdge>,
    /// For each vertex of the range, how many edges the buckets before it hold; and the total.
    first_edges: Vec<u32>,
}

/// The corner at which a half-edge starts (31 bits) and whether it runs down (the lowest bit), then its larger vertex.
type HalfEdge = [u32; 2];

#[inline]
fn pack(larger: u32, corner: u32, downwards: bool) -> HalfEdge {
    [corner << 1 | u32::from(downwards), larger]
}

/// By larger vertex, then by corner.
#[inline]
fn key([corner, larger]: HalfEdge) -> u64 {
    u64::from(larger) << 32 | u64::from(corner)
}

/// The complex of the polygons, edges numbered lexicographically and oriented from the smaller to the larger vertex.
pub(crate) fn complex(mut polygons: Polygons) -> CellComplex {
    let n_threads = if polygons.corners.len() < MIN_PARALLEL_CORNERS {
        1
    } else {
        rayon::current_num_threads()
    };
    let ranges = split(polygons.n_vertices, n_threads.min(16));

    let (edges, first_edges) = if ranges.len() == 1 {
        number_edges_alone(&polygons)
    } else {
        let buckets = map(ranges.clone(), |range| buckets(&polygons, range));
        let edges = number_edges(&polygons, &buckets);
        (edges, first_edges(&buckets, polygons.n_vertices))
    };

    let parallel = n_threads > 1;
    let (vertex_edges, (face_edges, signs)) = join(
        parallel,
        || vertex_edges(&edges.vertices, &first_edges, ranges),
        || face_edges(&polygons, edges.of_corner, parallel),
    );
    // ∂¹: each edge has −1 at its tail, the smaller vertex, and +1 at its head
    let edge_vertices = Columns {
        pointers: Vec::new(),
        width: 2,
        rows: edges.vertices,
        signs: Vec::new(),
    };
    let face_edges = Columns {
        pointers: std::mem::take(&mut polygons.starts),
        width: 3,
        rows: face_edges,
        signs,
    };
    CellComplex::new(
        polygons.n_vertices,
        true,
        vec![
            (edge_vertices, vertex_edges),
            (face_edges, edges.edge_faces),
        ],
    )
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
pub(super) fn map<T: Send, R: Send>(tasks: Vec<T>, run: impl Fn(T) -> R + Sync + Send) -> Vec<R> {
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

/// The half-edges whose smaller vertex lies in a range, by this vertex, in the order of their corners; and where those of each
/// vertex start.
fn half_edges(polygons: &Polygons, vertices: Range<usize>) -> (Vec<u32>, Vec<HalfEdge>) {
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

    // Each start moves to the end of its bucket, where the next one starts.
    let mut half_edges = vec![[0; 2]; starts[vertices.len()] as usize];
    let cursors = &mut starts[..vertices.len()];
    for_each_half_edge(polygons, |corner, tail, head| {
        if let Some(cursor) = cursors.get_mut(tail.min(head).wrapping_sub(first_vertex) as usize) {
            half_edges[*cursor as usize] = pack(tail.max(head), corner, head < tail);
            *cursor += 1;
        }
    });

    starts.pop();
    starts.insert(0, 0);
    (starts, half_edges)
}

fn buckets(polygons: &Polygons, vertices: Range<usize>) -> Buckets {
    let (starts, mut half_edges) = half_edges(polygons, vertices.clone());
    // The corners of a bucket ascend already, and they are distinct: sorting the packed numbers keeps them in order.
    let mut first_edges = vec![0; starts.len()];
    let mut n_edges = 0;
    for (first_edge, range) in first_edges.iter_mut().zip(starts.windows(2)) {
        *first_edge = n_edges;
        let bucket = &mut half_edges[range[0] as usize..range[1] as usize];
        sort(bucket);
        let mut last = None;
        for &[_, larger] in &*bucket {
            let larger = Some(larger);
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
fn sort(bucket: &mut [HalfEdge]) {
    if bucket.len() > 24 {
        return bucket.sort_unstable_by_key(|half_edge| key(*half_edge));
    }
    for i in 1..bucket.len() {
        let value = bucket[i];
        let mut hole = i;
        while hole > 0 && key(bucket[hole - 1]) > key(value) {
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

/// All edges, and for each vertex the first edge of which it is the smaller one; and the number of edges.
fn number_edges_alone(polygons: &Polygons) -> (Edges, Vec<u32>) {
    if polygons.all_triangles {
        return number_edges_with(polygons, |corner| corner / 3);
    }
    let faces = faces_of_corners(polygons);
    number_edges_with(polygons, |corner| faces[corner as usize])
}

fn number_edges_with(
    polygons: &Polygons,
    face_of_corner: impl Fn(u32) -> u32,
) -> (Edges, Vec<u32>) {
    let n_corners = polygons.corners.len();
    let (starts, mut half_edges) = half_edges(polygons, 0..polygons.n_vertices);
    // on a closed surface each edge has two corners
    let mut vertices: Vec<[u32; 2]> = Vec::with_capacity(n_corners.div_ceil(2));
    let mut pointers = Vec::with_capacity(n_corners.div_ceil(2) + 1);
    let mut signs = Vec::with_capacity(n_corners);
    let mut of_corner = vec![0; n_corners];
    let mut first_edges = Vec::with_capacity(starts.len());
    for (vertex, range) in starts.windows(2).enumerate() {
        first_edges.push(vertices.len() as u32);
        let bucket = &mut half_edges[range[0] as usize..range[1] as usize];
        sort(bucket);
        let mut last = None;
        for position in range[0]..range[1] {
            let [corner, larger] = half_edges[position as usize];
            if last != Some(larger) {
                last = Some(larger);
                pointers.push(position);
                vertices.push([vertex as u32, larger]);
            }
            signs.push(1 - 2 * (corner & 1) as i8);
            let corner = corner >> 1;
            of_corner[corner as usize] = vertices.len() as u32 - 1;
            // Faces take half of the memory of half-edges: this place was read before.
            half_edges[position as usize / 2][position as usize % 2] = face_of_corner(corner);
        }
    }
    first_edges.push(vertices.len() as u32);
    pointers.push(n_corners as u32);
    vertices.shrink_to_fit();
    pointers.shrink_to_fit();
    let mut faces = half_edges.into_flattened();
    faces.truncate(n_corners);
    faces.shrink_to_fit();
    let edges = Edges {
        vertices: vertices.into_flattened(),
        edge_faces: Columns {
            pointers,
            width: 0,
            rows: faces,
            signs,
        },
        of_corner,
    };
    (edges, first_edges)
}

/// The face of each corner.
fn faces_of_corners(polygons: &Polygons) -> Vec<u32> {
    let mut faces = Vec::with_capacity(polygons.corners.len());
    for (face, range) in polygons.starts.windows(2).enumerate() {
        faces.resize(range[1] as usize, face as u32);
    }
    faces
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
    let of_corner = if polygons.all_triangles {
        edges_of_corners(tasks, n_corners, |corner| corner / 3)
    } else {
        let face_of_corner = faces_of_corners(polygons);
        edges_of_corners(tasks, n_corners, |corner| face_of_corner[corner as usize])
    };
    Edges {
        vertices,
        edge_faces: Columns {
            pointers,
            width: 0,
            rows: faces,
            signs,
        },
        of_corner,
    }
}

/// Runs the tasks, and gives the edge from each corner to the next.
fn edges_of_corners(
    tasks: Vec<EdgeTask>,
    n_corners: usize,
    face_of_corner: impl Fn(u32) -> u32 + Sync,
) -> Vec<u32> {
    // Each corner is written once, by whichever thread holds its half-edge: order does not matter.
    let of_corner: Vec<AtomicU32> = (0..n_corners).map(|_| AtomicU32::new(0)).collect();
    map(tasks, |task| {
        task.run(&of_corner, &face_of_corner);
    });
    of_corner.into_iter().map(AtomicU32::into_inner).collect()
}

/// Cuts `length` items off the front of a slice.
pub(super) fn take<'a, T>(slice: &mut &'a mut [T], length: usize) -> &'a mut [T] {
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
                let [corner, larger] = self.buckets.half_edges[position];
                let sign = 1 - 2 * (corner & 1) as i8;
                let corner = corner >> 1;
                if last != Some(larger) {
                    last = Some(larger);
                    self.vertices[2 * n_edges] = vertex as u32;
                    self.vertices[2 * n_edges + 1] = larger;
                    n_edges += 1;
                }
                of_corner[corner as usize]
                    .store(self.first_edge + n_edges as u32 - 1, Ordering::Relaxed);
                self.faces[position] = face_of_corner(corner);
                self.signs[position] = sign;
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
