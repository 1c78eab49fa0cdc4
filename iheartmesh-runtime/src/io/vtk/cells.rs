//! The cells of a VTK file as elements.

use super::{
    CONVEX_POINT_SET, HEXAGONAL_PRISM, HEXAHEDRON, LINE, NO_COLOR, PENTAGONAL_PRISM, PIXEL,
    POLY_LINE, POLY_VERTEX, POLYGON, POLYHEDRON, PYRAMID, QUADRILATERAL, TETRAHEDRON, TRIANGLE,
    TRIANGLE_STRIP, VERTEX, VOXEL, WEDGE,
};
use crate::element::ElementKind;
use crate::io::FIRST_ORDER;
use crate::io::attributes::{AttributeValues, COLOR};
use crate::io::error::counted;
use crate::io::mesh_file::MeshFile;
use crate::io::polyhedra;

/// The cells as they stand in the file, until all is known of them.
#[derive(Default)]
pub(super) struct Cells {
    /// Where the numbers of each cell end.
    pub(super) ends: Vec<usize>,
    /// Corners, or what gives the faces of a polyhedron.
    pub(super) corners: Vec<i64>,
    /// Where each cell begins in the file.
    pub(super) places: Vec<usize>,
    pub(super) kinds: Vec<u8>,
}

impl Cells {
    /// For each cell its place, its type and its numbers.
    pub(super) fn iter(&self) -> impl Iterator<Item = (usize, u8, &[i64])> {
        let starts = [0].into_iter().chain(self.ends.iter().copied());
        let ranges = starts.zip(&self.ends);
        let cells = ranges.zip(self.places.iter().zip(&self.kinds));
        cells.map(|((start, &end), (&place, &kind))| (place, kind, &self.corners[start..end]))
    }

    /// The numbers of all wedges.
    pub(super) fn wedges(&self) -> impl Iterator<Item = [i64; 6]> {
        let wedges = self.iter().filter(|(_, kind, _)| *kind == WEDGE);
        wedges.filter_map(|(_, _, numbers)| numbers.try_into().ok())
    }
}

const OTHER_CELLS: &str = "remove it, or save it as other cells";

/// What is wrong with a cell, and what to do.
type Problem = (String, &'static str);

/// For each element, in the order of the mesh file, the VTK cell that it comes from.
#[derive(Default)]
pub(super) struct Sources {
    pub(super) n_cells: usize,
    edges: Vec<u32>,
    polygons: Vec<u32>,
    tetrahedra: Vec<u32>,
    hexahedra: Vec<u32>,
    polyhedra: Vec<u32>,
}

impl Sources {
    pub(super) fn n_elements(&self) -> usize {
        let first = self.edges.len() + self.polygons.len() + self.tetrahedra.len();
        first + self.hexahedra.len() + self.polyhedra.len()
    }

    /// Adds the elements of the next cell, or says what is wrong with it.
    pub(super) fn push(
        &mut self,
        kind: u8,
        numbers: &[i64],
        wedges_are_reversed: bool,
        file: &mut MeshFile,
    ) -> Result<(), Problem> {
        let cell = self.n_cells as u32;
        self.n_cells += 1;
        if kind == POLYHEDRON {
            self.polyhedra.push(cell);
            return push_polyhedron(cell, numbers, file);
        }
        let n_numbers = numbers.len();
        let expected = match kind {
            VERTEX | POLY_VERTEX => 0..usize::MAX,
            LINE => 2..3,
            POLY_LINE => 2..usize::MAX,
            TRIANGLE => 3..4,
            TRIANGLE_STRIP => 3..usize::MAX,
            // files may hold degenerate faces
            POLYGON => 0..usize::MAX,
            PIXEL | QUADRILATERAL | TETRAHEDRON => 4..5,
            VOXEL | HEXAHEDRON => 8..9,
            WEDGE => 6..7,
            PYRAMID => 5..6,
            PENTAGONAL_PRISM => 10..11,
            HEXAGONAL_PRISM => 12..13,
            CONVEX_POINT_SET => {
                let problem = format!(
                    "cell {cell} is of type {kind}, a convex point set, which does not say what its faces are"
                );
                return Err((problem, "save it as a polyhedron, of type 42"));
            }
            // quadratic and cubic, of any order, of Lagrange, of Bézier
            21..=37 | 60..=81 => {
                let problem = format!("cell {cell} is of type {kind}, which is not of first order");
                return Err((problem, FIRST_ORDER));
            }
            _ => {
                let problem = format!(
                    "cell {cell} is of type {kind}, which is neither an edge, a polygon nor a polyhedron"
                );
                return Err((problem, OTHER_CELLS));
            }
        };
        if !expected.contains(&n_numbers) {
            let problem = format!("cell {cell} of type {kind} has {n_numbers} corners");
            return Err((problem, OTHER_CELLS));
        }
        let n = file.positions.len();
        let corners = numbers.iter().map(|&number| corner(cell, number, n));
        let corners: Vec<u32> = corners.collect::<Result<_, _>>()?;
        match (kind, &corners[..]) {
            (VERTEX | POLY_VERTEX, _) => {}
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
            (WEDGE, &[a, b, c, d, e, f]) if wedges_are_reversed => {
                file.polyhedra.push_prism([a, c, b, d, f, e]);
                self.polyhedra.push(cell);
            }
            (WEDGE | PENTAGONAL_PRISM | HEXAGONAL_PRISM, _) => {
                file.polyhedra.push_any_prism(&corners);
                self.polyhedra.push(cell);
            }
            (PYRAMID, _) => {
                file.polyhedra.push_any_pyramid(&corners);
                self.polyhedra.push(cell);
            }
            _ => {
                file.polygons.push(&corners);
                self.polygons.push(cell);
            }
        }
        Ok(())
    }

    /// Gives each kind of element its values.
    pub(super) fn distribute(&self, name: &str, values: &AttributeValues, file: &mut MeshFile) {
        let cells: Vec<u32> = [&self.tetrahedra[..], &self.hexahedra, &self.polyhedra].concat();
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

fn corner(cell: u32, number: i64, n_vertices: usize) -> Result<u32, Problem> {
    match u32::try_from(number) {
        Ok(corner) if (corner as usize) < n_vertices => Ok(corner),
        _ => {
            let vertices = counted(n_vertices, ElementKind::Vertex);
            let problem = format!("cell {cell} names vertex {number}, but the file has {vertices}");
            Err((problem, "vertices are numbered from 0"))
        }
    }
}

/// A polyhedron: the number of its faces, and for each the number of its corners and these.
fn push_polyhedron(cell: u32, numbers: &[i64], file: &mut MeshFile) -> Result<(), Problem> {
    const FORM: &str = "a polyhedron is the number of its faces, then for each face the number of its corners and the corners";
    let n = file.positions.len();
    let Some((&n_faces, mut rest)) = numbers.split_first() else {
        return Err((
            format!("cell {cell} is a polyhedron without a number of faces"),
            FORM,
        ));
    };
    let (mut corners, mut lengths) = (Vec::with_capacity(rest.len()), Vec::new());
    while let Some((&length, after)) = rest.split_first() {
        let face = lengths.len();
        let split = usize::try_from(length)
            .ok()
            .and_then(|length| after.split_at_checked(length));
        let Some((own, after)) = split else {
            let problem = format!(
                "face {face} of cell {cell} is to have {length} corners, but {} numbers of the cell are left",
                after.len()
            );
            return Err((problem, FORM));
        };
        for &number in own {
            corners.push(corner(cell, number, n)?);
        }
        lengths.push(own.len());
        rest = after;
    }
    if i64::try_from(lengths.len()) != Ok(n_faces) {
        let problem = format!(
            "cell {cell} is to be a polyhedron with {n_faces} faces, but its numbers are those of {}",
            lengths.len()
        );
        return Err((problem, FORM));
    }
    let mut rest = &corners[..];
    let faces = lengths.iter().map(|&length| {
        let face;
        (face, rest) = rest.split_at(length);
        face
    });
    let faces: Vec<&[u32]> = faces.collect();
    if let Some(problem) = polyhedra::problem(faces.iter().copied()) {
        return Err((
            format!("cell {cell} is a polyhedron that {problem}"),
            polyhedra::LEAST,
        ));
    }
    file.polyhedra.push(faces);
    Ok(())
}
