//! What a vertex sees: its corners and its neighbours, in flat arrays.

use super::{Edges, NONE};

/// One face at a vertex i: the two vertices that follow and precede i in the face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// The vertex after i in the face.
    pub next: u32,
    /// The vertex before i in the face.
    pub previous: u32,
}

/// One edge at a vertex i, seen from i.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Neighbour {
    /// The vertex j at the other end.
    pub vertex: u32,
    /// The third vertex of the face that traverses i → j, or [`NONE`].
    pub opposite_forward: u32,
    /// The third vertex of the face that traverses j → i, or [`NONE`].
    pub opposite_backward: u32,
}

/// The neighbourhoods of all vertices in compressed rows: the entries of vertex v stand at
/// `offsets[v]..offsets[v + 1]`.
pub struct Adjacency {
    /// Where the corners of each vertex begin; one entry more than there are vertices.
    pub corner_offsets: Vec<u32>,
    /// The corners of each vertex, in ascending order of their faces.
    pub corners: Vec<Corner>,
    /// For each corner, three times its face plus its place in the face.
    pub corner_numbers: Vec<u32>,
    /// Where the neighbours of each vertex begin; one entry more than there are vertices.
    pub neighbour_offsets: Vec<u32>,
    /// The neighbours of each vertex, in ascending order.
    pub neighbours: Vec<Neighbour>,
    /// For each neighbour j of v, the face that traverses v → j and the one that traverses j → v.
    pub neighbour_faces: Vec<[u32; 2]>,
}

impl Adjacency {
    /// Collects the neighbourhoods in time linear in the size of the mesh.
    pub fn new(n_vertices: usize, triangles: &[[u32; 3]], edges: &Edges) -> Adjacency {
        let (corner_offsets, corners, corner_numbers) = corners_of_vertices(n_vertices, triangles);
        let (neighbour_offsets, neighbours, neighbour_faces) =
            neighbours_of_vertices(n_vertices, triangles, edges);
        Adjacency {
            corner_offsets,
            corners,
            corner_numbers,
            neighbour_offsets,
            neighbours,
            neighbour_faces,
        }
    }

    /// The number of vertices.
    pub fn n_vertices(&self) -> usize {
        self.corner_offsets.len() - 1
    }

    /// The corners at `vertex`.
    #[inline(always)]
    pub fn corners(&self, vertex: usize) -> &[Corner] {
        let start = self.corner_offsets[vertex] as usize;
        &self.corners[start..self.corner_offsets[vertex + 1] as usize]
    }

    /// The numbers of the corners at `vertex`: three times the face plus the place in the face.
    #[inline(always)]
    pub fn corner_numbers(&self, vertex: usize) -> &[u32] {
        let start = self.corner_offsets[vertex] as usize;
        &self.corner_numbers[start..self.corner_offsets[vertex + 1] as usize]
    }

    /// The neighbours of `vertex`.
    #[inline(always)]
    pub fn neighbours(&self, vertex: usize) -> &[Neighbour] {
        let start = self.neighbour_offsets[vertex] as usize;
        &self.neighbours[start..self.neighbour_offsets[vertex + 1] as usize]
    }

    /// The faces at the edges of `vertex`, in the order of [`Adjacency::neighbours`].
    #[inline(always)]
    pub fn neighbour_faces(&self, vertex: usize) -> &[[u32; 2]] {
        let start = self.neighbour_offsets[vertex] as usize;
        &self.neighbour_faces[start..self.neighbour_offsets[vertex + 1] as usize]
    }
}

/// Turns the number of entries of each vertex, `counts[v + 1]`, into where they begin, `counts[v]`.
fn accumulate(counts: &mut [u32]) {
    for v in 1..counts.len() {
        counts[v] += counts[v - 1];
    }
}

fn corners_of_vertices(
    n_vertices: usize,
    triangles: &[[u32; 3]],
) -> (Vec<u32>, Vec<Corner>, Vec<u32>) {
    let mut offsets = vec![0u32; n_vertices + 1];
    for &vertex in triangles.iter().flatten() {
        offsets[vertex as usize + 1] += 1;
    }
    accumulate(&mut offsets);

    let mut cursor = offsets.clone();
    let mut corners = vec![
        Corner {
            next: NONE,
            previous: NONE
        };
        triangles.len() * 3
    ];
    let mut numbers = vec![0u32; triangles.len() * 3];
    let mut number = 0;
    for &[i, j, k] in triangles {
        for (vertex, next, previous) in [(i, j, k), (j, k, i), (k, i, j)] {
            let slot = &mut cursor[vertex as usize];
            corners[*slot as usize] = Corner { next, previous };
            numbers[*slot as usize] = number;
            *slot += 1;
            number += 1;
        }
    }
    (offsets, corners, numbers)
}

fn neighbours_of_vertices(
    n_vertices: usize,
    triangles: &[[u32; 3]],
    edges: &Edges,
) -> (Vec<u32>, Vec<Neighbour>, Vec<[u32; 2]>) {
    let mut offsets = vec![0u32; n_vertices + 1];
    for &vertex in edges.ends.iter().flatten() {
        offsets[vertex as usize + 1] += 1;
    }
    accumulate(&mut offsets);

    // The edges come in lexicographic order: the edges that end at v, with ascending first vertex, all
    // come before the edges that begin at v, with ascending second vertex. So each row is ascending.
    let mut cursor = offsets.clone();
    let absent = Neighbour {
        vertex: NONE,
        opposite_forward: NONE,
        opposite_backward: NONE,
    };
    let mut neighbours = vec![absent; edges.ends.len() * 2];
    let mut faces = vec![[NONE; 2]; edges.ends.len() * 2];
    for (&[a, b], &[forward, backward]) in edges.ends.iter().zip(&edges.faces) {
        let third = |face: u32| match face {
            NONE => NONE,
            face => opposite(triangles[face as usize], a, b),
        };
        let (left, right) = (third(forward), third(backward));
        let mut push = |from: u32, neighbour, pair| {
            let slot = &mut cursor[from as usize];
            neighbours[*slot as usize] = neighbour;
            faces[*slot as usize] = pair;
            *slot += 1;
        };
        let from_a = Neighbour {
            vertex: b,
            opposite_forward: left,
            opposite_backward: right,
        };
        let from_b = Neighbour {
            vertex: a,
            opposite_forward: right,
            opposite_backward: left,
        };
        push(a, from_a, [forward, backward]);
        push(b, from_b, [backward, forward]);
    }
    (offsets, neighbours, faces)
}

/// The vertex of the triangle that is neither `a` nor `b`.
fn opposite(triangle: [u32; 3], a: u32, b: u32) -> u32 {
    triangle[0] ^ triangle[1] ^ triangle[2] ^ a ^ b
}
