//! Rows turned so that their key comes first.

use super::{PlanError, Rows, Table, concatenated, in_chunks, is_missing};

/// The rows of a table that hold their key in one of three columns, and those that do not.
///
/// A row of the first table holds the two elements after the key in `circle`, which goes around, then the columns
/// `kept`. Rows in which an element of the circle is missing, or a column of `merged` is not the element so many places
/// after the key, are not turned.
///
/// # Errors
/// When there are more rows than `u32` can count.
pub fn corners<const N: usize, const M: usize>(
    table: &Table<N>,
    circle: [usize; 3],
    merged: &[(usize, usize)],
    kept: &[usize],
) -> Result<(Table<M>, Table<N>), PlanError> {
    let turned = |key: u32, row: &[u32; N]| -> Option<[u32; M]> {
        let corners = circle.map(|column| row[column]);
        let first = corners.iter().position(|corner| *corner == key)?;
        let after = |places: usize| corners[(first + places) % 3];
        let is_whole = !corners.iter().any(|corner| is_missing(*corner));
        let is_same = merged
            .iter()
            .all(|&(column, places)| row[column] == after(places));
        (is_whole && is_same).then(|| {
            std::array::from_fn(|k| match k {
                0 | 1 => after(k + 1),
                _ => row[kept[k - 2]],
            })
        })
    };
    let mut chunks = in_chunks(table.n_keys(), |keys| {
        let mut first = Table::<M>::with_capacity(keys.len());
        let mut others = Table::<N>::with_capacity(0);
        for key in keys {
            for row in table.rows_of(key as usize) {
                match turned(key, row) {
                    Some(row) => first.push(row),
                    None => others.push(*row),
                }
            }
            first.finish_key()?;
            others.finish_key()?;
        }
        Ok((first, others))
    })?;
    Ok((
        concatenated(&mut chunks, |chunk| &mut chunk.0)?,
        concatenated(&mut chunks, |chunk| &mut chunk.1)?,
    ))
}
