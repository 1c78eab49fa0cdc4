//! Questions about the topology of meshes. Each takes one pass over the mesh; nothing is kept.

use super::{CellMesh, EdgeMesh, FaceMesh};
use crate::complex::CellComplex;
use crate::element::{Edge, Element, Face, Vertex};
use crate::set::{Set, SetItem};

/// The elements of dimension `k` − 1 at whose number of elements of dimension `k` a condition holds.
fn sides<E: Element + SetItem>(
    complex: &CellComplex,
    k: usize,
    is_wanted: impl Fn(usize) -> bool,
) -> Set<E> {
    (0..complex.n(k - 1))
        .filter(|&side| is_wanted(complex.coboundary_elements(k, side).len()))
        .map(|side| E::new(side as u32))
        .collect()
}

/// Whether at most two elements of dimension `k` meet at each of their sides, and if two, with opposite signs.
fn is_consistently_oriented(complex: &CellComplex, k: usize) -> bool {
    (0..complex.n(k - 1)).all(|side| {
        let signs = complex.coboundary_column(k, side).1;
        matches!(signs, [] | [_] | [1, -1] | [-1, 1])
    })
}

/// Whether some elements of dimension `k` could be turned around so that the complex is consistently oriented.
fn is_orientable(complex: &CellComplex, k: usize) -> bool {
    // Sign by which each element is to be multiplied; 0 as long as it is not reached.
    let mut turned = vec![0_i8; complex.n(k)];
    let mut reached = Vec::new();
    for seed in 0..complex.n(k) {
        if turned[seed] != 0 {
            continue;
        }
        turned[seed] = 1;
        reached.push(seed as u32);
        while let Some(element) = reached.pop() {
            let (sides, signs) = complex.boundary_column(k, element as usize);
            for (&side, &sign) in sides.iter().zip(signs) {
                let (elements, other_signs) = complex.coboundary_column(k, side as usize);
                if elements.len() > 2 {
                    return false;
                }
                let others = elements.iter().zip(other_signs);
                for (&other, &other_sign) in others.filter(|&(&other, _)| other != element) {
                    let needed = -turned[element as usize] * sign * other_sign;
                    let current = &mut turned[other as usize];
                    if *current == 0 {
                        *current = needed;
                        reached.push(other);
                    } else if *current != needed {
                        return false;
                    }
                }
            }
        }
    }
    true
}

impl EdgeMesh {
    /// The vertices with exactly one edge.
    pub fn boundary_vertices(&self) -> Set<Vertex> {
        sides(self.complex(), 1, |n_edges| n_edges == 1)
    }

    /// The vertices without edges.
    pub fn isolated_vertices(&self) -> Set<Vertex> {
        sides(self.complex(), 1, |n_edges| n_edges == 0)
    }
}

impl FaceMesh {
    /// The edges with exactly one face.
    pub fn boundary_edges(&self) -> Set<Edge> {
        sides(self.complex(), 2, |n_faces| n_faces == 1)
    }

    /// The vertices of the [boundary edges](Self::boundary_edges).
    pub fn boundary_vertices(&self) -> Set<Vertex> {
        let edges = self.boundary_edges();
        edges.iter().flat_map(|&e| self.edge_vertices(e)).collect()
    }

    /// The edges with more than two faces.
    pub fn non_manifold_edges(&self) -> Set<Edge> {
        sides(self.complex(), 2, |n_faces| n_faces > 2)
    }

    /// The vertices around which the faces are neither one fan nor one disk: those of the
    /// [non-manifold edges](Self::non_manifold_edges), and those where parts of the surface touch in nothing but the vertex.
    /// Isolated vertices are not among them.
    pub fn non_manifold_vertices(&self) -> Set<Vertex> {
        // each face at a vertex names the first one that is found to hang together with it
        let mut leaders: Vec<(u32, u32)> = Vec::new();
        let mut is_manifold = |vertex: Vertex| {
            let edges = self.vertex_edges(vertex);
            leaders.clear();
            for edge in edges {
                leaders.extend(self.edge_faces(edge).iter().map(|f| (f.id(), f.id())));
            }
            leaders.sort_unstable();
            // each face has two of its edges at the vertex
            leaders.dedup();
            let mut n_fans = leaders.len();
            for edge in edges {
                let faces = self.edge_faces(edge).ids();
                if faces.len() > 2 {
                    return false;
                }
                if let &[a, b] = faces {
                    let place = |face| leaders.binary_search_by_key(&face, |entry| entry.0);
                    let leader = |mut k: usize| {
                        while let Ok(next) = place(leaders[k].1)
                            && next != k
                        {
                            k = next;
                        }
                        k
                    };
                    if let (Ok(a), Ok(b)) = (place(a), place(b)) {
                        let (a, b) = (leader(a), leader(b));
                        n_fans -= usize::from(a != b);
                        leaders[a.max(b)].1 = leaders[a.min(b)].0;
                    }
                }
            }
            n_fans <= 1
        };
        self.vertices().filter(|&v| !is_manifold(v)).collect()
    }

    /// Whether the mesh is a surface, with or without boundary: no edge and no vertex is non-manifold, which
    /// [`non_manifold_edges`](Self::non_manifold_edges) and [`non_manifold_vertices`](Self::non_manifold_vertices) tell.
    /// Isolated vertices do not matter.
    pub fn is_manifold(&self) -> bool {
        self.non_manifold_vertices().is_empty()
    }

    /// The vertices without edges, and so without faces.
    pub fn isolated_vertices(&self) -> Set<Vertex> {
        sides(self.complex(), 1, |n_edges| n_edges == 0)
    }

    /// Whether no edge has exactly one face. True of a mesh without edges; isolated vertices do not matter.
    pub fn is_closed(&self) -> bool {
        self.edges().all(|edge| self.edge_faces(edge).len() != 1)
    }

    /// Whether every edge has at most two faces, and where it has two they run along it in opposite directions.
    pub fn is_consistently_oriented(&self) -> bool {
        is_consistently_oriented(self.complex(), 2)
    }

    /// Whether some faces could be turned around so that the mesh is
    /// [consistently oriented](Self::is_consistently_oriented): false of a Möbius strip and of a mesh with an edge of
    /// more than two faces.
    pub fn is_orientable(&self) -> bool {
        is_orientable(self.complex(), 2)
    }
}

impl CellMesh {
    /// The faces with exactly one cell.
    pub fn boundary_faces(&self) -> Set<Face> {
        sides(self.complex(), 3, |n_cells| n_cells == 1)
    }

    /// The edges of the [boundary faces](Self::boundary_faces).
    pub fn boundary_edges(&self) -> Set<Edge> {
        let faces = self.boundary_faces();
        faces
            .iter()
            .flat_map(|&f| self.face_boundary(f).0)
            .collect()
    }

    /// The vertices of the [boundary faces](Self::boundary_faces).
    pub fn boundary_vertices(&self) -> Set<Vertex> {
        let faces = self.boundary_faces();
        faces.iter().flat_map(|&f| self.face_vertices(f)).collect()
    }

    /// The faces with more than two cells.
    pub fn non_manifold_faces(&self) -> Set<Face> {
        sides(self.complex(), 3, |n_cells| n_cells > 2)
    }

    /// The vertices without edges, and so without cells.
    pub fn isolated_vertices(&self) -> Set<Vertex> {
        sides(self.complex(), 1, |n_edges| n_edges == 0)
    }

    /// Whether no face has exactly one cell. A mesh of cells in space always has such faces, unless it is empty.
    pub fn is_closed(&self) -> bool {
        self.faces().all(|face| self.face_cells(face).len() != 1)
    }

    /// Whether every face has at most two cells, and where it has two it is seen from both sides: false where one of two
    /// neighbours is inverted.
    pub fn is_consistently_oriented(&self) -> bool {
        is_consistently_oriented(self.complex(), 3)
    }

    /// Whether some cells could be turned inside out so that the mesh is
    /// [consistently oriented](Self::is_consistently_oriented): false of a mesh with a face of more than two cells.
    pub fn is_orientable(&self) -> bool {
        is_orientable(self.complex(), 3)
    }
}
