//! [`CellMesh`]: a mesh of tetrahedra, hexahedra or any polyhedra.

use std::fmt::{self, Debug};
use std::sync::Arc;

use super::accessors::{accessors, face_accessors};
use super::cell_faces::{self, Faces, Sides};
use super::edge::check_count;
use super::face::check_face;
use super::polygon_edges::MAX_CORNERS;
use super::{FaceMesh, MeshError};
use crate::boundary::BoundaryMatrix;
use crate::complex::CellComplex;
use crate::element::{Cell, Edge, ElementKind, ElementSlice, Elements, Face, Vertex};

/// The sides of a tetrahedron that is positively oriented, counter-clockwise seen from outside.
pub(super) const TETRAHEDRON: [&[usize]; 4] = [&[1, 2, 3], &[0, 3, 2], &[0, 1, 3], &[0, 2, 1]];

/// The sides of a hexahedron with its vertices in the order of VTK: around the bottom, then above them around the top.
pub(super) const HEXAHEDRON: [&[usize]; 6] = [
    &[0, 3, 2, 1],
    &[4, 5, 6, 7],
    &[0, 1, 5, 4],
    &[1, 2, 6, 5],
    &[2, 3, 7, 6],
    &[3, 0, 4, 7],
];

/// A mesh of polyhedra: vertices, edges, faces and cells with the boundary matrices ∂¹, ∂² and ∂³.
///
/// Only connectivity, no positions. A mesh never changes; clones share its memory.
///
/// **Numbering.** Vertices and cells keep the order of the input. Edges and faces are numbered lexicographically by their
/// vertices in ascending order. An edge is oriented from its smaller vertex to its larger; a face starts at its smallest
/// vertex and goes on to the smaller of the two next to it, so that a triangle is oriented by its ascending vertices. A
/// mesh made [from boundary matrices](Self::from_boundary_matrices) keeps its own numbers and orientations.
///
/// **Signs.** ∂¹(v, e) is −1 at the tail of e and +1 at its head. ∂²(e, f) is +1 if f runs along e from tail to head and
/// −1 if it runs against it. ∂³(f, c) is +1 if f, seen from outside of c, runs counter-clockwise, where c is positively
/// oriented: det(x₁ − x₀, x₂ − x₀, x₃ − x₀) > 0 for a tetrahedron (0, 1, 2, 3).
///
/// **What is allowed.** Inverted cells, faces with more than two cells, the same cell twice, vertices without cells.
///
/// Accessors panic if given an element that the mesh does not have, as indexing a slice does.
#[derive(Clone)]
pub struct CellMesh {
    data: Arc<Data>,
}

struct Data {
    complex: CellComplex,
    /// Corners of all faces in cyclic order, and where those of each face start.
    face_starts: Vec<u32>,
    face_corners: Vec<u32>,
    /// Vertices of all cells, and where those of each cell start.
    cell_starts: Vec<u32>,
    cell_corners: Vec<u32>,
    all_tetrahedra: bool,
}

impl CellMesh {
    /// The mesh of tetrahedra given by their vertices (numbers from 0). A tetrahedron is positively oriented if its last
    /// three vertices run counter-clockwise seen from outside; all may be, or none, or some.
    ///
    /// ```
    /// # use iheartmesh_runtime::{CellMesh, Cell, Face};
    /// let mesh = CellMesh::from_tetrahedra(5, &[[0, 1, 2, 3], [1, 2, 3, 4]])?;
    /// assert_eq!((mesh.n_edges(), mesh.n_faces(), mesh.n_cells()), (9, 7, 2));
    /// let shared = mesh.faces().find(|&face| mesh.face_cells(face).len() == 2);
    /// assert_eq!(shared, Some(Face::new(3)));
    /// # Ok::<(), iheartmesh_runtime::MeshError>(())
    /// ```
    ///
    /// # Errors
    /// - [`MeshError::VertexOutOfRange`] if a cell names a vertex that is not below `n_vertices`;
    /// - [`MeshError::RepeatedVertex`] if one names a vertex twice;
    /// - [`MeshError::TooManyElements`], [`MeshError::TooManyCorners`] if 32 bits cannot number the elements.
    ///
    /// Of several bad cells the first is reported.
    pub fn from_tetrahedra(
        n_vertices: usize,
        tetrahedra: &[[u32; 4]],
    ) -> Result<CellMesh, MeshError> {
        Self::from_alike(n_vertices, tetrahedra, &TETRAHEDRON)
    }

    /// The mesh of hexahedra given by their vertices (numbers from 0) in the order of VTK: four around the bottom,
    /// counter-clockwise seen from above, then the four above them. One whose top is below its bottom is negatively
    /// oriented; all may be, or none, or some.
    ///
    /// ```
    /// # use iheartmesh_runtime::CellMesh;
    /// let mesh = CellMesh::from_hexahedra(8, &[[0, 1, 2, 3, 4, 5, 6, 7]])?;
    /// assert_eq!((mesh.n_edges(), mesh.n_faces(), mesh.euler_characteristic()), (12, 6, 1));
    /// # Ok::<(), iheartmesh_runtime::MeshError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`from_tetrahedra`](Self::from_tetrahedra).
    pub fn from_hexahedra(
        n_vertices: usize,
        hexahedra: &[[u32; 8]],
    ) -> Result<CellMesh, MeshError> {
        Self::from_alike(n_vertices, hexahedra, &HEXAHEDRON)
    }

    fn from_alike<const N: usize>(
        n_vertices: usize,
        cells: &[[u32; N]],
        sides: &[&[usize]],
    ) -> Result<CellMesh, MeshError> {
        let n_corners: usize = sides.iter().map(|side| side.len()).sum();
        check_sizes(n_vertices, cells.len(), n_corners * cells.len())?;
        let mut scratch = Vec::new();
        for (element, cell) in cells.iter().enumerate() {
            check_face(ElementKind::Cell, n_vertices, element, cell, &mut scratch)?;
        }
        let starts = |length: usize, n: usize| -> Vec<u32> {
            (0..=n as u32).map(|k| k * length as u32).collect()
        };
        let mut side_starts = Vec::with_capacity(sides.len() * cells.len() + 1);
        side_starts.push(0);
        let mut corners = Vec::with_capacity(n_corners * cells.len());
        for cell in cells {
            for side in sides {
                corners.extend(side.iter().map(|&corner| cell[corner]));
                side_starts.push(corners.len() as u32);
            }
        }
        let faces = cell_faces::complex(
            n_vertices,
            Sides {
                cells: starts(sides.len(), cells.len()),
                starts: side_starts,
                corners,
            },
        );
        Ok(Self::new(
            faces,
            starts(N, cells.len()),
            cells.as_flattened().to_vec(),
            N == 4,
        ))
    }

    pub(super) fn new(
        faces: Faces,
        cell_starts: Vec<u32>,
        cell_corners: Vec<u32>,
        all_tetrahedra: bool,
    ) -> CellMesh {
        CellMesh {
            data: Arc::new(Data {
                complex: faces.complex,
                face_starts: faces.starts,
                face_corners: faces.corners,
                cell_starts,
                cell_corners,
                all_tetrahedra,
            }),
        }
    }

    /// Where all cells are tetrahedra, brings their vertices into the order that [`Self::from_tetrahedra`] takes: the
    /// smallest vertex first, the others as the side across from it runs seen from outside.
    pub(super) fn orient_tetrahedra(&mut self) {
        let mesh = self.clone();
        let is_tetrahedron = |cell: Cell| {
            let (faces, _) = mesh.cell_boundary(cell);
            faces.len() == 4
                && mesh.cell_vertices(cell).len() == 4
                && faces.iter().all(|face| mesh.face_vertices(face).len() == 3)
        };
        if !mesh.cells().all(is_tetrahedron) {
            return;
        }
        let mut corners = Vec::with_capacity(mesh.data.cell_corners.len());
        for cell in mesh.cells() {
            let smallest = mesh.cell_vertices(cell).get(0);
            let (faces, signs) = mesh.cell_boundary(cell);
            let across = faces.iter().zip(signs).find(|(face, _)| {
                !mesh
                    .face_vertices(*face)
                    .iter()
                    .any(|v| Some(v) == smallest)
            });
            let Some((face, sign)) = across else {
                return;
            };
            let mut side: Vec<u32> = mesh.face_vertices(face).iter().map(|v| v.id()).collect();
            if *sign < 0 {
                side.reverse();
            }
            corners.extend(smallest.map(|v| v.id()));
            corners.extend(side);
        }
        drop(mesh);
        if let Some(data) = Arc::get_mut(&mut self.data) {
            data.cell_corners = corners;
            data.all_tetrahedra = true;
        }
    }

    /// The vertices of a face in its cyclic order.
    #[inline]
    pub fn face_vertices(&self, face: Face) -> ElementSlice<'_, Vertex> {
        let data = &*self.data;
        let (from, to) = (
            data.face_starts[face.index()],
            data.face_starts[face.index() + 1],
        );
        ElementSlice::new(&data.face_corners[from as usize..to as usize])
    }

    /// The cells at a face, ascending.
    #[inline]
    pub fn face_cells(&self, face: Face) -> ElementSlice<'_, Cell> {
        ElementSlice::new(self.complex().coboundary_elements(3, face.index()))
    }

    /// The faces of a cell, ascending, and for each +1 if it runs counter-clockwise seen from outside and −1 if not.
    #[inline]
    pub fn cell_boundary(&self, cell: Cell) -> (ElementSlice<'_, Face>, &[i8]) {
        let (faces, signs) = self.complex().boundary_column(3, cell.index());
        (ElementSlice::new(faces), signs)
    }

    /// The vertices of a cell, each once: as in the input if the mesh was made from tetrahedra alone or hexahedra alone.
    /// Otherwise ascending, but, if all cells are tetrahedra, in such an order that each has the orientation that its
    /// sides say.
    #[inline]
    pub fn cell_vertices(&self, cell: Cell) -> ElementSlice<'_, Vertex> {
        let data = &*self.data;
        let (from, to) = (
            data.cell_starts[cell.index()],
            data.cell_starts[cell.index() + 1],
        );
        ElementSlice::new(&data.cell_corners[from as usize..to as usize])
    }

    /// The vertices of all cells, in the order that [`from_tetrahedra`](Self::from_tetrahedra) takes, or `None` unless every
    /// cell is a tetrahedron.
    #[inline]
    pub fn tetrahedra(&self) -> Option<&[[u32; 4]]> {
        self.data
            .all_tetrahedra
            .then(|| self.data.cell_corners.as_chunks().0)
    }

    /// The faces with exactly one cell as a mesh of their own, on the same vertices, oriented outwards; and the face of
    /// this mesh for each of its faces, ascending.
    ///
    /// # Errors
    /// None that are known; the signature leaves room.
    pub fn boundary_mesh(&self) -> Result<(FaceMesh, Vec<Face>), MeshError> {
        let faces: Vec<Face> = self
            .faces()
            .filter(|&face| self.face_cells(face).len() == 1)
            .collect();
        let polygons = faces.iter().map(|&face| {
            let mut corners: Vec<u32> = self.face_vertices(face).iter().map(|v| v.id()).collect();
            if self.complex().coboundary_column(3, face.index()).1 == [-1] {
                corners[1..].reverse();
            }
            corners
        });
        Ok((FaceMesh::from_polygons(self.n_vertices(), polygons)?, faces))
    }
}

accessors! {
    CellMesh, "matrices", complex: data.complex,
    vertices: "those without cells included",
    elements: [n_edges edges Edge 1 "edges", n_faces faces Face 2 "faces", n_cells cells Cell 3 "cells"],
    boundary: "∂ᵏ: k = 1 is vertices × edges, 2 is edges × faces, 3 is faces × cells.",
    transpose: "(∂ᵏ)ᵀ, as [`boundary`](Self::boundary) with rows and columns exchanged.",
    unsigned: "|∂ᵏ|",
    which: "k is 1, 2 or 3",
    euler: "|V| − |E| + |F| − |C|. Vertices without cells count.",
}
face_accessors!(CellMesh);

pub(super) fn check_sizes(
    n_vertices: usize,
    n_cells: usize,
    n_corners: usize,
) -> Result<(), MeshError> {
    check_count(ElementKind::Vertex, n_vertices)?;
    check_count(ElementKind::Cell, n_cells)?;
    match n_corners > MAX_CORNERS {
        true => Err(MeshError::TooManyCorners {
            count: n_corners,
            maximum: MAX_CORNERS,
        }),
        false => Ok(()),
    }
}
