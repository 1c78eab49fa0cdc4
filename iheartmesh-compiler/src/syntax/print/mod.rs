//! Canonical text of a tree.
