//! Subscripts.

use super::Checker;
use super::index::counted_through;
use super::wording::{ONE_MESH, called};
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Kind, Unary};
use crate::span::Span;
use crate::syntax::ast::{Expr, Subscript};
use crate::types::display::plural;
use crate::types::{Element, Number, Type};

impl<'a> Checker<'a> {
    pub(super) fn subscript(
        &mut self,
        e: &'a Expr,
        base: &'a Expr,
        subscripts: &'a [Subscript],
    ) -> ExprId {
        if let (crate::syntax::ast::ExprKind::Name(name), [Subscript::Expr(size)]) =
            (&base.kind, subscripts)
            && name.text == "I"
            && !self.is_bound("I")
        {
            return self.identity(e.span, size);
        }
        let value = self.expr(base);
        let ty = self.ty(value).clone();
        if ty.is_error() {
            return value;
        }
        if subscripts.iter().any(|s| matches!(s, Subscript::All(_))) {
            let value = self.in_numbers(value);
            return self.slice(e, base, value, subscripts);
        }
        let value = match &ty {
            Type::Vector { space: Some(_), .. } => self.in_numbers(value),
            _ => value,
        };
        let ty = self.ty(value).clone();
        let mut indices = Vec::new();
        for subscript in subscripts {
            if let Subscript::Expr(index) = subscript {
                indices.push((index, self.expr(index)));
            }
        }
        if indices.iter().any(|(_, i)| self.is_error(*i)) {
            return self.error();
        }
        let takes = match &ty {
            Type::Matrix { .. } => 2,
            Type::Sequence { item, .. } => match &**item {
                Type::Vector { .. } if indices.len() == 2 => 2,
                Type::Matrix { .. } if indices.len() == 3 => 3,
                _ => 1,
            },
            Type::Vector { .. } | Type::Set(_) | Type::Tuple(_) | Type::CellularSet(_) => 1,
            other => {
                let diagnostic =
                    Diagnostic::error(e.span, format!("{} takes no subscript", called(base)))
                        .label(base.span, format!("this is {}", other.described()))
                        .help("subscripts index vectors, matrices, sequences, sets and tuples; they are arguments of functions");
                let diagnostic = self.with_origins(diagnostic, &[base]);
                return self.report(diagnostic);
            }
        };
        if indices.len() != takes {
            let message = format!(
                "{} takes {} but is given {}",
                called(base),
                n_subscripts(takes),
                indices.len()
            );
            let help = match takes {
                1 => "write one subscript, as in `x_i`; entries of entries take two, as in `x_i,1`",
                2 if ty.shape().is_some() => {
                    "`A_i,j` is an entry of a matrix, `A_i,*` a row, `A_*,j` a column; commas without blanks separate subscripts"
                }
                _ => "commas without blanks separate subscripts, as in `A_i,j`",
            };
            let diagnostic = Diagnostic::error(e.span, message)
                .label(base.span, format!("this is {}", ty.described()))
                .help(help);
            let diagnostic = self.with_origins(diagnostic, &[base]);
            return self.report(diagnostic);
        }
        match ty {
            Type::Matrix {
                spaces: Some((rows, columns)),
                ..
            } => {
                let Kind::Boundary(boundary) = self.program.arena.kind(value).clone() else {
                    return self.unsupported(e.span, "this subscript is");
                };
                let (row, column) = (indices[0], indices[1]);
                if !self.is_index_of(row, rows, base, "the rows of ")
                    || !self.is_index_of(column, columns, base, "the columns of ")
                {
                    return self.error();
                }
                self.add(Kind::Entry(boundary, row.1, column.1), Type::INTEGER)
            }
            Type::Matrix { number, .. } => self.entry(e, value, [indices[0], indices[1]], number),
            Type::Sequence { item, index, .. } => {
                if let Some(element) = index {
                    if !self.is_index_of(indices[0], element, base, "") {
                        return self.error();
                    }
                } else if !self.is_index(indices[0]) {
                    return self.error();
                }
                self.note_indexed_by(value, indices[0].1);
                self.note_index_use(indices[0], value, 0);
                let item = self.item_type(&item, indices[0].1);
                if self.item_sizes.contains_key(&value) {
                    let size = self.item_size(value, indices[0].1);
                    self.program.arena.note_origin(size, e.span);
                    return size;
                }
                let found = self.add_at(e.span, Kind::Item(value, indices[0].1), item.clone());
                match (indices.get(1), &item) {
                    (Some(second), Type::Vector { number, .. }) => {
                        let (second, number) = (*second, *number);
                        self.component(e, found, second, number)
                    }
                    (Some(second), Type::Matrix { number, .. }) => {
                        let (indices, number) = ([*second, indices[2]], *number);
                        self.entry(e, found, indices, number)
                    }
                    _ => found,
                }
            }
            Type::Vector { number, .. } => self.component(e, value, indices[0], number),
            Type::Set(item) => {
                if !self.is_integer(indices[0], "a set") {
                    return self.error();
                }
                let item = self.item_type(&item, indices[0].1);
                self.add_at(e.span, Kind::SetItem(value, indices[0].1), item)
            }
            Type::Tuple(items) => self.tuple_item(value, indices[0], &items),
            Type::CellularSet(mesh) => {
                let Some(mesh) = mesh else {
                    return self.unsupported(e.span, "cellular sets of an unknown mesh are");
                };
                let items: Vec<Type> = crate::types::ELEMENT_KINDS
                    .iter()
                    .map(|&kind| Type::set_of(Type::Element(Element { kind, mesh })))
                    .collect();
                self.tuple_item(value, indices[0], &items)
            }
            _ => self.error(),
        }
    }

    /// An item of a sequence by one subscript.
    pub(super) fn sequence_item(
        &mut self,
        span: Span,
        sequence: ExprId,
        index: &'a Expr,
    ) -> Option<ExprId> {
        let Type::Sequence { item, .. } = self.ty(sequence).clone() else {
            return None;
        };
        let number = self.expr(index);
        if self.is_error(number) || !self.is_index((index, number)) {
            return None;
        }
        self.note_indexed_by(sequence, number);
        self.note_index_use((index, number), sequence, 0);
        let item = self.item_type(&item, number);
        Some(self.add_at(span, Kind::Item(sequence, number), item))
    }

    fn tuple_item(&mut self, value: ExprId, index: (&'a Expr, ExprId), items: &[Type]) -> ExprId {
        let n = items.len();
        match self.program.arena.kind(index.1) {
            Kind::Integer(k) if *k >= 1 && *k <= n as i64 => {
                let k = *k as usize - 1;
                self.project(value, k, items[k].clone())
            }
            Kind::Integer(k) => {
                let message = format!("a tuple of {n} items has no item {k}");
                self.report(
                    Diagnostic::error(index.0.span, message)
                        .help(format!("items are numbered from 1 to {n}")),
                )
            }
            _ => self.report(
                Diagnostic::error(
                    index.0.span,
                    "which item of a tuple is meant must stand in the text",
                )
                .help(format!(
                    "write a number from 1 to {n}; the items may differ in type"
                )),
            ),
        }
    }

    fn component(
        &mut self,
        e: &Expr,
        vector: ExprId,
        index: (&'a Expr, ExprId),
        number: Number,
    ) -> ExprId {
        if !self.is_entry_of(index, vector, 0) {
            return self.error();
        }
        let noted = index;
        let Some(index) = self.position(index, "a vector") else {
            return self.error();
        };
        self.note_index_use(noted, vector, 0);
        let length = self.ty(vector).fixed_vector();
        if let (Kind::Integer(k), Some(n)) = (self.program.arena.kind(index.1), length)
            && (*k < 1 || *k > n)
        {
            let message = format!("a vector of length {n} has no entry {k}");
            return self.report(
                Diagnostic::error(index.0.span, message)
                    .help(format!("entries are numbered from 1 to {n}")),
            );
        }
        self.add_at(
            e.span,
            Kind::Component(vector, index.1),
            Type::Scalar(number),
        )
    }

    /// An entry of a matrix.
    fn entry(
        &mut self,
        e: &Expr,
        matrix: ExprId,
        indices: [(&'a Expr, ExprId); 2],
        number: Number,
    ) -> ExprId {
        let mut places = [matrix; 2];
        for (axis, index) in indices.into_iter().enumerate() {
            if !self.is_entry_of(index, matrix, axis) {
                return self.error();
            }
            self.note_index_use(index, matrix, axis as u8);
            let Some(index) = self.position(index, "a matrix") else {
                return self.error();
            };
            places[axis] = index.1;
            if !self.in_range(matrix, axis, index) {
                return self.error();
            }
        }
        self.add_at(
            e.span,
            Kind::At(matrix, places[0], places[1]),
            Type::Scalar(number),
        )
    }

    /// Whether a subscript that stands in the text is within a size that stands in the text.
    fn in_range(&mut self, matrix: ExprId, axis: usize, index: (&'a Expr, ExprId)) -> bool {
        let size = match (self.ty(matrix), axis) {
            (Type::Matrix { rows, .. }, 0) => rows.value(),
            (Type::Matrix { columns, .. }, _) => columns.value(),
            _ => None,
        };
        match (self.program.arena.kind(index.1), size) {
            (Kind::Integer(k), Some(n)) if *k < 1 || *k > n => {
                let what = if axis == 0 { "row" } else { "column" };
                let (s, help) = match n {
                    0 => ("s", format!("it has no {what}s")),
                    1 => ("", format!("its only {what} is number 1")),
                    n => ("s", format!("{what}s are numbered from 1 to {n}")),
                };
                let message = format!("a matrix with {n} {what}{s} has no {what} {k}");
                self.report(Diagnostic::error(index.0.span, message).help(help));
                false
            }
            _ => true,
        }
    }

    /// `A_i,*`, `A_*,j`, `q_i,*,c`.
    fn slice(
        &mut self,
        e: &'a Expr,
        base: &'a Expr,
        value: ExprId,
        subscripts: &'a [Subscript],
    ) -> ExprId {
        let (mut matrix, mut rest) = (value, subscripts);
        if let (Type::Sequence { item, .. }, Some((Subscript::Expr(first), others))) =
            (self.ty(value).clone(), subscripts.split_first())
            && matches!(*item, Type::Matrix { .. })
        {
            let Some(found) = self.sequence_item(e.span, value, first) else {
                return self.error();
            };
            matrix = found;
            rest = others;
        }
        let ty = self.ty(matrix).clone();
        let Type::Matrix {
            number,
            rows,
            columns,
            spaces: None,
            ..
        } = ty
        else {
            let ty = ty.described();
            let diagnostic = Diagnostic::error(e.span, format!("{ty} has no rows and columns"))
                .label(base.span, format!("this is {ty}"))
                .help("`*` stands for all of a row or a column of a matrix, as in `A_i,*`");
            let diagnostic = self.with_origins(diagnostic, &[base]);
            return self.report(diagnostic);
        };
        let vector = |length| Type::Vector {
            number,
            length,
            sparse: false,
            space: None,
        };
        let (index, axis, length) = match rest {
            [Subscript::Expr(row), Subscript::All(_)] => (row, 0u8, columns),
            [Subscript::All(_), Subscript::Expr(column)] => (column, 1, rows),
            [Subscript::All(_), Subscript::All(_)] => return matrix,
            _ => {
                let ty = self.ty(matrix).described();
                let diagnostic = Diagnostic::error(e.span, "a matrix takes two subscripts")
                    .label(base.span, format!("this is {ty}"))
                    .help("write `A_i,*` for a row and `A_*,j` for a column");
                let diagnostic = self.with_origins(diagnostic, &[base]);
                return self.report(diagnostic);
            }
        };
        let number = self.expr(index);
        if self.is_error(number) {
            return self.error();
        }
        if !self.is_entry_of((index, number), matrix, axis.into()) {
            return self.error();
        }
        let noted = (index, number);
        let Some((_, number)) = self.position(noted, "a matrix") else {
            return self.error();
        };
        if !self.in_range(matrix, usize::from(axis), (index, number)) {
            return self.error();
        }
        self.note_index_use(noted, matrix, axis);
        let kind = match axis {
            0 => Kind::RowOf(matrix, number),
            _ => Kind::ColumnOf(matrix, number),
        };
        self.add_at(e.span, kind, vector(length))
    }

    /// Whether an element, if the index is one, is of those that the entries along an axis belong to.
    fn is_entry_of(&mut self, index: (&'a Expr, ExprId), array: ExprId, axis: usize) -> bool {
        let Some(element) = counted_through(self.ty(array), axis) else {
            return true;
        };
        let own = Type::Element(element);
        let ty = self.ty(index.1).clone();
        if !ty.is_element() || ty == own {
            return true;
        }
        let (given, takes) = self.described_both(&ty, &own);
        let what = self.ty(array).described();
        let message = format!("{given} indexes {what}");
        let diagnostic = Diagnostic::error(index.0.span, message)
            .here(format!("this is {given}"))
            .help(format!(
                "its entries belong to {}: write {takes} as this subscript",
                plural(element.kind)
            ));
        let diagnostic = self.with_origins(diagnostic, &[index.0]);
        self.report(diagnostic);
        false
    }

    /// The number of an entry, from 1: an integer, or an element by its place among those of its mesh.
    fn position(&mut self, index: (&'a Expr, ExprId), what: &str) -> Option<(&'a Expr, ExprId)> {
        if self.ty(index.1).is_element() {
            let number = self.add(Kind::Unary(Unary::ToInteger, index.1), Type::INTEGER);
            return Some((index.0, number));
        }
        self.is_integer(index, what).then_some(index)
    }

    pub(super) fn is_integer(&mut self, index: (&'a Expr, ExprId), what: &str) -> bool {
        let ty = self.ty(index.1).clone();
        if ty == Type::INTEGER {
            return true;
        }
        self.report(
            Diagnostic::error(
                index.0.span,
                format!("{} cannot index {what}", ty.described()),
            )
            .here(format!("this is {}", ty.described()))
            .help(match what {
                "a set" => "the members are numbered by integers, from 1",
                _ => "the entries are numbered by integers, from 1, or by elements of a mesh",
            }),
        );
        false
    }

    fn is_index(&mut self, index: (&'a Expr, ExprId)) -> bool {
        let ty = self.ty(index.1).clone();
        if ty == Type::INTEGER || ty.is_element() {
            return true;
        }
        self.report(
            Diagnostic::error(
                index.0.span,
                format!("{} cannot index a sequence", ty.described()),
            )
            .here(format!("this is {}", ty.described()))
            .help("a sequence is indexed by integers, from 1, or by elements of a mesh"),
        );
        false
    }

    /// Whether an index is an element of the kind and mesh that index this; `part` says which subscript of a matrix.
    fn is_index_of(
        &mut self,
        index: (&'a Expr, ExprId),
        element: Element,
        base: &Expr,
        part: &str,
    ) -> bool {
        let ty = self.ty(index.1).clone();
        let expected = Type::Element(element);
        if ty == expected {
            return true;
        }
        let (given, takes) = self.described_both(&ty, &expected);
        let of = match ty.owner() {
            Some(mesh) if mesh != element.mesh => format!(" of `{}`", self.mesh_name(element.mesh)),
            _ => String::new(),
        };
        let message = format!(
            "{part}{} {} indexed by {}{of}, not by {given}",
            called(base),
            if part.is_empty() { "is" } else { "are" },
            plural(element.kind)
        );
        let help = match &ty {
            Type::Element(other) if other.kind == element.kind => ONE_MESH.to_owned(),
            _ => format!("write {takes} as this subscript"),
        };
        let diagnostic = Diagnostic::error(index.0.span, message)
            .here(format!("this is {given}"))
            .help(help);
        let diagnostic = self.with_origins(diagnostic, &[base, index.0]);
        self.report(diagnostic);
        false
    }

    /// Notes that an input is indexed by elements, so that its length can be checked once.
    fn note_indexed_by(&mut self, sequence: ExprId, index: ExprId) {
        if let (Kind::Input(input), Type::Element(element)) = (
            self.program.arena.kind(sequence).clone(),
            self.ty(index).clone(),
        ) {
            let list = &mut self.program.inputs[input.0 as usize].indexed_by;
            if !list.contains(&element) {
                list.push(element);
            }
        }
    }
}

fn n_subscripts(n: usize) -> String {
    crate::resolve::symbols::count(n, "subscript")
}
