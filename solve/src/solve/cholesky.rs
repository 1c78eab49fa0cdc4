//! Sparse symmetric systems, through the Cholesky factorisations of faer.

use std::fmt;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::sparse::linalg::cholesky::supernodal::{SupernodalLdltRef, SymbolicSupernodalCholesky};
use faer::sparse::linalg::cholesky::{
    LdltRef, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};
use iheartmesh_runtime::sprs::CsMat;

/// A pivot that is smaller than `n` times this part of the entries that it comes from is 0 but for rounding. Of Laplacians,
/// whose last pivot is 0, rounding makes up to half of that.
const SMALLEST_PIVOT: f64 = f64::EPSILON;
/// `n` in small matrices.
const LEAST_SIZE: usize = 64;
/// Entries on both sides of the diagonal may differ by this part of the greatest entry.
const ASYMMETRY: f64 = 1e-8;

/// How a symmetric matrix is factorised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factorisation {
    /// `L Lᵀ`, which exists for positive definite matrices alone.
    PositiveDefinite,
    /// `L D Lᵀ` with a diagonal `D` of any signs, without pivoting. It exists wherever the leading minors, in the order
    /// that is chosen, are not 0, as for all quasi-definite matrices.
    Indefinite,
}

/// The factors of a sparse symmetric matrix, with a fill-reducing order (approximate minimum degree) of its rows.
///
/// ```
/// use iheartmesh_runtime::sprs::TriMat;
/// use iheartmesh_solve::solve::{Cholesky, Factorisation};
///
/// let mut a = TriMat::new((2, 2));
/// for (i, j, entry) in [(0, 0, 2.0), (0, 1, 1.0), (1, 0, 1.0), (1, 1, 3.0)] {
///     a.add_triplet(i, j, entry);
/// }
/// let mut factors = Cholesky::new(&a.to_csc(), Factorisation::PositiveDefinite)?;
/// let mut x = [4.0, 7.0];
/// factors.solve_in_place(&mut x)?;
/// assert!((x[0] - 1.0).abs() < 1e-14 && (x[1] - 2.0).abs() < 1e-14);
/// # Ok::<(), iheartmesh_solve::solve::CholeskyError>(())
/// ```
pub struct Cholesky {
    factorisation: Factorisation,
    pattern: Pattern,
    symbolic: SymbolicCholesky<usize>,
    /// The entries of the factors.
    values: Vec<f64>,
    /// What faer computes in; large enough for factorising and for solving.
    memory: MemBuffer,
    /// For each column, how far its upper part has been compared with rows.
    cursors: Vec<usize>,
    /// Whether `values` are the factors of some matrix.
    is_valid: bool,
}

/// Which entries of a matrix are stored, by columns.
struct Pattern {
    starts: Vec<usize>,
    rows: Vec<usize>,
}

impl Pattern {
    fn of(a: &CsMat<f64>) -> Pattern {
        Pattern {
            starts: a.proper_indptr().into_owned(),
            rows: a.indices().to_vec(),
        }
    }

    fn is_that_of(&self, a: &CsMat<f64>) -> bool {
        self.rows == a.indices() && self.starts == *a.proper_indptr()
    }

    fn n(&self) -> usize {
        self.starts.len() - 1
    }

    fn as_faer(&self) -> SymbolicSparseColMatRef<'_, usize> {
        SymbolicSparseColMatRef::new_checked(self.n(), self.n(), &self.starts, None, &self.rows)
    }
}

impl Cholesky {
    /// Factorises a matrix, of which both triangles are stored, by columns or by rows.
    ///
    /// # Errors
    /// If the matrix is not square, not finite, not symmetric, singular to working precision, not positive definite where
    /// that is asked for, or too large for memory.
    pub fn new(a: &CsMat<f64>, factorisation: Factorisation) -> Result<Cholesky, CholeskyError> {
        let (rows, columns) = a.shape();
        if rows != columns {
            return Err(CholeskyError::NotSquare { rows, columns });
        }
        let mut cursors = Vec::new();
        check_entries(a, &mut cursors)?;
        let pattern = Pattern::of(a);
        let (symbolic, memory) = analyse(&pattern, factorisation)?;
        let values = vec![0.0; symbolic.len_val()];
        let mut cholesky = Cholesky {
            factorisation,
            pattern,
            symbolic,
            values,
            memory,
            cursors,
            is_valid: false,
        };
        cholesky.factorise_values(a)?;
        Ok(cholesky)
    }

    /// Factorises another matrix. Where the pattern of its entries is that of the last one, the order and the pattern of the
    /// factors are kept and nothing is allocated.
    ///
    /// # Errors
    /// As [`Cholesky::new`]. Then there are no factors until the next call that succeeds.
    pub fn factorise(&mut self, a: &CsMat<f64>) -> Result<(), CholeskyError> {
        self.is_valid = false;
        if !self.pattern.is_that_of(a) {
            *self = Cholesky::new(a, self.factorisation)?;
            return Ok(());
        }
        check_entries(a, &mut self.cursors)?;
        self.factorise_values(a)
    }

    /// Number of rows and of columns.
    pub fn n(&self) -> usize {
        self.pattern.n()
    }

    /// Puts the solution `x` of `A x = b` in the place of `b`. Allocates nothing.
    ///
    /// # Errors
    /// If `b` has another length than `A` has rows, or if the last matrix could not be factorised.
    pub fn solve_in_place(&mut self, b: &mut [f64]) -> Result<(), CholeskyError> {
        let n = self.n();
        if b.len() != n {
            return Err(CholeskyError::Length {
                found: b.len(),
                expected: n,
            });
        }
        if !self.is_valid {
            return Err(CholeskyError::NoFactors);
        }
        if n == 0 {
            return Ok(());
        }
        let right = MatMut::from_column_major_slice_mut(b, n, 1);
        let stack = MemStack::new(&mut self.memory);
        match self.factorisation {
            Factorisation::PositiveDefinite => LltRef::new(&self.symbolic, &self.values)
                .solve_in_place_with_conj(Conj::No, right, Par::Seq, stack),
            Factorisation::Indefinite => LdltRef::new(&self.symbolic, &self.values)
                .solve_in_place_with_conj(Conj::No, right, Par::Seq, stack),
        }
        Ok(())
    }

    /// Writes the solution `x` of `A x = b`. Allocates nothing.
    ///
    /// # Errors
    /// If `b` or `x` has another length than `A` has rows, or if the last matrix could not be factorised.
    pub fn solve_into(&mut self, b: &[f64], x: &mut [f64]) -> Result<(), CholeskyError> {
        for found in [b.len(), x.len()] {
            let expected = self.n();
            if found != expected {
                return Err(CholeskyError::Length { found, expected });
            }
        }
        x.copy_from_slice(b);
        self.solve_in_place(x)
    }

    fn factorise_values(&mut self, a: &CsMat<f64>) -> Result<(), CholeskyError> {
        if self.n() > 0 {
            let done = match self.factorisation {
                Factorisation::PositiveDefinite => self.llt(a),
                Factorisation::Indefinite => self.ldlt(a),
            };
            self.check_pivots(a, done)?;
        }
        self.is_valid = true;
        Ok(())
    }

    fn llt(&mut self, a: &CsMat<f64>) -> bool {
        let matrix = SparseColMatRef::new(self.pattern.as_faer(), a.data());
        let result = self.symbolic.factorize_numeric_llt(
            &mut self.values,
            matrix,
            Side::Lower,
            Default::default(),
            Par::Seq,
            MemStack::new(&mut self.memory),
            Default::default(),
        );
        result.is_ok()
    }

    fn ldlt(&mut self, a: &CsMat<f64>) -> bool {
        let matrix = SparseColMatRef::new(self.pattern.as_faer(), a.data());
        let result = self.symbolic.factorize_numeric_ldlt(
            &mut self.values,
            matrix,
            Side::Lower,
            LdltRegularization::default(),
            Par::Seq,
            MemStack::new(&mut self.memory),
            Default::default(),
        );
        result.is_ok()
    }

    /// Finds the first pivot that is 0 but for rounding or of the wrong sign.
    fn check_pivots(&mut self, a: &CsMat<f64>, mut done: bool) -> Result<(), CholeskyError> {
        // LDLᵀ shows the pivot at which LLᵀ ends
        let squares = self.factorisation == Factorisation::PositiveDefinite && done;
        if !done && self.factorisation == Factorisation::PositiveDefinite {
            self.values.fill(0.0);
            self.ldlt(a);
            done = false;
        }
        let sizes = sizes(a);
        let smallest_part = SMALLEST_PIVOT * self.n().max(LEAST_SIZE) as f64;
        let order = self.symbolic.perm();
        let variable = |k: usize| order.map_or(k, |order| order.arrays().0[k]);
        for (k, pivot) in pivots(&self.symbolic, &self.values).enumerate() {
            let variable = variable(k);
            let pivot = if squares { pivot * pivot } else { pivot };
            let smallest = smallest_part * sizes[variable];
            if self.factorisation == Factorisation::PositiveDefinite && pivot < -smallest {
                return Err(CholeskyError::NotPositiveDefinite { variable });
            }
            if pivot.is_nan() || pivot.abs() <= smallest {
                return Err(CholeskyError::Singular { variable });
            }
        }
        match done {
            true => Ok(()),
            false => Err(CholeskyError::Singular {
                variable: variable(self.n() - 1),
            }),
        }
    }
}

impl fmt::Debug for Cholesky {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Cholesky")
            .field("factorisation", &self.factorisation)
            .field("n", &self.n())
            .field("entries_of_matrix", &self.pattern.rows.len())
            .field("entries_of_factors", &self.values.len())
            .field("is_valid", &self.is_valid)
            .finish()
    }
}

/// The pattern of the factors, and memory to compute them and to solve with them.
fn analyse(
    pattern: &Pattern,
    factorisation: Factorisation,
) -> Result<(SymbolicCholesky<usize>, MemBuffer), CholeskyError> {
    let symbolic = factorize_symbolic_cholesky(
        pattern.as_faer(),
        Side::Lower,
        SymmetricOrdering::Amd,
        Default::default(),
    )
    .map_err(|_| CholeskyError::TooLarge)?;
    let mut needed = symbolic
        .solve_in_place_scratch::<f64>(1, Par::Seq)
        .or(symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default()));
    if factorisation == Factorisation::PositiveDefinite {
        let llt = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        needed = needed.or(llt);
    }
    let memory = MemBuffer::try_new(needed).map_err(|_| CholeskyError::TooLarge)?;
    Ok((symbolic, memory))
}

/// The pivots in the order of elimination: the diagonal of L for LLᵀ, of D for LDLᵀ.
fn pivots<'a>(
    symbolic: &'a SymbolicCholesky<usize>,
    values: &'a [f64],
) -> Box<dyn Iterator<Item = f64> + 'a> {
    match symbolic.raw() {
        SymbolicCholeskyRaw::Simplicial(symbolic) => {
            let starts = &symbolic.col_ptr()[..symbolic.ncols()];
            Box::new(starts.iter().map(|start| values[*start]))
        }
        SymbolicCholeskyRaw::Supernodal(symbolic) => Box::new(supernodal_pivots(symbolic, values)),
    }
}

/// The pivots of blocks of columns; those of LLᵀ are stored as those of LDLᵀ are.
fn supernodal_pivots<'a>(
    symbolic: &'a SymbolicSupernodalCholesky<usize>,
    values: &'a [f64],
) -> impl Iterator<Item = f64> + 'a {
    let factors = SupernodalLdltRef::new(symbolic, values);
    (0..symbolic.n_supernodes()).flat_map(move |s| {
        let block = factors.supernode(s).val();
        (0..block.ncols()).map(move |k| block[(k, k)])
    })
}

/// The greatest absolute value in each row, which is that of the column.
fn sizes(a: &CsMat<f64>) -> Vec<f64> {
    let greatest = |column: &[f64]| column.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    a.outer_iterator()
        .map(|column| greatest(column.data()))
        .collect()
}

/// Checks that the entries are finite and symmetric, in one pass: down the columns in order, what is below the diagonal
/// meets what is above it in the order of its rows.
fn check_entries(a: &CsMat<f64>, cursors: &mut Vec<usize>) -> Result<(), CholeskyError> {
    let mut greatest = 0.0f64;
    for (entry, (row, column)) in a {
        if !entry.is_finite() {
            return Err(CholeskyError::NotFinite {
                row,
                column,
                entry: *entry,
            });
        }
        greatest = greatest.max(entry.abs());
    }
    let starts = a.proper_indptr();
    let (rows, data) = (a.indices(), a.data());
    cursors.clear();
    cursors.extend_from_slice(&starts[..starts.len() - 1]);
    let fault = |row: usize, column: usize, entry: f64| CholeskyError::NotSymmetric {
        row,
        column,
        entry,
        mirrored: a.get(column, row).copied().unwrap_or(0.0),
    };
    for column in 0..a.cols() {
        for place in starts[column]..starts[column + 1] {
            let row = rows[place];
            if row <= column {
                continue;
            }
            let mirror = cursors[row];
            let matches = mirror < starts[row + 1]
                && rows[mirror] == column
                && (data[place] - data[mirror]).abs() <= ASYMMETRY * greatest;
            if !matches {
                return Err(fault(row, column, data[place]));
            }
            cursors[row] += 1;
        }
    }
    for column in 0..a.cols() {
        let rest = cursors[column];
        if rest < starts[column + 1] && rows[rest] < column {
            return Err(fault(rows[rest], column, data[rest]));
        }
    }
    Ok(())
}

/// Why a matrix has no factors, or a system no solution. Rows and columns count from 0.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CholeskyError {
    /// The matrix is not square.
    NotSquare {
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
    },
    /// An entry is infinite or not a number.
    NotFinite {
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
        /// The entry.
        entry: f64,
    },
    /// An entry is not the one on the other side of the diagonal, or only one of them is stored.
    NotSymmetric {
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
        /// The entry.
        entry: f64,
        /// The one on the other side, 0 if it is not stored.
        mirrored: f64,
    },
    /// A pivot is 0 but for rounding: the matrix has no inverse, or, if `LDLᵀ` was asked for, needs pivoting.
    Singular {
        /// The row of the pivot.
        variable: usize,
    },
    /// A pivot is negative.
    NotPositiveDefinite {
        /// The row of the pivot.
        variable: usize,
    },
    /// A right side or a solution has not as many entries as the matrix has rows.
    Length {
        /// Number of its entries.
        found: usize,
        /// Number of rows of the matrix.
        expected: usize,
    },
    /// The last matrix could not be factorised.
    NoFactors,
    /// There is not enough memory.
    TooLarge,
}

impl fmt::Display for CholeskyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CholeskyError::NotSquare { rows, columns } => {
                write!(
                    f,
                    "the matrix is not square: {rows} rows, {columns} columns"
                )
            }
            CholeskyError::NotFinite { row, column, entry } => {
                write!(f, "the entry in row {row}, column {column} is {entry}")
            }
            CholeskyError::NotSymmetric {
                row,
                column,
                entry,
                mirrored,
            } => write!(
                f,
                "the matrix is not symmetric: in row {row}, column {column} it has {entry}, in row {column}, column \
                 {row} {mirrored}"
            ),
            CholeskyError::Singular { variable } => {
                write!(
                    f,
                    "the matrix is singular: the pivot of row {variable} is 0"
                )
            }
            CholeskyError::NotPositiveDefinite { variable } => write!(
                f,
                "the matrix is not positive definite: the pivot of row {variable} is negative"
            ),
            CholeskyError::Length { found, expected } => write!(
                f,
                "a vector has {found} entries, but the matrix has {expected} rows"
            ),
            CholeskyError::NoFactors => write!(f, "the last matrix could not be factorised"),
            CholeskyError::TooLarge => write!(f, "there is not enough memory for the factors"),
        }
    }
}

impl std::error::Error for CholeskyError {}
