//! MEDIT (`.mesh`, text): positions, edges, triangles, quadrilaterals, tetrahedra and hexahedra.
//!
//! `MeshVersionFormatted` and `Dimension 3`, then lists: a keyword, the number of entries, and for each the numbers of its
//! vertices (from 1) and a reference, which is not kept. Line breaks mean nothing; comments begin with `#`; the list ends
//! at `End` or with the file. Lists of what is special about elements (`Corners`, `Ridges`, …) are skipped.

use std::fmt::Write;
use std::str::SplitAsciiWhitespace;

use glam::DVec3;

use super::error::{CannotWrite, Malformed, Place, counted};
use super::mesh_file::MeshFile;
use super::text::shorten;
use crate::element::ElementKind;

/// The words of a text with the lines that they stand in.
struct Words<'a> {
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    rest: SplitAsciiWhitespace<'a>,
    line: usize,
    /// Number of bytes of the file.
    size: usize,
}

impl<'a> Words<'a> {
    fn new(text: &'a str) -> Self {
        Words {
            lines: text.lines().enumerate(),
            rest: "".split_ascii_whitespace(),
            line: 1,
            size: text.len(),
        }
    }

    fn next(&mut self) -> Option<&'a str> {
        loop {
            if let Some(word) = self.rest.next() {
                return Some(word);
            }
            let (index, line) = self.lines.next()?;
            self.line = index + 1;
            self.rest = line
                .split('#')
                .next()
                .unwrap_or_default()
                .split_ascii_whitespace();
        }
    }

    fn error(&self, problem: String, help: &'static str) -> Malformed {
        Malformed {
            place: Place::Line(self.line),
            problem,
            help,
        }
    }

    fn word(&mut self, what: &str) -> Result<&'a str, Malformed> {
        match self.next() {
            Some(word) => Ok(word),
            None => Err(self.error(
                format!("the file ends before {what}"),
                "it may be truncated",
            )),
        }
    }

    fn integer(&mut self, what: &str) -> Result<i64, Malformed> {
        let word = self.word(what)?;
        word.parse().map_err(|_| {
            self.error(
                format!("{what} `{}` is no whole number", shorten(word)),
                "write it as 17",
            )
        })
    }

    fn number(&mut self, what: &str) -> Result<f64, Malformed> {
        let word = self.word(what)?;
        word.parse().map_err(|_| {
            self.error(
                format!("{what} `{}` is no number", shorten(word)),
                "write it as 1.5e-3",
            )
        })
    }

    /// The number of entries of a list, each of which takes so many words, at least two bytes each.
    fn count(&mut self, list: &str, words: usize) -> Result<usize, Malformed> {
        let count = self.integer(&format!("the number of {list}"))?;
        match usize::try_from(count) {
            Ok(count) if count.saturating_mul(2 * words) <= self.size + 1 => Ok(count),
            Ok(_) => Err(self.error(
                format!("the number of {list} is {count}, more than the file can hold"),
                "it may be truncated",
            )),
            Err(_) => Err(self.error(
                format!("the number of {list} is {count}"),
                "it cannot be negative",
            )),
        }
    }

    /// The entries of a list of elements with `N` vertices.
    fn elements<const N: usize>(
        &mut self,
        list: &str,
        n_vertices: usize,
    ) -> Result<Vec<[u32; N]>, Malformed> {
        let count = self.count(list, N + 1)?;
        let mut elements = Vec::with_capacity(count);
        for _ in 0..count {
            let mut element = [0; N];
            for corner in &mut element {
                let index = self.integer("a vertex")?;
                if index < 1 || index as u64 > n_vertices as u64 {
                    let problem = format!(
                        "an entry of {list} names vertex {index}, but the file has {}",
                        counted(n_vertices, ElementKind::Vertex)
                    );
                    return Err(self.error(problem, "vertices are numbered from 1"));
                }
                *corner = (index - 1) as u32;
            }
            self.integer("a reference")?;
            elements.push(element);
        }
        Ok(elements)
    }
}

pub(super) fn read(text: &str) -> Result<MeshFile, Malformed> {
    let mut words = Words::new(text);
    let mut file = MeshFile::default();
    let first = words.word("`MeshVersionFormatted`")?;
    if first != "MeshVersionFormatted" {
        let problem = format!(
            "the first word is `{}`, not `MeshVersionFormatted`",
            shorten(first)
        );
        return Err(words.error(problem, "this is no text file of MEDIT"));
    }
    words.integer("the version")?;
    let mut has_vertices = false;
    while let Some(keyword) = words.next() {
        let n = file.positions.len();
        match keyword {
            "Dimension" => {
                let dimension = words.integer("the dimension")?;
                if dimension != 3 {
                    let problem = format!("the dimension is {dimension}");
                    return Err(words.error(problem, "positions have three coordinates"));
                }
            }
            "Vertices" => {
                if std::mem::replace(&mut has_vertices, true) {
                    let problem = "there are two lists of vertices".to_owned();
                    return Err(words.error(problem, "keep one"));
                }
                let count = words.count("vertices", 4)?;
                file.positions.reserve(count);
                for _ in 0..count {
                    let mut position = DVec3::ZERO;
                    for axis in 0..3 {
                        position[axis] = words.number("a coordinate")?;
                    }
                    if !position.is_finite() {
                        let problem = "the position is not finite".to_owned();
                        return Err(words.error(problem, "positions are real numbers"));
                    }
                    words.integer("a reference")?;
                    file.positions.push(position);
                }
            }
            "Edges" => file.edges.extend(words.elements::<2>(keyword, n)?),
            "Triangles" => words
                .elements::<3>(keyword, n)?
                .iter()
                .for_each(|face| file.polygons.push(face)),
            "Quadrilaterals" => words
                .elements::<4>(keyword, n)?
                .iter()
                .for_each(|face| file.polygons.push(face)),
            "Tetrahedra" => file.tetrahedra.extend(words.elements::<4>(keyword, n)?),
            "Hexahedra" => file.hexahedra.extend(words.elements::<8>(keyword, n)?),
            "Corners"
            | "RequiredVertices"
            | "Ridges"
            | "RequiredEdges"
            | "RequiredTriangles"
            | "RequiredQuadrilaterals" => skip(&mut words, keyword, 1)?,
            "Normals" | "Tangents" => skip(&mut words, keyword, 3)?,
            "NormalAtVertices" | "TangentAtVertices" => skip(&mut words, keyword, 2)?,
            "End" => return Ok(file),
            _ => {
                let problem = format!("there is no list `{}`", shorten(keyword));
                return Err(
                    words.error(problem, "remove it, or check the number of entries before")
                );
            }
        }
    }
    Ok(file)
}

fn skip(words: &mut Words, list: &str, length: usize) -> Result<(), Malformed> {
    let count = words.count(list, length)?;
    for _ in 0..count * length {
        words.number("an entry")?;
    }
    Ok(())
}

/// The lists of edges, polygons, tetrahedra and hexahedra of `file`.
pub(super) fn write(file: &MeshFile) -> Result<Vec<u8>, CannotWrite> {
    if let Some(attribute) = file.attributes.iter().next() {
        let problem = format!(
            "a MEDIT file cannot hold the {} attribute `{}`",
            attribute.element, attribute.name
        );
        return Err(CannotWrite {
            problem,
            help: "write a .vtk file",
        });
    }
    let mut text = String::from("MeshVersionFormatted 2\nDimension 3\n");
    // Writing into a `String` cannot fail.
    let _ = writeln!(text, "Vertices\n{}", file.positions.len());
    for position in &file.positions {
        let _ = writeln!(text, "{} {} {} 0", position.x, position.y, position.z);
    }
    let mut list = |name: &str, elements: &mut dyn ExactSizeIterator<Item = &[u32]>| {
        if elements.len() == 0 {
            return;
        }
        let _ = writeln!(text, "{name}\n{}", elements.len());
        for element in elements {
            for vertex in element {
                let _ = write!(text, "{} ", vertex + 1);
            }
            text.push_str("0\n");
        }
    };
    list("Edges", &mut file.edges.iter().map(|edge| &edge[..]));
    for (name, n_corners) in [("Triangles", 3), ("Quadrilaterals", 4)] {
        let faces: Vec<&[u32]> = file
            .polygons
            .iter()
            .filter(|face| face.len() == n_corners)
            .collect();
        list(name, &mut faces.into_iter());
    }
    if let Some(face) = file
        .polygons
        .iter()
        .find(|face| !matches!(face.len(), 3 | 4))
    {
        let problem = format!(
            "a MEDIT file cannot hold a face with {} corners",
            face.len()
        );
        return Err(CannotWrite {
            problem,
            help: "write a .ply or .vtk file",
        });
    }
    list(
        "Tetrahedra",
        &mut file.tetrahedra.iter().map(|cell| &cell[..]),
    );
    list(
        "Hexahedra",
        &mut file.hexahedra.iter().map(|cell| &cell[..]),
    );
    text.push_str("End\n");
    Ok(text.into_bytes())
}
