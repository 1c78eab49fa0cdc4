//! VTK (`.vtk`, the legacy format) for ParaView: positions, edges, polygons, tetrahedra, hexahedra, polyhedra, and all values
//! on vertices, edges, faces and cells.
//!
//! Written as text of version 3.0: one unstructured grid that holds all elements, so that values that belong to elements of
//! one kind are `nan` on the others, and colours grey. Values of the same name and form on several kinds are one array; otherwise
//! values of one name are refused, since VTK keeps one array of each.
//!
//! Read are unstructured grids and polygonal data in text and binary, of versions 1 to 5. Read here and not by a library: the maintained one
//! (`vtkio`) does not tell where a file is wrong and takes no `nan`, and with it no file that is written here.
//!
//! | in the file | becomes |
//! | --- | --- |
//! | lines, polylines | edges |
//! | triangles, quadrilaterals, pixels, polygons, triangle strips | polygons |
//! | tetrahedra | tetrahedra |
//! | hexahedra, voxels | hexahedra |
//! | wedges, pyramids, pentagonal and hexagonal prisms, polyhedra | polyhedra |
//! | vertices | nothing: they are positions |
//! | scalars with one component | scalar |
//! | vectors, normals, scalars and arrays of a field with three components | vector |
//! | colours, unsigned bytes with three or four components | colours, without the opacity |
//! | other values with `n` components, named `P` | scalars `P_0` to `P_(n−1)` |
//!
//! Values of VTK's cells are split by kind of element; a kind on which all are `nan` (or colours grey) has none.
//!
//! Prisms and pyramids are written as such if their faces stand in the order of `push_prism` and `push_pyramid`, so that they are
//! read again as they were; all others as polyhedra. VTK has two orders of the corners of wedges, see `wedges`.
//!
//! In names, blanks and the signs `%` and `"` are written as VTK does, `%20`, `%25` and `%22`.
//!
//! Fields that do not belong to elements, lookup tables and metadata are skipped.

mod cells;
mod read;
mod values;
mod wedges;
mod write;

pub(super) use read::read;
pub(super) use write::write;

/// The numbers by which VTK knows cells.
const VERTEX: u8 = 1;
const POLY_VERTEX: u8 = 2;
const LINE: u8 = 3;
const POLY_LINE: u8 = 4;
const TRIANGLE: u8 = 5;
const TRIANGLE_STRIP: u8 = 6;
const POLYGON: u8 = 7;
const PIXEL: u8 = 8;
const QUADRILATERAL: u8 = 9;
const TETRAHEDRON: u8 = 10;
const VOXEL: u8 = 11;
const HEXAHEDRON: u8 = 12;
const WEDGE: u8 = 13;
const PYRAMID: u8 = 14;
const PENTAGONAL_PRISM: u8 = 15;
const HEXAGONAL_PRISM: u8 = 16;
const CONVEX_POINT_SET: u8 = 41;
const POLYHEDRON: u8 = 42;

/// The colour of elements without one.
const NO_COLOR: [u8; 3] = [128; 3];
