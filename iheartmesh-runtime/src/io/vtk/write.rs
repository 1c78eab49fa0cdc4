//! Writing VTK.

use std::collections::HashSet;
use std::fmt::Write;

use glam::DVec3;

use super::{
    HEXAGONAL_PRISM, HEXAHEDRON, LINE, NO_COLOR, PENTAGONAL_PRISM, POLYGON, POLYHEDRON, PYRAMID,
    QUADRILATERAL, TETRAHEDRON, TRIANGLE, WEDGE, wedges,
};
use crate::element::ElementKind;
use crate::io::attributes::{Attribute, AttributeValues, Attributes, NORMAL};
use crate::io::error::CannotWrite;
use crate::io::mesh_file::{MeshFile, PolygonsIter};
use crate::io::polyhedra::{ordered_prism, ordered_pyramid};
use crate::io::text::percent_encoded;

pub(crate) fn write(file: &MeshFile) -> Result<Vec<u8>, CannotWrite> {
    let edges = file.edges.iter().map(|edge| (LINE, &edge[..]));
    let faces = file.polygons.iter().map(|face| match face.len() {
        3 => (TRIANGLE, face),
        4 => (QUADRILATERAL, face),
        _ => (POLYGON, face),
    });
    let tetrahedra = file.tetrahedra.iter().map(|cell| (TETRAHEDRON, &cell[..]));
    let hexahedra = file.hexahedra.iter().map(|cell| (HEXAHEDRON, &cell[..]));
    let polyhedra = polyhedra(file);
    let polyhedra = polyhedra
        .iter()
        .map(|(kind, numbers)| (*kind, &numbers[..]));
    let elements: Vec<(u8, &[u32])> = edges
        .chain(faces)
        .chain(tetrahedra)
        .chain(hexahedra)
        .chain(polyhedra)
        .collect();
    // where the elements of each kind stand among all
    let [n_edges, n_faces] = [file.edges.len(), file.polygons.len()];
    let range = |kind| match kind {
        ElementKind::Edge => 0..n_edges,
        ElementKind::Face => n_edges..n_edges + n_faces,
        _ => n_edges + n_faces..elements.len(),
    };

    let mut text =
        String::from("# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\n");
    // Writing into a `String` cannot fail.
    let _ = writeln!(text, "POINTS {} double", file.positions.len());
    for position in &file.positions {
        let _ = writeln!(text, "{} {} {}", position.x, position.y, position.z);
    }
    let length: usize = elements.iter().map(|(_, corners)| corners.len() + 1).sum();
    let _ = writeln!(text, "CELLS {} {length}", elements.len());
    for (_, corners) in &elements {
        let _ = write!(text, "{}", corners.len());
        for corner in *corners {
            let _ = write!(text, " {corner}");
        }
        text.push('\n');
    }
    let _ = writeln!(text, "CELL_TYPES {}", elements.len());
    for (kind, _) in &elements {
        let _ = writeln!(text, "{kind}");
    }
    for (title, is_at_vertices, count) in [
        ("POINT_DATA", true, file.positions.len()),
        ("CELL_DATA", false, elements.len()),
    ] {
        let mut is_first = true;
        let mut names = HashSet::new();
        for array in arrays(&file.attributes, is_at_vertices) {
            let name = &array[0].name;
            if !names.insert(name) {
                let at = if is_at_vertices {
                    "vertices"
                } else {
                    "other elements"
                };
                return Err(CannotWrite {
                    problem: format!(
                        "a VTK file cannot hold several attributes `{name}` of {at}, unless they are of different kinds of \
                         element and alike"
                    ),
                    help: "rename all but one of them",
                });
            }
            if name.is_empty() {
                return Err(CannotWrite {
                    problem: "values in a VTK file have a name, but that of an attribute is empty"
                        .to_owned(),
                    help: "give it one",
                });
            }
            if std::mem::replace(&mut is_first, false) {
                let _ = writeln!(text, "{title} {count}");
            }
            let place = |index: usize| {
                let mut members = array.iter();
                members.find_map(|attribute| {
                    let range = match is_at_vertices {
                        true => 0..count,
                        false => range(attribute.element),
                    };
                    let place = range.contains(&index).then(|| index - range.start)?;
                    Some((&attribute.values, place))
                })
            };
            values(&mut text, name, &array[0].values, count, place);
        }
    }
    Ok(text.into_bytes())
}

/// The attributes on vertices, or on all others, that are one array in the file: those on several kinds of element that have
/// the same name and the same kind of values, since VTK keeps one array of each name.
fn arrays(attributes: &Attributes, is_at_vertices: bool) -> Vec<Vec<&Attribute>> {
    let mut arrays: Vec<Vec<&Attribute>> = Vec::new();
    for attribute in attributes {
        if (attribute.element == ElementKind::Vertex) != is_at_vertices {
            continue;
        }
        let kind = |attribute: &Attribute| std::mem::discriminant(&attribute.values);
        let takes = |array: &&mut Vec<&Attribute>| {
            array[0].name == attribute.name
                && kind(array[0]) == kind(attribute)
                && array.iter().all(|other| other.element != attribute.element)
        };
        match arrays.iter_mut().find(takes) {
            Some(array) => array.push(attribute),
            None => arrays.push(vec![attribute]),
        }
    }
    arrays
}

/// The polyhedra as cells of VTK: prisms and pyramids as such if that says all of them.
fn polyhedra(file: &MeshFile) -> Vec<(u8, Vec<u32>)> {
    let mut cells: Vec<(u8, Vec<u32>)> = file.polyhedra.iter().map(polyhedron).collect();
    let wedges = cells.iter().filter(|(kind, _)| *kind == WEDGE);
    let wedges = wedges.filter_map(|(_, corners)| {
        let corners: [u32; 6] = corners.as_slice().try_into().ok()?;
        Some(corners.map(i64::from))
    });
    if wedges::are_reversed(wedges, &file.positions) {
        for ((kind, cell), faces) in cells.iter_mut().zip(&file.polyhedra) {
            if *kind == WEDGE {
                (*kind, *cell) = (POLYHEDRON, stream(faces));
            }
        }
    }
    cells
}

fn polyhedron(faces: PolygonsIter<'_>) -> (u8, Vec<u32>) {
    let prism = ordered_prism(faces.clone()).and_then(|corners| {
        let kind = match corners.len() {
            6 => WEDGE,
            10 => PENTAGONAL_PRISM,
            12 => HEXAGONAL_PRISM,
            _ => return None,
        };
        Some((kind, corners))
    });
    let pyramid = || {
        let corners = ordered_pyramid(faces.clone()).filter(|corners| corners.len() == 5);
        corners.map(|corners| (PYRAMID, corners))
    };
    let simple = prism.or_else(pyramid);
    simple.unwrap_or_else(|| (POLYHEDRON, stream(faces)))
}

/// The number of faces, and for each the number of its corners and these.
fn stream(faces: PolygonsIter<'_>) -> Vec<u32> {
    let mut stream = vec![faces.len() as u32];
    for face in faces {
        stream.push(face.len() as u32);
        stream.extend_from_slice(face);
    }
    stream
}

/// One array of values as these are, with the value that stands in `place(k)` for element k, or `nan` where there is none.
fn values<'a>(
    text: &mut String,
    name: &str,
    kind: &AttributeValues,
    count: usize,
    place: impl Fn(usize) -> Option<(&'a AttributeValues, usize)>,
) {
    let word = percent_encoded(name);
    let _ = match kind {
        AttributeValues::Scalar(_) => {
            writeln!(text, "SCALARS {word} double 1\nLOOKUP_TABLE default")
        }
        AttributeValues::Vector(_) if name == NORMAL => {
            writeln!(text, "NORMALS {word} double")
        }
        AttributeValues::Vector(_) => writeln!(text, "VECTORS {word} double"),
        AttributeValues::Color(_) => writeln!(text, "COLOR_SCALARS {word} 3"),
    };
    for k in 0..count {
        let (mut scalar, mut vector, mut color) = (f64::NAN, DVec3::NAN, NO_COLOR);
        match place(k) {
            Some((AttributeValues::Scalar(values), place)) => scalar = values[place],
            Some((AttributeValues::Vector(values), place)) => vector = values[place],
            Some((AttributeValues::Color(values), place)) => color = values[place],
            None => {}
        }
        let _ = match kind {
            AttributeValues::Scalar(_) => writeln!(text, "{}", number(scalar)),
            AttributeValues::Vector(_) => {
                let [x, y, z] = vector.to_array().map(number);
                writeln!(text, "{x} {y} {z}")
            }
            AttributeValues::Color(_) => {
                let [r, g, b] = color.map(|part| f64::from(part) / 255.0);
                writeln!(text, "{r} {g} {b}")
            }
        };
    }
}

/// A number as VTK reads it: `nan` and `inf` in small letters.
fn number(value: f64) -> String {
    match value.is_nan() {
        true => "nan".to_owned(),
        false => value.to_string(),
    }
}
