//! The compiler of I♥MESH: one plain library function for each stage.

pub mod diagnostic;
pub mod source;
pub mod span;
pub mod syntax;
