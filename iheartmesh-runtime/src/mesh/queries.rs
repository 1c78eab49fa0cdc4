//! Questions about the topology of a [`FaceMesh`]. Each takes one pass over the mesh; nothing is kept.

use super::FaceMesh;
use crate::element::{Edge, Vertex};
use crate::set::Set;

impl FaceMesh {
    /// The edges with exactly one face.
    pub fn boundary_edges(&self) -> Set<Edge> {
        self.edges()
            .filter(|&edge| self.edge_faces(edge).len() == 1)
            .collect()
    }

    /// The vertices of the [boundary edges](Self::boundary_edges).
    pub fn boundary_vertices(&self) -> Set<Vertex> {
        self.edges()
            .filter(|&edge| self.edge_faces(edge).len() == 1)
            .flat_map(|edge| self.edge_vertices(edge))
            .collect()
    }

    /// The edges with more than two faces.
    pub fn non_manifold_edges(&self) -> Set<Edge> {
        self.edges()
            .filter(|&edge| self.edge_faces(edge).len() > 2)
            .collect()
    }

    /// The vertices without edges, and so without faces.
    pub fn isolated_vertices(&self) -> Set<Vertex> {
        self.vertices()
            .filter(|&vertex| self.vertex_edges(vertex).is_empty())
            .collect()
    }

    /// Whether no edge has exactly one face. True of a mesh without edges; isolated vertices do not matter.
    pub fn is_closed(&self) -> bool {
        self.edges().all(|edge| self.edge_faces(edge).len() != 1)
    }

    /// Whether every edge has at most two faces, and where it has two they run along it in opposite directions.
    pub fn is_consistently_oriented(&self) -> bool {
        self.edges().all(|edge| {
            matches!(
                self.complex().coboundary_column(2, edge.index()).1,
                [] | [_] | [1, -1] | [-1, 1]
            )
        })
    }

    /// Whether some faces could be turned around so that the mesh is
    /// [consistently oriented](Self::is_consistently_oriented): false of a Möbius strip and of a mesh with an edge of
    /// more than two faces.
    pub fn is_orientable(&self) -> bool {
        // Sign by which each face is to be multiplied; 0 as long as it is not reached.
        let mut turned = vec![0_i8; self.n_faces()];
        let mut reached = Vec::new();
        for seed in self.faces() {
            if turned[seed.index()] != 0 {
                continue;
            }
            turned[seed.index()] = 1;
            reached.push(seed.id());
            while let Some(face) = reached.pop() {
                let (edges, signs) = self.complex().boundary_column(2, face as usize);
                for (&edge, &sign) in edges.iter().zip(signs) {
                    let (faces, other_signs) = self.complex().coboundary_column(2, edge as usize);
                    if faces.len() > 2 {
                        return false;
                    }
                    for (&other, &other_sign) in faces
                        .iter()
                        .zip(other_signs)
                        .filter(|&(&other, _)| other != face)
                    {
                        let needed = -turned[face as usize] * sign * other_sign;
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
}
