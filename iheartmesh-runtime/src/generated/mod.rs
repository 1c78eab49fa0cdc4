//! What generated code calls. No part of the public interface: it changes with the compiler.

mod all;
mod array;
mod assemble;
mod chain;
mod check;
mod corners;
mod dense;
mod fault;
mod host;
mod ids;
mod in_order;
mod keys;
mod lanes;
mod linear;
mod local;
mod local_block;
mod local_matrix;
mod local_rows;
mod missing;
mod optimum;
mod orbit;
mod pattern;
mod pending;
mod places;
mod power;
mod quadrature;
mod reuse;
mod slots;
mod sparse;
mod sparse_lu;
mod spectrum;
mod steps;
mod symmetric;
mod table;
mod touch;
mod tridiagonal;

pub use all::{Whole, for_each_element, for_each_of, in_chunks, total};
pub use array::*;
pub use assemble::*;
pub use chain::{Chain, boundary_as_matrix, chain_as_matrix, chain_as_vector};
pub use check::{
    Shown, check_argument, check_cellular_set, check_element_in, check_in, check_item_size,
    check_length, check_member, check_pairs, check_quotient, check_quotient_size,
    check_same_length, check_set_argument, check_size, check_tied, fail, known_size, undefined,
};
pub use corners::corners;
pub use dense::*;
pub use fault::{
    Fallible, Fault, PlanError, Recursion, at, encoded, entry, entry_mut, integer, integers,
    is_greater, is_less, sized,
};
pub use host::HostCounted;
pub use ids::{
    Ids, all, boundary_of, cellular_set, coboundary_of, copied, difference, ids_of_cellular_set,
    ids_of_set, intersection, set_of_handles, singleton, sorted, union, without,
};
pub use keys::Keys;
pub use linear::*;
pub use local::Locals;
pub use local_block::LocalBlock;
pub use missing::{FIRST_MISSING, NO_ELEMENT, element, is_missing, missing, of_element, rounds};
pub use optimum::{Coordinates, Domain, Optimum, Reasons, Restrictions};
pub use orbit::{Grouped, Orbits};
pub use pattern::Pattern;
pub use places::{Layout, Places};
pub use power::power;
pub use quadrature::integral;
pub use reuse::Reuse;
pub use slots::{Planned, Slots, Terms};
pub use sparse::*;
pub use spectrum::{Part, is_positive_semidefinite};
pub use steps::{
    Faces, beside_in_face, closed_ring, edge_between, face_beside, faces_of_vertex, first_common,
    vertices_of_face, with_signs,
};
pub use table::{Dense, Rows, Table, concatenated};
pub use touch::{Touch, touch};

pub use crate::element::ElementKind;

/// Stands in a row where an integer is missing.
pub const NO_INTEGER: u32 = 0x8000_0000;
