//! Numbering the edges of a triangle mesh by sorting.

use super::NONE;

/// The edges of a triangle mesh, in lexicographic order, with both directions of incidence.
pub struct Edges {
    /// The two ends of each edge, the smaller vertex first.
    pub ends: Vec<[u32; 2]>,
    /// The faces of each edge: first the one that traverses it from the smaller to the larger vertex,
    /// then the one that traverses it backwards. [`NONE`] where there is no such face.
    pub faces: Vec<[u32; 2]>,
    /// The edges of each face: entry k is the edge from corner k to corner k + 1.
    pub of_face: Vec<[u32; 3]>,
    /// For each entry of `of_face`, +1 where the face traverses the edge from the smaller to the larger
    /// vertex, −1 otherwise. `of_face` and `signs` are the columns of the boundary matrix ∂².
    pub signs: Vec<[i8; 3]>,
}

impl Edges {
    /// Numbers the edges of `triangles`.
    ///
    /// A counting sort by the smaller vertex puts the sides of all faces into one short bucket per
    /// vertex; a small sort of each bucket by the larger vertex then brings equal edges together. Time is
    /// linear in the number of faces as long as the valences are bounded.
    ///
    /// # Panics
    /// If two faces traverse an edge in the same direction: the mesh is not an oriented surface.
    pub fn new(n_vertices: usize, triangles: &[[u32; 3]]) -> Edges {
        let (bucket_ends, sides) = sides_by_smaller_vertex(n_vertices, triangles);

        // Euler: a closed surface has 3 edges for 2 faces; boundaries add a few more.
        let expected = triangles.len() * 3 / 2 + 1;
        let mut ends = Vec::with_capacity(expected);
        let mut faces = Vec::with_capacity(expected);
        let mut of_face = vec![[NONE; 3]; triangles.len()];
        let mut signs = vec![[0i8; 3]; triangles.len()];

        let mut start = 0;
        for (smaller, &end) in bucket_ends.iter().enumerate() {
            let mut previous = NONE;
            for &side in &sides[start..end as usize] {
                let larger = (side >> 32) as u32;
                let face = (side as u32 / 3) as usize;
                let corner = (side as u32 % 3) as usize;
                if larger != previous {
                    ends.push([smaller as u32, larger]);
                    faces.push([NONE; 2]);
                    previous = larger;
                }
                let edge = ends.len() - 1;
                let forward = triangles[face][corner] == smaller as u32;
                let slot = &mut faces[edge][usize::from(!forward)];
                assert!(
                    *slot == NONE,
                    "two faces traverse edge {edge} in the same direction"
                );
                *slot = face as u32;
                of_face[face][corner] = edge as u32;
                signs[face][corner] = if forward { 1 } else { -1 };
            }
            start = end as usize;
        }
        Edges {
            ends,
            faces,
            of_face,
            signs,
        }
    }
}

/// The sides of all faces, in buckets by their smaller vertex, each bucket sorted by the larger vertex.
///
/// Side k of face f is packed as `larger vertex · 2³² + (3 f + k)`, so that one integer comparison sorts
/// by larger vertex, then by face. Returns the end of each bucket and the packed sides.
fn sides_by_smaller_vertex(n_vertices: usize, triangles: &[[u32; 3]]) -> (Vec<u32>, Vec<u64>) {
    assert!(
        triangles.len() < (u32::MAX / 3) as usize,
        "too many faces for 32 bit indices"
    );
    let sides_of = |&[i, j, k]: &[u32; 3]| [(i, j), (j, k), (k, i)];

    // After this loop, `cursor[v + 1]` counts the sides of v; after the next, `cursor[v]` is where the
    // bucket of v begins; after the third, where it ends.
    let mut cursor = vec![0u32; n_vertices + 1];
    for (a, b) in triangles.iter().flat_map(sides_of) {
        cursor[a.min(b) as usize + 1] += 1;
    }
    for v in 0..n_vertices {
        cursor[v + 1] += cursor[v];
    }
    let mut sides = vec![0u64; triangles.len() * 3];
    for (number, (a, b)) in triangles.iter().flat_map(sides_of).enumerate() {
        let slot = &mut cursor[a.min(b) as usize];
        sides[*slot as usize] = (u64::from(a.max(b)) << 32) | number as u64;
        *slot += 1;
    }
    cursor.pop();

    let mut start = 0;
    for &end in &cursor {
        sides[start..end as usize].sort_unstable();
        start = end as usize;
    }
    (cursor, sides)
}
