//! Functions of the built-in module `linearalgebra`, and sequences.

use super::Checker;
use super::builtin::Builtin;
use crate::ir::{Binary, ExprId, Kind, Layout, Unary};
use crate::syntax::ast::CompareOp;
use crate::types::{Number, Shape, Type};

/// Whether a name is one of `linearalgebra`.
pub(super) fn is_linear(builtin: &str) -> bool {
    const NAMES: [&str; 14] = [
        "trace",
        "tr",
        "det",
        "rank",
        "inv",
        "diag",
        "vec",
        "vec⁻¹",
        "inversevec",
        "null",
        "orth",
        "svd",
        "psd",
        "psd_abs",
    ];
    NAMES.contains(&builtin)
}

impl<'a> Checker<'a> {
    /// A call of a function of `linearalgebra`.
    pub(super) fn linear_algebra(&mut self, call: &Builtin<'_, 'a>, builtin: &str) -> ExprId {
        match builtin {
            "trace" | "tr" => self.linear(
                call,
                |_, ty| match ty.shape()? {
                    Shape::Matrix(n, m) if !n.differs(&m) => Some((Unary::Trace, Type::REAL)),
                    _ => None,
                },
                "a square matrix",
            ),
            "det" => self.linear(
                call,
                |_, ty| match ty.shape()? {
                    Shape::Matrix(n, m) if !n.differs(&m) => Some((Unary::Determinant, Type::REAL)),
                    _ => None,
                },
                "a square matrix",
            ),
            "rank" => self.linear(
                call,
                |_, ty| match ty.shape()? {
                    Shape::Matrix(..) => Some((Unary::Rank, Type::INTEGER)),
                    _ => None,
                },
                "a matrix",
            ),
            "inv" => self.linear(
                call,
                |_, ty| match ty.shape()? {
                    Shape::Matrix(n, m) if !n.differs(&m) => {
                        Some((Unary::Inverse, Type::real_matrix(n, m)))
                    }
                    _ => None,
                },
                "a square matrix",
            ),
            "diag" if call.values.len() == 1 => self.linear(
                call,
                |_, ty| match ty.shape()? {
                    Shape::Matrix(n, m) if !n.differs(&m) => {
                        Some((Unary::Diagonal, Type::real_vector(n)))
                    }
                    Shape::Vector(n) => Some((Unary::Diagonal, Type::real_matrix(n.clone(), n))),
                    _ => None,
                },
                "a vector or a square matrix",
            ),
            "diag" if call.values.len() == 3 => self.rectangular_diagonal(call),
            "vec" => self.linear(
                call,
                |checker, ty| match ty.shape() {
                    Some(Shape::Vector(n)) => Some((Unary::Reshape, Type::real_vector(n))),
                    Some(Shape::Matrix(n, m)) => {
                        let length = n.multiply(&m).unwrap_or_else(|| checker.new_dimension());
                        Some((Unary::Stack, Type::real_vector(length)))
                    }
                    _ => match ty {
                        Type::Sequence { item, length, .. } => {
                            let (n, m) = item.shape().and_then(super::operator::extents)?;
                            let each = n.multiply(&m).and_then(|each| each.multiply(length));
                            let length = each.unwrap_or_else(|| checker.new_dimension());
                            Some((Unary::Stack, Type::real_vector(length)))
                        }
                        _ => None,
                    },
                },
                "a vector, a matrix, or a sequence of these",
            ),
            "vec⁻¹" | "inversevec" => self.unstack(call),
            "null" => self.linear(
                call,
                |checker, ty| match ty.shape()? {
                    Shape::Matrix(_, m) => Some((
                        Unary::NullSpace,
                        Type::real_matrix(m, checker.new_dimension()),
                    )),
                    _ => None,
                },
                "a matrix",
            ),
            "orth" => self.linear(
                call,
                |checker, ty| match ty.shape()? {
                    Shape::Matrix(n, _) => Some((
                        Unary::OrthogonalBasis,
                        Type::real_matrix(n, checker.new_dimension()),
                    )),
                    _ => None,
                },
                "a matrix",
            ),
            "svd" => self.linear(
                call,
                |checker, ty| match ty.shape()? {
                    Shape::Matrix(n, m) => {
                        let least = match (n.value(), m.value()) {
                            (Some(n), Some(m)) => crate::types::Dimension::known(n.min(m)),
                            _ if n == m => n.clone(),
                            _ => checker.new_dimension(),
                        };
                        let items = vec![
                            Type::real_matrix(n.clone(), n),
                            Type::real_vector(least),
                            Type::real_matrix(m.clone(), m),
                        ];
                        Some((Unary::SingularValues, Type::Tuple(items)))
                    }
                    _ => None,
                },
                "a matrix",
            ),
            "psd" | "psd_abs" => self.linear(
                call,
                |_, ty| match ty.shape()? {
                    Shape::Matrix(n, m) if !n.differs(&m) => {
                        let part = match builtin {
                            "psd" => Unary::PositivePart,
                            _ => Unary::AbsolutePart,
                        };
                        let mut result = Type::real_matrix(n, m);
                        if let Type::Matrix { sparse, .. } = &mut result {
                            *sparse = ty.is_sparse();
                        }
                        Some((part, result))
                    }
                    _ => None,
                },
                "a square matrix",
            ),
            _ => self.unsupported(call.span, &format!("`{}` is", call.name.text)),
        }
    }

    /// `diag(v, r, c)`: the matrix of `r` rows and `c` columns with as much of this diagonal as fits, and 0 elsewhere.
    fn rectangular_diagonal(&mut self, call: &Builtin<'_, 'a>) -> ExprId {
        let vector = call.values[0];
        let Some(Shape::Vector(_)) = self.ty(vector).shape() else {
            return self.wrong(call, 0, "a vector");
        };
        let (Some((rows, n)), Some((columns, m))) = (
            self.written_size(call.arguments[1]),
            self.written_size(call.arguments[2]),
        ) else {
            return self.error();
        };
        let arena = &mut self.program.arena;
        let variables = vec![
            arena.new_variable("i", Type::INTEGER),
            arena.new_variable("j", Type::INTEGER),
        ];
        let (i, j) = (arena.variable(variables[0]), arena.variable(variables[1]));
        let zero = arena.real(0.0);
        let last = self.extent(vector, 0);
        let on = self.add(Kind::Compare(CompareOp::Equal, i, j), Type::Boolean);
        let within = self.add(
            Kind::Compare(CompareOp::LessOrEqual, i, last),
            Type::Boolean,
        );
        let chosen = self.add(Kind::And(on, within), Type::Boolean);
        let number = match self.ty(vector) {
            Type::Vector { number, .. } => *number,
            _ => Number::Real,
        };
        let entry = self.add_at(call.span, Kind::Component(vector, i), Type::Scalar(number));
        let entry = self.real(entry);
        let body = self.add(Kind::If(chosen, entry, zero), Type::REAL);
        self.add_at(
            call.span,
            Kind::Tabulate {
                layout: Layout::Matrix,
                variables,
                sizes: vec![n, m],
                body,
            },
            Type::real_matrix(rows, columns),
        )
    }

    /// A function of linear algebra with one argument.
    fn linear(
        &mut self,
        call: &Builtin<'_, 'a>,
        result: impl FnOnce(&mut Self, &Type) -> Option<(Unary, Type)>,
        takes: &str,
    ) -> ExprId {
        if !self.takes(call, 1) {
            return self.error();
        }
        let ty = self.ty(call.values[0]).clone();
        match result(self, &ty) {
            Some((op, ty)) => {
                let square = matches!(
                    op,
                    Unary::Trace
                        | Unary::Determinant
                        | Unary::Inverse
                        | Unary::PositivePart
                        | Unary::AbsolutePart
                        | Unary::Diagonal
                );
                let value = match square {
                    true => self.squared(call.span, call.values[0]),
                    false => call.values[0],
                };
                let value = self.real(value);
                self.add_at(call.span, Kind::Unary(op, value), ty)
            }
            None => self.wrong(call, 0, takes),
        }
    }

    /// `vec⁻¹_x(v)`: the entries of `v` in the shape of `x`.
    fn unstack(&mut self, call: &Builtin<'_, 'a>) -> ExprId {
        if !self.takes(call, 2) {
            return self.error();
        }
        let (shape, entries) = (call.values[0], call.values[1]);
        let ty = self.ty(shape).clone();
        if !matches!(self.ty(entries).shape(), Some(Shape::Vector(_))) {
            return self.wrong(call, 1, "a vector");
        }
        let result = match (ty.shape(), &ty) {
            (Some(Shape::Vector(_) | Shape::Matrix(..)), _) => ty.with_reals(),
            (
                None,
                Type::Sequence {
                    item,
                    length,
                    index,
                },
            ) if item.shape().is_some() => Type::Sequence {
                item: Box::new(item.with_reals()),
                length: length.clone(),
                index: *index,
            },
            _ => return self.wrong(call, 0, "a vector, a matrix, or a sequence of these"),
        };
        let entries = self.real(entries);
        self.add_at(
            call.span,
            Kind::Binary(Binary::Unstack, shape, entries),
            result,
        )
    }

    /// `sequence(a, b, …)`, `sequence(q, a, …)`, `sequence(S)`.
    pub(super) fn sequence(&mut self, call: &Builtin<'_, 'a>) -> ExprId {
        let Some((&first, rest)) = call.values.split_first() else {
            return self.wrong_count(call, "at least 1 argument");
        };
        match self.ty(first).clone() {
            Type::Set(item) if rest.is_empty() => {
                let length = self.new_dimension();
                let ty = Type::Sequence {
                    item,
                    length,
                    index: None,
                };
                self.add(Kind::SequenceOf(first), ty)
            }
            Type::Sequence { item, .. } => {
                let mut sequence = first;
                for (k, value) in rest.iter().enumerate() {
                    let value = self.convert(*value, &item);
                    if self.ty(value) != &*item {
                        return self.wrong(call, k + 1, &format!("items of type {item}"));
                    }
                    let ty = Type::Sequence {
                        item: item.clone(),
                        length: self.new_dimension(),
                        index: None,
                    };
                    sequence = self.add(Kind::Binary(Binary::Append, sequence, value), ty);
                }
                sequence
            }
            item => {
                let item = match call.values.iter().any(|v| *self.ty(*v) == Type::REAL) {
                    true => Type::REAL,
                    false => item,
                };
                let mut items = Vec::new();
                for (k, value) in call.values.iter().enumerate() {
                    let value = self.convert(*value, &item);
                    if self.ty(value) != &item {
                        return self.wrong(call, k, &format!("items of one type, here {item}"));
                    }
                    items.push(value);
                }
                let ty = Type::Sequence {
                    item: Box::new(item),
                    length: crate::types::Dimension::known(items.len() as i64),
                    index: None,
                };
                self.add(Kind::Sequence(items), ty)
            }
        }
    }
}
