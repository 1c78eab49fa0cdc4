//! Memory that is used again.

use nalgebra::{DMatrix, DVector};
use sprs::CsMat;

use super::Slots;

/// A value whose memory can hold another of the same size.
pub trait Reuse {
    /// Takes over a value: in the memory that there is, if the size and the pattern agree.
    fn assign(&mut self, value: &Self);

    /// The entries, all 0, in the size and the pattern of these slots.
    fn entries_of(&mut self, slots: &Slots) -> &mut [f64];
}

impl Reuse for DVector<f64> {
    fn assign(&mut self, value: &Self) {
        match self.shape() == value.shape() {
            true => self.copy_from(value),
            false => self.clone_from(value),
        }
    }

    fn entries_of(&mut self, slots: &Slots) -> &mut [f64] {
        match self.len() == slots.rows() {
            true => self.fill(0.0),
            false => *self = Self::zeros(slots.rows()),
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

    fn entries_of(&mut self, slots: &Slots) -> &mut [f64] {
        let (rows, columns) = (slots.rows(), slots.columns());
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

    fn entries_of(&mut self, slots: &Slots) -> &mut [f64] {
        match slots.is_pattern_of(self) {
            true => self.data_mut().fill(0.0),
            false => *self = slots.matrix(vec![0.0; slots.entries()]),
        }
        self.data_mut()
    }
}
