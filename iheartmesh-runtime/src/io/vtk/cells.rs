//! The cells of a VTK file as elements.

use super::{
    HEXAHEDRON, LINE, NO_COLOR, PIXEL, POLY_LINE, POLY_VERTEX, POLYGON, QUADRILATERAL, TETRAHEDRON,
    TRIANGLE, TRIANGLE_STRIP, VERTEX, VOXEL,
};
use crate::element::ElementKind;
use crate::io::attributes::{AttributeValues, COLOR};
use crate::io::mesh_file::MeshFile;

/// For each element, in the order of the mesh file, the VTK cell that it comes from.
#[derive(Default)]
pub(super) struct Sources {
    pub(super) n_cells: usize,
    edges: Vec<u32>,
    polygons: Vec<u32>,
    tetrahedra: Vec<u32>,
    hexahedra: Vec<u32>,
}

impl Sources {
    pub(super) fn n_elements(&self) -> usize {
        self.edges.len() + self.polygons.len() + self.tetrahedra.len() + self.hexahedra.len()
    }

    /// Adds the elements of the next cell, or says what is wrong with it.
    pub(super) fn push(
        &mut self,
        kind: u8,
        corners: &[u32],
        file: &mut MeshFile,
    ) -> Result<(), String> {
        let cell = self.n_cells as u32;
        self.n_cells += 1;
        let expected = match kind {
            VERTEX | POLY_VERTEX => return Ok(()),
            LINE => 2..3,
            POLY_LINE => 2..usize::MAX,
            TRIANGLE => 3..4,
            TRIANGLE_STRIP => 3..usize::MAX,
            // files may hold degenerate faces
            POLYGON => 0..usize::MAX,
            PIXEL | QUADRILATERAL | TETRAHEDRON => 4..5,
            VOXEL | HEXAHEDRON => 8..9,
            _ => {
                return Err(format!(
                    "cell {cell} is of type {kind}, which is neither an edge, a polygon, a tetrahedron nor a hexahedron"
                ));
            }
        };
        if !expected.contains(&corners.len()) {
            let problem = format!("cell {cell} of type {kind} has {} corners", corners.len());
            return Err(problem);
        }
        match (kind, corners) {
            (LINE | POLY_LINE, _) => {
                for edge in corners.windows(2) {
                    file.edges.push([edge[0], edge[1]]);
                    self.edges.push(cell);
                }
            }
            (TRIANGLE_STRIP, _) => {
                for (index, corners) in corners.windows(3).enumerate() {
                    // every other triangle runs the other way round
                    let &[a, b, c] = corners else { continue };
                    let triangle = if index % 2 == 0 { [a, b, c] } else { [b, a, c] };
                    file.polygons.push(&triangle);
                    self.polygons.push(cell);
                }
            }
            (PIXEL, &[a, b, c, d]) => {
                file.polygons.push(&[a, b, d, c]);
                self.polygons.push(cell);
            }
            (TETRAHEDRON, &[a, b, c, d]) => {
                file.tetrahedra.push([a, b, c, d]);
                self.tetrahedra.push(cell);
            }
            (VOXEL, &[a, b, c, d, e, f, g, h]) => {
                file.hexahedra.push([a, b, d, c, e, f, h, g]);
                self.hexahedra.push(cell);
            }
            (HEXAHEDRON, &[a, b, c, d, e, f, g, h]) => {
                file.hexahedra.push([a, b, c, d, e, f, g, h]);
                self.hexahedra.push(cell);
            }
            _ => {
                file.polygons.push(corners);
                self.polygons.push(cell);
            }
        }
        Ok(())
    }

    /// Gives each kind of element its values.
    pub(super) fn distribute(&self, name: &str, values: &AttributeValues, file: &mut MeshFile) {
        let cells: Vec<u32> = [&self.tetrahedra[..], &self.hexahedra].concat();
        let kinds = [
            (ElementKind::Edge, &self.edges),
            (ElementKind::Face, &self.polygons),
            (ElementKind::Cell, &cells),
        ];
        let n_kinds = kinds.iter().filter(|(_, from)| !from.is_empty()).count();
        for (kind, from) in kinds {
            let from = || from.iter().map(|&cell| cell as usize);
            let (values, is_missing) = match values {
                AttributeValues::Scalar(all) => {
                    let values: Vec<f64> = from().map(|cell| all[cell]).collect();
                    let is_missing = values.iter().all(|value| value.is_nan());
                    (AttributeValues::Scalar(values), is_missing)
                }
                AttributeValues::Vector(all) => {
                    let values: Vec<_> = from().map(|cell| all[cell]).collect();
                    let is_missing = values.iter().all(|value| value.is_nan_mask().all());
                    (AttributeValues::Vector(values), is_missing)
                }
                AttributeValues::Color(all) => {
                    let values: Vec<_> = from().map(|cell| all[cell]).collect();
                    let is_missing = values.iter().all(|value| *value == NO_COLOR);
                    (AttributeValues::Color(values), is_missing)
                }
            };
            // of a file with one kind of element, all values belong to it
            if !values.is_empty() && (n_kinds == 1 || !is_missing) {
                let name = match values {
                    AttributeValues::Color(_) => COLOR,
                    _ => name,
                };
                file.attributes.push(kind, name, values);
            }
        }
    }
}
