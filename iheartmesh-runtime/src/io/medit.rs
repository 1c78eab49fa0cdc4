//! MEDIT (`.mesh`, text): positions, edges, triangles, quadrilaterals, tetrahedra, hexahedra, prisms and pyramids.
//!
//! `MeshVersionFormatted` and `Dimension 3`, then lists: a keyword, the number of entries, and for each the numbers of its
//! vertices (from 1) and a reference, which is not kept. Line breaks mean nothing; comments begin with `#`; the list ends
//! at `End` or with the file. Lists of what is special about elements (`Corners`, `Ridges`, …) are skipped.
//!
//! A prism begins with its bottom, counter-clockwise seen from its top, a pyramid with its base, counter-clockwise seen from its
//! apex. Each kind has one list, so that triangles are written before quadrilaterals and prisms before pyramids.

use std::fmt::Write;

use super::FIRST_ORDER;
use super::error::{CannotWrite, Malformed, counted};
use super::mesh_file::MeshFile;
use super::polyhedra::{self, Simple};
use super::stream::{Scalar, Stream};
use super::text::shorten;
use crate::element::ElementKind;

/// The number of entries of a list, each of which takes so many words.
fn count(words: &mut Stream, list: &str, length: usize) -> Result<usize, Malformed> {
    let count = words.integer(&format!("the number of {list}"))?;
    words.check_count(list, count, length, 0)
}

/// The entries of a list of elements with `N` vertices.
fn elements<const N: usize>(
    words: &mut Stream,
    list: &str,
    n_vertices: usize,
) -> Result<Vec<[u32; N]>, Malformed> {
    let count = count(words, list, N + 1)?;
    let mut elements = Vec::with_capacity(count);
    for _ in 0..count {
        let mut element = [0; N];
        for corner in &mut element {
            let index = words.integer("a vertex")?;
            if index < 1 || index as u64 > n_vertices as u64 {
                let problem = format!(
                    "an entry of {list} names vertex {index}, but the file has {}",
                    counted(n_vertices, ElementKind::Vertex)
                );
                return Err(words.error(problem, "vertices are numbered from 1"));
            }
            *corner = (index - 1) as u32;
        }
        words.integer("a reference")?;
        elements.push(element);
    }
    Ok(elements)
}

pub(super) fn read(bytes: &[u8]) -> Result<MeshFile, Malformed> {
    let mut words = Stream::new(bytes, Some(b'#'));
    let mut file = MeshFile::default();
    let first = words.word("`MeshVersionFormatted`")?;
    if first != "MeshVersionFormatted" {
        let problem = format!(
            "the first word is `{}`, not `MeshVersionFormatted`",
            shorten(&first)
        );
        return Err(words.error(problem, "this is no text file of MEDIT"));
    }
    words.integer("the version")?;
    let mut has_vertices = false;
    while let Some(keyword) = words.next() {
        let n = file.positions.len();
        match &*keyword {
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
                let count = count(&mut words, "vertices", 4)?;
                file.positions.reserve(count);
                for _ in 0..count {
                    let position = words.position(Scalar::F64)?;
                    words.integer("a reference")?;
                    file.positions.push(position);
                }
            }
            "Edges" => file.edges.extend(elements::<2>(&mut words, &keyword, n)?),
            "Triangles" => elements::<3>(&mut words, &keyword, n)?
                .iter()
                .for_each(|face| file.polygons.push(face)),
            "Quadrilaterals" => elements::<4>(&mut words, &keyword, n)?
                .iter()
                .for_each(|face| file.polygons.push(face)),
            "Tetrahedra" => file
                .tetrahedra
                .extend(elements::<4>(&mut words, &keyword, n)?),
            "Hexahedra" => file
                .hexahedra
                .extend(elements::<8>(&mut words, &keyword, n)?),
            "Prisms" => elements::<6>(&mut words, &keyword, n)?
                .into_iter()
                .for_each(|cell| file.polyhedra.push_prism(cell)),
            "Pyramids" => elements::<5>(&mut words, &keyword, n)?
                .into_iter()
                .for_each(|cell| file.polyhedra.push_pyramid(cell)),
            "Corners"
            | "RequiredVertices"
            | "Ridges"
            | "RequiredEdges"
            | "RequiredTriangles"
            | "RequiredQuadrilaterals" => skip(&mut words, &keyword, 1)?,
            "Normals" | "Tangents" => skip(&mut words, &keyword, 3)?,
            "NormalAtVertices" | "TangentAtVertices" => skip(&mut words, &keyword, 2)?,
            "End" => return Ok(file),
            _ if is_of_higher_order(&keyword) => {
                let problem = format!("`{}` are not of first order", shorten(&keyword));
                return Err(words.error(problem, FIRST_ORDER));
            }
            _ => {
                let problem = format!("there is no list `{}`", shorten(&keyword));
                return Err(
                    words.error(problem, "remove it, or check the number of entries before")
                );
            }
        }
    }
    Ok(file)
}

/// Whether a list is one of elements with more vertices than corners, such as `TetrahedraP2` and `HexahedraQ3`.
fn is_of_higher_order(keyword: &str) -> bool {
    let kinds = [
        "Edges",
        "Triangles",
        "Quadrilaterals",
        "Tetrahedra",
        "Hexahedra",
        "Prisms",
        "Pyramids",
    ];
    kinds.iter().any(|kind| {
        let order = keyword.strip_prefix(kind).map(str::as_bytes);
        matches!(order, Some([b'P' | b'Q', b'2'..=b'9']))
    })
}

fn skip(words: &mut Stream, list: &str, length: usize) -> Result<(), Malformed> {
    let count = count(words, list, length)?;
    for _ in 0..count * length {
        words.number("an entry")?;
    }
    Ok(())
}

/// The lists of edges, polygons and cells of `file`.
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
    let (mut prisms, mut pyramids) = (Vec::new(), Vec::new());
    for polyhedron in polyhedra::simple(&file.polyhedra, "MEDIT")? {
        match polyhedron {
            Simple::Prism(corners) => prisms.push(corners),
            Simple::Pyramid(corners) => pyramids.push(corners),
        }
    }
    list("Prisms", &mut prisms.iter().map(|cell| &cell[..]));
    list("Pyramids", &mut pyramids.iter().map(|cell| &cell[..]));
    text.push_str("End\n");
    Ok(text.into_bytes())
}
