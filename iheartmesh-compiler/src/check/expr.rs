//! Expressions.

use super::Checker;
use super::scope::Found;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Fold, Kind, Layout, Range, Unary, unproven};
use crate::syntax::ast::{Condition, Expr, ExprKind, Name};
use crate::types::{Dimension, Number, Type};

impl<'a> Checker<'a> {
    /// Checks an expression.
    pub(super) fn expr(&mut self, e: &'a Expr) -> ExprId {
        let value = self.expr_of_kind(e);
        // sizes that only values know may turn out not to agree
        if !unproven(&self.program.arena, value).is_empty() {
            self.program.arena.note_origin(value, e.span);
        }
        value
    }

    fn expr_of_kind(&mut self, e: &'a Expr) -> ExprId {
        match &e.kind {
            ExprKind::Integer(value) => self.program.arena.integer(*value),
            ExprKind::Real(value) => self.program.arena.real(*value),
            ExprKind::Pi => self.program.arena.real(std::f64::consts::PI),
            ExprKind::Infinity => self.program.arena.real(f64::INFINITY),
            ExprKind::Name(name) => self.name(name),
            ExprKind::Subscript { base, subscripts } => self.subscript(e, base, subscripts),
            ExprKind::Call {
                function,
                subscripts,
                arguments,
            } => self.call(e.span, function, subscripts, arguments),
            ExprKind::Unary { op, operand } => self.unary(e, *op, operand),
            ExprKind::Binary {
                op, left, right, ..
            } => self.binary(e, *op, left, right),
            ExprKind::Norm {
                double,
                operand,
                subscript,
            } => self.norm(e, *double, operand, subscript.as_ref()),
            ExprKind::Inner {
                left,
                right,
                weight,
            } => self.inner(e, left, right, weight.as_deref()),
            ExprKind::Vector(items) => self.vector(items),
            ExprKind::Set(items) => self.set_literal(e, items),
            ExprKind::Builder {
                element,
                variables,
                range,
                condition,
            } => self.builder(element, variables, range, condition.as_deref()),
            ExprKind::Big {
                op,
                head,
                body,
                locals,
            } => self.big(e, *op, head, body, locals),
            ExprKind::Piecewise {
                branches,
                otherwise,
            } => self.piecewise(e, branches, otherwise.as_deref()),
            ExprKind::Matrix(rows) => self.matrix(e, rows),
            ExprKind::NumberMatrix {
                ones,
                rows,
                columns,
            } => self.number_matrix(e.span, *ones, rows, columns.as_deref()),
            ExprKind::Optimise { .. } => self.optimise(e),
            ExprKind::Integral { .. } => self.integral(e),
            ExprKind::Derivative { total: true, .. } => {
                self.unsupported(e.span, "total derivatives are")
            }
            ExprKind::Derivative {
                order,
                numerator,
                denominators,
                ..
            } => self.derivative(e, *order, numerator, denominators),
            ExprKind::Gradient { variable, operand } => {
                self.gradient(e, variable.as_deref(), operand)
            }
            ExprKind::Laplacian(_) => self.unsupported(e.span, "`Δ` is"),
            ExprKind::Divergence(_) => self.unsupported(e.span, "`∇⋅` is"),
            ExprKind::Error => self.error(),
        }
    }

    fn name(&mut self, name: &Name) -> ExprId {
        match self.find(name) {
            Found::Value(value) => value,
            Found::Error if name.text == "I" && !self.is_bound("I") => self.report(
                Diagnostic::error(name.span, "the size of this identity matrix is not known").help(
                    "write `I_n` with its size; `I` alone stands for a block between others, as in `[A 0; 0 I]`",
                ),
            ),
            Found::Error => self.error(),
            Found::Dimension => self.size_symbol(&name.text),
            Found::Functions(functions) => {
                if let [(_, crate::resolve::Meaning::Builtin(builtin))] = functions.as_slice()
                    && builtin == "e"
                {
                    return self.program.arena.real(std::f64::consts::E);
                }
                let message = format!("`{}` is a function, not a value", name.text);
                let expr = Expr {
                    kind: ExprKind::Name(name.clone()),
                    span: name.span,
                };
                let diagnostic = Diagnostic::error(name.span, message)
                    .help(format!("call it, as in `{}(…)`", name.text));
                let diagnostic = self.with_origins(diagnostic, &[&expr]);
                self.report(diagnostic)
            }
        }
    }

    /// A number, or the entries of a vector or matrix, as real numbers.
    pub(super) fn real(&mut self, e: ExprId) -> ExprId {
        match (self.ty(e), self.program.arena.kind(e)) {
            (Type::Scalar(Number::Integer), Kind::Integer(value)) => {
                let value = *value as f64;
                self.program.arena.real(value)
            }
            (ty, _) if ty.is_integer() && ty.shape().is_some() => {
                let ty = ty.with_reals();
                self.add(Kind::Unary(crate::ir::Unary::ToReal, e), ty)
            }
            _ => e,
        }
    }

    /// Two values brought to one type: an integer beside a real number becomes one.
    pub(super) fn common(&mut self, a: ExprId, b: ExprId) -> (ExprId, ExprId) {
        match (self.ty(a), self.ty(b)) {
            (Type::Scalar(Number::Real), Type::Scalar(Number::Integer)) => {
                let b = self.real(b);
                (a, b)
            }
            (Type::Scalar(Number::Integer), Type::Scalar(Number::Real)) => {
                let a = self.real(a);
                (a, b)
            }
            (Type::Set(_), Type::Set(_)) => {
                let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
                (self.convert(a, &tb), self.convert(b, &ta))
            }
            _ => (a, b),
        }
    }

    /// A value as the type wants it, where there is a conversion: ℤ to ℝ, and the empty set to a set of anything.
    pub(super) fn convert(&mut self, e: ExprId, to: &Type) -> ExprId {
        if self.is_empty_set(e) && matches!(to, Type::Set(_)) {
            return self.add(Kind::Set(Vec::new()), to.clone());
        }
        if *self.ty(e) == Type::set_of(Type::INTEGER) && *to == Type::set_of(Type::REAL) {
            return self.set_of_reals(e);
        }
        if let (Type::Tuple(own), Type::Tuple(items)) = (self.ty(e).clone(), to)
            && own != *items
            && own.len() == items.len()
        {
            let items: Vec<ExprId> = (0..items.len())
                .map(|k| {
                    let item = self.project(e, k, own[k].clone());
                    self.convert(item, &items[k])
                })
                .collect();
            let types = items.iter().map(|item| self.ty(*item).clone()).collect();
            return self.add(Kind::Tuple(items), Type::Tuple(types));
        }
        if let (Type::Sequence { item, .. }, Type::Sequence { item: wanted, .. }) =
            (self.ty(e).clone(), to)
            && item.is_integer()
            && wanted.shape().is_some()
            && !wanted.is_integer()
        {
            let ty = Type::Sequence {
                item: Box::new(item.with_reals()),
                length: Dimension::known(0),
                index: None,
            };
            return self.each_item(e, &ty, |checker, item| checker.real(item));
        }
        let extents = |ty: &Type| ty.shape().and_then(super::operator::extents);
        let fits = match (extents(self.ty(e)), extents(to)) {
            (Some((n, m)), Some((p, q))) => !n.differs(&p) && !m.differs(&q),
            _ => false,
        };
        match to.shape() {
            Some(shape) if fits && !to.is_integer() => {
                let value = self.shaped(e, &shape);
                self.represented(value, to)
            }
            _ => e,
        }
    }

    /// A vector or matrix in the representation of another one of its shape: a size that is known when the program is
    /// compiled is part of the type in Rust, and sparse matrices are types of their own.
    pub(super) fn represented(&mut self, value: ExprId, to: &Type) -> ExprId {
        let ty = self.ty(value).clone();
        let is_same = ty.is_fixed() == to.is_fixed() && ty.is_sparse() == to.is_sparse();
        if to.shape().is_some() {
            return match is_same || to.is_sparse() {
                true => value,
                false => self.add(Kind::Unary(Unary::Reshape, value), to.clone()),
            };
        }
        match (&ty, to) {
            (Type::Tuple(own), Type::Tuple(items)) if own != items => {
                let items: Vec<ExprId> = (0..items.len())
                    .map(|k| {
                        let item = self.project(value, k, own[k].clone());
                        self.represented(item, &items[k])
                    })
                    .collect();
                let types = items.iter().map(|item| self.ty(*item).clone()).collect();
                self.add(Kind::Tuple(items), Type::Tuple(types))
            }
            (Type::Sequence { item, .. }, Type::Sequence { item: wanted, .. })
                if item.is_fixed() != wanted.is_fixed() =>
            {
                self.each_item(value, to, |checker, item| checker.represented(item, wanted))
            }
            (Type::Set(item), Type::Set(wanted)) if item.is_fixed() != wanted.is_fixed() => {
                let variable = self.program.arena.new_variable("x", (**item).clone());
                let item = self.program.arena.variable(variable);
                let body = self.represented(item, wanted);
                self.add(
                    Kind::Fold {
                        op: Fold::Collect,
                        variable,
                        range: Range::Set(value),
                        condition: None,
                        body,
                    },
                    to.clone(),
                )
            }
            _ => value,
        }
    }

    /// The sequence of what becomes of each item; its items have the type of those of `to`.
    fn each_item(
        &mut self,
        sequence: ExprId,
        to: &Type,
        of: impl FnOnce(&mut Self, ExprId) -> ExprId,
    ) -> ExprId {
        let Type::Sequence {
            item,
            length,
            index,
        } = self.ty(sequence).clone()
        else {
            return sequence;
        };
        let variable = self.program.arena.new_variable("k", Type::INTEGER);
        let k = self.program.arena.variable(variable);
        let item = self.add(Kind::Item(sequence, k), *item);
        let body = of(self, item);
        let size = self.extent(sequence, 0);
        let ty = match to {
            Type::Sequence { item, .. } => Type::Sequence {
                item: item.clone(),
                length,
                index,
            },
            _ => to.clone(),
        };
        self.add(
            Kind::Tabulate {
                layout: Layout::Sequence,
                variables: vec![variable],
                sizes: vec![size],
                body,
            },
            ty,
        )
    }

    /// The type of two sequences of the same items: of a length that is known only at run time where theirs differ.
    fn common_sequence(&mut self, a: &Type, b: &Type) -> Option<Type> {
        let (
            Type::Sequence {
                item,
                length: n,
                index: i,
            },
            Type::Sequence {
                item: other,
                length: m,
                index: j,
            },
        ) = (a, b)
        else {
            return None;
        };
        (item == other).then(|| Type::Sequence {
            item: item.clone(),
            length: match n == m {
                true => n.clone(),
                false => self.new_dimension(),
            },
            index: i.filter(|_| i == j),
        })
    }

    fn piecewise(
        &mut self,
        e: &'a Expr,
        branches: &'a [(Expr, Condition)],
        otherwise: Option<&'a Expr>,
    ) -> ExprId {
        let mut cases = Vec::new();
        let outer = std::mem::replace(&mut self.guarded, true);
        for (value, condition) in branches {
            let condition = self.condition(condition);
            cases.push((value, Some(condition), self.expr(value)));
        }
        if let Some(value) = otherwise {
            cases.push((value, None, self.expr(value)));
        }
        self.guarded = outer;
        // what is in error here may be a recursive call whose type is not yet known
        let typed: Vec<_> = cases
            .iter()
            .filter(|(_, _, v)| !self.is_error(*v))
            .map(|(syntax, _, v)| (*syntax, self.ty(*v).clone()))
            .collect();
        let Some((first, mut ty)) = typed.first().cloned() else {
            return self.error();
        };
        for (syntax, other) in &typed {
            if let Some(shape) = self.same_shape(&ty, other) {
                if ty.is_scalar() && ty.is_integer() && other.is_integer() {
                    continue;
                }
                ty = match (&ty, ty.is_integer()) {
                    (ty, false) if ty == other => ty.clone(),
                    _ => shape.real(),
                };
            } else if let Some(sequence) = self.common_sequence(&ty, other) {
                ty = sequence;
            } else if let Some(set) = common_set(&ty, other) {
                ty = set;
            } else if *other != ty {
                let (a, b) = self.described_both(&ty, other);
                let message = format!("the branches differ: {a} and {b}");
                let help = match (&ty, other) {
                    (Type::Vector { .. }, Type::Vector { .. })
                    | (Type::Matrix { .. }, Type::Matrix { .. }) => {
                        "all branches have one size, known as such while compiling: declare both with it"
                    }
                    _ => "all branches of a piecewise definition must have the same type",
                };
                let diagnostic = Diagnostic::error(syntax.span, message)
                    .here(format!("this is {b}"))
                    .label(first.span, format!("this is {a}"))
                    .help(help);
                let diagnostic = self.with_origins(diagnostic, &[first, syntax]);
                return self.report(diagnostic);
            }
        }
        let mut value = self.add_at(e.span, Kind::Fail, ty.clone());
        for (_, condition, case) in cases.into_iter().rev() {
            let case = match self.is_wrong(case) {
                true => self.add(Kind::Fail, ty.clone()),
                false => self.convert(case, &ty),
            };
            value = match condition {
                None => case,
                Some(condition) => {
                    self.add_at(e.span, Kind::If(condition, case, value), ty.clone())
                }
            };
        }
        value
    }
}

/// The type of two sets of which one is empty, or one holds integers and the other real numbers.
fn common_set(a: &Type, b: &Type) -> Option<Type> {
    let (Type::Set(x), Type::Set(y)) = (a, b) else {
        return None;
    };
    match (&**x, &**y) {
        (Type::Error, _) => Some(b.clone()),
        (_, Type::Error) => Some(a.clone()),
        (Type::Scalar(_), Type::Scalar(_)) if x != y => Some(Type::set_of(Type::REAL)),
        _ => None,
    }
}
