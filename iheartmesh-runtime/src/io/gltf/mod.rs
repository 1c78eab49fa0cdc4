//! glTF 2.0 (`.gltf`, `.glb`) with the feature `gltf`: positions, triangles, edges, and values on vertices.
//!
//! Containers and JSON are parsed and written by the crate `gltf`, without its checks, which panic where a primitive names
//! an accessor that is not there; buffers are read here, with bounds.
//!
//! | in the file | becomes |
//! | --- | --- |
//! | triangles, strips, fans | triangles |
//! | lines, line strips, line loops | edges |
//! | `POSITION` | positions, placed by the nodes of the scene |
//! | `NORMAL` | vector `normal`, turned by the nodes |
//! | `COLOR_0` | colours, without the opacity |
//! | `_P` | scalar or vector `P`; with two or four components scalars `P_0`, `P_1`, … |
//!
//! The meshes of the scene (the default one or the first; without any, all meshes) follow one another. What only some of them have is
//! NaN on the others, or white. Vertices are not merged: programs write a vertex several times where normals or
//! textures differ, see [`MeshFile::merge_equal_positions`](super::MeshFile::merge_equal_positions).
//! Materials, textures, skins, animations and morph targets are skipped; compressed meshes are errors.
//!
//! The format has single precision: positions and values are rounded when they are written. It holds neither values on
//! faces nor polygons that are not triangles.

mod buffers;
mod elements;
mod read;
mod write;

pub(super) use read::read;
pub(super) use write::write;
