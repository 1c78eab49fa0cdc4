//! Loops and definitions entry by entry.

use nalgebra::DMatrix;

use super::array::{compare, integer, numbers, real, reals, size};
use super::{Fault, Interpreter, Scope, Value};
use crate::ir::{ExprId, Fold, Layout, Range, VariableId};
use crate::optimize::Rows;
use crate::syntax::ast::CompareOp;
use crate::types::{Number, Type, element_dimension};

type Result<T> = std::result::Result<T, Fault>;

impl<'a> Interpreter<'a> {
    /// What a bound variable runs over.
    pub(super) fn range(
        &self,
        scope: &mut Scope<'a>,
        e: ExprId,
        variable: VariableId,
        range: &Range,
    ) -> Result<Vec<Value>> {
        let set = match range {
            Range::Set(set) => *set,
            Range::Integers(from, to) => {
                let (from, to) = (self.number(scope, *from)?, self.number(scope, *to)?);
                return Ok((from..=to).map(Value::Integer).collect());
            }
            Range::Rows { .. } => {
                match scope.plan.and_then(|p| p.space(variable)).map(|s| s.rows) {
                    Some(Rows::Members(set)) => set,
                    Some(Rows::Universe(element)) => {
                        let n = self.meshes[&element.mesh].count(element_dimension(element.kind));
                        return Ok((0..n as u32).map(Value::Element).collect());
                    }
                    _ => panic!(
                        "bug in iheartmesh: no rows in {}",
                        crate::ir::expression(self.program, e)
                    ),
                }
            }
        };
        self.members(scope, set)
    }

    pub(super) fn fold(
        &self,
        scope: &mut Scope<'a>,
        e: ExprId,
        op: Fold,
        values: Vec<Value>,
    ) -> Result<Value> {
        let ty = self.ty(e);
        let too_large = || self.fault(e);
        Ok(match op {
            Fold::Sum => match ty {
                Type::Scalar(Number::Integer) => {
                    let mut terms = values.into_iter().map(integer);
                    let sum = terms.try_fold(0i64, |sum, term| sum.checked_add(term));
                    Value::Integer(sum.ok_or_else(too_large)?)
                }
                Type::Scalar(Number::Real) => {
                    Value::Real(values.into_iter().map(real).fold(0.0, |a, b| a + b))
                }
                _ => {
                    let terms: Vec<DMatrix<f64>> = values.into_iter().map(reals).collect();
                    let (rows, columns) = match terms.first() {
                        Some(first) => first.shape(),
                        None => self.shape_of(scope, ty).ok_or_else(|| self.fault(e))?,
                    };
                    if terms.iter().any(|term| term.shape() != (rows, columns)) {
                        return Err(self.fault(e));
                    }
                    let zero = DMatrix::zeros(rows, columns);
                    if terms.iter().any(|term| term.shape() != zero.shape()) {
                        return Err(self.fault(e));
                    }
                    Value::Reals(terms.iter().fold(zero, |sum, term| sum + term))
                }
            },
            Fold::Product => match ty {
                Type::Scalar(Number::Integer) => {
                    let mut factors = values.into_iter().map(integer);
                    let product = factors.try_fold(1i64, |product, f| product.checked_mul(f));
                    Value::Integer(product.ok_or_else(too_large)?)
                }
                _ => Value::Real(values.into_iter().map(real).fold(1.0, |a, b| a * b)),
            },
            Fold::Union => {
                let members = values.into_iter().flat_map(|value| match value {
                    Value::Set(members) => members,
                    other => panic!("bug in iheartmesh: {other} is no set"),
                });
                Value::set(members)
            }
            Fold::Collect => Value::set(values),
            Fold::Min | Fold::Max => {
                let better = match op {
                    Fold::Min => CompareOp::Less,
                    _ => CompareOp::Greater,
                };
                let best = values.into_iter().reduce(|best, value| {
                    match is_better(better, &value, &best) {
                        true => value,
                        false => best,
                    }
                });
                best.ok_or_else(|| self.fault(e))?
            }
            Fold::ArgMin | Fold::ArgMax => {
                let better = match op {
                    Fold::ArgMin => CompareOp::Less,
                    _ => CompareOp::Greater,
                };
                let pairs = values.into_iter().map(|pair| match pair {
                    Value::Tuple(pair) => pair,
                    other => panic!("bug in iheartmesh: {other} is no pair"),
                });
                let best = pairs.reduce(|best, pair| match is_better(better, &pair[0], &best[0]) {
                    true => pair,
                    false => best,
                });
                let mut best = best.ok_or_else(|| self.fault(e))?;
                best.swap_remove(1)
            }
        })
    }

    /// Rows and columns of a type, where they are known.
    fn shape_of(&self, scope: &Scope<'a>, ty: &Type) -> Option<(usize, usize)> {
        let known = |dimension| self.size(scope, dimension).map(size);
        Some(match ty {
            Type::Vector { length, .. } => (known(length)?, 1),
            Type::Matrix { rows, columns, .. } => (known(rows)?, known(columns)?),
            _ => (1, 1),
        })
    }

    /// An element-wise definition.
    pub(super) fn tabulate(
        &self,
        scope: &mut Scope<'a>,
        e: ExprId,
        layout: Layout,
        variables: &[VariableId],
        sizes: &[ExprId],
        body: ExprId,
    ) -> Result<Value> {
        let ty = self.ty(e);
        let sizes = self.sizes(scope, sizes)?;
        let columns = sizes.get(1).copied().unwrap_or(1);
        // row by row
        let mut values = Vec::new();
        for i in 1..=sizes[0] as i64 {
            for j in 1..=columns as i64 {
                for (variable, index) in variables.iter().zip([i, j]) {
                    let value = match self.program.arena.variable_type(*variable) {
                        Type::Element(_) => Value::Element(index as u32 - 1),
                        _ => Value::Integer(index),
                    };
                    scope.bind(*variable, value);
                }
                values.push(self.eval(scope, body)?);
            }
        }
        Ok(match layout {
            Layout::Sequence => Value::Sequence(values),
            Layout::Vector | Layout::Matrix | Layout::Sparse => {
                numbers(ty, sizes[0], columns, |i, j| &values[i * columns + j])
            }
            Layout::Diagonal => {
                let entries: Vec<f64> = values.into_iter().map(real).collect();
                Value::Reals(DMatrix::from_diagonal(&entries.into()))
            }
            Layout::Rows | Layout::Columns => {
                let vectors: Vec<DMatrix<f64>> = values.into_iter().map(reals).collect();
                let length = match (vectors.first(), self.ty(body)) {
                    (Some(first), _) => first.nrows(),
                    (None, Type::Vector { length, .. }) => {
                        size(self.size(scope, length).unwrap_or(0))
                    }
                    _ => 0,
                };
                if vectors.iter().any(|v| v.nrows() != length) {
                    return Err(self.fault(e));
                }
                let columns = DMatrix::from_fn(length, vectors.len(), |i, j| vectors[j][(i, 0)]);
                Value::Reals(match layout {
                    Layout::Rows => columns.transpose(),
                    _ => columns,
                })
            }
        })
    }
}

/// Whether a number takes the place of the best one so far: what is not a number gives way to all others.
fn is_better(better: CompareOp, value: &Value, best: &Value) -> bool {
    let is_number = |value: &Value| !matches!(value, Value::Real(x) if x.is_nan());
    compare(better, value, best) || is_number(value) && !is_number(best)
}
