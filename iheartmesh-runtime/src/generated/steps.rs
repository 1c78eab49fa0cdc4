//! Steps from an element to its neighbours, without the sets in between.

use super::{Fallible, Fault, Ids, boundary_of, copied};
use crate::complex::CellComplex;
use crate::{CellMesh, Face, FaceMesh};

/// The vertices of a face, ascending.
#[inline]
pub fn vertices_of_face(complex: &CellComplex, face: usize) -> &[u32] {
    complex.vertices_of_face(face)
}

/// The faces around a vertex, ascending.
#[inline]
pub fn faces_of_vertex(complex: &CellComplex, vertex: usize) -> &[u32] {
    complex.faces_of_vertex(vertex)
}

/// A vertex with those that share an edge with it, ascending; nothing for a vertex without edges.
#[inline]
pub fn closed_ring(complex: &CellComplex, vertex: usize) -> Ids {
    match complex.closed_ring(vertex) {
        Some(ring) => copied(ring),
        None => boundary_of(complex, 1, complex.coboundary_elements(1, vertex)),
    }
}

/// A mesh with faces.
pub trait Faces {
    /// The least vertex, other than `vertex`, of the edges e of `face` at `vertex` where ∂²[e, face] ∂¹[vertex, e] is `sign`:
    /// the next one around the face for −1, the one before for +1.
    fn beside(&self, face: u32, vertex: u32, sign: i64) -> Option<u32>;

    /// The faces around a vertex.
    fn faces_around(&self, vertex: u32) -> &[u32];

    /// Reads what is asked of a face in a plan.
    fn touch(&self, face: u32) -> u32;
}

impl Faces for FaceMesh {
    #[inline]
    fn beside(&self, face: u32, vertex: u32, sign: i64) -> Option<u32> {
        if let Some(triangles) = self.triangles() {
            let corners = triangles[face as usize];
            let at = usize::from(corners[1] == vertex) + 2 * usize::from(corners[2] == vertex);
            let places = if sign < 0 { [1, 2, 0, 0] } else { [2, 0, 1, 0] };
            return (corners[at] == vertex).then(|| corners[places[at]]);
        }
        // a face runs through each of its vertices once
        let corners = self.face_vertices(Face::new(face)).ids();
        let at = corners.iter().position(|corner| *corner == vertex)?;
        let place = if sign < 0 {
            at + 1
        } else {
            at + corners.len() - 1
        };
        Some(corners[place % corners.len()])
    }

    #[inline]
    fn faces_around(&self, vertex: u32) -> &[u32] {
        self.complex().faces_of_vertex(vertex as usize)
    }

    #[inline]
    fn touch(&self, face: u32) -> u32 {
        let corners = self.triangles().map_or(0, |all| all[face as usize][0]);
        corners ^ self.complex().touch_vertices_of_face(face as usize)
    }
}

impl Faces for CellMesh {
    fn beside(&self, face: u32, vertex: u32, sign: i64) -> Option<u32> {
        beside(self.complex(), face, vertex, sign)
    }

    #[inline]
    fn faces_around(&self, vertex: u32) -> &[u32] {
        self.complex().faces_of_vertex(vertex as usize)
    }

    #[inline]
    fn touch(&self, face: u32) -> u32 {
        self.complex().touch_vertices_of_face(face as usize)
    }
}

/// The same from the boundary matrices.
fn beside(complex: &CellComplex, face: u32, vertex: u32, sign: i64) -> Option<u32> {
    let (edges, signs) = complex.boundary_column(2, face as usize);
    let ends = edges.iter().zip(signs).filter_map(|(&edge, &direction)| {
        let [tail, head] = complex.edge_vertices(edge as usize);
        let at = i64::from(head == vertex) - i64::from(tail == vertex);
        (i64::from(direction) * at == sign).then_some(tail ^ head ^ vertex)
    });
    ends.min()
}

/// [`Faces::beside`], which must exist.
///
/// # Errors
/// When the vertex is not one of the face.
#[inline]
pub fn beside_in_face(
    mesh: &impl Faces,
    face: u32,
    vertex: u32,
    sign: i64,
    fault: Fault,
) -> Fallible<u32> {
    mesh.beside(face, vertex, sign).ok_or(fault)
}

/// The first edge that has both vertices; of one vertex its first edge.
///
/// # Errors
/// When there is none.
#[inline]
pub fn edge_between(complex: &CellComplex, a: u32, b: u32, fault: Fault) -> Fallible<u32> {
    complex.edge_between(a, b).ok_or(fault)
}

/// The first face f of an edge e for which ∂²[e, f] ∂¹[v, e] with a vertex v is `sign`, or, with `other`, is something else.
///
/// # Errors
/// When there is none.
#[inline]
pub fn face_beside(
    complex: &CellComplex,
    edge: u32,
    vertex: u32,
    sign: i8,
    other: bool,
    fault: Fault,
) -> Fallible<u32> {
    complex.face_beside(edge, vertex, sign, other).ok_or(fault)
}

/// The elements of a column of a boundary matrix with their signs.
#[inline]
pub fn with_signs<'a>(
    (elements, signs): (&'a [u32], &'a [i8]),
) -> impl Iterator<Item = (u32, i8)> + 'a {
    elements.iter().copied().zip(signs.iter().copied())
}

/// The first number in both of two sorted lists.
///
/// # Errors
/// When there is none.
#[inline]
pub fn first_common(a: &[u32], b: &[u32], fault: Fault) -> Fallible<u32> {
    const FEW: usize = 16;
    if a.len() <= FEW && b.len() <= FEW {
        // all pairs, without branches that nobody can predict
        let mut first = None;
        for &x in a.iter().rev() {
            let is_common = b.iter().fold(false, |found, y| found | (x == *y));
            first = if is_common { Some(x) } else { first };
        }
        return first.ok_or(fault);
    }
    super::intersection(a, b).first().copied().ok_or(fault)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_say_what_the_matrices_do() {
        let triangles = FaceMesh::from_triangles(5, &[[0, 3, 1], [3, 0, 4]]).unwrap();
        let polygons: &[&[u32]] = &[&[4, 0, 3, 1], &[3, 0, 2], &[0, 4, 1, 3, 2]];
        let polygons = FaceMesh::from_polygons(5, polygons).unwrap();
        for mesh in [triangles, polygons] {
            for face in 0..mesh.complex().n(2) as u32 {
                for vertex in 0..5 {
                    for sign in [-1, 1] {
                        let expected = beside(mesh.complex(), face, vertex, sign);
                        assert_eq!(mesh.beside(face, vertex, sign), expected);
                    }
                }
            }
        }
    }

    #[test]
    fn the_first_common_number_is_that_of_the_intersection() {
        let fault = Fault::new("none");
        let long: Vec<u32> = (0..40).map(|k| 3 * k).collect();
        for (a, b) in [
            (&[1, 4, 6, 9][..], &[4, 9][..]),
            (&[5], &long),
            (&[7, 9], &long),
            (&[], &[1]),
        ] {
            let expected = super::super::intersection(a, b).first().copied();
            assert_eq!(first_common(a, b, fault).ok(), expected);
            assert_eq!(first_common(b, a, fault).ok(), expected);
        }
    }
}
