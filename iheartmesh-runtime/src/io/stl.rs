//! STL, text and binary: triangles without numbering, each with the positions of its corners.
//!
//! Parsed and written by `stl_io`, one triangle at a time. Corners at the same position are one vertex (exactly the same: no
//! tolerance, −0 is 0), numbered as they come; facet normals that are not all zero are the vectors `normal` on faces.
//!
//! The format has single precision: positions are rounded when they are written, in the binary form.

use std::collections::HashMap;
use std::io::{self, ErrorKind, Read, Seek, SeekFrom};

use glam::DVec3;
use stl_io::{Normal, Triangle, Vertex};

use super::attributes::{AttributeValues, Attributes, NORMAL};
use super::error::{CannotWrite, Malformed, Place};
use super::mesh_file::{FaceList, MeshFile};
use super::text::shorten;
use crate::element::ElementKind;

/// Bytes before the triangles of a binary file: a title and the number of triangles.
const HEADER: usize = 84;
/// Bytes of a triangle.
const TRIANGLE: usize = 50;

/// A file as the library is to see it: another first line or title, then the rest; of a text one line at a time, so that it is
/// known in which line the reader stopped.
struct Source<'a> {
    parts: [&'a [u8]; 2],
    at: usize,
    is_text: bool,
    n_lines: usize,
    /// Where the last line began.
    line: usize,
}

impl<'a> Source<'a> {
    fn new(first: &'a [u8], rest: &'a [u8], is_text: bool) -> Self {
        Source {
            parts: [first, rest],
            at: 0,
            is_text,
            n_lines: 0,
            line: 0,
        }
    }

    /// What is not read yet of the part that is being read.
    fn rest(&self) -> &'a [u8] {
        let [first, rest] = self.parts;
        match self.at.checked_sub(first.len()) {
            Some(at) => &rest[at..],
            None => &first[self.at..],
        }
    }

    fn last_line(&self) -> String {
        let [first, rest] = self.parts;
        let line = rest.get(self.line.saturating_sub(first.len())..);
        let line = line.unwrap_or_default().split(|&byte| byte == b'\n').next();
        shorten(String::from_utf8_lossy(line.unwrap_or_default()).trim())
    }
}

impl Read for Source<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let rest = self.rest();
        let mut end = rest.len();
        if self.is_text {
            let newline = rest.iter().position(|&byte| byte == b'\n');
            end = newline.map_or(end, |newline| newline + 1);
        }
        let length = end.min(buffer.len());
        buffer[..length].copy_from_slice(&rest[..length]);
        if length > 0 && length == end {
            self.n_lines += 1;
            self.line = self.at;
        }
        self.at += length;
        Ok(length)
    }
}

impl Seek for Source<'_> {
    /// To the beginning, which is all that the library asks for.
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        match position {
            SeekFrom::Start(0) => (self.at, self.n_lines, self.line) = (0, 0, 0),
            _ => return Err(ErrorKind::Unsupported.into()),
        }
        Ok(0)
    }
}

/// Triangles without numbering become a mesh file.
#[derive(Default)]
struct Welding {
    file: MeshFile,
    normals: Vec<DVec3>,
    vertices: HashMap<[u32; 3], u32>,
}

impl Welding {
    /// `false` if a corner is not finite.
    fn push(&mut self, triangle: &Triangle) -> bool {
        let mut corners = [0; 3];
        for (corner, vertex) in corners.iter_mut().zip(&triangle.vertices) {
            // adding 0 takes −0 to 0
            let position = vertex.0.map(|x| x + 0.0);
            if !position.iter().all(|x| x.is_finite()) {
                return false;
            }
            let next = self.file.positions.len() as u32;
            *corner = *self
                .vertices
                .entry(position.map(f32::to_bits))
                .or_insert(next);
            if *corner == next {
                let position = position.map(f64::from);
                self.file.positions.push(position.into());
            }
        }
        self.file.polygons.push(&corners);
        self.normals.push(triangle.normal.0.map(f64::from).into());
        true
    }

    fn finish(mut self) -> MeshFile {
        if self.normals.iter().any(|normal| *normal != DVec3::ZERO) {
            let values = AttributeValues::Vector(self.normals);
            self.file.attributes.push(ElementKind::Face, NORMAL, values);
        }
        self.file
    }
}

pub(super) fn read(bytes: &[u8]) -> Result<MeshFile, Malformed> {
    // Some programs begin the title of a binary file with `solid` too: then its length gives it away.
    let promised = bytes
        .get(80..HEADER)
        .and_then(|count| count.try_into().ok())
        .map(|count| u32::from_le_bytes(count) as usize);
    let is_binary = promised.is_some_and(|count| {
        count
            .checked_mul(TRIANGLE)
            .is_some_and(|size| size == bytes.len() - HEADER)
    });
    match promised {
        Some(count) if is_binary || !bytes.trim_ascii_start().starts_with(b"solid") => {
            read_binary(bytes, count)
        }
        _ => read_text(bytes),
    }
}

fn read_binary(bytes: &[u8], count: usize) -> Result<MeshFile, Malformed> {
    let error = |byte, problem| Malformed {
        place: Place::Byte(byte),
        problem,
        help: "the file is truncated or damaged, or of another format",
    };
    let left = bytes.len() - HEADER;
    if count.checked_mul(TRIANGLE).is_none_or(|size| size != left) {
        let problem = format!(
            "the header promises {count} triangles of {TRIANGLE} bytes each, but {left} bytes follow"
        );
        return Err(error(80, problem));
    }
    // A title `solid …` would be taken for text.
    let mut source = Source::new(&[0; 80], &bytes[80..], false);
    let mut welding = Welding::default();
    let triangles = stl_io::create_stl_reader(&mut source);
    let triangles = triangles.map_err(|_| error(0, "the header cannot be read".to_owned()))?;
    for (index, triangle) in triangles.enumerate() {
        let byte = HEADER + index * TRIANGLE;
        let is_good = triangle.is_ok_and(|triangle| welding.push(&triangle));
        if !is_good {
            let problem = format!("a corner of triangle {index} is not finite");
            return Err(error(byte, problem));
        }
    }
    Ok(welding.finish())
}

fn read_text(bytes: &[u8]) -> Result<MeshFile, Malformed> {
    let error = |line, problem| Malformed {
        place: Place::Line(line),
        problem,
        help: "a text file repeats the lines `facet normal 0 0 1`, `outer loop`, three times `vertex 0 0 0`, \
               `endloop`, `endfacet` between `solid` and `endsolid`",
    };
    let mut welding = Welding::default();
    // lines of the solids before
    let mut n_before = 0;
    let mut rest = bytes;
    let mut n_solids = 0;
    loop {
        // blank lines between solids
        let n_blank = rest.len() - rest.trim_ascii_start().len();
        n_before += count_lines(&rest[..n_blank]);
        rest = &rest[n_blank..];
        if rest.is_empty() && n_solids > 0 {
            return Ok(welding.finish());
        }
        let length = rest.iter().position(|&byte| byte == b'\n');
        let (first, others) = rest.split_at(length.map_or(rest.len(), |length| length + 1));
        let word = first.split(u8::is_ascii_whitespace).next();
        if word != Some(b"solid") {
            let line = String::from_utf8_lossy(first);
            let problem = format!("`{}` is no beginning of a solid", shorten(line.trim()));
            return Err(error(n_before + 1, problem));
        }
        // the name does not matter, but the library wants a blank before it
        let mut source = Source::new(b"solid \n", others, true);
        let outcome = solid(&mut source, &mut welding);
        let line = n_before + source.n_lines;
        outcome.map_err(|cause| match cause.kind() {
            ErrorKind::UnexpectedEof => error(line, "the file ends within a solid".to_owned()),
            _ => error(
                line,
                format!("the line `{}` cannot be read", source.last_line()),
            ),
        })?;
        n_before = line;
        n_solids += 1;
        rest = source.rest();
    }
}

/// The triangles of a solid.
fn solid(source: &mut Source, welding: &mut Welding) -> io::Result<()> {
    for triangle in stl_io::create_stl_reader(source)? {
        if !welding.push(&triangle?) {
            return Err(ErrorKind::InvalidData.into());
        }
    }
    Ok(())
}

fn count_lines(bytes: &[u8]) -> usize {
    bytes.iter().filter(|&&byte| byte == b'\n').count()
}

/// The unit normal of a triangle, or zero.
fn normal(corners: [DVec3; 3]) -> DVec3 {
    let [a, b, c] = corners;
    (b - a).cross(c - a).normalize_or_zero()
}

pub(super) fn write(
    positions: &[DVec3],
    faces: &(impl FaceList + ?Sized),
    attributes: &Attributes,
) -> Result<Vec<u8>, CannotWrite> {
    let cannot = |problem, help| Err(CannotWrite { problem, help });
    let normals = attributes.vector(ElementKind::Face, NORMAL);
    for attribute in attributes {
        let is_normal =
            attribute.element == ElementKind::Face && attribute.name == NORMAL && normals.is_some();
        if !is_normal {
            let problem = format!(
                "an STL file cannot hold the {} attribute `{}`",
                attribute.element, attribute.name
            );
            return cannot(problem, "write a .ply file");
        }
    }
    if let Some(vertex) = positions
        .iter()
        .position(|position| position.abs().max_element() > f64::from(f32::MAX))
    {
        let problem = format!("the position of vertex {vertex} is beyond single precision");
        return cannot(problem, "scale the positions, or write a .ply file");
    }
    let mut is_used = vec![false; positions.len()];
    let mut triangles = Vec::with_capacity(faces.n_faces());
    for face in 0..faces.n_faces() {
        let Ok(corners) = <[u32; 3]>::try_from(faces.corners(face)) else {
            let problem = format!(
                "an STL file cannot hold a face with {} corners",
                faces.corners(face).len()
            );
            return cannot(
                problem,
                "divide the faces into triangles, or write a .ply file",
            );
        };
        for vertex in corners {
            is_used[vertex as usize] = true;
        }
        let corners = corners.map(|vertex| positions[vertex as usize]);
        let normal = normals.map_or_else(|| normal(corners), |normals| normals[face]);
        triangles.push(Triangle {
            normal: Normal::new(normal.as_vec3().to_array()),
            vertices: corners.map(|corner| Vertex::new(corner.as_vec3().to_array())),
        });
    }
    if let Some(vertex) = is_used.iter().position(|is_used| !is_used) {
        let problem = format!("vertex {vertex} is in no face, and an STL file has faces only");
        return cannot(problem, "leave it out, or write a .ply file");
    }
    if u32::try_from(triangles.len()).is_err() {
        let problem = format!("an STL file cannot hold {} triangles", triangles.len());
        return cannot(problem, "write a .ply file");
    }
    let mut bytes = Vec::with_capacity(HEADER + TRIANGLE * triangles.len());
    // Writing into memory cannot fail.
    let _ = stl_io::write_stl(&mut bytes, triangles.iter());
    Ok(bytes)
}
