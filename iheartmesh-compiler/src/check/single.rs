//! Single entries, rows and columns on the left of a definition: they replace what is there.

use super::Checker;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Kind, Layout};
use crate::span::Span;
use crate::syntax::ast::{self, Expr, ExprKind, Subscript};
use crate::types::{Number, Shape, Type};

impl<'a> Checker<'a> {
    /// Whether a single entry, a row or a column is not defined a second time by the text alone.
    pub(super) fn is_written_once(
        &mut self,
        definition: &'a ast::Definition,
        written: &mut Vec<(Vec<Option<i64>>, Span)>,
    ) -> bool {
        let target = &definition.targets[0];
        let mut place = Vec::new();
        for subscript in &target.subscripts {
            match subscript {
                Subscript::Expr(Expr {
                    kind: ExprKind::Integer(k),
                    ..
                }) => place.push(Some(*k)),
                Subscript::All(_) => place.push(None),
                _ => return true,
            }
        }
        if place.is_empty() || definition.add {
            return true;
        }
        if let Some((_, before)) = written.iter().find(|(other, _)| *other == place) {
            let message = "this entry is defined twice";
            self.report(
                Diagnostic::error(definition.span, message)
                    .here("defined again here")
                    .label(*before, "defined here")
                    .help("remove one of the two, or add with `+=`"),
            );
            return false;
        }
        written.push((place, definition.span));
        true
    }

    /// `y_1 = s`, `A_1,2 = s`, `A_1,* = v`.
    pub(super) fn single(
        &mut self,
        definition: &'a ast::Definition,
        subscripts: &[Option<&'a Expr>],
        base: Option<ExprId>,
        declared: Option<&Type>,
    ) -> ExprId {
        let name = &definition.targets[0].name;
        let Some(base) = base.or_else(|| self.zeros(declared?)) else {
            let message = format!("`{}` has no entries yet", name.text);
            return self.report(
                Diagnostic::error(name.span, message).help(format!(
                    "define it above, or declare its size, as in `{} ∈ ℝ^n`: entries that are not defined are 0",
                    name.text
                )),
            );
        };
        let base = self.real(base);
        let ty = self.ty(base).clone();
        let takes = match (&ty, subscripts) {
            (Type::Vector { .. } | Type::Matrix { .. }, [Some(_)])
                if !matches!(ty, Type::Matrix { .. }) =>
            {
                Some(Type::REAL)
            }
            (Type::Sequence { item, .. }, [Some(_)]) => Some((**item).clone()),
            (Type::Matrix { spaces: None, .. }, [Some(_), Some(_)]) => Some(Type::REAL),
            (
                Type::Matrix {
                    columns,
                    spaces: None,
                    ..
                },
                [Some(_), None],
            ) => Some(Type::real_vector(columns.clone())),
            (
                Type::Matrix {
                    rows, spaces: None, ..
                },
                [None, Some(_)],
            ) => Some(Type::real_vector(rows.clone())),
            _ => None,
        };
        let Some(takes) = takes else {
            let found = ty.described();
            let message = format!("{found} has no such entries");
            return self.report(
                Diagnostic::error(definition.targets[0].name.span, message)
                    .here(format!("this is {found}"))
                    .help("write `y_1 = …` for an entry of a vector or an item of a sequence, `A_1,2 = …` for an entry of a matrix, and `A_1,* = …` for a row"),
            );
        };
        let mut places = Vec::new();
        for (axis, subscript) in subscripts.iter().enumerate() {
            let Some(subscript) = *subscript else {
                places.push(None);
                continue;
            };
            let index = self.expr(subscript);
            if self.is_error(index) || !self.is_entry(base, axis, (subscript, index)) {
                return self.error();
            }
            places.push(Some(index));
        }
        let value = self.expr(&definition.value);
        if self.is_error(value) {
            return value;
        }
        let value = match definition.add {
            false => value,
            true => {
                let kind = match places.as_slice() {
                    [Some(k)] if matches!(ty, Type::Sequence { .. }) => Kind::Item(base, *k),
                    [Some(k)] => Kind::Component(base, *k),
                    [Some(row), Some(column)] => Kind::At(base, *row, *column),
                    [Some(row), None] => Kind::RowOf(base, *row),
                    [None, Some(column)] => Kind::ColumnOf(base, *column),
                    _ => return self.error(),
                };
                let own = self.add_at(definition.span, kind, takes.clone());
                self.added(definition, own, value)
            }
        };
        if self.is_error(value) {
            return value;
        }
        let value = self.convert(value, &takes);
        let found = self.ty(value).clone();
        let fits = match (takes.shape(), found.shape()) {
            (Some(Shape::Scalar), Some(Shape::Scalar)) => true,
            (Some(a), Some(b)) => !super::operator::differ(&a, &b),
            _ => takes == found,
        };
        if !fits {
            let (given, asked) = (found.described(), takes.described());
            let message = format!("{given} cannot stand here in `{}`", name.text);
            return self.report(
                Diagnostic::error(definition.value.span, message)
                    .here(format!("this is {given}"))
                    .label(name.span, format!("this is {}", ty.described()))
                    .help(format!("what is defined here is {asked}")),
            );
        }
        let value = match takes.is_scalar() && !takes.is_integer() {
            true => self.real(value),
            false => value,
        };
        // what is replaced one after the other is copied once
        let (base, mut entries) = match self.program.arena.kind(base) {
            Kind::Update(base, entries) => (*base, entries.clone()),
            _ => (base, Vec::new()),
        };
        entries.push((places, value));
        self.add_at(definition.span, Kind::Update(base, entries), ty)
    }

    /// Whether a subscript on the left is an integer in range, as far as the text says.
    fn is_entry(&mut self, base: ExprId, axis: usize, index: (&'a Expr, ExprId)) -> bool {
        let (what, noun, size) = match (self.ty(base), axis) {
            (Type::Matrix { rows, .. }, 0) => ("a matrix", "row", rows.value()),
            (Type::Matrix { columns, .. }, _) => ("a matrix", "column", columns.value()),
            (Type::Vector { length, .. }, _) => ("a vector", "entry", length.value()),
            _ => ("a sequence", "item", None),
        };
        if !self.is_integer(index, what) {
            return false;
        }
        match (self.program.arena.kind(index.1), size) {
            (Kind::Integer(k), size) if *k < 1 || size.is_some_and(|n| *k > n) => {
                let message = format!("{what} has no {noun} {k}");
                let last = size.map_or(String::new(), |n| format!(" to {n}"));
                let help = format!("they are numbered from 1{last}");
                self.report(Diagnostic::error(index.0.span, message).help(help));
                false
            }
            _ => true,
        }
    }

    /// A value of a type with nothing but zeros in it.
    pub(super) fn zeros(&mut self, ty: &Type) -> Option<ExprId> {
        let zero = self.program.arena.real(0.0);
        let sizes: Vec<_> = match ty {
            Type::Scalar(Number::Real) => return Some(zero),
            Type::Vector { length, .. } => vec![length],
            Type::Matrix { rows, columns, .. } => vec![rows, columns],
            Type::Sequence { item, length, .. } => {
                let body = self.zeros(item)?;
                let size = self.size(length)?;
                let variable = self.program.arena.new_variable("i", Type::INTEGER);
                let kind = Kind::Tabulate {
                    layout: Layout::Sequence,
                    variables: vec![variable],
                    sizes: vec![size],
                    body,
                };
                return Some(self.add(kind, ty.clone()));
            }
            _ => return None,
        };
        let sizes: Option<Vec<ExprId>> = sizes.into_iter().map(|size| self.size(size)).collect();
        Some(self.add(Kind::Filled(zero, sizes?), ty.clone()))
    }
}
