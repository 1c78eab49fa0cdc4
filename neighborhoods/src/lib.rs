//! Neighborhoods.
