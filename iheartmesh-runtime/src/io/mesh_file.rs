//! What a mesh file holds.

use std::collections::HashMap;

use glam::DVec3;

use super::attributes::Attributes;
use super::polyhedra::{self, Polyhedra};
use crate::element::{Cell, Face};
use crate::mesh::{CellMesh, EdgeMesh, FaceMesh, MeshError};

/// The contents of a mesh file, as they stand there: elements are not renumbered, merged, dropped or repaired. What the
/// [table of formats](super) does not name for a format, such as the lines and texture coordinates of OBJ files and the
/// edges of PLY files, is not read.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeshFile {
    /// Position of each vertex, also of those that no polygon names. All are finite.
    pub positions: Vec<DVec3>,
    /// Edges that stand in the file as such; those of polygons and cells are not repeated here. Both ends are below the
    /// number of positions, and may be the same.
    pub edges: Vec<[u32; 2]>,
    /// The polygons. Every corner is below the number of positions; a polygon may be degenerate.
    pub polygons: Polygons,
    /// Tetrahedra by their vertices, in the order that [`CellMesh::from_tetrahedra`] takes. They may be degenerate.
    pub tetrahedra: Vec<[u32; 4]>,
    /// Hexahedra by their vertices, in the order that [`CellMesh::from_hexahedra`] takes. They may be degenerate.
    pub hexahedra: Vec<[u32; 8]>,
    /// All other cells: prisms, pyramids and polyhedra of any form, in the order of the file. Every corner is below the
    /// number of positions; each has at least four faces, and each face at least three corners.
    pub polyhedra: Polyhedra,
    /// Named values on vertices, edges, faces and cells. The cells are the tetrahedra, then the hexahedra, then the
    /// polyhedra, whatever order they have in the file: values are read into this order.
    pub attributes: Attributes,
}

impl MeshFile {
    /// A file with these positions and nothing else, to be filled and written.
    pub fn of_positions(positions: impl Into<Vec<DVec3>>) -> MeshFile {
        MeshFile {
            positions: positions.into(),
            ..MeshFile::default()
        }
    }

    /// A file with these positions and the cells of a mesh, to be written. Cell k of the mesh is cell k of the file.
    ///
    /// Tetrahedra, and the hexahedra after them, go into the lists of these kinds; all cells after the first of another
    /// kind are polyhedra. So a mesh with a tetrahedron after another cell can be written to VTK only: Gmsh and MEDIT hold
    /// no polyhedra that are tetrahedra or hexahedra.
    ///
    /// ```no_run
    /// # use iheartmesh_runtime::CellMesh;
    /// # use iheartmesh_runtime::glam::DVec3;
    /// # use iheartmesh_runtime::io::{self, MeshFile};
    /// let pyramid: [&[u32]; 5] = [&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]];
    /// let mesh = CellMesh::from_polyhedra(5, [pyramid])?;
    /// let positions = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y, DVec3::Z];
    /// io::write_file("pyramid.msh", &MeshFile::of_cells(positions, &mesh))?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_cells(positions: impl Into<Vec<DVec3>>, mesh: &CellMesh) -> MeshFile {
        let mut file = MeshFile::of_positions(positions);
        if let Some(tetrahedra) = mesh.tetrahedra() {
            file.tetrahedra = tetrahedra.to_vec();
            return file;
        }
        mesh.cells().for_each(|cell| file.push_cell(mesh, cell));
        file
    }

    fn push_cell(&mut self, mesh: &CellMesh, cell: Cell) {
        let mut sides = Polygons::new();
        let (faces, signs) = mesh.cell_boundary(cell);
        for (face, sign) in faces.iter().zip(signs) {
            let corners = mesh.face_vertices(face).ids();
            match sign {
                1 => sides.push(corners),
                _ => sides.push_all(polyhedra::backwards(corners)),
            }
        }
        let corners = mesh.cell_vertices(cell).ids();
        let is_given = |corners: &&[u32]| {
            corners.len() == 8
                && polyhedra::are_faces_of(corners, Polyhedra::push_any_prism, sides.iter())
        };
        let pyramid = polyhedra::pyramid(sides.iter());
        let prism = match Some(corners).filter(is_given) {
            Some(corners) => Some(corners.to_vec()),
            None => polyhedra::prism(sides.iter()),
        };
        let takes_hexahedra = self.polyhedra.is_empty();
        let takes_tetrahedra = takes_hexahedra && self.hexahedra.is_empty();
        match (pyramid.as_deref(), prism.as_deref()) {
            (Some(&[a, b, c, d]), _) if takes_tetrahedra => self.tetrahedra.push([a, b, c, d]),
            (_, Some(&[a, b, c, d, e, f, g, h])) if takes_hexahedra => {
                self.hexahedra.push([a, b, c, d, e, f, g, h]);
            }
            (Some(corners), _) => self.polyhedra.push_any_pyramid(corners),
            (_, Some(corners)) => self.polyhedra.push_any_prism(corners),
            _ => self.polyhedra.push(&sides),
        }
    }

    /// Makes one vertex of all that have exactly the same position (−0 is 0), the first of them; it keeps its values. Edges,
    /// polygons and cells name it, and keep their order; what joins two that are merged is degenerate then, and kept.
    ///
    /// For files in which a vertex stands once for each normal or texture coordinate, as in glTF, where a surface would
    /// otherwise be cut along such seams.
    ///
    /// ```
    /// use iheartmesh_runtime::glam::DVec3;
    /// use iheartmesh_runtime::io::MeshFile;
    ///
    /// let mut file = MeshFile::of_positions([DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X, DVec3::ONE, DVec3::Y]);
    /// file.polygons.push(&[0, 1, 2]);
    /// file.polygons.push(&[3, 4, 5]);
    /// file.merge_equal_positions();
    /// assert_eq!(file.positions.len(), 4);
    /// assert_eq!(file.polygons.get(1), Some(&[1, 3, 2][..]));
    /// ```
    pub fn merge_equal_positions(&mut self) {
        // a file that was built by hand may have any positions: NaN equals itself here
        let key = |position: DVec3| position.to_array().map(|x| (x + 0.0).to_bits());
        let mut kept: Vec<usize> = Vec::new();
        let mut first = HashMap::with_capacity(self.positions.len());
        let mut names = Vec::with_capacity(self.positions.len());
        for (vertex, &position) in self.positions.iter().enumerate() {
            let name = *first.entry(key(position)).or_insert_with(|| {
                kept.push(vertex);
                kept.len() as u32 - 1
            });
            names.push(name);
        }
        let rename = |vertex: &mut u32| {
            if let Some(name) = names.get(*vertex as usize) {
                *vertex = *name;
            }
        };
        self.edges.iter_mut().flatten().for_each(rename);
        self.polygons.corners.iter_mut().for_each(rename);
        self.tetrahedra.iter_mut().flatten().for_each(rename);
        self.hexahedra.iter_mut().flatten().for_each(rename);
        self.polyhedra.corners_mut().iter_mut().for_each(rename);
        self.positions = kept.iter().map(|&vertex| self.positions[vertex]).collect();
        self.attributes.keep_vertices(&kept);
    }

    /// The mesh of all edges that stand in the file as such.
    ///
    /// # Errors
    /// Those of [`EdgeMesh::from_edges`].
    pub fn edge_mesh(&self) -> Result<EdgeMesh, MeshError> {
        EdgeMesh::from_edges(self.positions.len(), &self.edges)
    }

    /// Number of tetrahedra, hexahedra and polyhedra.
    pub fn n_cells(&self) -> usize {
        self.tetrahedra.len() + self.hexahedra.len() + self.polyhedra.len()
    }

    /// The mesh of all tetrahedra, then all hexahedra, then all polyhedra, numbered as the values of
    /// [`attributes`](Self::attributes) are.
    ///
    /// # Errors
    /// Those of [`CellMesh::from_tetrahedra`], and, if there are polyhedra, of [`CellMesh::from_polyhedra`]: a file may hold
    /// degenerate cells, a mesh may not.
    pub fn cell_mesh(&self) -> Result<CellMesh, MeshError> {
        let n = self.positions.len();
        let kinds = (
            self.tetrahedra.is_empty(),
            self.hexahedra.is_empty(),
            self.polyhedra.is_empty(),
        );
        match kinds {
            (_, true, true) => CellMesh::from_tetrahedra(n, &self.tetrahedra),
            (true, false, true) => CellMesh::from_hexahedra(n, &self.hexahedra),
            _ => {
                let polyhedra = self
                    .polyhedra
                    .iter()
                    .map(|faces| faces.map(<[u32]>::to_vec).collect());
                CellMesh::from_all(n, &self.tetrahedra, &self.hexahedra, polyhedra)
            }
        }
    }

    /// The mesh of all polygons.
    ///
    /// # Errors
    /// Those of [`FaceMesh::from_polygons`]: a file may hold degenerate faces, a mesh may not.
    pub fn face_mesh(&self) -> Result<FaceMesh, MeshError> {
        match self.polygons.as_triangles() {
            Some(triangles) => FaceMesh::from_triangles(self.positions.len(), triangles),
            None => FaceMesh::from_polygons(self.positions.len(), &self.polygons),
        }
    }
}

/// A list of polygons, each given by the numbers (from 0) of its vertices in cyclic order.
///
/// ```
/// use iheartmesh_runtime::io::Polygons;
///
/// let polygons: Polygons = [vec![0, 1, 2, 3], vec![2, 1, 4]].into_iter().collect();
/// assert_eq!(polygons.len(), 2);
/// assert_eq!(polygons.iter().last(), Some(&[2, 1, 4][..]));
/// assert_eq!(polygons.triangles(), None);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polygons {
    /// For each polygon, where its corners end.
    ends: Vec<usize>,
    pub(super) corners: Vec<u32>,
}

impl Polygons {
    /// No polygons.
    pub fn new() -> Self {
        Polygons::default()
    }

    /// Adds a polygon at the end.
    pub fn push(&mut self, corners: &[u32]) {
        self.corners.extend_from_slice(corners);
        self.ends.push(self.corners.len());
    }

    /// As [`push`](Self::push), of corners that stand in no slice.
    pub(super) fn push_all(&mut self, corners: impl Iterator<Item = u32>) {
        self.corners.extend(corners);
        self.ends.push(self.corners.len());
    }

    /// Number of polygons.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is no polygon.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The corners of polygon `index` (from 0), or `None` past the end.
    pub fn get(&self, index: usize) -> Option<&[u32]> {
        let end = *self.ends.get(index)?;
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        Some(&self.corners[start..end])
    }

    /// The polygons in order, each as the slice of its corners.
    pub fn iter(&self) -> PolygonsIter<'_> {
        self.range(0..self.len())
    }

    /// The polygons with these numbers, which all exist.
    pub(super) fn range(&self, range: std::ops::Range<usize>) -> PolygonsIter<'_> {
        PolygonsIter {
            polygons: self,
            range,
        }
    }

    /// The corners of all polygons, one after the other.
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// All polygons as triangles, or `None` if one of them is not.
    pub fn triangles(&self) -> Option<Vec<[u32; 3]>> {
        self.as_triangles().map(<[_]>::to_vec)
    }

    /// As [`triangles`](Self::triangles), without a copy.
    pub fn as_triangles(&self) -> Option<&[[u32; 3]]> {
        let is_triangle = |(index, &end): (usize, &usize)| end == 3 * (index + 1);
        self.ends
            .iter()
            .enumerate()
            .all(is_triangle)
            .then(|| self.corners.as_chunks().0)
    }
}

/// Iterator over [`Polygons`], or over the faces of one of [`Polyhedra`].
#[derive(Clone, Debug)]
pub struct PolygonsIter<'a> {
    polygons: &'a Polygons,
    range: std::ops::Range<usize>,
}

impl<'a> Iterator for PolygonsIter<'a> {
    type Item = &'a [u32];

    fn next(&mut self) -> Option<&'a [u32]> {
        self.polygons.get(self.range.next()?)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.range.size_hint()
    }
}

impl ExactSizeIterator for PolygonsIter<'_> {}

impl<'a> IntoIterator for &'a Polygons {
    type Item = &'a [u32];
    type IntoIter = PolygonsIter<'a>;

    fn into_iter(self) -> PolygonsIter<'a> {
        self.iter()
    }
}

impl<P: AsRef<[u32]>> FromIterator<P> for Polygons {
    fn from_iter<I: IntoIterator<Item = P>>(polygons: I) -> Self {
        let mut all = Polygons::new();
        for polygon in polygons {
            all.push(polygon.as_ref());
        }
        all
    }
}

/// What can be written as the faces of a mesh file: a [`FaceMesh`], [`Polygons`] or a slice of triangles.
pub trait FaceList {
    /// Number of faces.
    fn n_faces(&self) -> usize;

    /// Vertices of face `index` in cyclic order.
    ///
    /// # Panics
    /// If `index` is not below [`n_faces`](Self::n_faces).
    fn corners(&self, index: usize) -> &[u32];

    /// Number of vertices of the mesh, if the faces know it.
    fn n_vertices(&self) -> Option<usize> {
        None
    }
}

impl FaceList for FaceMesh {
    fn n_faces(&self) -> usize {
        FaceMesh::n_faces(self)
    }

    fn corners(&self, index: usize) -> &[u32] {
        self.face_vertices(Face::new(index as u32)).ids()
    }

    fn n_vertices(&self) -> Option<usize> {
        Some(FaceMesh::n_vertices(self))
    }
}

impl FaceList for Polygons {
    fn n_faces(&self) -> usize {
        self.len()
    }

    fn corners(&self, index: usize) -> &[u32] {
        self.get(index)
            .unwrap_or_else(|| panic!("there is no polygon {index}: there are {}", self.len()))
    }
}

impl FaceList for [[u32; 3]] {
    fn n_faces(&self) -> usize {
        self.len()
    }

    fn corners(&self, index: usize) -> &[u32] {
        &self[index]
    }
}

impl FaceList for Vec<[u32; 3]> {
    fn n_faces(&self) -> usize {
        self.len()
    }

    fn corners(&self, index: usize) -> &[u32] {
        &self[index]
    }
}
