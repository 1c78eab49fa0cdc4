//! Numbers, vectors and matrices of any size through one interface, so that generated code is the same for all of them.
//!
//! Sizes that are known when the program is compiled are types without allocation (glam up to 4, then nalgebra);
//! others are nalgebra's dynamic vectors and matrices.

use std::ops::{Add, AddAssign, Mul};

use glam::{DMat2, DMat3, DMat4, DVec2, DVec3, DVec4};
use nalgebra::{DMatrix, DVector, SMatrix, Scalar};

/// ℝ or ℤ as entries.
pub trait Number:
    Scalar + Copy + Default + PartialOrd + Add<Output = Self> + Mul<Output = Self> + AddAssign
{
    /// As a real number.
    fn real(self) -> f64;
}

impl Number for f64 {
    #[inline(always)]
    fn real(self) -> f64 {
        self
    }
}

impl Number for i64 {
    #[inline(always)]
    fn real(self) -> f64 {
        self as f64
    }
}

/// Rows and columns of numbers: a number is 1×1, a vector has one column.
pub trait Array {
    /// What the entries are.
    type Item: Number;
    /// Number of rows.
    fn rows(&self) -> usize;
    /// Number of columns.
    fn columns(&self) -> usize;
    /// An entry, from 0. Must be in range.
    fn entry(&self, row: usize, column: usize) -> Self::Item;

    /// Whether entries that are 0 are left out where they can be.
    const SPARSE: bool = false;

    /// Calls `f` with the row, the column and the value of each entry, column by column; those that are not stored are
    /// 0 and left out.
    #[inline(always)]
    fn each(&self, mut f: impl FnMut(usize, usize, Self::Item)) {
        for column in 0..self.columns() {
            for row in 0..self.rows() {
                f(row, column, self.entry(row, column));
            }
        }
    }
}

/// What can be made entry by entry.
pub trait Build: Array + Sized {
    /// All entries 0. Sizes that the type fixes are not looked at.
    fn zeros(rows: usize, columns: usize) -> Self;
    /// Sets an entry, from 0. Must be in range.
    fn set(&mut self, row: usize, column: usize, value: Self::Item);

    /// By its entries.
    #[inline(always)]
    fn build(rows: usize, columns: usize, f: impl Fn(usize, usize) -> Self::Item) -> Self {
        let mut all = Self::zeros(rows, columns);
        for column in 0..all.columns() {
            for row in 0..all.rows() {
                all.set(row, column, f(row, column));
            }
        }
        all
    }
}

macro_rules! number {
    ($type:ty) => {
        impl Array for $type {
            type Item = $type;
            #[inline(always)]
            fn rows(&self) -> usize {
                1
            }
            #[inline(always)]
            fn columns(&self) -> usize {
                1
            }
            #[inline(always)]
            fn entry(&self, _: usize, _: usize) -> $type {
                *self
            }
        }

        impl Build for $type {
            #[inline(always)]
            fn zeros(_: usize, _: usize) -> Self {
                <$type>::default()
            }
            #[inline(always)]
            fn set(&mut self, _: usize, _: usize, value: $type) {
                *self = value;
            }
        }
    };
}

number!(f64);
number!(i64);

macro_rules! small {
    ($vector:ty, $matrix:ty, $n:literal) => {
        impl Array for $vector {
            type Item = f64;
            #[inline(always)]
            fn rows(&self) -> usize {
                $n
            }
            #[inline(always)]
            fn columns(&self) -> usize {
                1
            }
            #[inline(always)]
            fn entry(&self, row: usize, _: usize) -> f64 {
                self[row]
            }
        }

        impl Build for $vector {
            #[inline(always)]
            fn zeros(_: usize, _: usize) -> Self {
                Self::ZERO
            }
            #[inline(always)]
            fn set(&mut self, row: usize, _: usize, value: f64) {
                self[row] = value;
            }
        }

        impl Array for $matrix {
            type Item = f64;
            #[inline(always)]
            fn rows(&self) -> usize {
                $n
            }
            #[inline(always)]
            fn columns(&self) -> usize {
                $n
            }
            #[inline(always)]
            fn entry(&self, row: usize, column: usize) -> f64 {
                self.col(column)[row]
            }
        }

        impl Build for $matrix {
            #[inline(always)]
            fn zeros(_: usize, _: usize) -> Self {
                Self::ZERO
            }
            #[inline(always)]
            fn set(&mut self, row: usize, column: usize, value: f64) {
                self.col_mut(column)[row] = value;
            }
        }
    };
}

small!(DVec2, DMat2, 2);
small!(DVec3, DMat3, 3);
small!(DVec4, DMat4, 4);

impl<T: Number, const R: usize, const C: usize> Array for SMatrix<T, R, C> {
    type Item = T;
    #[inline(always)]
    fn rows(&self) -> usize {
        R
    }
    #[inline(always)]
    fn columns(&self) -> usize {
        C
    }
    #[inline(always)]
    fn entry(&self, row: usize, column: usize) -> T {
        self[(row, column)]
    }
}

impl<T: Number, const R: usize, const C: usize> Build for SMatrix<T, R, C> {
    #[inline(always)]
    fn zeros(_: usize, _: usize) -> Self {
        Self::from_element(T::default())
    }
    #[inline(always)]
    fn set(&mut self, row: usize, column: usize, value: T) {
        self[(row, column)] = value;
    }
}

impl<T: Number> Array for DVector<T> {
    type Item = T;
    #[inline(always)]
    fn rows(&self) -> usize {
        self.len()
    }
    #[inline(always)]
    fn columns(&self) -> usize {
        1
    }
    #[inline(always)]
    fn entry(&self, row: usize, _: usize) -> T {
        self[row]
    }
}

impl<T: Number> Build for DVector<T> {
    fn zeros(rows: usize, _: usize) -> Self {
        Self::from_element(rows, T::default())
    }
    #[inline(always)]
    fn set(&mut self, row: usize, _: usize, value: T) {
        self[row] = value;
    }
}

impl<T: Number> Array for DMatrix<T> {
    type Item = T;
    #[inline(always)]
    fn rows(&self) -> usize {
        self.nrows()
    }
    #[inline(always)]
    fn columns(&self) -> usize {
        self.ncols()
    }
    #[inline(always)]
    fn entry(&self, row: usize, column: usize) -> T {
        self[(row, column)]
    }
}

impl<T: Number> Build for DMatrix<T> {
    fn zeros(rows: usize, columns: usize) -> Self {
        Self::from_element(rows, columns, T::default())
    }
    #[inline(always)]
    fn set(&mut self, row: usize, column: usize, value: T) {
        self[(row, column)] = value;
    }
}

impl Array for sprs::CsMat<f64> {
    type Item = f64;
    fn rows(&self) -> usize {
        sprs::CsMatBase::rows(self)
    }
    fn columns(&self) -> usize {
        self.cols()
    }
    fn entry(&self, row: usize, column: usize) -> f64 {
        self.get(row, column).copied().unwrap_or(0.0)
    }

    const SPARSE: bool = true;

    fn each(&self, mut f: impl FnMut(usize, usize, f64)) {
        for (entry, (row, column)) in self {
            f(row, column, *entry);
        }
    }
}

impl Build for sprs::CsMat<f64> {
    fn zeros(rows: usize, columns: usize) -> Self {
        sprs::CsMat::zero((rows, columns)).into_csc()
    }

    /// A 0 is not stored where nothing is.
    fn set(&mut self, row: usize, column: usize, value: f64) {
        if value != 0.0 || self.get(row, column).is_some() {
            self.insert(row, column, value);
        }
    }
}

/// A dynamic column of real numbers.
pub type Column = DVector<f64>;
