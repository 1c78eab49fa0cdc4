//! Writing glTF.

use ::gltf::binary::{Glb, Header};
use ::gltf::json::accessor::{ComponentType, GenericComponentType, Type};
use ::gltf::json::buffer::{Target, View};
use ::gltf::json::mesh::{Mesh, Mode, Primitive, Semantic};
use ::gltf::json::validation::Checked;
use ::gltf::json::{Accessor, Asset, Buffer, Index, Node, Root, Scene, Value};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use glam::DVec3;

use crate::element::ElementKind;
use crate::io::attributes::{AttributeValues, NORMAL};
use crate::io::error::CannotWrite;
use crate::io::mesh_file::MeshFile;

/// The data of a file, piece by piece.
#[derive(Default)]
struct Data {
    bytes: Vec<u8>,
    views: Vec<View>,
    accessors: Vec<Accessor>,
}

impl Data {
    /// Adds what has been appended to `bytes` since `start` as an accessor.
    fn accessor(
        &mut self,
        start: usize,
        count: usize,
        component: ComponentType,
        kind: Type,
        target: Target,
    ) -> &mut Accessor {
        let length = self.bytes.len() - start;
        // views begin at multiples of four
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let view = Index::push(
            &mut self.views,
            View {
                buffer: Index::new(0),
                byte_length: length.into(),
                byte_offset: Some(start.into()),
                byte_stride: None,
                name: None,
                target: Some(Checked::Valid(target)),
                extensions: None,
                extras: None,
            },
        );
        let index = Index::push(
            &mut self.accessors,
            Accessor {
                buffer_view: Some(view),
                byte_offset: None,
                count: count.into(),
                component_type: Checked::Valid(GenericComponentType(component)),
                extensions: None,
                extras: None,
                type_: Checked::Valid(kind),
                min: None,
                max: None,
                name: None,
                normalized: component == ComponentType::U8,
                sparse: None,
            },
        );
        &mut self.accessors[index.value()]
    }

    fn last(&self) -> Index<Accessor> {
        Index::new(self.accessors.len() as u32 - 1)
    }

    fn vectors(&mut self, vectors: &[DVec3]) -> &mut Accessor {
        let start = self.bytes.len();
        for vector in vectors {
            for part in vector.as_vec3().to_array() {
                self.bytes.extend(part.to_le_bytes());
            }
        }
        let (count, kind) = (vectors.len(), Type::Vec3);
        self.accessor(start, count, ComponentType::F32, kind, Target::ArrayBuffer)
    }

    fn scalars(&mut self, scalars: &[f64]) {
        let start = self.bytes.len();
        for scalar in scalars {
            self.bytes.extend((*scalar as f32).to_le_bytes());
        }
        let (count, kind) = (scalars.len(), Type::Scalar);
        self.accessor(start, count, ComponentType::F32, kind, Target::ArrayBuffer);
    }

    fn indices(&mut self, indices: impl Iterator<Item = u32>) -> Index<Accessor> {
        let start = self.bytes.len();
        self.bytes.extend(indices.flat_map(u32::to_le_bytes));
        let count = (self.bytes.len() - start) / 4;
        let target = Target::ElementArrayBuffer;
        self.accessor(start, count, ComponentType::U32, Type::Scalar, target);
        self.last()
    }
}

fn cannot<T>(problem: String, help: &'static str) -> Result<T, CannotWrite> {
    Err(CannotWrite { problem, help })
}

/// Whether a number is one in single precision too.
fn is_single(value: f64) -> bool {
    (value as f32).is_finite()
}

pub(crate) fn write(file: &MeshFile, is_binary: bool) -> Result<Vec<u8>, CannotWrite> {
    if file.n_cells() > 0 {
        return cannot(
            "a glTF file cannot hold cells".to_owned(),
            "write a .mesh, .msh or .vtk file",
        );
    }
    let Some(triangles) = file.polygons.as_triangles() else {
        return cannot(
            "a glTF file cannot hold faces that are no triangles".to_owned(),
            "divide them into triangles, or write a .ply file",
        );
    };
    let is_large = |position: &DVec3| !position.to_array().into_iter().all(is_single);
    if let Some(vertex) = file.positions.iter().position(is_large) {
        let problem = format!("the position of vertex {vertex} is beyond single precision");
        return cannot(problem, "scale the positions, or write a .ply file");
    }
    let mut data = Data::default();
    let mut root = Root {
        asset: Asset {
            generator: Some("iheartmesh".to_owned()),
            ..Asset::default()
        },
        ..Root::default()
    };
    if !file.positions.is_empty() {
        let mesh = mesh(file, triangles, &mut data)?;
        root.meshes.push(mesh);
        let node = Node {
            mesh: Some(Index::new(0)),
            ..Node::default()
        };
        root.nodes.push(node);
        root.scenes.push(Scene {
            extensions: None,
            extras: None,
            name: None,
            nodes: vec![Index::new(0)],
        });
        root.scene = Some(Index::new(0));
        root.buffers.push(Buffer {
            byte_length: data.bytes.len().into(),
            name: None,
            uri: (!is_binary).then(|| {
                let data = BASE64_STANDARD.encode(&data.bytes);
                format!("data:application/octet-stream;base64,{data}")
            }),
            extensions: None,
            extras: None,
        });
    } else if let Some(attribute) = file.attributes.iter().next() {
        check_element(attribute.element, &attribute.name)?;
    }
    (root.buffer_views, root.accessors) = (data.views, data.accessors);
    let text = root.to_vec().map_err(|cause| CannotWrite {
        problem: format!("the contents cannot be written as JSON: {cause}"),
        help: "write a .ply file",
    })?;
    if !is_binary {
        return Ok(text);
    }
    // lengths have 32 bits
    if u32::try_from(text.len() + data.bytes.len() + 64).is_err() {
        let problem = format!("a .glb file cannot hold {} bytes", data.bytes.len());
        return cannot(problem, "write a .ply file");
    }
    let container = Glb {
        // its length is computed anew
        header: Header {
            magic: *b"glTF",
            version: 2,
            length: 0,
        },
        json: text.into(),
        bin: (!data.bytes.is_empty()).then(|| data.bytes.into()),
    };
    container.to_vec().map_err(|cause| CannotWrite {
        problem: format!("the file cannot be made: {cause}"),
        help: "write a .ply file",
    })
}

fn check_element(element: ElementKind, name: &str) -> Result<(), CannotWrite> {
    match element {
        ElementKind::Vertex => Ok(()),
        _ => cannot(
            format!("a glTF file cannot hold the {element} attribute `{name}`"),
            "write a .ply or .vtk file",
        ),
    }
}

/// A mesh of all vertices with their values, of triangles and of edges.
fn mesh(file: &MeshFile, triangles: &[[u32; 3]], data: &mut Data) -> Result<Mesh, CannotWrite> {
    let mut attributes = std::collections::BTreeMap::new();
    let least = file.positions.iter().copied().reduce(DVec3::min);
    let greatest = file.positions.iter().copied().reduce(DVec3::max);
    let bound = |corner: Option<DVec3>| {
        let corner = corner.unwrap_or_default().as_vec3().to_array();
        Some(Value::from(corner.to_vec()))
    };
    let accessor = data.vectors(&file.positions);
    (accessor.min, accessor.max) = (bound(least), bound(greatest));
    attributes.insert(Checked::Valid(Semantic::Positions), data.last());
    for attribute in &file.attributes {
        let name = &attribute.name;
        check_element(attribute.element, name)?;
        let semantic = match &attribute.values {
            AttributeValues::Color(_) => Semantic::Colors(0),
            AttributeValues::Vector(_) if name == NORMAL => Semantic::Normals,
            _ => Semantic::Extras(name.clone()),
        };
        let is_finite = match &attribute.values {
            AttributeValues::Scalar(values) => values.iter().copied().all(is_single),
            AttributeValues::Vector(values) => !values
                .iter()
                .any(|value| !value.to_array().into_iter().all(is_single)),
            AttributeValues::Color(_) => true,
        };
        if !is_finite {
            let problem = format!("a value of `{name}` is not finite in single precision");
            return cannot(problem, "write a .ply file");
        }
        match &attribute.values {
            AttributeValues::Scalar(values) => data.scalars(values),
            AttributeValues::Vector(values) => drop(data.vectors(values)),
            AttributeValues::Color(values) => {
                let start = data.bytes.len();
                // with an opacity, so that each takes four bytes
                let colors = values
                    .iter()
                    .flat_map(|&[red, green, blue]| [red, green, blue, 255]);
                data.bytes.extend(colors);
                let (count, target) = (values.len(), Target::ArrayBuffer);
                data.accessor(start, count, ComponentType::U8, Type::Vec4, target);
            }
        }
        if attributes
            .insert(Checked::Valid(semantic), data.last())
            .is_some()
        {
            let problem = format!("there are two attributes `{name}`");
            return cannot(problem, "rename one of them");
        }
    }
    let primitive = |mode, indices| Primitive {
        attributes: attributes.clone(),
        extensions: None,
        extras: None,
        indices,
        material: None,
        mode: Checked::Valid(mode),
        targets: None,
    };
    let mut primitives = Vec::new();
    if !triangles.is_empty() {
        let indices = data.indices(triangles.iter().flatten().copied());
        primitives.push(primitive(Mode::Triangles, Some(indices)));
    }
    if !file.edges.is_empty() {
        let indices = data.indices(file.edges.iter().flatten().copied());
        primitives.push(primitive(Mode::Lines, Some(indices)));
    }
    if primitives.is_empty() {
        primitives.push(primitive(Mode::Points, None));
    }
    Ok(Mesh {
        extensions: None,
        extras: None,
        name: None,
        primitives,
        weights: None,
    })
}
