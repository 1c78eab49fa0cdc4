//! Writing VTK.

use std::fmt::Write;

use super::{HEXAHEDRON, LINE, NO_COLOR, POLYGON, QUADRILATERAL, TETRAHEDRON, TRIANGLE};
use crate::element::ElementKind;
use crate::io::attributes::{AttributeValues, NORMAL};
use crate::io::error::CannotWrite;
use crate::io::mesh_file::MeshFile;

pub(crate) fn write(file: &MeshFile) -> Result<Vec<u8>, CannotWrite> {
    let edges = file.edges.iter().map(|edge| (LINE, &edge[..]));
    let faces = file.polygons.iter().map(|face| match face.len() {
        3 => (TRIANGLE, face),
        4 => (QUADRILATERAL, face),
        _ => (POLYGON, face),
    });
    let tetrahedra = file.tetrahedra.iter().map(|cell| (TETRAHEDRON, &cell[..]));
    let hexahedra = file.hexahedra.iter().map(|cell| (HEXAHEDRON, &cell[..]));
    let elements: Vec<(u8, &[u32])> = edges
        .chain(faces)
        .chain(tetrahedra)
        .chain(hexahedra)
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
        for attribute in &file.attributes {
            if (attribute.element == ElementKind::Vertex) != is_at_vertices {
                continue;
            }
            let name = &attribute.name;
            if name.is_empty() || name.contains(|c: char| c.is_whitespace() || c.is_control()) {
                return Err(CannotWrite {
                    problem: format!("`{name}` cannot be the name of values in a VTK file"),
                    help: "use a name without blanks",
                });
            }
            if std::mem::replace(&mut is_first, false) {
                let _ = writeln!(text, "{title} {count}");
            }
            let range = match is_at_vertices {
                true => 0..count,
                false => range(attribute.element),
            };
            let place = |index: usize| range.contains(&index).then(|| index - range.start);
            values(&mut text, name, &attribute.values, count, place);
        }
    }
    Ok(text.into_bytes())
}

/// One array, with the value at `place(k)` for element k, or `nan` where there is none.
fn values(
    text: &mut String,
    name: &str,
    values: &AttributeValues,
    count: usize,
    place: impl Fn(usize) -> Option<usize>,
) {
    let _ = match values {
        AttributeValues::Scalar(_) => {
            writeln!(text, "SCALARS {name} double 1\nLOOKUP_TABLE default")
        }
        AttributeValues::Vector(_) if name == NORMAL => {
            writeln!(text, "NORMALS {name} double")
        }
        AttributeValues::Vector(_) => writeln!(text, "VECTORS {name} double"),
        AttributeValues::Color(_) => writeln!(text, "COLOR_SCALARS {name} 3"),
    };
    for k in 0..count {
        let _ = match values {
            AttributeValues::Scalar(values) => {
                let value = place(k).map_or(f64::NAN, |place| values[place]);
                writeln!(text, "{}", number(value))
            }
            AttributeValues::Vector(values) => {
                let value = place(k).map_or(glam::DVec3::NAN, |place| values[place]);
                let [x, y, z] = value.to_array().map(number);
                writeln!(text, "{x} {y} {z}")
            }
            AttributeValues::Color(values) => {
                let value = place(k).map_or(NO_COLOR, |place| values[place]);
                let [r, g, b] = value.map(|part| f64::from(part) / 255.0);
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
