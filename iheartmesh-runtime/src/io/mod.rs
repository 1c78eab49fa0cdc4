//! Mesh files: OBJ, OFF, PLY, STL, MEDIT, Gmsh, VTK and glTF, chosen by the extension of the file name.
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
//! | MEDIT (`.mesh`) | text: positions, edges, triangles, quadrilaterals, tetrahedra, hexahedra, prisms, pyramids | the same, no values |
//! | Gmsh (`.msh`) | 2.2 and 4.1, text and binary: the same, and all values | 2.2, text; no colours |
//! | VTK (`.vtk`, legacy) | text and binary: positions, edges, polygons, tetrahedra, hexahedra, all other polyhedra, all values | the same, text |
//! | STL | text and binary: triangles, with normals; equal corners become one vertex | the same, binary, `f32` |
//! | glTF (`.gltf`, `.glb`), with the feature `gltf` | positions, triangles, edges, values on vertices | the same, `f32` |
//!
//! Prisms and pyramids are [`Polyhedra`] that know what they are. The cells of a file are its tetrahedra, then its hexahedra,
//! then its polyhedra, each in the order of the file; [`MeshFile::cell_mesh`] numbers them so, and values are put into this
//! order. Elements of second or higher order, with vertices between their corners, are refused.
//!
//! A file without contents is refused in every format. One that says that it has no vertices, such as a PLY file with empty
//! lists or an OBJ file of comments, is an empty mesh.
//!
//! Vertices and faces keep their order (but in MEDIT triangles are written before quadrilaterals and prisms before
//! pyramids), vertices that no face names are kept, polygons are not split, and positions are read as `f64`. What a format
//! cannot hold is an error, not left out. A file that is not what its format demands is an [`IoError`] with the place;
//! memory stays within a small multiple of the size of the file.

mod attributes;
mod error;
#[cfg(feature = "gltf")]
mod gltf;
mod medit;
mod mesh_file;
mod msh;
mod obj;
mod off;
mod ply;
mod polyhedra;
mod stl;
mod stream;
mod text;
mod vtk;

use std::path::{Component, Path};

use glam::DVec3;

pub use attributes::{Attribute, AttributeValues, Attributes};
pub use error::{IoError, Place};
pub use mesh_file::{FaceList, MeshFile, Polygons, PolygonsIter};
pub use polyhedra::{Polyhedra, PolyhedraIter};

use crate::element::ElementKind;
use error::{CannotWrite, counted};

/// What to do about elements with more vertices than corners.
const FIRST_ORDER: &str = "make the mesh of first order, with vertices at the corners of elements only, and save it again";

#[derive(Clone, Copy)]
enum Format {
    Obj,
    Off,
    Ply,
    #[cfg(feature = "gltf")]
    Gltf,
    #[cfg(feature = "gltf")]
    Glb,
    Medit,
    Msh,
    Stl,
    Vtk,
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
            #[cfg(feature = "gltf")]
            "gltf" => Ok(Format::Gltf),
            #[cfg(feature = "gltf")]
            "glb" => Ok(Format::Glb),
            #[cfg(not(feature = "gltf"))]
            "gltf" | "glb" => Err(IoError::MissingFeature {
                path: path.to_owned(),
                feature: "gltf",
            }),
            "mesh" => Ok(Format::Medit),
            "stl" => Ok(Format::Stl),
            "msh" => Ok(Format::Msh),
            "vtk" => Ok(Format::Vtk),
            _ => Err(IoError::UnknownFormat {
                path: path.to_owned(),
            }),
        }
    }
}

/// Reads a mesh file. The extension of `path` (in any case) chooses the format.
///
/// # Errors
/// [`IoError::UnknownFormat`] for another extension, [`IoError::MissingFeature`] for one whose format is not compiled in,
/// [`IoError::File`] if the file cannot be read, [`IoError::Malformed`] with the place if its contents are wrong.
pub fn read(path: impl AsRef<Path>) -> Result<MeshFile, IoError> {
    let path = path.as_ref();
    Format::of(path)?;
    let bytes = std::fs::read(path).map_err(|source| IoError::File {
        path: path.to_owned(),
        source,
    })?;
    parse(path, &bytes, &|name| beside(path, name))
}

/// Reads the contents of a mesh file from memory. `path` chooses the format and stands in errors; it is not opened.
///
/// # Errors
/// As [`read`], without [`IoError::File`]; also where a glTF file has data in other files.
pub fn from_bytes(path: impl AsRef<Path>, bytes: &[u8]) -> Result<MeshFile, IoError> {
    let refuse = |_: &str| Err("other files are not opened for contents in memory".to_owned());
    parse(path.as_ref(), bytes, &refuse)
}

/// A file in the folder of another one or below.
fn beside(path: &Path, name: &str) -> Result<Vec<u8>, String> {
    let is_below = |part| matches!(part, Component::Normal(_) | Component::CurDir);
    if name.contains("://") || !Path::new(name).components().all(is_below) {
        return Err("it must be in the same folder or below".to_owned());
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    std::fs::read(folder.join(name)).map_err(|cause| cause.to_string())
}

/// Reads the contents of a file; `_open` reads another one that it refers to, or says why not.
fn parse(
    path: &Path,
    bytes: &[u8],
    _open: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<MeshFile, IoError> {
    // Names and comments may be in any encoding; what matters is ASCII.
    // Some programs put the mark of UTF-8 first.
    let text = || String::from_utf8_lossy(bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes));
    match Format::of(path)? {
        Format::Obj => obj::read(&text()),
        Format::Off => off::read(&text()),
        Format::Ply => ply::read(bytes),
        #[cfg(feature = "gltf")]
        Format::Gltf | Format::Glb => gltf::read(bytes, _open),
        Format::Medit => medit::read(bytes),
        Format::Msh => msh::read(bytes),
        Format::Stl => stl::read(bytes),
        Format::Vtk => vtk::read(bytes),
    }
    .map_err(|malformed| malformed.in_file(path))
}

/// Writes a mesh file. The extension of `path` (in any case) chooses the format.
///
/// `positions` has one entry for each vertex; `faces` is a [`FaceMesh`](crate::FaceMesh), [`Polygons`] or a list of
/// triangles, with corners numbered from 0. Reading the file back gives the same numbers, bit by bit, except where the format
/// rounds: STL and glTF hold positions and values in single precision, OBJ and VTK colours as decimal fractions,
/// from which the same colours are read. STL numbers its vertices anew.
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
            Format::Stl => stl::write(positions, faces, attributes),
            #[cfg(feature = "gltf")]
            Format::Gltf => gltf::write(&collected(positions, faces, attributes), false),
            #[cfg(feature = "gltf")]
            Format::Glb => gltf::write(&collected(positions, faces, attributes), true),
            Format::Medit => medit::write(&collected(positions, faces, attributes)),
            Format::Msh => msh::write(&collected(positions, faces, attributes)),
            Format::Vtk => vtk::write(&collected(positions, faces, attributes)),
        })
        .map_err(|cannot| cannot.about(path))
}

/// Writes all of a mesh file, such as one with tetrahedra. The extension of `path` (in any case) chooses the format.
/// [`MeshFile::of_cells`] makes one of a [`CellMesh`](crate::CellMesh).
///
/// ```no_run
/// # use iheartmesh_runtime::io::{self, Attributes, MeshFile};
/// # use iheartmesh_runtime::glam::DVec3;
/// let mut file = MeshFile::of_positions([DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]);
/// file.tetrahedra.push([0, 1, 2, 3]);
/// file.attributes = Attributes::new().cell_scalar("volume", [1.0 / 6.0]);
/// io::write_file("tetrahedron.vtk", &file)?;
/// # Ok::<(), io::IoError>(())
/// ```
///
/// # Errors
/// As [`write()`]; also where the file has edges or cells and the format is OBJ, OFF, PLY or STL, which hold none, or cells
/// and it is glTF; where it has polyhedra that are neither prisms nor pyramids and the format is MEDIT or Gmsh; and where a
/// polyhedron has fewer than four faces, or one of fewer than three corners.
pub fn write_file(path: impl AsRef<Path>, file: &MeshFile) -> Result<(), IoError> {
    let path = path.as_ref();
    let bytes = file_to_bytes(path, file)?;
    std::fs::write(path, bytes).map_err(|source| IoError::File {
        path: path.to_owned(),
        source,
    })
}

/// The contents that [`write_file`] gives the file `path`, in memory.
///
/// # Errors
/// As [`write_file`], without [`IoError::File`].
pub fn file_to_bytes(path: impl AsRef<Path>, file: &MeshFile) -> Result<Vec<u8>, IoError> {
    let path = path.as_ref();
    let format = Format::of(path)?;
    let MeshFile {
        positions,
        polygons,
        attributes,
        ..
    } = file;
    check_file(file)
        .and_then(|()| match format {
            Format::Medit => medit::write(file),
            Format::Msh => msh::write(file),
            #[cfg(feature = "gltf")]
            Format::Gltf => gltf::write(file, false),
            #[cfg(feature = "gltf")]
            Format::Glb => gltf::write(file, true),
            Format::Vtk => vtk::write(file),
            _ if file.n_cells() + file.edges.len() > 0 => Err(CannotWrite {
                problem: "this format holds neither edges nor cells".to_owned(),
                help: "write a .mesh, .msh or .vtk file",
            }),
            Format::Obj => obj::write(positions, polygons, attributes),
            Format::Off => off::write(positions, polygons, attributes),
            Format::Ply => ply::write(positions, polygons, attributes),
            Format::Stl => stl::write(positions, polygons, attributes),
        })
        .map_err(|cannot| cannot.about(path))
}

fn collected(
    positions: &[DVec3],
    faces: &(impl FaceList + ?Sized),
    attributes: &Attributes,
) -> MeshFile {
    let mut file = MeshFile::of_positions(positions);
    (0..faces.n_faces()).for_each(|face| file.polygons.push(faces.corners(face)));
    file.attributes = attributes.clone();
    file
}

fn check_file(file: &MeshFile) -> Result<(), CannotWrite> {
    let n = file.positions.len();
    let n_first = file.tetrahedra.len() + file.hexahedra.len();
    let edges = file.edges.iter().map(|edge| (ElementKind::Edge, &edge[..]));
    let tetrahedra = file.tetrahedra.iter().map(|cell| &cell[..]);
    let hexahedra = file.hexahedra.iter().map(|cell| &cell[..]);
    let cells = tetrahedra.chain(hexahedra);
    let sides = file.polyhedra.iter().enumerate();
    let sides = sides.flat_map(|(index, faces)| faces.map(move |face| (n_first + index, face)));
    let all = (0..)
        .zip(edges)
        .map(|(index, (kind, edge))| (kind, index, edge));
    let cells = cells.enumerate().chain(sides);
    let all = all.chain(cells.map(|(index, cell)| (ElementKind::Cell, index, cell)));
    for (kind, index, corners) in all {
        if let Some(vertex) = corners.iter().find(|&&vertex| vertex as usize >= n) {
            let problem =
                format!("{kind} {index} names vertex {vertex}, but there are {n} positions");
            return Err(CannotWrite {
                problem,
                help: "vertices are numbered from 0",
            });
        }
    }
    for (index, faces) in file.polyhedra.iter().enumerate() {
        if let Some(problem) = polyhedra::problem(faces) {
            return Err(CannotWrite {
                problem: format!("polyhedron {index} {problem}"),
                help: polyhedra::LEAST,
            });
        }
    }
    let counts = [n, file.edges.len(), file.polygons.len(), file.n_cells()];
    check_with(&file.positions, &file.polygons, &file.attributes, counts)
}

fn check(
    positions: &[DVec3],
    faces: &(impl FaceList + ?Sized),
    attributes: &Attributes,
) -> Result<(), CannotWrite> {
    let counts = [positions.len(), 0, faces.n_faces(), 0];
    check_with(positions, faces, attributes, counts)
}

/// `counts` are the numbers of vertices, edges, faces and cells.
fn check_with(
    positions: &[DVec3],
    faces: &(impl FaceList + ?Sized),
    attributes: &Attributes,
    counts: [usize; 4],
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
        let expected = counts[match attribute.element {
            ElementKind::Vertex => 0,
            ElementKind::Edge => 1,
            ElementKind::Face => 2,
            ElementKind::Cell => 3,
        }];
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
