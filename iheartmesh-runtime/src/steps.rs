//! Elements two steps away: vertices of a face, faces around a vertex, vertices that share an edge.
//!
//! Products of two boundary matrices, as tables. Each is made when it is first asked for; where elements are
//! numbered at random, one read of a table takes the place of many all over memory.

use std::sync::OnceLock;

use crate::complex::CellComplex;
use crate::generated::NO_ELEMENT;

/// The tables of a complex. Those of vertices are in the order of [`CellComplex::vertex_order`]: what is near each other in
/// the mesh is near each other in memory, whatever the numbering.
#[derive(Clone, Default)]
pub(crate) struct Steps {
    vertices_of_faces: OnceLock<Lists>,
    faces_of_vertices: OnceLock<Lists>,
    closed_rings: OnceLock<Option<Lists>>,
    edges_of_vertices: OnceLock<Option<Around>>,
    faces_beside: OnceLock<Option<Vec<[u32; 2]>>>,
}

/// A sorted list of elements for each place.
#[derive(Clone)]
struct Lists {
    starts: Starts,
    elements: Vec<u32>,
}

/// Where lists begin.
#[derive(Clone)]
enum Starts {
    /// All have this length.
    Every(usize),
    /// One more than there are lists.
    At(Vec<u32>),
}

impl Lists {
    #[inline]
    fn of(&self, place: usize) -> &[u32] {
        let range = match &self.starts {
            Starts::Every(length) => place * length..(place + 1) * length,
            Starts::At(starts) => starts[place] as usize..starts[place + 1] as usize,
        };
        &self.elements[range]
    }

    /// The lists that `list` appends for each element; `None` when `u32` cannot count what is in them.
    fn made<E>(
        elements: impl ExactSizeIterator<Item = E>,
        capacity: usize,
        mut list: impl FnMut(E, &mut Vec<u32>),
    ) -> Option<Self> {
        let mut starts = Vec::with_capacity(elements.len() + 1);
        starts.push(0);
        let mut all = Vec::with_capacity(capacity);
        for element in elements {
            list(element, &mut all);
            starts.push(u32::try_from(all.len()).ok()?);
        }
        Some(Self {
            starts: Starts::At(starts),
            elements: all,
        })
    }

    /// For each of `n` places the lists in which an element of this place is. One counting sort.
    fn transposed(&self, n_lists: usize, n: usize, place: impl Fn(u32) -> usize) -> Self {
        let mut starts = vec![0; n + 1];
        for &element in &self.elements {
            starts[place(element) + 1] += 1;
        }
        for k in 0..n {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let mut elements = vec![0; self.elements.len()];
        for number in 0..n_lists {
            for &element in self.of(number) {
                let slot = &mut next[place(element)];
                elements[*slot as usize] = number as u32;
                *slot += 1;
            }
        }
        Self {
            starts: Starts::At(starts),
            elements,
        }
    }
}

/// The edges around each vertex, ascending, with the vertices at their other ends.
#[derive(Clone)]
struct Around {
    starts: Vec<u32>,
    /// The other end, then the edge.
    edges: Vec<[u32; 2]>,
}

impl Around {
    #[inline]
    fn range(&self, place: usize) -> std::ops::Range<usize> {
        self.starts[place] as usize..self.starts[place + 1] as usize
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

    /// Reads the vertices of a face, if they have been asked for.
    #[inline]
    pub(crate) fn touch_vertices_of_face(&self, face: usize) -> u32 {
        let lists = self.steps().vertices_of_faces.get();
        lists.map_or(0, |lists| lists.of(face).first().copied().unwrap_or(0))
    }

    fn all_vertices_of_faces(&self) -> &Lists {
        self.steps().vertices_of_faces.get_or_init(|| {
            let n_corners = self.n_entries(2);
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
            let mut lists =
                Lists::made(0..self.n(2), n_corners, list).expect("corners are counted by `u32`");
            if let Starts::At(starts) = &lists.starts
                && starts.windows(2).all(|ends| ends[1] - ends[0] == 3)
            {
                lists.starts = Starts::Every(3);
            }
            lists
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

    /// Where the lists of a vertex are.
    #[inline]
    fn place(&self, vertex: usize) -> usize {
        match self.vertex_order() {
            None => vertex,
            Some(order) => order.rank[vertex] as usize,
        }
    }

    /// The vertices in the order of their lists.
    fn in_order(&self) -> impl ExactSizeIterator<Item = usize> {
        let order = self.vertex_order();
        (0..self.n(0)).map(move |place| match order {
            None => place,
            Some(order) => order.vertices[place] as usize,
        })
    }

    /// The faces around a vertex, ascending.
    ///
    /// # Panics
    /// When there is no such vertex.
    #[inline]
    pub(crate) fn faces_of_vertex(&self, vertex: usize) -> &[u32] {
        let make = || {
            let place = |vertex: u32| self.place(vertex as usize);
            self.all_vertices_of_faces()
                .transposed(self.n(2), self.n(0), place)
        };
        let lists = self.steps().faces_of_vertices.get_or_init(make);
        lists.of(self.place(vertex))
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
            Lists::made(self.in_order(), 2 * self.n(1) + self.n(0), list)
        };
        let lists = self.steps().closed_rings.get_or_init(make).as_ref()?;
        Some(lists.of(self.place(vertex)))
    }

    /// The edges around all vertices; `None` when there are more ends of edges than `u32` can count.
    fn edges_of_vertices(&self) -> Option<&Around> {
        let make = || {
            let n_ends = u32::try_from(2 * self.n(1)).ok()?;
            let mut starts = Vec::with_capacity(self.n(0) + 1);
            starts.push(0);
            let mut end = 0;
            for vertex in self.in_order() {
                end += self.coboundary_elements(1, vertex).len() as u32;
                starts.push(end);
            }
            debug_assert_eq!(end, n_ends);
            let mut edges = vec![[0; 2]; n_ends as usize];
            self.each_end(&starts, |edge, place, _, other| {
                edges[place] = [other, edge];
            });
            Some(Around { starts, edges })
        };
        self.steps().edges_of_vertices.get_or_init(make).as_ref()
    }

    /// Both ends of each edge, with the place of the edge in the list of the vertex there, whether it is the tail, and the
    /// vertex at the other end. One pass over the edges: the reads of a list do not wait for each other.
    fn each_end(&self, starts: &[u32], mut see: impl FnMut(u32, usize, bool, u32)) {
        let mut next = starts[..self.n(0)].to_vec();
        for edge in 0..self.n(1) {
            let [tail, head] = self.edge_vertices(edge);
            for (vertex, is_tail) in [(tail, true), (head, false)] {
                let slot = &mut next[self.place(vertex as usize)];
                let place = *slot as usize;
                *slot += 1;
                see(edge as u32, place, is_tail, tail ^ head ^ vertex);
            }
        }
    }

    /// The first edge that has both vertices; of one vertex its first edge.
    ///
    /// # Panics
    /// When there is no such first vertex.
    #[inline]
    pub(crate) fn edge_between(&self, a: u32, b: u32) -> Option<u32> {
        let Some(around) = self.edges_of_vertices() else {
            let edges = self.coboundary_elements(1, a as usize).iter().copied();
            return edges
                .filter(|edge| self.edge_vertices(*edge as usize).contains(&b))
                .min();
        };
        let edges = &around.edges[around.range(self.place(a as usize))];
        let found = edges.iter().find(|[other, _]| *other == b || a == b);
        found.map(|[_, edge]| *edge)
    }

    /// The first faces f at each edge e of each vertex v for which ∂²[e, f] ∂¹[v, e] is −1 and +1.
    fn all_faces_beside(&self) -> Option<(&Around, &[[u32; 2]])> {
        let around = self.edges_of_vertices()?;
        let make = || {
            let mut all = vec![[NO_ELEMENT; 2]; around.edges.len()];
            self.each_end(&around.starts, |edge, place, is_tail, _| {
                let (faces, signs) = self.coboundary_column(2, edge as usize);
                // the least comes last
                for (&face, &sign) in faces.iter().zip(signs).rev() {
                    all[place][usize::from((sign > 0) != is_tail)] = face;
                }
            });
            Some(all)
        };
        let all = self.steps().faces_beside.get_or_init(make).as_ref()?;
        Some((around, all))
    }

    /// The first face f of an edge e for which ∂²[e, f] ∂¹[v, e] is `sign`, or, with `other`, is something else.
    ///
    /// # Panics
    /// When there is no such edge or vertex.
    #[inline]
    pub(crate) fn face_beside(&self, edge: u32, vertex: u32, sign: i8, other: bool) -> Option<u32> {
        if let Some((around, beside)) = self.all_faces_beside() {
            let range = around.range(self.place(vertex as usize));
            let edges = &around.edges[range.clone()];
            if let Some(k) = edges.iter().position(|[_, at]| *at == edge) {
                let face = beside[range.start + k][usize::from((sign > 0) != other)];
                return (face != NO_ELEMENT).then_some(face);
            }
        }
        self.face_beside_in_matrices(edge, vertex, sign, other)
    }

    /// The same from the boundary matrices.
    fn face_beside_in_matrices(
        &self,
        edge: u32,
        vertex: u32,
        sign: i8,
        other: bool,
    ) -> Option<u32> {
        let at = self.boundary_entry(1, vertex as usize, edge as usize);
        let (faces, signs) = self.coboundary_column(2, edge as usize);
        let mut faces = faces.iter().zip(signs);
        faces
            .find(|(_, direction)| (**direction * at == sign) != other)
            .map(|(face, _)| *face)
    }
}

#[cfg(test)]
mod tests {
    use crate::generated::{boundary_of, coboundary_of, intersection};
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
        for a in 0..complex.n(0) as u32 {
            for b in 0..complex.n(0) as u32 {
                let [of_a, of_b] = [a, b].map(|v| complex.coboundary_elements(1, v as usize));
                let expected = intersection(of_a, of_b).first().copied();
                assert_eq!(complex.edge_between(a, b), expected);
            }
        }
        if complex.dimension() > 1 {
            check_faces_beside(complex);
        }
    }

    fn check_faces_beside(complex: &super::CellComplex) {
        for edge in 0..complex.n(1) as u32 {
            for vertex in 0..complex.n(0) as u32 {
                for sign in [-1, 1] {
                    let product = |face: &u32| {
                        let of_face = complex.boundary_entry(2, edge as usize, *face as usize);
                        of_face * complex.boundary_entry(1, vertex as usize, edge as usize)
                    };
                    let faces = complex
                        .coboundary_elements(2, edge as usize)
                        .iter()
                        .copied();
                    let [mut with, mut without] = [faces.clone(), faces];
                    let found = |other| complex.face_beside(edge, vertex, sign, other);
                    assert_eq!(found(false), with.find(|f| product(f) == sign));
                    assert_eq!(found(true), without.find(|f| product(f) != sign));
                }
            }
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
        // three faces at an edge, two of which run along it in the same direction
        let fan = [[0, 1, 2], [1, 0, 3], [0, 1, 4], [5, 6, 0], [6, 5, 1]];
        check(FaceMesh::from_triangles(7, &fan).unwrap().complex());
        let edges = EdgeMesh::from_edges(5, &[[3, 1], [1, 0], [4, 1]]).unwrap();
        check(edges.complex());
    }

    #[test]
    fn lists_are_those_of_their_vertices_in_any_numbering() {
        // a grid whose numbering is not local, so that the lists stand in another order
        const SIDE: u32 = 60;
        let number = |x: u32, y: u32| (y * SIDE + x) * 1709 % (SIDE * SIDE);
        let mut triangles = Vec::new();
        for (x, y) in (0..SIDE - 1).flat_map(|y| (0..SIDE - 1).map(move |x| (x, y))) {
            let corner = |a: u32, b: u32| number(x + a, y + b);
            triangles.push([corner(0, 0), corner(1, 0), corner(1, 1)]);
            triangles.push([corner(1, 1), corner(0, 1), corner(0, 0)]);
        }
        let mesh = FaceMesh::from_triangles((SIDE * SIDE) as usize, &triangles).unwrap();
        let complex = mesh.complex();
        assert!(complex.vertex_order().is_some());
        for v in 0..complex.n(0) {
            let edges = complex.coboundary_elements(1, v);
            assert_eq!(
                complex.closed_ring(v).unwrap(),
                &boundary_of(complex, 1, edges)[..]
            );
            assert_eq!(
                complex.faces_of_vertex(v),
                &coboundary_of(complex, 2, edges)[..]
            );
            for &edge in edges {
                let [a, b] = complex.edge_vertices(edge as usize);
                assert_eq!(complex.edge_between(a, b), Some(edge));
                for (sign, other) in [(-1, false), (-1, true), (1, false), (1, true)] {
                    let expected = complex.face_beside_in_matrices(edge, v as u32, sign, other);
                    assert_eq!(complex.face_beside(edge, v as u32, sign, other), expected);
                }
            }
        }
        assert_eq!(complex.edge_between(number(0, 0), number(5, 5)), None);
    }
}
