//! Reading PLY.

use std::collections::BTreeMap;

use glam::DVec3;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyDef,
    PropertyType, ScalarType,
};
use smallvec::SmallVec;

use super::coordinate_names;
use crate::element::ElementKind;
use crate::io::attributes::{AttributeValues, COLOR, NORMAL};
use crate::io::error::{Malformed, Place, counted};
use crate::io::mesh_file::MeshFile;
use crate::io::text::{Line, shorten};

/// The names of the list of corners in use.
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// One element as it is parsed: its scalars and its corners in the order of the file.
#[derive(Default)]
struct Row {
    scalars: SmallVec<[f64; 12]>,
    corners: SmallVec<[i64; 4]>,
    /// Whether the corners are no whole numbers.
    is_fractional: bool,
}

impl PropertyAccess for Row {
    fn new() -> Self {
        Row::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        match property {
            Property::Char(value) => self.scalars.push(value.into()),
            Property::UChar(value) => self.scalars.push(value.into()),
            Property::Short(value) => self.scalars.push(value.into()),
            Property::UShort(value) => self.scalars.push(value.into()),
            Property::Int(value) => self.scalars.push(value.into()),
            Property::UInt(value) => self.scalars.push(value.into()),
            Property::Float(value) => self.scalars.push(value.into()),
            Property::Double(value) => self.scalars.push(value),
            _ if !CORNERS.contains(&name) => return PropertyAccessResult::Ignored,
            Property::ListChar(values) => self.corners.extend(values.into_iter().map(i64::from)),
            Property::ListUChar(values) => self.corners.extend(values.into_iter().map(i64::from)),
            Property::ListShort(values) => self.corners.extend(values.into_iter().map(i64::from)),
            Property::ListUShort(values) => self.corners.extend(values.into_iter().map(i64::from)),
            Property::ListInt(values) => self.corners.extend(values.into_iter().map(i64::from)),
            Property::ListUInt(values) => self.corners.extend(values.into_iter().map(i64::from)),
            Property::ListFloat(_) | Property::ListDouble(_) => self.is_fractional = true,
        }
        PropertyAccessResult::Set
    }
}

/// What follows the header, read from its front.
struct Payload<'a> {
    rest: &'a [u8],
    encoding: Encoding,
    /// Line (in text) or byte at which `rest` starts.
    position: usize,
}

/// All elements of one name: a column for each scalar property.
struct Table {
    names: Vec<String>,
    columns: BTreeMap<String, Vec<f64>>,
    color_names: Vec<String>,
}

pub(crate) fn read(bytes: &[u8]) -> Result<MeshFile, Malformed> {
    let (header, mut payload) = header(bytes)?;
    let mut file = MeshFile::default();
    // Faces may stand before the vertices that they name: the largest corner is compared at the end.
    let mut largest = None;
    for element in header.elements.values() {
        match element.name.as_str() {
            "vertex" => {
                let mut table = payload.table(element, |_, _| Ok(()))?;
                file.positions = positions(&mut table, element, &payload)?;
                table.into_attributes(ElementKind::Vertex, &mut file);
            }
            "face" => {
                let mut corners: Vec<u32> = Vec::new();
                let table = payload.table(element, |row, place| {
                    if row.is_fractional {
                        let problem =
                            "the corners of the faces are not of an integer type".to_owned();
                        return Err(Malformed {
                            place,
                            problem,
                            help: CORNER_HELP,
                        });
                    }
                    corners.clear();
                    for &corner in &row.corners {
                        let vertex = u32::try_from(corner).map_err(|_| Malformed {
                            place,
                            problem: format!("the face names vertex {corner}"),
                            help: CORNER_HELP,
                        })?;
                        if largest.is_none_or(|(other, _)| vertex > other) {
                            largest = Some((vertex, place));
                        }
                        corners.push(vertex);
                    }
                    file.polygons.push(&corners);
                    Ok(())
                })?;
                table.into_attributes(ElementKind::Face, &mut file);
            }
            "tristrips" => {
                let problem = "the faces are given as triangle strips".to_owned();
                return Err(Malformed {
                    place: payload.place(),
                    problem,
                    help: "save the file with plain faces",
                });
            }
            _ => drop(payload.table(element, |_, _| Ok(()))?),
        }
    }
    match largest {
        Some((vertex, place)) if vertex as usize >= file.positions.len() => {
            let problem = format!(
                "the face names vertex {vertex}, but the file has {}",
                counted(file.positions.len(), ElementKind::Vertex)
            );
            Err(Malformed {
                place,
                problem,
                help: CORNER_HELP,
            })
        }
        _ => Ok(file),
    }
}

const CORNER_HELP: &str = "vertices are numbered from 0";

/// Splits off the header and has the library parse it.
fn header(bytes: &[u8]) -> Result<(Header, Payload<'_>), Malformed> {
    const HELP: &str = "a PLY file begins with the lines `ply` and `format …` and a header that ends with `end_header`";
    let (mut size, mut n_lines, mut n_declarations, mut has_end) = (0, 0, 0, false);
    for line in bytes.split_inclusive(|&byte| byte == b'\n') {
        size += line.len();
        n_lines += 1;
        n_declarations +=
            usize::from(line.starts_with(b"element") || line.starts_with(b"property"));
        has_end = line.trim_ascii() == b"end_header";
        // A file of another kind must not be taken for an endless header.
        if has_end || (n_lines == 1 && line.trim_ascii() != b"ply") {
            break;
        }
    }
    let error = |line: usize, problem: String| Malformed {
        place: Place::Line(line),
        problem,
        help: HELP,
    };
    if !has_end {
        return Err(error(
            n_lines.max(1),
            "the header is not complete".to_owned(),
        ));
    }
    // Comments may be in any encoding.
    let text = String::from_utf8_lossy(&bytes[..size]);
    let header = Parser::<Row>::new()
        .read_header(&mut Reader::new(text.as_bytes()))
        .map_err(|cause| {
            let line = cause.line().unwrap_or(n_lines);
            let text = text.lines().nth(line.saturating_sub(1)).unwrap_or_default();
            error(
                line,
                format!("the header line `{}` cannot be read", shorten(text)),
            )
        })?;
    let n_kept: usize = header
        .elements
        .values()
        .map(|element| 1 + element.properties.len())
        .sum();
    if n_kept != n_declarations {
        return Err(error(
            n_lines,
            "the header declares an element or a property twice".to_owned(),
        ));
    }
    if !header.elements.contains_key("vertex") {
        return Err(Malformed {
            place: Place::Line(n_lines),
            problem: "the header declares no element `vertex`".to_owned(),
            help: "a mesh without vertices has `element vertex 0`",
        });
    }
    let position = if header.encoding == Encoding::Ascii {
        n_lines + 1
    } else {
        size
    };
    let encoding = header.encoding;
    Ok((
        header,
        Payload {
            rest: &bytes[size..],
            encoding,
            position,
        },
    ))
}

/// Least number of bytes that one element takes.
fn least_size(element: &ElementDef, encoding: Encoding) -> usize {
    let size = |scalar: &ScalarType| match scalar {
        _ if encoding == Encoding::Ascii => 2,
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    };
    let property_size = |property: &PropertyDef| match &property.data_type {
        PropertyType::Scalar(scalar) => size(scalar),
        PropertyType::List(length, _) => size(length),
    };
    element.properties.values().map(property_size).sum()
}

impl Payload<'_> {
    fn place(&self) -> Place {
        match self.encoding {
            Encoding::Ascii => Place::Line(self.position),
            _ => Place::Byte(self.position),
        }
    }

    fn truncated(&self, element: &ElementDef, index: usize) -> Malformed {
        let problem = format!(
            "the file ends before element {index} of {} `{}`",
            element.count, element.name
        );
        Malformed {
            place: self.place(),
            problem,
            help: "the file is truncated or its header wrong",
        }
    }

    /// Reads all elements of one name; `visit` sees each with its place.
    fn table(
        &mut self,
        element: &ElementDef,
        mut visit: impl FnMut(&Row, Place) -> Result<(), Malformed>,
    ) -> Result<Table, Malformed> {
        let scalars: Vec<(&String, &ScalarType)> = element
            .properties
            .values()
            .filter_map(|property| match &property.data_type {
                PropertyType::Scalar(scalar) => Some((&property.name, scalar)),
                PropertyType::List(..) => None,
            })
            .collect();
        let mut columns = vec![Vec::new(); scalars.len()];
        // Elements without properties take no space: there is nothing to read, however many there are. The last line of
        // a text file may lack its end.
        if !element.properties.is_empty() {
            let least_size = element
                .count
                .checked_mul(least_size(element, self.encoding));
            if least_size.is_none_or(|size| size > self.rest.len() + 1) {
                let problem = format!(
                    "the header promises {} `{}`, more than the {} bytes after it can hold",
                    element.count,
                    element.name,
                    self.rest.len()
                );
                return Err(Malformed {
                    place: self.place(),
                    problem,
                    help: "the file is truncated or its header wrong",
                });
            }
            for column in &mut columns {
                column.reserve_exact(element.count);
            }
            for index in 0..element.count {
                let (row, place) = match self.encoding {
                    Encoding::Ascii => self.text_row(element, index)?,
                    _ => self.binary_row(element, index)?,
                };
                for (column, &value) in columns.iter_mut().zip(&row.scalars) {
                    column.push(value);
                }
                visit(&row, place)?;
            }
        }
        Ok(Table {
            names: scalars.iter().map(|(name, _)| (*name).clone()).collect(),
            color_names: scalars
                .iter()
                .filter(|(_, scalar)| **scalar == ScalarType::UChar)
                .map(|(name, _)| (*name).clone())
                .collect(),
            columns: scalars
                .iter()
                .map(|(name, _)| (*name).clone())
                .zip(columns)
                .collect(),
        })
    }

    fn binary_row(
        &mut self,
        element: &ElementDef,
        index: usize,
    ) -> Result<(Row, Place), Malformed> {
        let place = self.place();
        let before = self.rest.len();
        let parser = Parser::<Row>::new();
        let row = match self.encoding {
            Encoding::BinaryBigEndian => parser.read_big_endian_element(&mut self.rest, element),
            _ => parser.read_little_endian_element(&mut self.rest, element),
        };
        let row = row.map_err(|cause| match cause.kind() {
            std::io::ErrorKind::UnexpectedEof => self.truncated(element, index),
            _ => {
                let problem = format!(
                    "a list of element {index} of `{}` has no valid length",
                    element.name
                );
                Malformed {
                    place,
                    problem,
                    help: "the file is damaged or its header wrong",
                }
            }
        })?;
        self.position += before - self.rest.len();
        Ok((row, place))
    }

    fn text_row(&mut self, element: &ElementDef, index: usize) -> Result<(Row, Place), Malformed> {
        let mut line = loop {
            if self.rest.is_empty() {
                return Err(self.truncated(element, index));
            }
            let end = self
                .rest
                .iter()
                .position(|&byte| byte == b'\n')
                .map_or(self.rest.len(), |end| end + 1);
            let (text, rest) = self.rest.split_at(end);
            self.rest = rest;
            self.position += 1;
            let number = self.position - 1;
            let text = std::str::from_utf8(text).map_err(|_| Malformed {
                place: Place::Line(number),
                problem: format!("element {index} of `{}` is no text", element.name),
                help: "the header says that the file is; it may be damaged",
            })?;
            if !text.trim_ascii().is_empty() {
                break Line::new(number, text);
            }
        };
        let mut row = Row::default();
        for property in element.properties.values() {
            let name = property.name.as_str();
            match &property.data_type {
                PropertyType::Scalar(_) => {
                    let value = line.number(name)?;
                    row.scalars.push(value);
                }
                PropertyType::List(..) => {
                    let length = line.integer("length of the list")?;
                    if usize::try_from(length).map_or(true, |length| length > line.remaining()) {
                        let problem = format!(
                            "the list is to have {length} items, but {} follow",
                            line.remaining()
                        );
                        return Err(
                            line.error(problem, "write the length of the list, then each item")
                        );
                    }
                    for _ in 0..length {
                        if CORNERS.contains(&name) {
                            row.corners.push(line.integer("corner")?);
                        } else {
                            line.number(name)?;
                        }
                    }
                }
            }
        }
        Ok((row, line.place()))
    }
}

fn positions(
    table: &mut Table,
    element: &ElementDef,
    payload: &Payload,
) -> Result<Vec<DVec3>, Malformed> {
    let error = |problem: String, help| Malformed {
        place: payload.place(),
        problem,
        help,
    };
    let axes = ["x", "y", "z"].map(|axis| table.columns.remove(axis));
    let [Some(x), Some(y), Some(z)] = axes else {
        return Err(error(
            "the vertices have no coordinates".to_owned(),
            "each needs the properties x, y and z",
        ));
    };
    let positions: Vec<DVec3> = (0..x.len())
        .map(|vertex| DVec3::new(x[vertex], y[vertex], z[vertex]))
        .collect();
    match positions.iter().position(|position| !position.is_finite()) {
        Some(vertex) => {
            let problem = format!(
                "the position of vertex {vertex} of {} is not finite",
                element.count
            );
            Err(error(problem, "positions are real numbers"))
        }
        None => Ok(positions),
    }
}

impl Table {
    fn into_attributes(mut self, element: ElementKind, file: &mut MeshFile) {
        for name in std::mem::take(&mut self.names) {
            // Gone if it is a coordinate or the second or third component of something.
            if !self.columns.contains_key(&name) {
                continue;
            }
            let vector = if name == "nx" {
                Some(NORMAL)
            } else {
                name.strip_suffix("_x")
            };
            if let Some([x, y, z]) = vector.and_then(|vector| self.take(coordinate_names(vector))) {
                let values = (0..x.len())
                    .map(|index| DVec3::new(x[index], y[index], z[index]))
                    .collect();
                file.attributes.push(
                    element,
                    vector.unwrap_or_default(),
                    AttributeValues::Vector(values),
                );
                continue;
            }
            let is_color = name == "red"
                && ["red", "green", "blue"]
                    .iter()
                    .all(|name| self.color_names.iter().any(|other| other == name));
            if is_color
                && let Some([red, green, blue]) =
                    self.take(["red", "green", "blue"].map(str::to_owned))
            {
                // Numbers of a text file that are no bytes saturate.
                let values = (0..red.len())
                    .map(|index| [red[index] as u8, green[index] as u8, blue[index] as u8]);
                file.attributes
                    .push(element, COLOR, AttributeValues::Color(values.collect()));
                continue;
            }
            if let Some(values) = self.columns.remove(&name) {
                file.attributes
                    .push(element, &name, AttributeValues::Scalar(values));
            }
        }
    }

    /// Takes three columns out, if all are there.
    fn take(&mut self, names: [String; 3]) -> Option<[Vec<f64>; 3]> {
        if !names.iter().all(|name| self.columns.contains_key(name)) {
            return None;
        }
        Some(names.map(|name| self.columns.remove(&name).unwrap_or_default()))
    }
}
