//! Chains: sparse vectors over the elements of one kind, and their products with boundary matrices.

use nalgebra::DVector;
use sprs::{CsMat, TriMat};

use super::Ids;
use crate::complex::CellComplex;

/// A sparse vector with integer entries, by ascending element; zeros may be stored.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chain {
    entries: Vec<(u32, i64)>,
}

impl Chain {
    /// 1 at the members of a set. Source: *I♥MESH*, algorithm 1.
    pub fn indicator(set: &[u32]) -> Self {
        Self {
            entries: set.iter().map(|id| (*id, 1)).collect(),
        }
    }

    /// The product of a boundary matrix and a chain, by columns of the matrix.
    pub fn product(
        complex: &CellComplex,
        k: usize,
        signed: bool,
        transposed: bool,
        chain: &Chain,
    ) -> Self {
        let mut terms: Vec<(u32, i64)> = Vec::new();
        for &(id, value) in &chain.entries {
            let (ids, signs) = match transposed {
                false => complex.boundary_column(k, id as usize),
                true => complex.coboundary_column(k, id as usize),
            };
            for (id, sign) in ids.iter().zip(signs) {
                let entry = if signed { i64::from(*sign) } else { 1 };
                terms.push((*id, entry * value));
            }
        }
        terms.sort_unstable_by_key(|(id, _)| *id);
        terms.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1 += next.1;
            }
            same
        });
        Self { entries: terms }
    }

    /// The elements with an entry other than 0, ascending. Source: *I♥MESH*, algorithm 2.
    pub fn non_zeros(&self) -> Ids {
        self.entries
            .iter()
            .filter(|(_, v)| *v != 0)
            .map(|(id, _)| *id)
            .collect()
    }

    /// Of all `n` elements those with this entry, ascending.
    pub fn where_equal(&self, value: i64, n: usize) -> Ids {
        if value == 0 {
            let mut others = self.entries.iter().filter(|(_, v)| *v != 0).peekable();
            let mut is_other = |id: &u32| others.next_if(|(other, _)| other == id).is_some();
            return (0..n as u32).filter(|id| !is_other(id)).collect();
        }
        self.entries
            .iter()
            .filter(|(_, v)| *v == value)
            .map(|(id, _)| *id)
            .collect()
    }
}

/// A chain as an `n` × 1 matrix.
pub fn chain_as_matrix(chain: &Chain, n: usize) -> CsMat<f64> {
    let mut triplets = TriMat::new((n, 1));
    for (id, value) in &chain.entries {
        if *value != 0 {
            triplets.add_triplet(*id as usize, 0, *value as f64);
        }
    }
    triplets.to_csc()
}

/// A chain as a vector with an entry for each of `n` elements.
pub fn chain_as_vector(chain: &Chain, n: usize) -> DVector<f64> {
    let mut vector = DVector::zeros(n);
    for &(id, value) in &chain.entries {
        vector[id as usize] = value as f64;
    }
    vector
}

/// A boundary matrix with real entries.
pub fn boundary_as_matrix(
    complex: &CellComplex,
    k: usize,
    signed: bool,
    transposed: bool,
) -> CsMat<f64> {
    let (rows, columns) = match transposed {
        false => (complex.n(k - 1), complex.n(k)),
        true => (complex.n(k), complex.n(k - 1)),
    };
    let mut starts = Vec::with_capacity(columns + 1);
    let (mut indices, mut entries) = (Vec::new(), Vec::new());
    starts.push(0);
    for column in 0..columns {
        let (ids, signs) = match transposed {
            false => complex.boundary_column(k, column),
            true => complex.coboundary_column(k, column),
        };
        indices.extend(ids.iter().map(|id| *id as usize));
        entries.extend(
            signs
                .iter()
                .map(|sign| if signed { f64::from(*sign) } else { 1.0 }),
        );
        starts.push(indices.len());
    }
    CsMat::new_csc((rows, columns), starts, indices, entries)
}
