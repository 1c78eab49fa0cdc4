//! Elements two steps away: vertices of a face, faces around a vertex, vertices that share an edge.
//!
//! Products of two unsigned boundary matrices, as tables. Each is made when it is first asked for; where elements are
//! numbered at random, one read of a table takes the place of many all over memory.

use std::sync::OnceLock;

use crate::complex::CellComplex;

/// The tables of a complex.
#[derive(Clone, Default)]
pub(crate) struct Steps {
    vertices_of_faces: OnceLock<Lists>,
    faces_of_vertices: OnceLock<Lists>,
    closed_rings: OnceLock<Option<Lists>>,
}

/// A sorted list of elements for each element.
#[derive(Clone)]
struct Lists {
    starts: Vec<u32>,
    elements: Vec<u32>,
}

impl Lists {
    #[inline]
    fn of(&self, element: usize) -> &[u32] {
        &self.elements[self.starts[element] as usize..self.starts[element + 1] as usize]
    }

    /// The lists that `list` appends for each element; `None` when `u32` cannot count what is in them.
    fn made(n: usize, capacity: usize, mut list: impl FnMut(usize, &mut Vec<u32>)) -> Option<Self> {
        let mut starts = Vec::with_capacity(n + 1);
        starts.push(0);
        let mut elements = Vec::with_capacity(capacity);
        for element in 0..n {
            list(element, &mut elements);
            starts.push(u32::try_from(elements.len()).ok()?);
        }
        Some(Self { starts, elements })
    }

    /// For each of `n` elements those whose lists it is in. One counting sort.
    fn transposed(&self, n: usize) -> Self {
        let mut starts = vec![0; n + 1];
        for &element in &self.elements {
            starts[element as usize + 1] += 1;
        }
        for k in 0..n {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let mut elements = vec![0; self.elements.len()];
        for (number, ends) in (0u32..).zip(self.starts.windows(2)) {
            for &element in &self.elements[ends[0] as usize..ends[1] as usize] {
                let place = &mut next[element as usize];
                elements[*place as usize] = number;
                *place += 1;
            }
        }
        Self { starts, elements }
    }
}

/// Sorts what stands from `start` on, and removes repetitions.
fn sort_from(list: &mut Vec<u32>, start: usize) {
    list[start..].sort_unstable();
    let mut end = start;
    for k in start..list.len() {
        if end == start || list[end - 1] != list[k] {
            list[end] = list[k];
            end += 1;
        }
    }
    list.truncate(end);
}

impl CellComplex {
    /// The vertices of a face, ascending.
    ///
    /// # Panics
    /// When there is no such face, or when there are more than 2³² corners.
    #[inline]
    pub(crate) fn vertices_of_face(&self, face: usize) -> &[u32] {
        self.all_vertices_of_faces().of(face)
    }

    fn all_vertices_of_faces(&self) -> &Lists {
        self.steps().vertices_of_faces.get_or_init(|| {
            let n_corners = self.boundary(2).nnz();
            let list = |face: usize, list: &mut Vec<u32>| {
                let start = list.len();
                let edges = self.boundary_elements(2, face);
                if let Some(vertices) = self.triangle(edges) {
                    list.extend(vertices);
                    return;
                }
                for &edge in edges {
                    list.extend(self.edge_vertices(edge as usize));
                }
                sort_from(list, start);
            };
            // a face has as many vertices as edges, or less
            Lists::made(self.n(2), n_corners, list).expect("corners are counted by `u32`")
        })
    }

    /// The vertices, ascending, of three edges that are a triangle.
    fn triangle(&self, edges: &[u32]) -> Option<[u32; 3]> {
        let &[a, b, c] = edges else {
            return None;
        };
        let ends = [a, b, c].map(|edge| self.edge_vertices(edge as usize));
        let ends = ends.as_flattened();
        let (least, most) = ends.iter().fold((u32::MAX, 0), |(least, most), end| {
            (least.min(*end), most.max(*end))
        });
        // each vertex is the end of two edges
        let sum: u64 = ends.iter().map(|end| u64::from(*end)).sum();
        let middle = (sum / 2).checked_sub(u64::from(least) + u64::from(most))?;
        let middle = u32::try_from(middle).ok()?;
        let is_triangle = least < middle && middle < most && ends.contains(&middle);
        is_triangle.then_some([least, middle, most])
    }

    /// The faces around a vertex, ascending.
    ///
    /// # Panics
    /// When there is no such vertex.
    #[inline]
    pub(crate) fn faces_of_vertex(&self, vertex: usize) -> &[u32] {
        let make = || self.all_vertices_of_faces().transposed(self.n(0));
        self.steps().faces_of_vertices.get_or_init(make).of(vertex)
    }

    /// A vertex and those that share an edge with it, ascending; nothing for a vertex without edges. `None` when there are
    /// more than `u32` can count.
    ///
    /// # Panics
    /// When there is no such vertex.
    #[inline]
    pub(crate) fn closed_ring(&self, vertex: usize) -> Option<&[u32]> {
        let make = || {
            let list = |vertex: usize, list: &mut Vec<u32>| {
                let start = list.len();
                for &edge in self.coboundary_elements(1, vertex) {
                    let [a, b] = self.edge_vertices(edge as usize);
                    list.push(a ^ b ^ vertex as u32);
                }
                if list.len() > start {
                    list.push(vertex as u32);
                }
                sort_from(list, start);
            };
            Lists::made(self.n(0), 2 * self.n(1) + self.n(0), list)
        };
        let lists = self.steps().closed_rings.get_or_init(make).as_ref()?;
        Some(lists.of(vertex))
    }
}

#[cfg(test)]
mod tests {
    use crate::generated::{boundary_of, coboundary_of};
    use crate::{EdgeMesh, FaceMesh};

    fn check(complex: &super::CellComplex) {
        for v in 0..complex.n(0) {
            let edges = complex.coboundary_elements(1, v);
            let ring = boundary_of(complex, 1, edges);
            assert_eq!(complex.closed_ring(v).unwrap(), &ring[..]);
            if complex.dimension() > 1 {
                let faces = coboundary_of(complex, 2, edges);
                assert_eq!(complex.faces_of_vertex(v), &faces[..]);
            }
        }
        for f in 0..complex.n(2) {
            let vertices = boundary_of(complex, 1, complex.boundary_elements(2, f));
            assert_eq!(complex.vertices_of_face(f), &vertices[..]);
        }
    }

    #[test]
    fn the_lists_are_what_products_give() {
        // a fan that is no manifold, a polygon apart from it, a vertex without edges
        let faces: &[&[u32]] = &[
            &[0, 9, 2],
            &[3, 9, 0],
            &[9, 0, 4],
            &[5, 8, 6, 1],
            &[4, 9, 3],
        ];
        check(FaceMesh::from_polygons(11, faces).unwrap().complex());
        check(FaceMesh::from_triangles(0, &[]).unwrap().complex());
        let edges = EdgeMesh::from_edges(5, &[[3, 1], [1, 0], [4, 1]]).unwrap();
        check(edges.complex());
    }
}
