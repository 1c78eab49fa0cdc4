//! Reading glTF.

use std::borrow::Cow;
use std::collections::BTreeMap;

use ::gltf::binary::Glb;
use ::gltf::json::mesh::{Primitive, Semantic};
use ::gltf::json::validation::Checked;
use ::gltf::json::{self, Root};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use glam::{DMat4, DQuat, DVec3};

use super::buffers::{Buffers, Contents, Numbers, entry};
use crate::element::ElementKind;
use crate::io::attributes::{AttributeValues, COLOR, NORMAL};
use crate::io::error::{Malformed, Place};
use crate::io::mesh_file::MeshFile;
use crate::io::text::{percent_decoded, shorten};

/// Opens a file that stands beside the one that is read, or says why not.
pub(crate) type Open<'a> = &'a dyn Fn(&str) -> Result<Vec<u8>, String>;

pub(super) const DAMAGED: &str = "the file is truncated or damaged";
/// Bytes before the JSON of a binary file.
const GLB_HEADER: usize = 20;

/// What `read` knows of a vertex attribute.
enum Column {
    Scalar(Vec<f64>),
    Vector(Vec<DVec3>),
    Color(Vec<[u8; 3]>),
}

impl Column {
    fn len(&self) -> usize {
        match self {
            Column::Scalar(values) => values.len(),
            Column::Vector(values) => values.len(),
            Column::Color(values) => values.len(),
        }
    }

    /// Fills up with what stands for no value.
    fn resize(&mut self, n: usize) {
        match self {
            Column::Scalar(values) => values.resize(n, f64::NAN),
            Column::Vector(values) => values.resize(n, DVec3::NAN),
            Column::Color(values) => values.resize(n, [255; 3]),
        }
    }
}

pub(super) struct Reader<'a> {
    pub(super) contents: Contents<'a>,
    pub(super) file: MeshFile,
    columns: BTreeMap<String, Column>,
}

pub(crate) fn read(bytes: &[u8], open: Open) -> Result<MeshFile, Malformed> {
    let is_binary = bytes.starts_with(b"glTF");
    let container = match is_binary {
        true => Some(container(bytes)?),
        false => None,
    };
    let text = container.as_ref().map_or(bytes, |glb| &glb.json);
    let error = |place, problem| Malformed {
        place,
        problem,
        help: "a glTF file is JSON, alone or after the bytes `glTF` and a header",
    };
    // an empty object takes three bytes in the file, and some hundred in memory
    let n_objects = text.iter().filter(|&&byte| byte == b'{').count();
    if n_objects.saturating_mul(16) > text.len() + (1 << 16) {
        let problem = format!("there are {n_objects} objects in {} bytes", text.len());
        return Err(error(Place::Line(1), problem));
    }
    let root: Root = json::deserialize::from_slice(text).map_err(|cause| {
        let place = match is_binary {
            true => Place::Byte(GLB_HEADER + offset(text, cause.line(), cause.column())),
            false => Place::Line(cause.line().max(1)),
        };
        let message = cause.to_string();
        let message = message.split(" at line ").next().unwrap_or_default();
        error(place, shorten_message(message))
    })?;
    let ignored = [
        "KHR_materials_",
        "KHR_texture_",
        "KHR_lights_",
        "KHR_mesh_quantization",
    ];
    let is_ignored = |name: &&String| !ignored.iter().any(|start| name.starts_with(start));
    if let Some(name) = root.extensions_required.iter().find(is_ignored) {
        let problem = format!("the file needs the extension `{}`", shorten(name));
        return Err(Malformed {
            place: Place::Line(1),
            problem,
            help: "save it without compression",
        });
    }
    let blob = container.as_ref().and_then(|glb| glb.bin.as_deref());
    let (buffers, n_bytes) = buffers(&root, blob, open)?;
    let mut reader = Reader {
        contents: Contents {
            root: &root,
            buffers,
            allowance: (bytes.len() + n_bytes).saturating_mul(32) + (1 << 16),
        },
        file: MeshFile::default(),
        columns: BTreeMap::new(),
    };
    reader.scene(&root)?;
    reader.finish()
}

/// The parts of a binary file.
fn container(bytes: &[u8]) -> Result<Glb<'_>, Malformed> {
    let error = |byte, problem| Malformed {
        place: Place::Byte(byte),
        problem,
        help: DAMAGED,
    };
    // the library takes any length
    let length = bytes.get(8..12).and_then(|length| length.try_into().ok());
    let length = length.map_or(0, u32::from_le_bytes) as usize;
    if length != bytes.len() || length < GLB_HEADER {
        let problem = format!("the length is to be {length} bytes, but is {}", bytes.len());
        return Err(error(bytes.len().min(8), problem));
    }
    Glb::from_slice(bytes).map_err(|cause| error(12, cause.to_string()))
}

fn offset(text: &[u8], line: usize, column: usize) -> usize {
    let lines = text.split_inclusive(|&byte| byte == b'\n');
    let before: usize = lines.take(line.saturating_sub(1)).map(<[u8]>::len).sum();
    before + column.saturating_sub(1)
}

/// A message of the parser, which may quote the file.
fn shorten_message(message: &str) -> String {
    let mut shown: String = message
        .chars()
        .filter(|character| !character.is_control())
        .take(80)
        .collect();
    if shown.len() < message.len() {
        shown.push('…');
    }
    shown
}

/// The contents of all buffers, and how many bytes were not in the file itself.
fn buffers<'a>(
    root: &'a Root,
    blob: Option<&'a [u8]>,
    open: Open,
) -> Result<(Buffers<'a>, usize), Malformed> {
    let mut n_bytes = 0;
    let mut buffers = Vec::with_capacity(root.buffers.len());
    for (index, buffer) in root.buffers.iter().enumerate() {
        let error = |problem, help| Malformed {
            place: Place::Entry("buffers", index),
            problem,
            help,
        };
        let mut data: Cow<[u8]> = match &buffer.uri {
            None if index == 0 && blob.is_some() => Cow::Borrowed(blob.unwrap_or_default()),
            None => {
                return Err(error(
                    "the buffer has no contents".to_owned(),
                    "it needs a `uri`, or the binary part of a .glb file",
                ));
            }
            Some(uri) if uri.starts_with("data:") => {
                let data = uri.split_once(";base64,").map(|(_, data)| data);
                let data = data.and_then(|data| BASE64_STANDARD.decode(data).ok());
                let problem = || "the `uri` of the buffer is no data in base 64".to_owned();
                Cow::Owned(data.ok_or_else(|| error(problem(), DAMAGED))?)
            }
            Some(uri) => {
                let name = percent_decoded(uri);
                let data = open(&name).map_err(|cause| {
                    let problem = format!("the buffer is the file `{}`: {cause}", shorten(&name));
                    error(problem, "save it as .glb, which is one file")
                })?;
                n_bytes += data.len();
                Cow::Owned(data)
            }
        };
        let length = usize::try_from(buffer.byte_length.0).unwrap_or(usize::MAX);
        if length > data.len() {
            let problem = format!(
                "the buffer is to have {length} bytes, but has {}",
                data.len()
            );
            return Err(error(problem, DAMAGED));
        }
        // binary files are filled up to a multiple of four
        match &mut data {
            Cow::Borrowed(data) => *data = &data[..length],
            Cow::Owned(data) => data.truncate(length),
        }
        buffers.push(data);
    }
    Ok((buffers, n_bytes))
}

impl Reader<'_> {
    /// All meshes, where the nodes place them.
    fn scene(&mut self, root: &Root) -> Result<(), Malformed> {
        let scene = root.scene.map_or(0, |scene| scene.value());
        if root.scenes.is_empty() {
            for mesh in 0..root.meshes.len() {
                self.mesh(root, mesh, DMat4::IDENTITY)?;
            }
            return Ok(());
        }
        let scene = entry(&root.scenes, "scenes", scene, Place::Line(1))?;
        let mut is_visited = vec![false; root.nodes.len()];
        // in the order of the file: the last one pushed comes first
        let mut open: Vec<(usize, DMat4)> = Vec::new();
        let place = Place::Entry("scenes", 0);
        open.extend(
            scene
                .nodes
                .iter()
                .rev()
                .map(|node| (node.value(), DMat4::IDENTITY)),
        );
        while let Some((index, above)) = open.pop() {
            let node = entry(&root.nodes, "nodes", index, place)?;
            let place = Place::Entry("nodes", index);
            if std::mem::replace(&mut is_visited[index], true) {
                return Err(Malformed {
                    place,
                    problem: "the node is reached twice".to_owned(),
                    help: "the nodes of a scene are a tree",
                });
            }
            let own = match &node.matrix {
                Some(matrix) => DMat4::from_cols_array(&matrix.map(f64::from)),
                None => DMat4::from_scale_rotation_translation(
                    node.scale.unwrap_or([1.0; 3]).map(f64::from).into(),
                    node.rotation.map_or(DQuat::IDENTITY, |rotation| {
                        DQuat::from_array(rotation.0.map(f64::from))
                    }),
                    node.translation.unwrap_or_default().map(f64::from).into(),
                ),
            };
            let placed = above * own;
            if let Some(mesh) = node.mesh {
                entry(&root.meshes, "meshes", mesh.value(), place)?;
                self.mesh(root, mesh.value(), placed)?;
            }
            let children = node.children.as_deref().unwrap_or_default();
            open.extend(children.iter().rev().map(|child| (child.value(), placed)));
        }
        Ok(())
    }

    fn mesh(&mut self, root: &Root, index: usize, placed: DMat4) -> Result<(), Malformed> {
        // primitives with the same attributes share their vertices
        let mut known: Vec<(&Primitive, usize, usize)> = Vec::new();
        for primitive in &entry(&root.meshes, "meshes", index, Place::Line(1))?.primitives {
            let place = Place::Entry("meshes", index);
            let is_same = |(other, ..): &&(&Primitive, _, _)| {
                let values = |primitive: &Primitive| -> Vec<usize> {
                    let values = primitive.attributes.values();
                    values.map(|accessor| accessor.value()).collect()
                };
                other.attributes.keys().eq(primitive.attributes.keys())
                    && values(other) == values(primitive)
            };
            // looked for among the last ones only, so that a file with many primitives is read in no time
            let same = known.iter().rev().take(4).find(is_same);
            let (first, count) = match same {
                Some(&(_, first, count)) => (first, count),
                None => {
                    let first = self.file.positions.len();
                    let count = self.vertices(primitive, place, placed)?;
                    known.push((primitive, first, count));
                    (first, count)
                }
            };
            self.elements(primitive, place, (first, count), placed)?;
        }
        Ok(())
    }

    /// The vertices of a primitive with all their values; gives their number.
    fn vertices(
        &mut self,
        primitive: &Primitive,
        place: Place,
        placed: DMat4,
    ) -> Result<usize, Malformed> {
        let error = |problem: String, help| Malformed {
            place,
            problem,
            help,
        };
        let key = Checked::Valid(Semantic::Positions);
        let Some(accessor) = primitive.attributes.get(&key) else {
            return Err(error(
                "a primitive has no `POSITION`".to_owned(),
                "vertices need positions",
            ));
        };
        let positions = self.contents.numbers(accessor.value(), place)?.fractions();
        if positions.n_components != 3 {
            let problem = format!("positions have {} coordinates", positions.n_components);
            return Err(error(problem, "`POSITION` is of type VEC3"));
        }
        let first = self.file.positions.len();
        let is_placed = placed != DMat4::IDENTITY;
        for (index, position) in positions.values.chunks_exact(3).enumerate() {
            let mut position = DVec3::from_slice(position);
            if is_placed {
                position = placed.transform_point3(position);
            }
            if !position.is_finite() {
                return Err(Malformed {
                    place: Place::Entry("accessors", accessor.value()),
                    problem: format!("the position of vertex {index} is not finite"),
                    help: "positions are real numbers",
                });
            }
            self.file.positions.push(position);
        }
        let n = self.file.positions.len();
        if u32::try_from(n).is_err() {
            let problem = format!("there are {n} vertices, more than 32 bits count");
            return Err(error(problem, "divide the mesh"));
        }
        for (semantic, accessor) in &primitive.attributes {
            let name = match semantic {
                Checked::Valid(Semantic::Normals) => NORMAL,
                Checked::Valid(Semantic::Colors(0)) => COLOR,
                Checked::Valid(Semantic::Extras(name)) => name,
                _ => continue,
            };
            let numbers = self.contents.numbers(accessor.value(), place)?.fractions();
            if numbers.values.len() != (n - first) * numbers.n_components {
                return Err(Malformed {
                    place: Place::Entry("accessors", accessor.value()),
                    problem: format!(
                        "there are {} values for {} positions",
                        numbers.values.len() / numbers.n_components,
                        n - first
                    ),
                    help: "each vertex has one",
                });
            }
            let is_color = matches!(semantic, Checked::Valid(Semantic::Colors(_)));
            let turning = (name == NORMAL && is_placed).then_some(placed);
            self.values(name, numbers, first, is_color, turning, place)?;
        }
        Ok(n - first)
    }

    /// Adds values of the vertices from `first` on.
    fn values(
        &mut self,
        name: &str,
        numbers: Numbers,
        first: usize,
        is_color: bool,
        turning: Option<DMat4>,
        place: Place,
    ) -> Result<(), Malformed> {
        let n_components = numbers.n_components;
        let rows = numbers.values.chunks_exact(n_components);
        let mut columns: Vec<(String, Column)> = Vec::new();
        if is_color && n_components >= 3 {
            // Saturates, and takes NaN to 0.
            let color =
                |row: &[f64]| [row[0], row[1], row[2]].map(|part| (part * 255.0).round() as u8);
            columns.push((name.to_owned(), Column::Color(rows.map(color).collect())));
        } else if n_components == 3 {
            let turning = turning.map(|placed| placed.inverse().transpose());
            let vector = |row: &[f64]| {
                let vector = DVec3::from_slice(row);
                turning.map_or(vector, |turning| {
                    turning.transform_vector3(vector).normalize_or_zero()
                })
            };
            columns.push((name.to_owned(), Column::Vector(rows.map(vector).collect())));
        } else {
            for component in 0..n_components {
                let name = match n_components {
                    1 => name.to_owned(),
                    _ => format!("{name}_{component}"),
                };
                let values = rows.clone().map(|row| row[component]).collect();
                columns.push((name, Column::Scalar(values)));
            }
        }
        for (name, new) in columns {
            let column = self.columns.entry(name.clone());
            let column = column.or_insert_with(|| match new {
                Column::Scalar(_) => Column::Scalar(Vec::new()),
                Column::Vector(_) => Column::Vector(Vec::new()),
                Column::Color(_) => Column::Color(Vec::new()),
            });
            let missing = first.saturating_sub(column.len());
            self.contents.take(missing.saturating_mul(24), place)?;
            column.resize(first);
            match (column, new) {
                (Column::Scalar(all), Column::Scalar(new)) => all.extend(new),
                (Column::Vector(all), Column::Vector(new)) => all.extend(new),
                (Column::Color(all), Column::Color(new)) => all.extend(new),
                _ => {
                    let problem = format!("`{}` has another type than before", shorten(&name));
                    return Err(Malformed {
                        place,
                        problem,
                        help: "values of one name have one type",
                    });
                }
            }
        }
        Ok(())
    }

    fn finish(mut self) -> Result<MeshFile, Malformed> {
        let n = self.file.positions.len();
        for (name, mut column) in self.columns {
            let missing = n.saturating_sub(column.len());
            self.contents
                .take(missing.saturating_mul(24), Place::Line(1))?;
            column.resize(n);
            let values = match column {
                Column::Scalar(values) => AttributeValues::Scalar(values),
                Column::Vector(values) => AttributeValues::Vector(values),
                Column::Color(values) => AttributeValues::Color(values),
            };
            self.file
                .attributes
                .push(ElementKind::Vertex, &name, values);
        }
        Ok(self.file)
    }
}
