//! Matrices by places and numbers, and values with entries replaced.

use nalgebra::DMatrix;

use super::array::{from_one, real, reals, size};
use super::{Fault, Interpreter, Scope, Value};
use crate::ir::{ExprId, VariableId};

type Result<T> = std::result::Result<T, Fault>;

impl<'a> Interpreter<'a> {
    /// For each member of a set a number at a place.
    pub(super) fn scatter(
        &self,
        scope: &mut Scope<'a>,
        e: ExprId,
        (variable, set): (VariableId, ExprId),
        sizes: [ExprId; 2],
        place: [ExprId; 2],
        body: ExprId,
    ) -> Result<Value> {
        let rows = size(self.number(scope, sizes[0])?);
        let columns = size(self.number(scope, sizes[1])?);
        let mut all = DMatrix::zeros(rows, columns);
        for member in self.members(scope, set)? {
            scope.bind(variable, member);
            let row = from_one(self.number(scope, place[0])?, rows);
            let column = from_one(self.number(scope, place[1])?, columns);
            let value = real(self.eval(scope, body)?);
            match (row, column) {
                (Some(i), Some(j)) => all[(i, j)] += value,
                _ => return Err(self.fault(e)),
            }
        }
        Ok(Value::Reals(all))
    }

    /// A value with entries replaced, one after the other.
    pub(super) fn update(
        &self,
        scope: &mut Scope<'a>,
        e: ExprId,
        base: ExprId,
        entries: &[(Vec<Option<ExprId>>, ExprId)],
    ) -> Result<Value> {
        let mut all = self.eval(scope, base)?;
        for (subscripts, value) in entries {
            let mut numbers = Vec::new();
            for subscript in subscripts {
                numbers.push(match subscript {
                    Some(subscript) => Some(self.number(scope, *subscript)?),
                    None => None,
                });
            }
            let value = self.eval(scope, *value)?;
            let set = match &mut all {
                Value::Sequence(items) => numbers[0]
                    .and_then(|k| from_one(k, items.len()))
                    .map(|place| items[place] = value),
                Value::Reals(a) => set_entries(a, &numbers, value),
                other => panic!("bug in iheartmesh: {other} has no entries that are replaced"),
            };
            set.ok_or_else(|| self.fault(e))?;
        }
        Ok(all)
    }
}

/// Sets an entry, a row or a column; nothing where there is none.
fn set_entries(a: &mut DMatrix<f64>, numbers: &[Option<i64>], value: Value) -> Option<()> {
    let row = |k| from_one(k, a.nrows());
    let column = |k| from_one(k, a.ncols());
    match numbers {
        [Some(i)] => {
            let i = row(*i)?;
            a[(i, 0)] = real(value);
        }
        [Some(i), Some(j)] => {
            let place = (row(*i)?, column(*j)?);
            a[place] = real(value);
        }
        [Some(i), None] => {
            let (i, value) = (row(*i)?, reals(value));
            (value.nrows() == a.ncols()).then(|| a.set_row(i, &value.transpose().row(0)))?;
        }
        [None, Some(j)] => {
            let (j, value) = (column(*j)?, reals(value));
            (value.nrows() == a.nrows()).then(|| a.set_column(j, &value.column(0)))?;
        }
        _ => return None,
    }
    Some(())
}
