//! Operations on numbers, vectors and matrices of any size.

use super::array::{Array, Build, Number};
use super::{Fallible, Fault};

/// Each entry by itself.
#[inline(always)]
pub fn map<R: Build>(a: &impl Array<Item = R::Item>, f: impl Fn(R::Item) -> R::Item) -> R {
    R::build(a.rows(), a.columns(), |i, j| f(a.entry(i, j)))
}

/// Two entries at a time; both of one size.
#[inline(always)]
pub fn zip<R: Build>(
    a: &impl Array<Item = R::Item>,
    b: &impl Array<Item = R::Item>,
    f: impl Fn(R::Item, R::Item) -> R::Item,
) -> R {
    R::build(a.rows(), a.columns(), |i, j| {
        f(a.entry(i, j), b.entry(i, j))
    })
}

/// Integers as real numbers.
#[inline(always)]
pub fn reals<R: Build<Item = f64>>(a: &impl Array) -> R {
    R::build(a.rows(), a.columns(), |i, j| a.entry(i, j).real())
}

/// The product of matrices.
#[inline(always)]
pub fn product<R: Build<Item = f64>>(a: &impl Array<Item = f64>, b: &impl Array<Item = f64>) -> R {
    R::build(a.rows(), b.columns(), |i, j| {
        let mut sum = 0.0;
        for k in 0..a.columns() {
            sum += a.entry(i, k) * b.entry(k, j);
        }
        sum
    })
}

/// Rows and columns exchanged.
#[inline(always)]
pub fn transpose<R: Build>(a: &impl Array<Item = R::Item>) -> R {
    R::build(a.columns(), a.rows(), |i, j| a.entry(j, i))
}

/// The same entries in another shape of the same size.
#[inline(always)]
pub fn reshape<R: Build>(a: &impl Array<Item = R::Item>) -> R {
    R::build(a.rows(), a.columns(), |i, j| a.entry(i, j))
}

/// Sum of the products of the entries.
#[inline(always)]
pub fn inner<A: Array<Item = f64>, B: Array<Item = f64>>(a: &A, b: &B) -> f64 {
    match B::SPARSE && !A::SPARSE {
        true => fold(b, 0.0, |sum, i, j, x| sum + a.entry(i, j) * x),
        false => fold(a, 0.0, |sum, i, j, x| sum + x * b.entry(i, j)),
    }
}

/// Over the entries; those that a sparse matrix does not store are left out.
#[inline(always)]
fn fold<A: Array, T: Copy>(a: &A, start: T, f: impl Fn(T, usize, usize, A::Item) -> T) -> T {
    let mut value = start;
    a.each(|i, j, entry| value = f(value, i, j, entry));
    value
}

/// The Kronecker product.
pub fn kronecker<R: Build<Item = f64>>(
    a: &impl Array<Item = f64>,
    b: &impl Array<Item = f64>,
) -> R {
    let (p, q) = (b.rows(), b.columns());
    R::build(a.rows() * p, a.columns() * q, |i, j| {
        a.entry(i / p, j / q) * b.entry(i % p, j % q)
    })
}

/// The square root of the sum of the squares of the entries.
#[inline(always)]
pub fn norm(a: &impl Array<Item = f64>) -> f64 {
    inner(a, a).sqrt()
}

/// The sum of the absolute values of the entries.
pub fn norm_one(a: &impl Array<Item = f64>) -> f64 {
    fold(a, 0.0, |sum, _, _, x| sum + x.abs())
}

/// The largest absolute value of the entries.
pub fn norm_max(a: &impl Array<Item = f64>) -> f64 {
    fold(a, 0.0, |most: f64, _, _, x| match x.is_nan() {
        true => x,
        false if x.abs() > most => x.abs(),
        false => most,
    })
}

/// The number of entries other than 0.
pub fn norm_zero(a: &impl Array<Item = f64>) -> f64 {
    fold(a, 0.0, |n, _, _, x| if x == 0.0 { n } else { n + 1.0 })
}

/// The `p`-norm.
pub fn norm_power(a: &impl Array<Item = f64>, p: f64) -> f64 {
    fold(a, 0.0, |sum, _, _, x| sum + x.abs().powf(p)).powf(1.0 / p)
}

/// `√(aᵀ P a)`.
pub fn norm_weighted(a: &impl Array<Item = f64>, p: &impl Array<Item = f64>) -> f64 {
    fold(p, 0.0, |sum, i, j, x| {
        sum + a.entry(i, 0) * x * a.entry(j, 0)
    })
    .sqrt()
}

/// The sum of the diagonal.
#[inline(always)]
pub fn trace(a: &impl Array<Item = f64>) -> f64 {
    (0..a.rows().min(a.columns())).map(|i| a.entry(i, i)).sum()
}

/// The diagonal of a matrix.
pub fn diagonal_of<R: Build<Item = f64>>(a: &impl Array<Item = f64>) -> R {
    R::build(a.rows().min(a.columns()), 1, |i, _| a.entry(i, i))
}

/// The matrix with this diagonal.
pub fn diagonal<R: Build<Item = f64>>(a: &impl Array<Item = f64>) -> R {
    R::build(
        a.rows(),
        a.rows(),
        |i, j| if i == j { a.entry(i, 0) } else { 0.0 },
    )
}

/// The columns of a matrix, one below the other.
pub fn stack<R: Build<Item = f64>>(a: &impl Array<Item = f64>) -> R {
    let rows = a.rows();
    R::build(rows * a.columns(), 1, |i, _| {
        a.entry(i % rows.max(1), i / rows.max(1))
    })
}

/// The items of a sequence, each column by column, one below the other.
pub fn stack_items<R: Build<Item = f64>, A: Array>(items: &[A]) -> R {
    let mut entries = Vec::new();
    for item in items {
        for j in 0..item.columns() {
            for i in 0..item.rows() {
                entries.push(item.entry(i, j).real());
            }
        }
    }
    R::build(entries.len(), 1, |i, _| entries[i])
}

/// The inverse of [`stack`]: entries in the shape of a matrix.
pub fn unstack<R: Build<Item = f64>>(
    shape: &impl Array,
    entries: &impl Array<Item = f64>,
    fault: Fault,
) -> Fallible<R> {
    let (rows, columns) = (shape.rows(), shape.columns());
    if entries.rows() != rows * columns {
        return Err(fault);
    }
    Ok(R::build(rows, columns, |i, j| {
        entries.entry(i + j * rows, 0)
    }))
}

/// The inverse of [`stack_items`].
pub fn unstack_items<R: Build<Item = f64>>(
    shape: &[impl Array],
    entries: &impl Array<Item = f64>,
    fault: Fault,
) -> Fallible<Vec<R>> {
    let total: usize = shape.iter().map(|item| item.rows() * item.columns()).sum();
    if entries.rows() != total {
        return Err(fault);
    }
    let mut start = 0;
    let mut items = Vec::with_capacity(shape.len());
    for item in shape {
        let (rows, columns) = (item.rows(), item.columns());
        items.push(R::build(rows, columns, |i, j| {
            entries.entry(start + i + j * rows, 0)
        }));
        start += rows * columns;
    }
    Ok(items)
}

/// A row as a column vector; the number is from 1.
pub fn row<R: Build>(a: &impl Array<Item = R::Item>, number: i64, fault: Fault) -> Fallible<R> {
    let row = index(number, a.rows(), fault)?;
    Ok(R::build(a.columns(), 1, |j, _| a.entry(row, j)))
}

/// A column; the number is from 1.
pub fn column<R: Build>(a: &impl Array<Item = R::Item>, number: i64, fault: Fault) -> Fallible<R> {
    let column = index(number, a.columns(), fault)?;
    Ok(R::build(a.rows(), 1, |i, _| a.entry(i, column)))
}

/// An entry by its numbers from 1.
#[inline(always)]
pub fn entry_at<A: Array>(a: &A, row: i64, column: i64, fault: Fault) -> Fallible<A::Item> {
    Ok(a.entry(
        index(row, a.rows(), fault)?,
        index(column, a.columns(), fault)?,
    ))
}

/// Sets an entry by its numbers from 1.
#[inline(always)]
pub fn set_at<B: Build>(
    a: &mut B,
    row: i64,
    column: i64,
    value: B::Item,
    fault: Fault,
) -> Fallible<()> {
    let row = index(row, a.rows(), fault)?;
    let column = index(column, a.columns(), fault)?;
    a.set(row, column, value);
    Ok(())
}

/// Sets a row, by its number from 1, to the entries of a vector.
pub fn set_row<B: Build>(
    a: &mut B,
    number: i64,
    row: &impl Array<Item = B::Item>,
    fault: Fault,
) -> Fallible<()> {
    let place = index(number, a.rows(), fault)?;
    if row.rows() != a.columns() {
        return Err(fault);
    }
    (0..row.rows()).for_each(|j| a.set(place, j, row.entry(j, 0)));
    Ok(())
}

/// Sets a column, by its number from 1, to the entries of a vector.
pub fn set_column<B: Build>(
    a: &mut B,
    number: i64,
    column: &impl Array<Item = B::Item>,
    fault: Fault,
) -> Fallible<()> {
    let place = index(number, a.columns(), fault)?;
    if column.rows() != a.rows() {
        return Err(fault);
    }
    (0..column.rows()).for_each(|i| a.set(i, place, column.entry(i, 0)));
    Ok(())
}

/// The place of an entry by its number from 1.
#[inline(always)]
pub(super) fn index(number: i64, size: usize, fault: Fault) -> Fallible<usize> {
    match usize::try_from(number.wrapping_sub(1)) {
        Ok(index) if index < size => Ok(index),
        _ => Err(fault),
    }
}

/// Puts a block into a matrix; the matrix is large enough.
#[inline(always)]
pub fn put<R: Build>(
    matrix: &mut R,
    row: usize,
    column: usize,
    block: &impl Array<Item = R::Item>,
) {
    for j in 0..block.columns() {
        for i in 0..block.rows() {
            matrix.set(row + i, column + j, block.entry(i, j));
        }
    }
}

/// The identity.
pub fn identity<R: Build<Item = f64>>(n: usize) -> R {
    R::build(n, n, |i, j| if i == j { 1.0 } else { 0.0 })
}

/// The least entry; a vector without entries has none.
pub fn least<A: Array>(a: &A, fault: Fault) -> Fallible<A::Item> {
    extreme(a, |x, best| x < best, fault)
}

/// The greatest entry; a vector without entries has none.
pub fn greatest<A: Array>(a: &A, fault: Fault) -> Fallible<A::Item> {
    extreme(a, |x, best| x > best, fault)
}

/// The least of several numbers; of none there is none.
pub fn least_item<T: Number>(items: &[T], fault: Fault) -> Fallible<T> {
    extreme_item(items, |x, best| x < best, fault)
}

/// The greatest of several numbers; of none there is none.
pub fn greatest_item<T: Number>(items: &[T], fault: Fault) -> Fallible<T> {
    extreme_item(items, |x, best| x > best, fault)
}

/// Of NaN and another number there is no greatest one.
#[inline(always)]
fn is_nan<T: PartialOrd>(x: T) -> bool {
    x.partial_cmp(&x).is_none()
}

fn extreme_item<T: Number>(
    items: &[T],
    better: impl Fn(T, T) -> bool,
    fault: Fault,
) -> Fallible<T> {
    let best = items
        .iter()
        .copied()
        .reduce(|best, x| match is_nan(x) || better(x, best) {
            true => x,
            false => best,
        });
    best.ok_or(fault)
}

fn extreme<A: Array>(
    a: &A,
    better: impl Fn(A::Item, A::Item) -> bool,
    fault: Fault,
) -> Fallible<A::Item> {
    let mut best: Option<A::Item> = None;
    for j in 0..a.columns() {
        for i in 0..a.rows() {
            let entry = a.entry(i, j);
            if best.is_none_or(|best| is_nan(entry) || better(entry, best)) {
                best = Some(entry);
            }
        }
    }
    best.ok_or(fault)
}

/// A size as generated code counts; negative ones are empty.
#[inline(always)]
pub fn size(n: i64) -> usize {
    usize::try_from(n).unwrap_or(0)
}

/// Sizes of a matrix; fails where one is negative, or where there would be too many entries.
fn sizes(rows: i64, columns: i64, fault: Fault) -> Fallible<(usize, usize)> {
    let size = |n: i64| u32::try_from(n).map_err(|_| fault);
    let (rows, columns) = (size(rows)?, size(columns)?);
    match rows.checked_mul(columns) {
        Some(_) => Ok((rows as usize, columns as usize)),
        None => Err(fault),
    }
}

/// An array of one value; fails where a size is negative, or where there would be too many entries.
#[inline]
pub fn filled<R: Build>(rows: i64, columns: i64, value: R::Item, fault: Fault) -> Fallible<R>
where
    R::Item: Copy,
{
    let (rows, columns) = sizes(rows, columns, fault)?;
    Ok(R::build(rows, columns, |_, _| value))
}

/// The identity; fails where the size is negative, or where there would be too many entries.
#[inline]
pub fn identity_of<R: Build<Item = f64>>(n: i64, fault: Fault) -> Fallible<R> {
    let (n, _) = sizes(n, n, fault)?;
    Ok(super::identity(n))
}

/// Two sizes that must agree.
#[inline(always)]
pub fn agree(a: i64, b: i64, fault: Fault) -> Fallible<()> {
    if a == b { Ok(()) } else { Err(fault) }
}

/// Adds a term to a sum that has the size of its first term.
pub fn add_to<R: Build>(
    sum: &mut Option<R>,
    term: &impl Array<Item = R::Item>,
    fault: Fault,
) -> Fallible<()> {
    let Some(sum) = sum else {
        *sum = Some(reshape(term));
        return Ok(());
    };
    if (sum.rows(), sum.columns()) != (term.rows(), term.columns()) {
        return Err(fault);
    }
    for column in 0..term.columns() {
        for row in 0..term.rows() {
            let mut entry = sum.entry(row, column);
            entry += term.entry(row, column);
            sum.set(row, column, entry);
        }
    }
    Ok(())
}
