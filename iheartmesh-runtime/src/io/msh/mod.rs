//! Gmsh (`.msh`): positions, edges, triangles, quadrilaterals, tetrahedra, hexahedra, prisms, pyramids, and values on all of
//! them.
//!
//! Versions 2.2 and 4.1 are read, text and binary of either byte order; 2.2 is written, as text, since most programs read it.
//! Read here and not by a library: the one that there is (`mshio`) knows version 4.1 only, rests on parsers of
//! 2019, and panics where a file has numbers of sizes that it does not expect.
//!
//! Nodes are numbered in the order of the file, whatever tags they have; points among the elements are positions anyway and left out.
//! Physical and elementary tags, entities and names of groups are not kept. Views `$NodeData` and `$ElementData` with one component
//! are scalars, with three vectors, others as scalars `P_0`, `P_1`, …; elements without a value have NaN.

mod read;
mod views;
mod write;

pub(super) use read::read;
pub(super) use write::write;

/// The numbers by which Gmsh knows elements.
const LINE: i64 = 1;
const TRIANGLE: i64 = 2;
const QUADRILATERAL: i64 = 3;
const TETRAHEDRON: i64 = 4;
const HEXAHEDRON: i64 = 5;
const PRISM: i64 = 6;
const PYRAMID: i64 = 7;
const POINT: i64 = 15;
