//! The combinatorial core of every mesh: elements of dimension 0 to 3 and the boundary matrices between them.

use std::fmt::{self, Debug};
use std::ops::Range;
use std::sync::OnceLock;

use crate::boundary::{self, BoundaryMatrix, Columns};
use crate::mesh::MeshError;
use crate::order::VertexOrder;
use crate::steps::Steps;

/// Elements of dimensions 0 to `dimension()` and the signed boundary matrices ∂ᵏ between them.
///
/// ∂ᵏ has one row for each element of dimension k − 1 and one column for each element of dimension k. An entry is +1
/// where the orientation of the smaller element agrees with the one that the larger induces on it, −1 where it does
/// not, and absent where the one is no side of the other; ∂ᵏ⁻¹∂ᵏ = 0. So ∂¹ is vertices × edges (−1 at the tail of
/// the edge, +1 at its head), ∂² edges × faces, ∂³ faces × cells. (Dong et al. number them from ∂⁰ in the language and
/// from ∂¹ in the text; this crate follows the text.)
///
/// Every ∂ᵏ is stored together with its transpose, both in compressed columns, so that the boundary of an element and
/// the elements around it are each one slice: [`boundary_column`](Self::boundary_column) and
/// [`coboundary_column`](Self::coboundary_column). The matrices of `sprs`, which hold the same once more, are made when first
/// asked for, each of the signed and unsigned ones by itself.
///
/// # Panics
/// Methods with a parameter `k` panic unless 1 ≤ k ≤ `dimension()`, those with an element number panic if there is no
/// such element, as indexing a slice does.
#[derive(Clone)]
pub struct CellComplex {
    n_elements: [usize; 4],
    /// Whether every edge runs from its smaller to its larger vertex.
    has_tails_first: bool,
    incidences: Vec<Incidence>,
    order: OnceLock<Option<VertexOrder>>,
    steps: Steps,
}

/// ∂ᵏ for one k and its transpose; and both as matrices for users, with signs and without.
#[derive(Clone)]
struct Incidence {
    columns: Columns,
    transpose: Columns,
    matrices: Box<[OnceLock<BoundaryMatrix>; 4]>,
}

impl Incidence {
    fn new((columns, transpose): (Columns, Columns)) -> Self {
        Incidence {
            columns,
            transpose,
            matrices: Box::default(),
        }
    }

    /// ∂ᵏ or its transpose as a matrix, kept for the next time.
    fn matrix(&self, transposed: bool) -> &BoundaryMatrix {
        self.matrices[usize::from(transposed)].get_or_init(|| match transposed {
            false => self.columns.to_matrix(self.transpose.n()),
            true => self.transpose.to_matrix(self.columns.n()),
        })
    }

    fn unsigned_matrix(&self, transposed: bool) -> &BoundaryMatrix {
        let is_made = || boundary::unsigned(self.matrix(transposed));
        self.matrices[2 + usize::from(transposed)].get_or_init(is_made)
    }
}

impl CellComplex {
    /// The complex with the given numbers of elements and pairs of ∂ᵏ and its transpose for k = 1, 2, …
    ///
    /// The caller guarantees all that [`from_boundary_matrices`](Self::from_boundary_matrices) checks, and says whether
    /// every edge runs from its smaller to its larger vertex.
    pub(crate) fn new(
        n_vertices: usize,
        has_tails_first: bool,
        matrices: Vec<(Columns, Columns)>,
    ) -> Self {
        let mut n_elements = [n_vertices, 0, 0, 0];
        for (k, (columns, _)) in matrices.iter().enumerate() {
            n_elements[k + 1] = columns.n();
        }
        CellComplex {
            n_elements,
            has_tails_first,
            incidences: matrices.into_iter().map(Incidence::new).collect(),
            order: OnceLock::new(),
            steps: Steps::default(),
        }
    }

    /// The complex with boundary matrices ∂¹, ∂², … (one to three of them), in either storage order of `sprs`.
    ///
    /// The numbering of the elements is that of the rows and columns given.
    ///
    /// # Errors
    /// - [`MeshError::NumberOfMatrices`] unless there are one, two or three matrices;
    /// - [`MeshError::TooManyElements`] if a dimension has more elements than a `u32` can number;
    /// - [`MeshError::ShapeMismatch`] if ∂ᵏ⁻¹ has another number of columns than ∂ᵏ has rows;
    /// - [`MeshError::InvalidEntry`] if a stored entry is neither −1 nor +1;
    /// - [`MeshError::InvalidEdge`] if a column of ∂¹ is not one −1 and one +1;
    /// - [`MeshError::NotAComplex`] if ∂ᵏ⁻¹∂ᵏ ≠ 0, with the first element whose boundary has a boundary.
    pub fn from_boundary_matrices(matrices: &[&BoundaryMatrix]) -> Result<Self, MeshError> {
        if !(1..=3).contains(&matrices.len()) {
            return Err(MeshError::NumberOfMatrices {
                found: matrices.len(),
            });
        }
        for (index, pair) in matrices.windows(2).enumerate() {
            if pair[0].cols() != pair[1].rows() {
                return Err(MeshError::ShapeMismatch {
                    k: index + 2,
                    rows: pair[1].rows(),
                    expected: pair[0].cols(),
                });
            }
        }
        let mut checked = Vec::with_capacity(matrices.len());
        for (index, matrix) in matrices.iter().enumerate() {
            let columns = boundary::checked(index + 1, matrix)?;
            let transpose = columns.transposed(matrix.rows());
            checked.push((columns, transpose));
        }
        let mut complex = CellComplex::new(matrices[0].rows(), false, checked);
        complex.check_edges()?;
        let edges = &mut complex.incidences[0].columns;
        (edges.pointers, edges.width) = (Vec::new(), 2);
        complex.has_tails_first = edges.signs.as_chunks().0.iter().all(|s| *s == [-1, 1]);
        if complex.has_tails_first {
            edges.signs = Vec::new();
        }
        for k in 2..=complex.dimension() {
            complex.check_boundary_of_boundary(k)?;
        }
        Ok(complex)
    }

    fn check_edges(&self) -> Result<(), MeshError> {
        match (0..self.n(1))
            .find(|&edge| !matches!(self.boundary_column(1, edge).1, [-1, 1] | [1, -1]))
        {
            Some(edge) => Err(MeshError::InvalidEdge { edge }),
            None => Ok(()),
        }
    }

    pub(crate) fn check_boundary_of_boundary(&self, k: usize) -> Result<(), MeshError> {
        let mut sums: Vec<(u32, i64)> = Vec::new();
        for j in 0..self.n(k) {
            sums.clear();
            let (sides, signs) = self.boundary_column(k, j);
            for (&side, &sign) in sides.iter().zip(signs) {
                let (rows, entries) = self.boundary_column(k - 1, side as usize);
                sums.extend(
                    rows.iter()
                        .zip(entries)
                        .map(|(&row, &entry)| (row, i64::from(entry * sign))),
                );
            }
            sums.sort_unstable_by_key(|&(row, _)| row);
            let cancels =
                |group: &[(u32, i64)]| group.iter().map(|&(_, term)| term).sum::<i64>() == 0;
            if !sums.chunk_by(|left, right| left.0 == right.0).all(cancels) {
                return Err(MeshError::NotAComplex {
                    kind: boundary::kind(k),
                    element: j,
                });
            }
        }
        Ok(())
    }

    /// The same complex with cells, of which ∂³ and its transpose are given.
    pub(crate) fn with_cells(mut self, columns: Columns, transpose: Columns) -> Self {
        self.n_elements[3] = columns.n();
        self.incidences.push(Incidence::new((columns, transpose)));
        self
    }

    /// Number of connected components; an isolated vertex is one.
    pub fn n_components(&self) -> usize {
        let mut is_reached = vec![false; self.n(0)];
        let mut reached = Vec::new();
        let mut n_components = 0;
        for seed in 0..self.n(0) as u32 {
            if std::mem::replace(&mut is_reached[seed as usize], true) {
                continue;
            }
            n_components += 1;
            reached.push(seed);
            while let Some(vertex) = reached.pop() {
                for &edge in self.coboundary_elements(1, vertex as usize) {
                    for neighbour in self.edge_vertices(edge as usize) {
                        if !std::mem::replace(&mut is_reached[neighbour as usize], true) {
                            reached.push(neighbour);
                        }
                    }
                }
            }
        }
        n_components
    }

    /// The highest dimension for which there is a boundary matrix: 1 to 3.
    #[inline]
    pub fn dimension(&self) -> usize {
        self.incidences.len()
    }

    /// Number of elements of dimension `dimension`; 0 above [`dimension()`](Self::dimension).
    ///
    /// # Panics
    /// If `dimension` > 3.
    #[inline]
    pub fn n(&self, dimension: usize) -> usize {
        self.n_elements[dimension]
    }

    /// Σₖ (−1)ᵏ nₖ, the Euler characteristic.
    pub fn euler_characteristic(&self) -> i64 {
        let [vertices, edges, faces, cells] = self.n_elements.map(|n| n as i64);
        vertices - edges + faces - cells
    }

    #[inline]
    fn incidence(&self, k: usize) -> &Incidence {
        match k
            .checked_sub(1)
            .and_then(|index| self.incidences.get(index))
        {
            Some(incidence) => incidence,
            None => no_such_boundary_matrix(k, self.dimension()),
        }
    }

    /// Column `j` of ∂ᵏ: the sides of element `j` of dimension `k`, ascending, and their signs.
    #[inline]
    pub fn boundary_column(&self, k: usize, j: usize) -> (&[u32], &[i8]) {
        self.incidence(k).columns.column(j)
    }

    /// The sides of element `j` of dimension `k`, ascending: [`boundary_column`](Self::boundary_column) without signs,
    /// which is faster.
    #[inline]
    pub fn boundary_elements(&self, k: usize, j: usize) -> &[u32] {
        let columns = &self.incidence(k).columns;
        match k {
            1 => columns.pair(j),
            _ => columns.column_rows(j),
        }
    }

    /// Row `i` of ∂ᵏ, a column of its transpose: the elements of dimension `k` of which element `i` of dimension
    /// `k` − 1 is a side, ascending, and its sign in each.
    #[inline]
    pub fn coboundary_column(&self, k: usize, i: usize) -> (&[u32], &[i8]) {
        self.incidence(k).transpose.column(i)
    }

    /// The elements of dimension `k` of which element `i` of dimension `k` − 1 is a side, ascending:
    /// [`coboundary_column`](Self::coboundary_column) without signs, which is faster.
    #[inline]
    pub fn coboundary_elements(&self, k: usize, i: usize) -> &[u32] {
        self.incidence(k).transpose.column_rows(i)
    }

    /// Tail and head of an edge: the rows of −1 and +1 in its column of ∂¹.
    #[inline]
    pub fn edge_vertices(&self, edge: usize) -> [u32; 2] {
        let d1 = &self.incidence(1).columns;
        let [first, second] = *d1.pair(edge);
        if self.has_tails_first || d1.signs[2 * edge] < 0 {
            [first, second]
        } else {
            [second, first]
        }
    }

    /// An order of the vertices that is better for memory than their numbering, if there is one. Found on the first call.
    pub(crate) fn vertex_order(&self) -> Option<&VertexOrder> {
        self.order.get_or_init(|| VertexOrder::of(self)).as_ref()
    }

    pub(crate) fn steps(&self) -> &Steps {
        &self.steps
    }

    /// Entry of ∂ᵏ: −1, +1, or 0 where `row` is no side of `column`.
    ///
    /// Searches the column: linear in the few sides that an element usually has, binary in long ones.
    #[inline]
    pub fn boundary_entry(&self, k: usize, row: usize, column: usize) -> i8 {
        assert!(
            row < self.n(k - 1),
            "row {row} of ∂{k} is out of range: there are {} rows",
            self.n(k - 1)
        );
        if k == 1 {
            let [tail, head] = self.edge_vertices(column);
            return i8::from(head as usize == row) - i8::from(tail as usize == row);
        }
        let (rows, signs) = self.boundary_column(k, column);
        let position = if rows.len() <= 16 {
            rows.iter().position(|&other| other as usize == row)
        } else {
            rows.binary_search(&(row as u32)).ok()
        };
        position.map_or(0, |position| signs[position])
    }

    /// Where the entries of a column of ∂ᵏ stand.
    #[inline]
    pub(crate) fn boundary_range(&self, k: usize, j: usize) -> Range<usize> {
        self.incidence(k).columns.range(j)
    }

    /// Number of entries of ∂ᵏ.
    pub(crate) fn n_entries(&self, k: usize) -> usize {
        self.incidence(k).columns.rows.len()
    }

    /// ∂ᵏ, shape n(k − 1) × n(k), entries −1 and +1, in compressed columns. Made on the first call, and kept: 5 bytes for each
    /// entry and 4 for each column. [`boundary_column`](Self::boundary_column) needs none of it.
    pub fn boundary(&self, k: usize) -> &BoundaryMatrix {
        self.incidence(k).matrix(false)
    }

    /// (∂ᵏ)ᵀ, shape n(k) × n(k − 1), entries −1 and +1, in compressed columns. Made on the first call, and kept, as
    /// [`boundary`](Self::boundary). [`coboundary_column`](Self::coboundary_column) needs none of it.
    pub fn boundary_transpose(&self, k: usize) -> &BoundaryMatrix {
        self.incidence(k).matrix(true)
    }

    /// |∂ᵏ|, shape n(k − 1) × n(k), entries 1. Made on the first call.
    pub fn unsigned_boundary(&self, k: usize) -> &BoundaryMatrix {
        self.incidence(k).unsigned_matrix(false)
    }

    /// |∂ᵏ|ᵀ, shape n(k) × n(k − 1), entries 1: in compressed columns. Made on the first call.
    pub fn unsigned_boundary_transpose(&self, k: usize) -> &BoundaryMatrix {
        self.incidence(k).unsigned_matrix(true)
    }
}

impl Debug for CellComplex {
    /// The numbers of elements; the matrices would fill pages.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let n_elements = &self.n_elements[..=self.dimension()];
        formatter
            .debug_struct("CellComplex")
            .field("n_elements", &n_elements)
            .finish_non_exhaustive()
    }
}

#[cold]
#[inline(never)]
fn no_such_boundary_matrix(k: usize, dimension: usize) -> ! {
    panic!(
        "there is no boundary matrix ∂{k} in a mesh of dimension {dimension}: k goes from 1 to {dimension}"
    )
}
