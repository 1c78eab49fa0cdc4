//! Mesh files: OBJ, OFF and PLY, chosen by the extension of the file name.
//!
//! ```no_run
//! use iheartmesh_runtime::io::{self, Attributes};
//!
//! let file = io::read("meshes/spot.ply")?;
//! let mesh = file.face_mesh()?;
//! let valence: Vec<f64> = mesh.vertices().map(|v| mesh.vertex_edges(v).len() as f64).collect();
//! let attributes = Attributes::new().vertex_scalar("valence", valence);
//! io::write("valence.ply", &file.positions, &mesh, &attributes)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | format | read | written |
//! | --- | --- | --- |
//! | OBJ | positions, polygons, vertex colours | the same |
//! | OFF | positions, polygons, vertex and face colours, vertex normals | the same |
//! | PLY | text and binary: positions, polygons, all values on vertices and faces | the same, binary |
//!
//! Vertices and faces keep their order, vertices that no face names are kept, polygons are not split, and positions are
//! read as `f64`. A file that is not what its format demands is an [`IoError`] with the place; memory stays within a
//! small multiple of the size of the file.

mod attributes;
mod error;
mod mesh_file;
mod obj;
mod off;
mod ply;
mod text;

use std::path::Path;

use glam::DVec3;

pub use attributes::{Attribute, AttributeValues, Attributes};
pub use error::{IoError, Place};
pub use mesh_file::{FaceList, MeshFile, Polygons, PolygonsIter};

use crate::element::ElementKind;
use error::{CannotWrite, counted};

#[derive(Clone, Copy)]
enum Format {
    Obj,
    Off,
    Ply,
}

impl Format {
    fn of(path: &Path) -> Result<Format, IoError> {
        let extension = path
            .extension()
            .unwrap_or_default()
            .to_string_lossy()
            .to_ascii_lowercase();
        match extension.as_str() {
            "obj" => Ok(Format::Obj),
            "off" => Ok(Format::Off),
            "ply" => Ok(Format::Ply),
            _ => Err(IoError::UnknownFormat {
                path: path.to_owned(),
            }),
        }
    }
}

/// Reads a mesh file. The extension of `path` (`.obj`, `.off` or `.ply`, in any case) chooses the format.
///
/// # Errors
/// [`IoError::UnknownFormat`] for another extension, [`IoError::File`] if the file cannot be read,
/// [`IoError::Malformed`] with the place if its contents are wrong.
pub fn read(path: impl AsRef<Path>) -> Result<MeshFile, IoError> {
    let path = path.as_ref();
    Format::of(path)?;
    let bytes = std::fs::read(path).map_err(|source| IoError::File {
        path: path.to_owned(),
        source,
    })?;
    from_bytes(path, &bytes)
}

/// Reads the contents of a mesh file from memory. `path` chooses the format and stands in errors; it is not opened.
///
/// # Errors
/// As [`read`], without [`IoError::File`].
pub fn from_bytes(path: impl AsRef<Path>, bytes: &[u8]) -> Result<MeshFile, IoError> {
    let path = path.as_ref();
    // Names and comments may be in any encoding; what matters is ASCII.
    let text = || String::from_utf8_lossy(bytes);
    match Format::of(path)? {
        Format::Obj => obj::read(&text()),
        Format::Off => off::read(&text()),
        Format::Ply => ply::read(bytes),
    }
    .map_err(|malformed| malformed.in_file(path))
}

/// Writes a mesh file. The extension of `path` (`.obj`, `.off` or `.ply`, in any case) chooses the format.
///
/// `positions` has one entry for each vertex; `faces` is a [`FaceMesh`](crate::FaceMesh), [`Polygons`] or a list of
/// triangles. Reading the file back gives the same numbers, bit by bit (colours in OBJ excepted: they are fractions).
///
/// # Errors
/// [`IoError::UnknownFormat`] for another extension, [`IoError::File`] if the file cannot be written, and
/// [`IoError::CannotWrite`] if a face names a vertex without a position, a position is not finite, an attribute has
/// another number of values than there are elements, or the format cannot hold it. Then no file is made.
pub fn write(
    path: impl AsRef<Path>,
    positions: &[DVec3],
    faces: &(impl FaceList + ?Sized),
    attributes: &Attributes,
) -> Result<(), IoError> {
    let path = path.as_ref();
    let bytes = to_bytes(path, positions, faces, attributes)?;
    std::fs::write(path, bytes).map_err(|source| IoError::File {
        path: path.to_owned(),
        source,
    })
}

/// The contents that [`write()`] gives the file `path`, in memory.
///
/// # Errors
/// As [`write()`], without [`IoError::File`].
pub fn to_bytes(
    path: impl AsRef<Path>,
    positions: &[DVec3],
    faces: &(impl FaceList + ?Sized),
    attributes: &Attributes,
) -> Result<Vec<u8>, IoError> {
    let path = path.as_ref();
    let format = Format::of(path)?;
    check(positions, faces, attributes)
        .and_then(|()| match format {
            Format::Obj => obj::write(positions, faces, attributes),
            Format::Off => off::write(positions, faces, attributes),
            Format::Ply => ply::write(positions, faces, attributes),
        })
        .map_err(|cannot| cannot.about(path))
}

fn check(
    positions: &[DVec3],
    faces: &(impl FaceList + ?Sized),
    attributes: &Attributes,
) -> Result<(), CannotWrite> {
    if let Some(n_vertices) = faces
        .n_vertices()
        .filter(|&n_vertices| n_vertices != positions.len())
    {
        let problem = format!(
            "{} positions for {}",
            positions.len(),
            counted(n_vertices, ElementKind::Vertex)
        );
        return Err(CannotWrite {
            problem,
            help: "give one for each",
        });
    }
    if let Some(vertex) = positions.iter().position(|position| !position.is_finite()) {
        let problem = format!("the position of vertex {vertex} is not finite");
        return Err(CannotWrite {
            problem,
            help: "positions are real numbers",
        });
    }
    for face in 0..faces.n_faces() {
        if let Some(vertex) = faces
            .corners(face)
            .iter()
            .find(|&&vertex| vertex as usize >= positions.len())
        {
            let problem = format!(
                "face {face} names vertex {vertex}, but there are {} positions",
                positions.len()
            );
            return Err(CannotWrite {
                problem,
                help: "vertices are numbered from 0",
            });
        }
    }
    for attribute in attributes {
        let expected = if attribute.element == ElementKind::Vertex {
            positions.len()
        } else {
            faces.n_faces()
        };
        if attribute.values.len() != expected {
            let problem = format!(
                "the attribute `{}` has {} values for {}",
                attribute.name,
                attribute.values.len(),
                counted(expected, attribute.element)
            );
            return Err(CannotWrite {
                problem,
                help: "give one for each",
            });
        }
    }
    Ok(())
}
