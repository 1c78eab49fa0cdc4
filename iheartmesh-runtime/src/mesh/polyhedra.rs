//! Cell meshes from lists of polyhedra and from boundary matrices.

use super::cell::{HEXAHEDRON, TETRAHEDRON, check_sizes};
use super::cell_faces::{self, Faces, Sides};
use super::face::{check_face, walk};
use super::{CellMesh, MeshError};
use crate::boundary::BoundaryMatrix;
use crate::complex::CellComplex;
use crate::element::ElementKind;

impl CellMesh {
    /// The mesh of polyhedra: each cell is a list of its sides, each side its vertices (numbers from 0) in cyclic order,
    /// counter-clockwise seen from outside.
    ///
    /// ```
    /// # use iheartmesh_runtime::CellMesh;
    /// // a pyramid over a square
    /// let pyramid: [&[u32]; 5] = [&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]];
    /// let mesh = CellMesh::from_polyhedra(5, [pyramid])?;
    /// assert_eq!((mesh.n_edges(), mesh.n_faces(), mesh.euler_characteristic()), (8, 5, 1));
    /// # Ok::<(), iheartmesh_runtime::MeshError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`from_tetrahedra`](Self::from_tetrahedra), and
    /// - [`MeshError::TooFewCorners`] if a side has fewer than three vertices;
    /// - [`MeshError::TooFewSides`] if a cell has fewer than four sides;
    /// - [`MeshError::RepeatedFace`] if a cell has a side twice;
    /// - [`MeshError::OpenCell`] if the sides of a cell do not close: each edge must be run along as often in one direction
    ///   as in the other.
    ///
    /// For the errors of a side, `element` is the number of the cell.
    pub fn from_polyhedra<I, S>(n_vertices: usize, cells: I) -> Result<CellMesh, MeshError>
    where
        I: IntoIterator,
        I::Item: AsRef<[S]>,
        S: AsRef<[u32]>,
    {
        let mut sides = Sides {
            cells: vec![0],
            starts: vec![0],
            corners: Vec::new(),
        };
        let (mut cell_starts, mut cell_corners) = (vec![0], Vec::new());
        let mut scratch = Vec::new();
        let cells = cells.into_iter();
        // a cell has four sides of three corners at least
        let n_cells = cells.size_hint().0;
        check_sizes(n_vertices, n_cells, n_cells.saturating_mul(12))?;
        for (element, cell) in cells.enumerate() {
            let cell = cell.as_ref();
            let first = sides.corners.len();
            for side in cell {
                let side = side.as_ref();
                check_sizes(n_vertices, element, sides.corners.len() + side.len())?;
                check_face(ElementKind::Cell, n_vertices, element, side, &mut scratch)?;
                sides.corners.extend_from_slice(side);
                sides.starts.push(sides.corners.len() as u32);
            }
            if cell.len() < 4 {
                return Err(MeshError::TooFewSides {
                    cell: element,
                    sides: cell.len(),
                });
            }
            sides.cells.push(sides.starts.len() as u32 - 1);
            let mut vertices = sides.corners[first..].to_vec();
            vertices.sort_unstable();
            vertices.dedup();
            cell_corners.extend_from_slice(&vertices);
            cell_starts.push(cell_corners.len() as u32);
        }
        check_sizes(n_vertices, sides.cells.len() - 1, sides.corners.len())?;
        check_repeated_sides(&sides)?;
        let faces = cell_faces::complex(n_vertices, sides);
        if let Err(MeshError::NotAComplex { element, .. }) =
            faces.complex.check_boundary_of_boundary(3)
        {
            return Err(MeshError::OpenCell { cell: element });
        }
        let mut mesh = Self::new(faces, cell_starts, cell_corners, false);
        mesh.orient_tetrahedra();
        Ok(mesh)
    }

    /// The mesh of tetrahedra, then hexahedra, both in the orders that the constructors for one kind take: the cells are
    /// numbered in this order. [`cell_vertices`](Self::cell_vertices) are ascending if there are hexahedra.
    ///
    /// # Errors
    /// Those of [`from_tetrahedra`](Self::from_tetrahedra).
    pub fn from_mixed(
        n_vertices: usize,
        tetrahedra: &[[u32; 4]],
        hexahedra: &[[u32; 8]],
    ) -> Result<CellMesh, MeshError> {
        Self::from_all(n_vertices, tetrahedra, hexahedra, std::iter::empty())
    }

    /// The mesh of tetrahedra, then hexahedra, then polyhedra, as their constructors take them.
    pub(crate) fn from_all(
        n_vertices: usize,
        tetrahedra: &[[u32; 4]],
        hexahedra: &[[u32; 8]],
        polyhedra: impl Iterator<Item = Vec<Vec<u32>>>,
    ) -> Result<CellMesh, MeshError> {
        let n_cells = tetrahedra.len() + hexahedra.len();
        let n_corners = 12 * tetrahedra.len() + 24 * hexahedra.len();
        check_sizes(n_vertices, n_cells, n_corners)?;
        let mut scratch = Vec::new();
        let corners = tetrahedra.iter().map(|cell| &cell[..]);
        let corners = corners.chain(hexahedra.iter().map(|cell| &cell[..]));
        for (element, cell) in corners.enumerate() {
            check_face(ElementKind::Cell, n_vertices, element, cell, &mut scratch)?;
        }
        let sides = |cell: &[u32], sides: &[&[usize]]| -> Vec<Vec<u32>> {
            let side = |side: &&[usize]| side.iter().map(|&corner| cell[corner]).collect();
            sides.iter().map(side).collect()
        };
        let tetrahedra = tetrahedra.iter().map(|cell| sides(cell, &TETRAHEDRON));
        let hexahedra = hexahedra.iter().map(|cell| sides(cell, &HEXAHEDRON));
        let cells = tetrahedra.chain(hexahedra).chain(polyhedra);
        Self::from_polyhedra(n_vertices, cells)
    }

    /// The mesh with these boundary matrices, in either storage order of `sprs`: `d1` is ∂¹ (vertices × edges), `d2` is
    /// ∂² (edges × faces), `d3` is ∂³ (faces × cells). All numbers and orientations are those of the matrices, with the
    /// signs that [`CellMesh`] describes.
    ///
    /// # Errors
    /// Those of [`FaceMesh::from_boundary_matrices`](crate::FaceMesh::from_boundary_matrices), and
    /// [`MeshError::TooFewSides`] if a column of ∂³ has fewer than four entries.
    pub fn from_boundary_matrices(
        d1: &BoundaryMatrix,
        d2: &BoundaryMatrix,
        d3: &BoundaryMatrix,
    ) -> Result<CellMesh, MeshError> {
        check_sizes(0, 0, d2.nnz())?;
        let complex = CellComplex::from_boundary_matrices(&[d1, d2, d3])?;
        let (mut starts, mut corners) = (vec![0], Vec::with_capacity(d2.nnz()));
        for face in 0..complex.n(2) {
            walk(&complex, face, &mut corners)?;
            starts.push(corners.len() as u32);
        }
        let (mut cell_starts, mut cell_corners) = (vec![0], Vec::new());
        for cell in 0..complex.n(3) {
            let sides = complex.boundary_elements(3, cell).len();
            if sides < 4 {
                return Err(MeshError::TooFewSides { cell, sides });
            }
            let mut vertices: Vec<u32> = complex
                .boundary_elements(3, cell)
                .iter()
                .flat_map(|&f| {
                    &corners[starts[f as usize] as usize..starts[f as usize + 1] as usize]
                })
                .copied()
                .collect();
            vertices.sort_unstable();
            vertices.dedup();
            check_sizes(0, 0, cell_corners.len() + vertices.len())?;
            cell_corners.extend_from_slice(&vertices);
            cell_starts.push(cell_corners.len() as u32);
        }
        let faces = Faces {
            complex,
            starts,
            corners,
        };
        let mut mesh = Self::new(faces, cell_starts, cell_corners, false);
        mesh.orient_tetrahedra();
        Ok(mesh)
    }
}

/// No cell may have two sides on the same vertices in the same cycle.
fn check_repeated_sides(sides: &Sides) -> Result<(), MeshError> {
    for (cell, range) in sides.cells.windows(2).enumerate() {
        let mut forms: Vec<Vec<u32>> = (range[0] as usize..range[1] as usize)
            .map(|k| {
                let (from, to) = (sides.starts[k] as usize, sides.starts[k + 1] as usize);
                let mut side = sides.corners[from..to].to_vec();
                cell_faces::normalize(&mut side);
                side
            })
            .collect();
        forms.sort_unstable();
        if forms.windows(2).any(|pair| pair[0] == pair[1]) {
            return Err(MeshError::RepeatedFace { cell });
        }
    }
    Ok(())
}
