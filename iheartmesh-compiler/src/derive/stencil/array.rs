//! Vectors and matrices of a few entries as formulas of real numbers.

use super::numbers::Numbers;
use crate::ir::ExprId;

/// A number, vector or matrix by its entries, column by column. The factor stands outside: the inverse of a matrix is
/// its adjugate times the reciprocal of its determinant.
#[derive(Clone, Debug)]
pub(super) struct Array {
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) factor: Option<ExprId>,
    pub(super) entries: Vec<ExprId>,
}

impl Array {
    pub(super) fn number(value: ExprId) -> Self {
        Self::new(1, 1, vec![value])
    }

    pub(super) fn new(rows: usize, columns: usize, entries: Vec<ExprId>) -> Self {
        Self {
            rows,
            columns,
            factor: None,
            entries,
        }
    }

    fn with(self, factor: Option<ExprId>) -> Self {
        Self { factor, ..self }
    }

    pub(super) fn at(&self, i: usize, j: usize) -> ExprId {
        self.entries[i + j * self.rows]
    }

    fn row(&self, i: usize) -> Vec<ExprId> {
        (0..self.columns).map(|j| self.at(i, j)).collect()
    }

    pub(super) fn column(&self, j: usize) -> &[ExprId] {
        &self.entries[j * self.rows..(j + 1) * self.rows]
    }

    /// The same by its entries alone.
    pub(super) fn expanded(&self, s: &mut Numbers<'_>) -> Self {
        let Some(factor) = self.factor else {
            return self.clone();
        };
        let entries = self.entries.iter().map(|e| s.multiply(factor, *e));
        Self::new(self.rows, self.columns, entries.collect())
    }

    pub(super) fn scaled(&self, s: &mut Numbers<'_>, k: ExprId) -> Self {
        match self.factor {
            Some(factor) => {
                let factor = s.multiply(factor, k);
                self.clone().with(Some(factor))
            }
            None => {
                let entries = self.entries.iter().map(|e| s.multiply(k, *e));
                Self::new(self.rows, self.columns, entries.collect())
            }
        }
    }

    pub(super) fn map(
        &self,
        s: &mut Numbers<'_>,
        f: impl Fn(&mut Numbers<'_>, ExprId) -> ExprId,
    ) -> Self {
        let all = self.expanded(s);
        let entries = all.entries.iter().map(|e| f(s, *e)).collect();
        Self::new(self.rows, self.columns, entries)
    }

    /// Entry by entry with another of the same size.
    pub(super) fn zip(
        &self,
        s: &mut Numbers<'_>,
        other: &Self,
        f: impl Fn(&mut Numbers<'_>, ExprId, ExprId) -> ExprId,
    ) -> Option<Self> {
        if self.entries.len() != other.entries.len() {
            return None;
        }
        let (a, b) = (self.expanded(s), other.expanded(s));
        let pairs = a.entries.iter().zip(&b.entries);
        let entries = pairs.map(|(a, b)| f(s, *a, *b)).collect();
        Some(Self::new(self.rows, self.columns, entries))
    }

    pub(super) fn transposed(&self) -> Self {
        let entries = (0..self.rows).flat_map(|i| self.row(i)).collect();
        Self::new(self.columns, self.rows, entries).with(self.factor)
    }

    fn factors(s: &mut Numbers<'_>, a: &Self, b: &Self) -> Option<ExprId> {
        match (a.factor, b.factor) {
            (Some(k), Some(l)) => Some(s.multiply(k, l)),
            (k, l) => k.or(l),
        }
    }

    /// The sum of the products of the entries.
    pub(super) fn inner(&self, s: &mut Numbers<'_>, other: &Self) -> Option<ExprId> {
        if self.entries.len() != other.entries.len() {
            return None;
        }
        let sum = s.inner(&self.entries, &other.entries);
        Some(match Self::factors(s, self, other) {
            Some(factor) => s.multiply(factor, sum),
            None => sum,
        })
    }

    pub(super) fn product(&self, s: &mut Numbers<'_>, other: &Self) -> Option<Self> {
        if self.columns != other.rows {
            return None;
        }
        let mut entries = Vec::new();
        for j in 0..other.columns {
            for i in 0..self.rows {
                entries.push(s.inner(&self.row(i), other.column(j)));
            }
        }
        let factor = Self::factors(s, self, other);
        Some(Self::new(self.rows, other.columns, entries).with(factor))
    }

    pub(super) fn cross(&self, s: &mut Numbers<'_>, other: &Self) -> Option<Self> {
        if self.entries.len() != 3 || other.entries.len() != 3 {
            return None;
        }
        let entries = (0..3).map(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let first = s.multiply(self.entries[i], other.entries[j]);
            let second = s.multiply(self.entries[j], other.entries[i]);
            s.subtract(first, second)
        });
        let entries = entries.collect();
        let factor = Self::factors(s, self, other);
        Some(Self::new(self.rows, self.columns, entries).with(factor))
    }

    pub(super) fn kronecker(&self, s: &mut Numbers<'_>, other: &Self) -> Self {
        let (n, m) = (self.rows * other.rows, self.columns * other.columns);
        let mut entries = Vec::new();
        for j in 0..m {
            for i in 0..n {
                let outer = self.at(i / other.rows, j / other.columns);
                let inner = other.at(i % other.rows, j % other.columns);
                entries.push(s.multiply(outer, inner));
            }
        }
        let factor = Self::factors(s, self, other);
        Self::new(n, m, entries).with(factor)
    }

    /// The determinant of the rows and columns of these numbers, without the factor.
    fn minor(&self, s: &mut Numbers<'_>, rows: &[usize], columns: &[usize]) -> ExprId {
        let Some((&column, others)) = columns.split_first() else {
            return s.real(1.0);
        };
        let mut sum = s.real(0.0);
        for (k, &row) in rows.iter().enumerate() {
            let left: Vec<usize> = rows.iter().copied().filter(|r| *r != row).collect();
            let minor = self.minor(s, &left, others);
            let term = s.multiply(self.at(row, column), minor);
            sum = match k % 2 {
                0 => s.add(sum, term),
                _ => s.subtract(sum, term),
            };
        }
        sum
    }

    /// The determinant of a square matrix with at most four rows.
    pub(super) fn determinant(&self, s: &mut Numbers<'_>) -> Option<ExprId> {
        if self.rows != self.columns || self.rows > 4 {
            return None;
        }
        let all: Vec<usize> = (0..self.rows).collect();
        let mut value = self.minor(s, &all, &all);
        if let Some(factor) = self.factor {
            let power = s.power(factor, self.rows as f64);
            value = s.multiply(power, value);
        }
        Some(value)
    }

    /// The adjugate of a square matrix, without the factor.
    fn adjugate(&self, s: &mut Numbers<'_>) -> Vec<ExprId> {
        let n = self.rows;
        let mut entries = Vec::new();
        for j in 0..n {
            for i in 0..n {
                let rows: Vec<usize> = (0..n).filter(|k| *k != j).collect();
                let columns: Vec<usize> = (0..n).filter(|k| *k != i).collect();
                let minor = self.minor(s, &rows, &columns);
                entries.push(match (i + j) % 2 {
                    0 => minor,
                    _ => s.negate(minor),
                });
            }
        }
        entries
    }

    /// The inverse, from the reciprocal of the determinant without the factor.
    pub(super) fn inverse(
        &self,
        s: &mut Numbers<'_>,
        reciprocal: impl FnOnce(&mut Numbers<'_>, ExprId) -> ExprId,
    ) -> Option<Self> {
        let plain = self.clone().with(None);
        let determinant = plain.determinant(s)?;
        let entries = plain.adjugate(s);
        let mut factor = reciprocal(s, determinant);
        if let Some(own) = self.factor {
            let own = s.reciprocal(own);
            factor = s.multiply(own, factor);
        }
        Some(Self::new(self.rows, self.columns, entries).with(Some(factor)))
    }
}
