//! From programs to text in other languages.

pub mod rust;
