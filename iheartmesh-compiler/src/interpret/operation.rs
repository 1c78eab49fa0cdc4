//! Operations with one and with two operands.

use nalgebra::DMatrix;

use super::array::{integer, real, reals, shape};
use super::{Fault, Interpreter, Value, factor};
use crate::ir::{Binary, Elementary, ExprId, Unary};
use crate::types::{Number, Type};

type Result = std::result::Result<Value, Fault>;

impl Interpreter<'_> {
    /// An operation with one operand.
    pub(super) fn unary(&self, e: ExprId, op: Unary, a: Value) -> Result {
        let ty = self.ty(e);
        let fault = || self.fault(e);
        Ok(match op {
            Unary::Negate => match a {
                Value::Integer(k) => Value::Integer(k.checked_neg().ok_or_else(fault)?),
                Value::Real(x) => Value::Real(-x),
                a => Value::Reals(-reals(a)),
            },
            Unary::Absolute => match a {
                Value::Integer(k) => Value::Integer(k.checked_abs().ok_or_else(fault)?),
                a => Value::Real(real(a).abs()),
            },
            Unary::SquareRoot => Value::Real(real(a).sqrt()),
            Unary::Norm => Value::Real(reals(a).iter().map(|x| x * x).sum::<f64>().sqrt()),
            Unary::NormOne => Value::Real(reals(a).iter().map(|x| x.abs()).sum()),
            Unary::NormMax => {
                let larger = |most: f64, x: &f64| match x.is_nan() || x.abs() > most {
                    true => x.abs(),
                    false => most,
                };
                Value::Real(reals(a).iter().fold(0.0, larger))
            }
            Unary::NormZero => Value::Real(reals(a).iter().filter(|x| **x != 0.0).count() as f64),
            Unary::NormNuclear => Value::Real(factor::singular_values(&reals(a)).iter().sum()),
            Unary::Transpose => match a {
                Value::Integers(a) => Value::Integers(a.transpose()),
                a => Value::Reals(reals(a).transpose()),
            },
            Unary::Inverse => Value::Reals(factor::inverse(reals(a)).ok_or_else(fault)?),
            Unary::PseudoInverse => Value::Reals(factor::pseudo_inverse(&reals(a))),
            Unary::Determinant => Value::Real(reals(a).determinant()),
            Unary::Trace => {
                let a = reals(a);
                Value::Real((0..a.nrows().min(a.ncols())).map(|i| a[(i, i)]).sum())
            }
            Unary::Rank => Value::Integer(factor::rank(&reals(a)) as i64),
            Unary::Diagonal => {
                let a = reals(a);
                Value::Reals(match ty {
                    Type::Matrix { .. } => DMatrix::from_diagonal(&a.column(0).into_owned()),
                    _ => DMatrix::from_fn(a.nrows().min(a.ncols()), 1, |i, _| a[(i, i)]),
                })
            }
            Unary::Stack => Value::vector(&stack(a)),
            Unary::NullSpace => Value::Reals(factor::null_space(&reals(a))),
            Unary::OrthogonalBasis => Value::Reals(factor::orthogonal_basis(&reals(a))),
            Unary::SingularValues => {
                let (u, values, v) = factor::decomposition(&reals(a));
                Value::Tuple(vec![
                    Value::Reals(u),
                    Value::vector(&values),
                    Value::Reals(v),
                ])
            }
            Unary::Least | Unary::Greatest => match a {
                Value::Integers(a) => {
                    let entries = a.iter().copied();
                    let best = if op == Unary::Least {
                        entries.min()
                    } else {
                        entries.max()
                    };
                    Value::Integer(best.ok_or_else(fault)?)
                }
                Value::Sequence(items) if *ty == Type::INTEGER => {
                    let entries = items.into_iter().map(integer);
                    let best = if op == Unary::Least {
                        entries.min()
                    } else {
                        entries.max()
                    };
                    Value::Integer(best.ok_or_else(fault)?)
                }
                a => {
                    let better = |x: f64, y: f64| if op == Unary::Least { x < y } else { x > y };
                    let best = stack(a).into_iter().reduce(|best, x| {
                        if x.is_nan() || better(x, best) {
                            x
                        } else {
                            best
                        }
                    });
                    Value::Real(best.ok_or_else(fault)?)
                }
            },
            Unary::PositivePart => {
                Value::Reals(factor::with_eigenvalues(&reals(a), |x| x.max(0.0)))
            }
            Unary::AbsolutePart => Value::Reals(factor::with_eigenvalues(&reals(a), f64::abs)),
            Unary::Reshape => match (ty, a) {
                (Type::Scalar(_), a) if shape(&a) != (1, 1) => return Err(fault()),
                (Type::Scalar(Number::Integer), Value::Integers(a)) => Value::Integer(a[(0, 0)]),
                (Type::Scalar(Number::Integer), a) => a,
                (Type::Scalar(_), a) => Value::Real(real(a)),
                (_, Value::Integers(a)) => Value::Integers(a),
                (_, a) => {
                    let a = reals(a);
                    if !fits(ty, a.shape()) {
                        return Err(fault());
                    }
                    Value::Reals(a)
                }
            },
            Unary::ToReal => match a {
                Value::Integer(k) => Value::Real(k as f64),
                Value::Integers(a) => Value::Reals(a.map(|k| k as f64)),
                a => a,
            },
            Unary::ToInteger => match a {
                Value::Element(id) => Value::Integer(i64::from(id) + 1),
                other => panic!("bug in iheartmesh: {other} is no element"),
            },
            Unary::ToElement => match a {
                Value::Integer(k) => Value::Element((k - 1) as u32),
                other => panic!("bug in iheartmesh: {other} is no number"),
            },
            Unary::ByRows | Unary::ByColumns => a,
            Unary::FromHost => a.counted(),
            Unary::Apply(function) => match a {
                Value::Real(x) => Value::Real(elementary(function, x)),
                a => Value::Reals(reals(a).map(|x| elementary(function, x))),
            },
        })
    }

    /// An operation with two operands.
    pub(super) fn binary(&self, e: ExprId, op: Binary, a: Value, b: Value) -> Result {
        let ty = self.ty(e);
        let fault = || self.fault(e);
        if let (Value::Integer(a), Value::Integer(b)) = (&a, &b) {
            let result = match op {
                Binary::Add => a.checked_add(*b),
                Binary::Subtract => a.checked_sub(*b),
                Binary::Multiply => a.checked_mul(*b),
                Binary::Min => Some(*a.min(b)),
                Binary::Max => Some(*a.max(b)),
                other => panic!("bug in iheartmesh: {other:?} of integers"),
            };
            return result.map(Value::Integer).ok_or_else(fault);
        }
        Ok(match op {
            Binary::Add => self.zip(e, a, b, |x, y| x + y)?,
            Binary::Subtract => self.zip(e, a, b, |x, y| x - y)?,
            Binary::Hadamard => self.zip(e, a, b, |x, y| x * y)?,
            Binary::Multiply => {
                let k = real(a);
                match b {
                    Value::Real(x) => Value::Real(k * x),
                    b => Value::Reals(reals(b).map(|x| k * x)),
                }
            }
            Binary::Divide => {
                let k = real(b);
                match a {
                    Value::Real(x) => Value::Real(x / k),
                    a => Value::Reals(reals(a).map(|x| x / k)),
                }
            }
            Binary::Power => Value::Real(real(a).powf(real(b))),
            Binary::Atan2 => Value::Real(real(a).atan2(real(b))),
            Binary::Min => Value::Real(real(a).min(real(b))),
            Binary::Max => Value::Real(real(a).max(real(b))),
            Binary::Dot | Binary::Frobenius => {
                let (a, b) = (reals(a), reals(b));
                if a.shape() != b.shape() {
                    return Err(fault());
                }
                Value::Real(a.iter().zip(b.iter()).map(|(x, y)| x * y).sum())
            }
            Binary::Cross => {
                let (a, b) = (reals(a), reals(b));
                Value::vector(&[
                    a[1] * b[2] - a[2] * b[1],
                    a[2] * b[0] - a[0] * b[2],
                    a[0] * b[1] - a[1] * b[0],
                ])
            }
            Binary::Product => {
                let (a, b) = (reals(a), reals(b));
                if a.ncols() != b.nrows() {
                    return Err(fault());
                }
                match ty {
                    Type::Scalar(_) => Value::Real((a * b)[(0, 0)]),
                    _ => Value::Reals(a * b),
                }
            }
            Binary::Kronecker => Value::Reals(reals(a).kronecker(&reals(b))),
            Binary::Solve => {
                let (a, b) = (reals(a), reals(b));
                if a.nrows() != b.nrows() {
                    return Err(fault());
                }
                Value::Reals(factor::solve(a, &b).ok_or_else(fault)?)
            }
            Binary::MatrixPower => {
                Value::Reals(factor::power(&reals(a), real(b)).ok_or_else(fault)?)
            }
            Binary::NormPower => {
                let p = real(b);
                let sum: f64 = reals(a).iter().map(|x| x.abs().powf(p)).sum();
                Value::Real(sum.powf(1.0 / p))
            }
            Binary::NormWeighted => {
                let (u, p) = (reals(a), reals(b));
                if (u.nrows(), u.nrows()) != p.shape() {
                    return Err(fault());
                }
                Value::Real((u.transpose() * p * u)[(0, 0)].sqrt())
            }
            Binary::Unstack => self.unstack(e, a, &reals(b))?,
            Binary::Append => match a {
                Value::Sequence(mut items) => {
                    items.push(b);
                    Value::Sequence(items)
                }
                other => panic!("bug in iheartmesh: {other} is no sequence"),
            },
        })
    }

    /// Two entries at a time.
    fn zip(&self, e: ExprId, a: Value, b: Value, f: impl Fn(f64, f64) -> f64) -> Result {
        match (a, b) {
            (Value::Real(x), Value::Real(y)) => Ok(Value::Real(f(x, y))),
            (a, b) => {
                let (a, b) = (reals(a), reals(b));
                if a.shape() != b.shape() {
                    return Err(self.fault(e));
                }
                Ok(Value::Reals(a.zip_map(&b, f)))
            }
        }
    }

    /// Entries in the shape of a vector, matrix or sequence.
    fn unstack(&self, e: ExprId, like: Value, entries: &DMatrix<f64>) -> Result {
        let mut entries = entries.iter().copied();
        let mut part = |like: &Value| {
            let (rows, columns) = shape(like);
            let part: Vec<f64> = entries.by_ref().take(rows * columns).collect();
            if part.len() < rows * columns {
                return Err(self.fault(e));
            }
            Ok(match like {
                Value::Real(_) => Value::Real(part[0]),
                _ => Value::Reals(DMatrix::from_column_slice(rows, columns, &part)),
            })
        };
        let value = match &like {
            Value::Sequence(items) => {
                let parts = items
                    .iter()
                    .map(part)
                    .collect::<std::result::Result<_, _>>();
                Value::Sequence(parts?)
            }
            other => part(other)?,
        };
        match entries.next() {
            Some(_) => Err(self.fault(e)),
            None => Ok(value),
        }
    }
}

/// Whether a type with known sizes has these.
fn fits(ty: &Type, (rows, columns): (usize, usize)) -> bool {
    let agrees = |dimension: &crate::types::Dimension, found: usize| {
        dimension.value().is_none_or(|n| n == found as i64)
    };
    match ty {
        Type::Vector { length, .. } => agrees(length, rows) && columns == 1,
        Type::Matrix {
            rows: n,
            columns: m,
            ..
        } => agrees(n, rows) && agrees(m, columns),
        _ => true,
    }
}

/// The entries of an array down its columns, of a sequence item by item.
fn stack(value: Value) -> Vec<f64> {
    match value {
        Value::Sequence(items) => items.into_iter().flat_map(stack).collect(),
        Value::Integer(k) => vec![k as f64],
        Value::Integers(a) => a.iter().map(|k| *k as f64).collect(),
        other => reals(other).iter().copied().collect(),
    }
}

fn elementary(function: Elementary, x: f64) -> f64 {
    match function {
        Elementary::Sin => x.sin(),
        Elementary::Cos => x.cos(),
        Elementary::Tan => x.tan(),
        Elementary::Cot => 1.0 / x.tan(),
        Elementary::Sec => 1.0 / x.cos(),
        Elementary::Csc => 1.0 / x.sin(),
        Elementary::Asin => x.asin(),
        Elementary::Acos => x.acos(),
        Elementary::Atan => x.atan(),
        Elementary::Sinh => x.sinh(),
        Elementary::Cosh => x.cosh(),
        Elementary::Tanh => x.tanh(),
        Elementary::Asinh => x.asinh(),
        Elementary::Acosh => x.acosh(),
        Elementary::Atanh => x.atanh(),
        Elementary::Exp => x.exp(),
        Elementary::Ln => x.ln(),
        Elementary::Log2 => x.log2(),
        Elementary::Log10 => x.log10(),
    }
}
