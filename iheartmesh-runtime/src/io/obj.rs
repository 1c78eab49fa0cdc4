//! Wavefront OBJ: positions, polygons and, as many programs write them, vertex colours after the position.
//!
//! Read here and not by a library: the maintained reader (`tobj`) splits a file into models, renumbers the vertices of
//! each and drops those that no face names, while an index into the file's own vertices is what per-vertex data of
//! other programs refers to.
//!
//! Understood are `v` and `f` with indices of the forms `i`, `i/t`, `i//n`, `i/t/n`, counted from 1 or, if negative,
//! from the last vertex back; comments and lines continued by `\`. Texture coordinates, normals, groups, materials,
//! points, lines, and curves and surfaces are skipped.
//!
//! The format has no header. A file without any statement or comment is refused, since it is more likely an accident than a
//! mesh without vertices; the latter is written as a comment.

use std::fmt::Write;

use glam::DVec3;

use super::attributes::{AttributeValues, Attributes};
use super::error::{CannotWrite, Malformed, Place, counted};
use super::mesh_file::{FaceList, MeshFile};
use super::text::{Line, shorten};
use crate::element::ElementKind;

/// Statements of the format that say nothing about positions and polygons.
const SKIPPED: &str = "vt vn vp g o s mg l p usemtl mtllib usemap maplib lod bevel c_interp d_interp shadow_obj \
    trace_obj ctech stech cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con call csh bsp bzp cdc cdp res";

const STATEMENTS: &str = "an OBJ file has lines such as `v 0 0 1` and `f 1 2 3`";

pub(super) fn read(text: &str) -> Result<MeshFile, Malformed> {
    if text.trim_ascii().is_empty() {
        return Err(Line::new(1, text).error("the file is empty", STATEMENTS));
    }
    let mut file = MeshFile::default();
    let mut colors = Vec::new();
    let mut corners = Vec::new();
    // A face may name a vertex that follows it: the largest index is compared when all vertices are known.
    let mut largest = None;
    let mut joined = String::new();
    let mut lines = text.lines().enumerate();
    while let Some((index, mut text)) = lines.next() {
        if text.ends_with('\\') {
            joined.clear();
            while let Some(part) = text.strip_suffix('\\') {
                joined.push_str(part);
                joined.push(' ');
                text = lines.next().map_or("", |(_, text)| text);
            }
            joined.push_str(text);
            text = &joined;
        }
        let text = text.split('#').next().unwrap_or_default();
        let mut line = Line::new(index + 1, text);
        match line.token() {
            None => {}
            Some("v") => {
                file.positions.push(line.position()?);
                // Three more numbers are a colour, a single one is a weight; four are a weight and a colour.
                if line.remaining() == 4 {
                    line.number("weight")?;
                }
                colors.extend(line.color(true)?);
            }
            Some("f") => {
                corners.clear();
                while let Some(token) = line.token() {
                    let vertex = corner(&line, token, file.positions.len())?;
                    if largest.is_none_or(|(other, _)| vertex > other) {
                        largest = Some((vertex, line.place()));
                    }
                    corners.push(vertex);
                }
                file.polygons.push(&corners);
            }
            Some(keyword) if SKIPPED.split(' ').any(|other| other == keyword) => {}
            Some(keyword) => {
                let problem = format!("unknown statement `{}`", shorten(keyword));
                return Err(line.error(problem, STATEMENTS));
            }
        }
    }
    check_largest(largest, file.positions.len())?;
    if !colors.is_empty() && colors.len() == file.positions.len() {
        file.attributes = Attributes::new().vertex_colors(colors);
    }
    Ok(file)
}

/// The vertex that a corner `i`, `i/t`, `i//n` or `i/t/n` names.
fn corner(line: &Line, token: &str, n_vertices: usize) -> Result<u32, Malformed> {
    const HELP: &str = "indices count from 1, or from −1 for the last vertex before the face";
    let mut parts = token.split('/');
    let index = parts.next().and_then(|part| part.parse::<i64>().ok());
    let is_valid = parts.clone().count() <= 2
        && parts.all(|part| part.is_empty() || part.parse::<i64>().is_ok());
    let Some(index) = index.filter(|_| is_valid) else {
        return Err(line.error(
            format!("corner `{}` is no index", shorten(token)),
            "write it as 7, 7/1, 7//1 or 7/1/1",
        ));
    };
    let vertex = match index {
        0 => None,
        1.. => u32::try_from(index - 1).ok(),
        _ => (n_vertices as i64)
            .checked_add(index)
            .and_then(|vertex| u32::try_from(vertex).ok()),
    };
    vertex.ok_or_else(|| line.error(format!("there is no vertex with the index {index}"), HELP))
}

fn check_largest(largest: Option<(u32, Place)>, n_vertices: usize) -> Result<(), Malformed> {
    match largest {
        Some((vertex, place)) if vertex as usize >= n_vertices => Err(Malformed {
            place,
            problem: format!(
                "the face names vertex {}, but the file has {}",
                u64::from(vertex) + 1,
                counted(n_vertices, ElementKind::Vertex)
            ),
            help: "indices count from 1; the file may be truncated",
        }),
        _ => Ok(()),
    }
}

pub(super) fn write(
    positions: &[DVec3],
    faces: &(impl FaceList + ?Sized),
    attributes: &Attributes,
) -> Result<Vec<u8>, CannotWrite> {
    let colors = attributes.colors(ElementKind::Vertex);
    for attribute in attributes {
        let is_color = matches!(attribute.values, AttributeValues::Color(_));
        if !(is_color && attribute.element == ElementKind::Vertex) {
            let problem = format!(
                "an OBJ file cannot hold the {} attribute `{}`",
                attribute.element, attribute.name
            );
            return Err(CannotWrite {
                problem,
                help: "write a .ply file",
            });
        }
    }
    let mut text = String::new();
    if positions.is_empty() {
        text.push_str("# no vertices\n");
    }
    for (vertex, position) in positions.iter().enumerate() {
        // Writing into a `String` cannot fail.
        let _ = write!(text, "v {} {} {}", position.x, position.y, position.z);
        if let Some(colors) = colors {
            let [red, green, blue] = colors[vertex].map(|component| f64::from(component) / 255.0);
            let _ = write!(text, " {red:.6} {green:.6} {blue:.6}");
        }
        text.push('\n');
    }
    for face in 0..faces.n_faces() {
        text.push('f');
        for &vertex in faces.corners(face) {
            let _ = write!(text, " {}", u64::from(vertex) + 1);
        }
        text.push('\n');
    }
    Ok(text.into_bytes())
}
