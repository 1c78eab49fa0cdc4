//! Arrays that blocks are added to.

use nalgebra::DMatrix;

use super::array::{from_one, integer, reals};
use super::{Fault, Interpreter, Scope, Value};
use crate::ir::{Block, ExprId};

impl<'a> Interpreter<'a> {
    /// An array of zeros with these blocks added.
    pub(super) fn assemble(
        &self,
        scope: &mut Scope<'a>,
        e: ExprId,
        sizes: &[ExprId],
        blocks: &[Block],
    ) -> Result<Value, Fault> {
        let sizes = self.sizes(scope, sizes)?;
        let columns = sizes.get(1).copied();
        let mut all = DMatrix::zeros(sizes[0], columns.unwrap_or(1));
        for block in blocks {
            let mut value = reals(self.eval(scope, block.value)?);
            if columns.is_none() {
                // column by column
                let n = value.len();
                value = DMatrix::from_column_slice(n, 1, value.as_slice());
            }
            let mut rows = self.places(scope, &block.rows, value.nrows())?;
            let mut across = vec![Some(0)];
            if columns.is_some() {
                across = self.places(scope, &block.columns, value.ncols())?;
            }
            for (j, column) in across.drain(..).enumerate() {
                for (i, row) in rows.iter_mut().enumerate() {
                    match (*row, column) {
                        (Some(row), Some(column)) if row < all.nrows() && column < all.ncols() => {
                            all[(row, column)] += value[(i, j)];
                        }
                        _ => return Err(self.fault(e)),
                    }
                }
            }
        }
        Ok(Value::Reals(all))
    }

    /// Where each of `n` rows goes, from 0.
    fn places(
        &self,
        scope: &mut Scope<'a>,
        places: &[ExprId],
        n: usize,
    ) -> Result<Vec<Option<usize>>, Fault> {
        let height = n / places.len().max(1);
        let mut all = Vec::new();
        for place in places {
            let start = match self.eval(scope, *place)? {
                Value::Element(id) => Some(id as usize),
                number => from_one(integer(number), usize::MAX),
            };
            let start = start.and_then(|start| start.checked_mul(height));
            all.extend((0..height).map(|k| Some(start? + k)));
        }
        Ok(all)
    }
}
