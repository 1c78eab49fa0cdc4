//! What every example shares: pictures of meshes, generated meshes, timing.

// Every example that includes this module uses only a part of it.
#![allow(dead_code, unused_imports)]

pub mod animation;
pub mod bar;
pub mod checkerboard;
pub mod colour;
pub mod disk;
pub mod generate;
mod lettering;
pub mod picture;
pub mod plot;
pub mod raster;
pub mod springs;
pub mod surface;
pub mod tetrahedra;
pub mod timing;
pub mod wave;
