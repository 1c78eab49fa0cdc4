//! Values of generated Rust as words, as the interpreter's are written.

use iheartmesh::{Cell, Edge, Error, Face, Set, Vertex, glam, sprs};
use nalgebra::{DMatrix, DVector, SMatrix};

/// A value as words: what it is, its sizes, its entries.
pub trait Show {
    fn show(&self, text: &mut String);
}

/// The words of a value, or `fault`.
pub fn outcome<T: Show>(value: Result<T, Error>) -> String {
    let mut text = String::new();
    match value {
        Ok(value) => value.show(&mut text),
        Err(_) => text.push_str("fault"),
    }
    text.trim_end().to_owned()
}

/// A sparse matrix by its entries.
pub fn sparse(n: usize, entries: &[(usize, usize, f64)]) -> sprs::CsMat<f64> {
    let mut triplets = sprs::TriMat::new((n, n));
    for (i, j, entry) in entries {
        triplets.add_triplet(*i, *j, *entry);
    }
    triplets.to_csc()
}

fn array(rows: usize, columns: usize, entries: impl Iterator<Item = f64>, text: &mut String) {
    text.push_str(&format!("array {rows} {columns} "));
    entries.for_each(|entry| entry.show(text));
}

macro_rules! plain {
    ($($name:ty),*) => {$(
        impl Show for $name {
            fn show(&self, text: &mut String) {
                text.push_str(&format!("{self:?} "));
            }
        }
    )*};
}

plain!(f64, i64);

macro_rules! elements {
    ($($name:ty),*) => {$(
        impl Show for $name {
            fn show(&self, text: &mut String) {
                text.push_str(&format!("#{} ", self.index()));
            }
        }
    )*};
}

elements!(Vertex, Edge, Face, Cell);

macro_rules! small {
    ($($vector:ty, $matrix:ty, $n:literal;)*) => {$(
        impl Show for $vector {
            fn show(&self, text: &mut String) {
                array($n, 1, self.to_array().into_iter(), text);
            }
        }

        impl Show for $matrix {
            fn show(&self, text: &mut String) {
                array($n, $n, self.to_cols_array().into_iter(), text);
            }
        }
    )*};
}

small! {
    glam::DVec2, glam::DMat2, 2;
    glam::DVec3, glam::DMat3, 3;
    glam::DVec4, glam::DMat4, 4;
}

impl<const R: usize, const C: usize> Show for SMatrix<f64, R, C> {
    fn show(&self, text: &mut String) {
        array(R, C, self.iter().copied(), text);
    }
}

impl Show for DVector<f64> {
    fn show(&self, text: &mut String) {
        array(self.len(), 1, self.iter().copied(), text);
    }
}

impl Show for DMatrix<f64> {
    fn show(&self, text: &mut String) {
        array(self.nrows(), self.ncols(), self.iter().copied(), text);
    }
}

impl Show for sprs::CsMat<f64> {
    fn show(&self, text: &mut String) {
        let (rows, columns) = self.shape();
        let places = (0..columns).flat_map(|j| (0..rows).map(move |i| (i, j)));
        let entries = places.map(|(i, j)| self.get(i, j).copied().unwrap_or(0.0));
        array(rows, columns, entries, text);
    }
}

impl<T: Show> Show for Vec<T> {
    fn show(&self, text: &mut String) {
        text.push_str(&format!("sequence {} ", self.len()));
        self.iter().for_each(|item| item.show(text));
    }
}

impl<T: Show> Show for Set<T> {
    fn show(&self, text: &mut String) {
        text.push_str(&format!("set {} ", self.len()));
        self.iter().for_each(|item| item.show(text));
    }
}

impl<A: Show, B: Show> Show for (A, B) {
    fn show(&self, text: &mut String) {
        text.push_str("tuple 2 ");
        self.0.show(text);
        self.1.show(text);
    }
}
