//! PLY (Stanford polygon format): positions, polygons and any number of values on vertices and faces.
//!
//! Text and binary files of either byte order are read, binary little-endian files are written.
//!
//! The header and the elements of binary files are parsed by `ply-rs-bw`, one element at a time over the bytes of the
//! file, so that an error has a position and memory stays bounded by the size of the file, whatever the header
//! promises. Elements of text files are split here, since that library takes neither `1.` nor `nan` for a number.
//!
//! | properties in the file | attribute |
//! | --- | --- |
//! | `x`, `y`, `z` of `vertex` | the positions |
//! | `vertex_indices` or `vertex_index` of `face` | the polygons |
//! | `red`, `green`, `blue` of type `uchar` | colours `color` |
//! | `nx`, `ny`, `nz` | vector `normal` |
//! | `P_x`, `P_y`, `P_z` | vector `P` |
//! | any other scalar `P` | scalar `P` |
//!
//! Other lists and other elements are skipped.

mod read;
mod write;

pub(super) use read::read;
pub(super) use write::write;

use super::attributes::NORMAL;

/// The names under which the three coordinates of a vector attribute are stored.
fn coordinate_names(vector: &str) -> [String; 3] {
    if vector == NORMAL {
        ["nx", "ny", "nz"].map(str::to_owned)
    } else {
        ["x", "y", "z"].map(|axis| format!("{vector}_{axis}"))
    }
}
