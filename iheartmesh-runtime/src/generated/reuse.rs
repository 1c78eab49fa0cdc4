//! Memory that is used again.

use nalgebra::{DMatrix, DVector};
use sprs::CsMat;

use super::Pattern;

/// A value whose memory can hold another of the same size.
pub trait Reuse {
    /// Takes over a value: in the memory that there is, if the size and the pattern agree.
    fn assign(&mut self, value: &Self);

    /// The entries, all 0, in the size and the places of this pattern.
    fn entries_of(&mut self, pattern: &Pattern) -> &mut [f64];
}

impl Reuse for DVector<f64> {
    fn assign(&mut self, value: &Self) {
        match self.shape() == value.shape() {
            true => self.copy_from(value),
            false => self.clone_from(value),
        }
    }

    fn entries_of(&mut self, pattern: &Pattern) -> &mut [f64] {
        match self.len() == pattern.rows() {
            true => self.fill(0.0),
            false => *self = Self::zeros(pattern.rows()),
        }
        self.as_mut_slice()
    }
}

impl Reuse for DMatrix<f64> {
    fn assign(&mut self, value: &Self) {
        match self.shape() == value.shape() {
            true => self.copy_from(value),
            false => self.clone_from(value),
        }
    }

    fn entries_of(&mut self, pattern: &Pattern) -> &mut [f64] {
        let (rows, columns) = (pattern.rows(), pattern.columns());
        match self.shape() == (rows, columns) {
            true => self.fill(0.0),
            false => *self = Self::zeros(rows, columns),
        }
        self.as_mut_slice()
    }
}

impl Reuse for CsMat<f64> {
    fn assign(&mut self, value: &Self) {
        let same = self.storage() == value.storage()
            && self.shape() == value.shape()
            && self.indices() == value.indices()
            && self.indptr() == value.indptr();
        match same {
            true => self.data_mut().copy_from_slice(value.data()),
            false => self.clone_from(value),
        }
    }

    fn entries_of(&mut self, pattern: &Pattern) -> &mut [f64] {
        match pattern.is_of(self) {
            true => self.data_mut().fill(0.0),
            false => *self = pattern.matrix(vec![0.0; pattern.entries()]),
        }
        self.data_mut()
    }
}
