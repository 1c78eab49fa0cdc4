//! Small programs of linear algebra against values that NumPy and SciPy computed, with and without optimisations.
//! `make.py` writes `programs.rs` from `programs.py`.

#![allow(
    deprecated,
    reason = "a program that is warned about, since `T` is a name in it"
)]
#![allow(
    clippy::approx_constant,
    reason = "values are written as they were computed"
)]
#![allow(uncommon_codepoints, reason = "the Greek letters of a program")]

use iheartmesh::Set;
use iheartmesh::glam::{DMat2, DMat3, DMat4, DVec2, DVec3, DVec4};
use iheartmesh::nalgebra::{
    DMatrix, DVector, Dim, IsContiguous, Matrix, RawStorage, SMatrix, SVector,
};
use iheartmesh::sprs::{CsMat, TriMat};

#[macro_use]
#[path = "../support/twice.rs"]
mod twice;

include!("programs.rs");

/// The numbers of a value, arrays by columns.
trait Numbers {
    fn numbers(&self) -> Vec<f64>;
}

impl Numbers for f64 {
    fn numbers(&self) -> Vec<f64> {
        vec![*self]
    }
}

impl Numbers for i64 {
    fn numbers(&self) -> Vec<f64> {
        vec![*self as f64]
    }
}

macro_rules! of_glam {
    ($($ty:ty, $array:ident;)*) => {
        $(impl Numbers for $ty {
            fn numbers(&self) -> Vec<f64> {
                self.$array().to_vec()
            }
        })*
    };
}

of_glam! {
    DVec2, to_array;
    DVec3, to_array;
    DVec4, to_array;
    DMat2, to_cols_array;
    DMat3, to_cols_array;
    DMat4, to_cols_array;
}

impl<T: Numbers, R: Dim, C: Dim, S: RawStorage<T, R, C> + IsContiguous> Numbers
    for Matrix<T, R, C, S>
{
    fn numbers(&self) -> Vec<f64> {
        self.iter().flat_map(Numbers::numbers).collect()
    }
}

impl Numbers for CsMat<f64> {
    fn numbers(&self) -> Vec<f64> {
        let mut dense = DMatrix::zeros(self.rows(), self.cols());
        for (value, (i, j)) in self.iter() {
            dense[(i, j)] = *value;
        }
        dense.numbers()
    }
}

impl<T: Numbers> Numbers for Vec<T> {
    fn numbers(&self) -> Vec<f64> {
        self.iter().flat_map(Numbers::numbers).collect()
    }
}

impl<T: Numbers> Numbers for Set<T> {
    fn numbers(&self) -> Vec<f64> {
        self.as_slice().iter().flat_map(Numbers::numbers).collect()
    }
}

fn check(name: &str, found: &impl Numbers, expected: &[f64]) {
    let found = found.numbers();
    let close = |(a, b): (&f64, &f64)| a == b || (a - b).abs() <= 1e-6 * (1.0 + b.abs());
    assert!(
        found.len() == expected.len() && found.iter().zip(expected).all(close),
        "{name}: {found:?} instead of {expected:?}"
    );
}

fn sparse(rows: usize, columns: usize, entries: &[(usize, usize, f64)]) -> CsMat<f64> {
    let mut triplets = TriMat::new((rows, columns));
    for &(i, j, value) in entries {
        triplets.add_triplet(i, j, value);
    }
    triplets.to_csc()
}
