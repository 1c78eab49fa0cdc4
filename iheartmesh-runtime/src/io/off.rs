//! OFF (Object File Format): positions, polygons, and colours of vertices (COFF) and faces.
//!
//! The first word is `OFF`, before it in this order `ST` if texture coordinates, `C` if colours and `N` if normals
//! follow each position. Then come the numbers of vertices, faces and edges (the last is not used), one line for each
//! vertex and one for each face: number of corners, corners from 0, and perhaps a colour. Comments begin with `#`.
//! Colours are whole numbers from 0 to 255 or, with a decimal point, 0 to 1. Texture coordinates are skipped.

use std::fmt::Write;

use glam::DVec3;

use super::attributes::{AttributeValues, Attributes, NORMAL};
use super::error::{CannotWrite, Malformed, Place, counted};
use super::mesh_file::{FaceList, MeshFile};
use super::text::{Line, shorten};
use crate::element::ElementKind;

/// What stands after each position.
#[derive(Default)]
struct Variant {
    has_texture: bool,
    has_colors: bool,
    has_normals: bool,
}

impl Variant {
    fn parse(word: &str) -> Option<Variant> {
        let mut prefix = word.strip_suffix("OFF")?;
        let mut has = |letters| {
            let rest = prefix.strip_prefix(letters);
            prefix = rest.unwrap_or(prefix);
            rest.is_some()
        };
        let variant = Variant {
            has_texture: has("ST"),
            has_colors: has("C"),
            has_normals: has("N"),
        };
        prefix.is_empty().then_some(variant)
    }
}

/// The lines that hold something.
struct Lines<'a> {
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    /// Number of the last line read.
    last: usize,
}

impl<'a> Lines<'a> {
    fn new(text: &'a str) -> Self {
        Lines {
            lines: text.lines().enumerate(),
            last: 1,
        }
    }

    fn next(&mut self, what: &str) -> Result<Line<'a>, Malformed> {
        for (index, text) in self.lines.by_ref() {
            self.last = index + 1;
            let text = text.split('#').next().unwrap_or_default();
            if !text.trim_ascii().is_empty() {
                return Ok(Line::new(self.last, text));
            }
        }
        let place = Place::Line(self.last);
        Err(Malformed {
            place,
            problem: format!("the file ends before {what}"),
            help: "it may be truncated",
        })
    }
}

pub(super) fn read(text: &str) -> Result<MeshFile, Malformed> {
    const HELP: &str =
        "an OFF file begins with the word OFF, COFF, NOFF, CNOFF or one of these after ST";
    let mut lines = Lines::new(text);
    let mut line = lines.next("the word OFF")?;
    let word = line.token().unwrap_or_default();
    let Some(variant) = Variant::parse(word) else {
        return Err(line.error(
            format!("`{}` is no OFF file that can be read", shorten(word)),
            HELP,
        ));
    };
    if line.remaining() == 0 {
        line = lines.next("the numbers of vertices and faces")?;
    } else if line.remaining() == 1 {
        return Err(line.error("the OFF file is not plain text", "save it as text"));
    }
    let [n_vertices, n_faces] =
        ["number of vertices", "number of faces"].map(|what| count(&mut line, what, text.len()));
    let (n_vertices, n_faces) = (n_vertices?, n_faces?);

    let mut file = MeshFile {
        positions: Vec::with_capacity(n_vertices),
        ..MeshFile::default()
    };
    let (mut normals, mut colors) = (Vec::new(), Vec::new());
    for vertex in 0..n_vertices {
        let mut line = lines.next(&format!("vertex {vertex} of {n_vertices}"))?;
        file.positions.push(line.position()?);
        if variant.has_normals {
            let mut normal = DVec3::ZERO;
            for axis in 0..3 {
                normal[axis] = line.number("coordinate of the normal")?;
            }
            normals.push(normal);
        }
        if variant.has_colors && !variant.has_texture {
            colors.extend(line.color(false)?);
        }
    }
    let mut face_colors = Vec::new();
    let mut corners = Vec::new();
    for face in 0..n_faces {
        let mut line = lines.next(&format!("face {face} of {n_faces}"))?;
        let n_corners = line.integer("number of corners")?;
        if usize::try_from(n_corners).map_or(true, |n_corners| n_corners > line.remaining()) {
            let problem = format!(
                "the face is to have {n_corners} corners, but {} follow",
                line.remaining()
            );
            return Err(line.error(problem, "write the number of corners, then each of them"));
        }
        corners.clear();
        for _ in 0..n_corners {
            let index = line.integer("corner")?;
            match u32::try_from(index) {
                Ok(vertex) if (vertex as usize) < n_vertices => corners.push(vertex),
                _ => {
                    let problem = format!(
                        "the face names vertex {index}, but the file has {}",
                        counted(n_vertices, ElementKind::Vertex)
                    );
                    return Err(line.error(problem, "vertices are numbered from 0"));
                }
            }
        }
        file.polygons.push(&corners);
        face_colors.extend(line.color(false)?);
    }

    // Files of other programs colour some elements only, or by a number of a colour map: then there are no colours.
    let all = [
        (
            ElementKind::Vertex,
            n_vertices,
            AttributeValues::Vector(normals),
            NORMAL,
        ),
        (
            ElementKind::Vertex,
            n_vertices,
            AttributeValues::Color(colors),
            super::attributes::COLOR,
        ),
        (
            ElementKind::Face,
            n_faces,
            AttributeValues::Color(face_colors),
            super::attributes::COLOR,
        ),
    ];
    for (element, n_elements, values, name) in all {
        if !values.is_empty() && values.len() == n_elements {
            file.attributes.push(element, name, values);
        }
    }
    Ok(file)
}

/// A number of elements. Each takes at least two bytes of the file.
fn count(line: &mut Line, what: &str, file_size: usize) -> Result<usize, Malformed> {
    let count = line.integer(what)?;
    match usize::try_from(count) {
        Ok(count) if count <= file_size / 2 => Ok(count),
        Ok(_) => Err(line.error(
            format!("the {what} is {count}, more than the file can hold"),
            "it may be truncated",
        )),
        Err(_) => Err(line.error(format!("the {what} is {count}"), "it cannot be negative")),
    }
}

pub(super) fn write(
    positions: &[DVec3],
    faces: &(impl FaceList + ?Sized),
    attributes: &Attributes,
) -> Result<Vec<u8>, CannotWrite> {
    let colors = attributes.colors(ElementKind::Vertex);
    let face_colors = attributes.colors(ElementKind::Face);
    let normals = attributes.vector(ElementKind::Vertex, NORMAL);
    for attribute in attributes {
        let is_normal = attribute.element == ElementKind::Vertex
            && attribute.name == NORMAL
            && normals.is_some();
        if !(is_normal || matches!(attribute.values, AttributeValues::Color(_))) {
            let problem = format!(
                "an OFF file cannot hold the {} attribute `{}`",
                attribute.element, attribute.name
            );
            return Err(CannotWrite {
                problem,
                help: "write a .ply file",
            });
        }
    }
    let mut text = String::new();
    let prefix = |letter, is_present| if is_present { letter } else { "" };
    // Writing into a `String` cannot fail.
    let _ = writeln!(
        text,
        "{}{}OFF",
        prefix("C", colors.is_some()),
        prefix("N", normals.is_some())
    );
    let _ = writeln!(text, "{} {} 0", positions.len(), faces.n_faces());
    for (vertex, position) in positions.iter().enumerate() {
        let _ = write!(text, "{} {} {}", position.x, position.y, position.z);
        if let Some(normals) = normals {
            let normal = normals[vertex];
            let _ = write!(text, " {} {} {}", normal.x, normal.y, normal.z);
        }
        if let Some([red, green, blue]) = colors.map(|colors| colors[vertex]) {
            let _ = write!(text, " {red} {green} {blue} 255");
        }
        text.push('\n');
    }
    for face in 0..faces.n_faces() {
        let corners = faces.corners(face);
        let _ = write!(text, "{}", corners.len());
        for vertex in corners {
            let _ = write!(text, " {vertex}");
        }
        if let Some([red, green, blue]) = face_colors.map(|colors| colors[face]) {
            let _ = write!(text, " {red} {green} {blue}");
        }
        text.push('\n');
    }
    Ok(text.into_bytes())
}
