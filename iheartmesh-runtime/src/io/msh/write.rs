//! Writing Gmsh files of version 2.2.

use std::fmt::Write;

use super::{HEXAHEDRON, LINE, PRISM, PYRAMID, QUADRILATERAL, TETRAHEDRON, TRIANGLE};
use crate::element::ElementKind;
use crate::io::attributes::AttributeValues;
use crate::io::error::CannotWrite;
use crate::io::mesh_file::MeshFile;
use crate::io::polyhedra::{self, Simple};

pub(crate) fn write(file: &MeshFile) -> Result<Vec<u8>, CannotWrite> {
    if let Some(face) = file
        .polygons
        .iter()
        .find(|face| !matches!(face.len(), 3 | 4))
    {
        let problem = format!("a Gmsh file cannot hold a face with {} corners", face.len());
        return Err(CannotWrite {
            problem,
            help: "write a .ply or .vtk file",
        });
    }
    let edges = file.edges.iter().map(|edge| (LINE, &edge[..]));
    let faces = file.polygons.iter().map(|face| match face.len() {
        3 => (TRIANGLE, face),
        _ => (QUADRILATERAL, face),
    });
    let tetrahedra = file.tetrahedra.iter().map(|cell| (TETRAHEDRON, &cell[..]));
    let hexahedra = file.hexahedra.iter().map(|cell| (HEXAHEDRON, &cell[..]));
    let simple = polyhedra::simple(&file.polyhedra, "Gmsh")?;
    let simple = simple.iter().map(|polyhedron| match polyhedron {
        Simple::Prism(corners) => (PRISM, &corners[..]),
        Simple::Pyramid(corners) => (PYRAMID, &corners[..]),
    });
    let [n_edges, n_faces] = [file.edges.len(), file.polygons.len()];
    let n_elements = n_edges + n_faces + file.n_cells();

    let mut text = String::from("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
    // Writing into a `String` cannot fail.
    let _ = writeln!(text, "$Nodes\n{}", file.positions.len());
    for (index, position) in file.positions.iter().enumerate() {
        let _ = writeln!(
            text,
            "{} {} {} {}",
            index + 1,
            position.x,
            position.y,
            position.z
        );
    }
    let _ = writeln!(text, "$EndNodes\n$Elements\n{n_elements}");
    let cells = tetrahedra.chain(hexahedra).chain(simple);
    let elements = edges.chain(faces).chain(cells);
    for (index, (kind, corners)) in elements.enumerate() {
        // one physical and one elementary tag, as Gmsh expects them
        let _ = write!(text, "{} {kind} 2 0 1", index + 1);
        for corner in corners {
            let _ = write!(text, " {}", u64::from(*corner) + 1);
        }
        text.push('\n');
    }
    text.push_str("$EndElements\n");
    for attribute in &file.attributes {
        let name = &attribute.name;
        if name.contains(|c: char| c == '"' || c.is_control()) {
            return Err(CannotWrite {
                problem: format!("`{name}` cannot be the name of values in a Gmsh file"),
                help: "use a name without quotes",
            });
        }
        let (section, first) = match attribute.element {
            ElementKind::Vertex => ("NodeData", 1),
            ElementKind::Edge => ("ElementData", 1),
            ElementKind::Face => ("ElementData", 1 + n_edges),
            ElementKind::Cell => ("ElementData", 1 + n_edges + n_faces),
        };
        let n_components = match attribute.values {
            AttributeValues::Scalar(_) => 1,
            AttributeValues::Vector(_) => 3,
            AttributeValues::Color(_) => {
                return Err(CannotWrite {
                    problem: format!(
                        "a Gmsh file cannot hold colours of each {}",
                        attribute.element
                    ),
                    help: "write a .ply or .vtk file",
                });
            }
        };
        let count = attribute.values.len();
        // one name, one real tag (the time), three integer tags
        let _ = writeln!(
            text,
            "${section}\n1\n\"{name}\"\n1\n0\n3\n0\n{n_components}\n{count}"
        );
        match &attribute.values {
            AttributeValues::Scalar(values) => {
                for (index, value) in values.iter().enumerate() {
                    let _ = writeln!(text, "{} {value}", first + index);
                }
            }
            AttributeValues::Vector(values) => {
                for (index, value) in values.iter().enumerate() {
                    let _ = writeln!(
                        text,
                        "{} {} {} {}",
                        first + index,
                        value.x,
                        value.y,
                        value.z
                    );
                }
            }
            AttributeValues::Color(_) => {}
        }
        let _ = writeln!(text, "$End{section}");
    }
    Ok(text.into_bytes())
}
