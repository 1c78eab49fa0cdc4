//! Writing PLY: binary, little-endian.
//!
//! Positions, scalars and vectors are `double`, colours `uchar`, corners `int`, as every common program reads them.

use std::collections::BTreeSet;

use glam::DVec3;
use ply_rs_bw::ply::{
    Addable, DefaultElement, ElementDef, Encoding, Header, PropertyDef, PropertyType, ScalarType,
};
use ply_rs_bw::writer::Writer;

use super::coordinate_names;
use crate::element::ElementKind;
use crate::io::attributes::{AttributeValues, Attributes};
use crate::io::error::CannotWrite;
use crate::io::mesh_file::FaceList;

pub(crate) fn write(
    positions: &[DVec3],
    faces: &(impl FaceList + ?Sized),
    attributes: &Attributes,
) -> Result<Vec<u8>, CannotWrite> {
    let mut vertex = Element::new("vertex", positions.len());
    for axis in ["x", "y", "z"] {
        vertex.declare(axis, PropertyType::Scalar(ScalarType::Double))?;
    }
    let mut face = Element::new("face", faces.n_faces());
    // A byte for the number of corners is what the oldest programs expect.
    let longest = (0..faces.n_faces())
        .map(|index| faces.corners(index).len())
        .max()
        .unwrap_or(0);
    let length = if longest <= usize::from(u8::MAX) {
        ScalarType::UChar
    } else {
        ScalarType::Int
    };
    let is_byte = length == ScalarType::UChar;
    face.declare(
        "vertex_indices",
        PropertyType::List(length, ScalarType::Int),
    )?;
    for attribute in attributes {
        let element = if attribute.element == ElementKind::Vertex {
            &mut vertex
        } else {
            &mut face
        };
        element.declare_attribute(&attribute.name, &attribute.values)?;
    }
    if positions.len() > i32::MAX as usize {
        let problem = format!("a PLY file cannot number {} vertices", positions.len());
        return Err(CannotWrite {
            problem,
            help: "split the mesh",
        });
    }

    let mut header = Header::new();
    header.encoding = Encoding::BinaryLittleEndian;
    header.elements.add(vertex.definition);
    header.elements.add(face.definition);
    let mut bytes = Vec::new();
    Writer::<DefaultElement>::new()
        .write_header(&mut bytes, &header)
        .map_err(|cause| CannotWrite {
            problem: format!("the header cannot be written ({cause})"),
            help: "rename the attributes",
        })?;

    for (index, position) in positions.iter().enumerate() {
        put_vector(&mut bytes, *position);
        put_attributes(&mut bytes, attributes, ElementKind::Vertex, index);
    }
    for index in 0..faces.n_faces() {
        let corners = faces.corners(index);
        if is_byte {
            bytes.push(corners.len() as u8);
        } else {
            bytes.extend((corners.len() as i32).to_le_bytes());
        }
        for corner in corners {
            bytes.extend(corner.to_le_bytes());
        }
        put_attributes(&mut bytes, attributes, ElementKind::Face, index);
    }
    Ok(bytes)
}

fn put_vector(bytes: &mut Vec<u8>, vector: DVec3) {
    for coordinate in vector.to_array() {
        bytes.extend(coordinate.to_le_bytes());
    }
}

fn put_attributes(
    bytes: &mut Vec<u8>,
    attributes: &Attributes,
    element: ElementKind,
    index: usize,
) {
    for attribute in attributes
        .iter()
        .filter(|attribute| attribute.element == element)
    {
        match &attribute.values {
            AttributeValues::Scalar(values) => bytes.extend(values[index].to_le_bytes()),
            AttributeValues::Vector(values) => put_vector(bytes, values[index]),
            AttributeValues::Color(values) => bytes.extend(values[index]),
        }
    }
}

/// The declaration of an element under construction.
struct Element {
    definition: ElementDef,
    names: BTreeSet<String>,
}

impl Element {
    fn new(name: &str, count: usize) -> Self {
        let mut definition = ElementDef::new(name.to_owned());
        definition.count = count;
        Element {
            definition,
            names: BTreeSet::new(),
        }
    }

    fn declare(&mut self, name: &str, data_type: PropertyType) -> Result<(), CannotWrite> {
        let mut characters = name.chars();
        let is_valid = characters
            .next()
            .is_some_and(|first| first.is_ascii_alphabetic() || first == '_')
            && characters
                .all(|other| other.is_ascii_alphanumeric() || other == '_' || other == '-');
        if !is_valid {
            return Err(CannotWrite {
                problem: format!("`{name}` cannot be the name of a property of a PLY file"),
                help: "use the letters a to z and A to Z, digits, `_` and `-`, a letter first",
            });
        }
        if !self.names.insert(name.to_owned()) {
            return Err(CannotWrite {
                problem: format!("the {} has two properties `{name}`", self.definition.name),
                help: "rename the attribute",
            });
        }
        self.definition
            .properties
            .add(PropertyDef::new(name.to_owned(), data_type));
        Ok(())
    }

    fn declare_attribute(
        &mut self,
        name: &str,
        values: &AttributeValues,
    ) -> Result<(), CannotWrite> {
        let scalar = PropertyType::Scalar;
        match values {
            AttributeValues::Scalar(_) => self.declare(name, scalar(ScalarType::Double)),
            AttributeValues::Vector(_) => coordinate_names(name)
                .iter()
                .try_for_each(|name| self.declare(name, scalar(ScalarType::Double))),
            AttributeValues::Color(_) => ["red", "green", "blue"]
                .iter()
                .try_for_each(|name| self.declare(name, scalar(ScalarType::UChar))),
        }
    }
}
