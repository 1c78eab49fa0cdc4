//! Sums along a row or a column of a sparse matrix become sums over its stored entries.
//!
//! `∑_j W_ij x_j` runs over the stored entries of row `i`, if each term has the factor `W_ij`, the index runs over all of
//! the row, and nothing else in the terms can fail: the terms left out are 0. (0 times an infinite number, which is no
//! number, is left out as well, as in the product of a sparse matrix and a vector.) The matrix is stored once in the
//! order in which it is walked along.

use std::collections::HashMap;

use super::{MayFail, rewrite};
use crate::ir::{
    Arena, Binary, ExprId, Fold, Global, GlobalId, Kind, Program, Range, Unary, VariableId,
};
use crate::span::Span;
use crate::types::{Atom, Dimension, Type};

pub fn run(program: &mut Program) {
    let mut pass = Pass {
        may_fail: MayFail::of(program),
        first: program.globals.len() as u32,
        walked: Vec::new(),
    };
    rewrite::program(program, |arena, e| pass.rule(arena, e).unwrap_or(e));
    for (matrix, axis) in pass.walked {
        let (op, way) = match axis {
            0 => (Unary::ByRows, "rows"),
            _ => (Unary::ByColumns, "columns"),
        };
        let name = match program.arena.kind(matrix) {
            Kind::Global(id) => program.global(*id).name.clone(),
            Kind::Input(id) => program.input(*id).name.clone(),
            _ => String::new(),
        };
        let ty = program.arena.ty(matrix).clone();
        let value = program.arena.add(Kind::Unary(op, matrix), ty);
        program.globals.push(Global {
            name: format!("{name} by {way}"),
            value,
            span: Span::default(),
        });
    }
}

struct Pass {
    may_fail: MayFail,
    /// The number of the first definition that the pass adds.
    first: u32,
    /// The matrices that are walked along rows (0) or columns (1).
    walked: Vec<(ExprId, u8)>,
}

/// A sum over an index, with the matrix that it runs along.
struct Walk {
    variable: VariableId,
    entry: ExprId,
    matrix: ExprId,
    /// Which subscript is fixed.
    axis: u8,
    index: ExprId,
    /// Sizes that are compared at run time, with the range.
    agreed: Vec<(ExprId, ExprId)>,
    size: Dimension,
    /// The size of the matrix in the direction of `index`.
    other: Dimension,
}

impl Pass {
    fn rule(&mut self, arena: &mut Arena, e: ExprId) -> Option<ExprId> {
        let Kind::Fold {
            op: Fold::Sum,
            variable,
            range,
            condition,
            body,
        } = arena.kind(e).clone()
        else {
            return None;
        };
        let (mut agreed, mut place) = (Vec::new(), None);
        let size = match range {
            Range::Integers(from, to) if *arena.kind(from) == Kind::Integer(1) => {
                let mut to = to;
                place = arena.origin(to);
                while let Kind::Agree(a, b, value) = *arena.kind(to) {
                    agreed.push((a, b));
                    to = value;
                }
                match arena.kind(to) {
                    Kind::Size(size) => size.clone(),
                    Kind::Integer(n) => Dimension::known(*n),
                    _ => return None,
                }
            }
            Range::Set(set) => match arena.kind(set) {
                Kind::AllElements(element) => Dimension::atom(Atom::Count(*element)),
                _ => return None,
            },
            _ => return None,
        };
        let mut walk = entries(arena, body, variable)
            .into_iter()
            .find(|walk| walk.size == size)?;
        walk.agreed = agreed;
        if !self.is_safe(arena, body, &walk)
            || condition.is_some_and(|condition| !self.is_safe(arena, condition, &walk))
        {
            return None;
        }
        let (variable, condition, body) = by_numbers(arena, variable, condition, body);
        let known = (walk.matrix, walk.axis);
        let number = self.walked.iter().position(|other| *other == known);
        let number = number.unwrap_or_else(|| {
            self.walked.push(known);
            self.walked.len() - 1
        });
        let ty = arena.ty(walk.matrix).clone();
        let global = Kind::Global(GlobalId(self.first + number as u32));
        let stored = arena.add(global, ty);
        let set = arena.add(
            Kind::Stored(stored, walk.axis, walk.index),
            Type::set_of(Type::INTEGER),
        );
        if let Some(span) = arena.origin(walk.entry) {
            arena.note_origin(set, span);
        }
        let ty = arena.ty(e).clone();
        let mut all = arena.add(
            Kind::Fold {
                op: Fold::Sum,
                variable,
                range: Range::Set(set),
                condition,
                body,
            },
            ty.clone(),
        );
        for (a, b) in walk.agreed {
            let agree = arena.add(Kind::Agree(a, b, all), ty.clone());
            if let Some(span) = place.or(arena.origin(e)) {
                arena.note_origin(agree, span);
            }
            all = agree;
        }
        Some(all)
    }

    /// Whether an expression in a term cannot fail for any index in range, but for the row of the matrix itself.
    fn is_safe(&self, arena: &Arena, e: ExprId, walk: &Walk) -> bool {
        if e == walk.entry {
            return true;
        }
        // where the row of the matrix exists, other entries with its number do as well
        if let Kind::Component(of, k) | Kind::Item(of, k) = *arena.kind(e)
            && k == walk.index
            && let Type::Vector { length, .. } | Type::Sequence { length, .. } = arena.ty(of)
            && *length == walk.other
        {
            return self.is_safe(arena, of, walk);
        }
        if !arena.depends_on(e, walk.variable) {
            return !self.may_fail.expr(arena, e);
        }
        let is_index = |k: ExprId| is_number_of(arena, k, walk.variable);
        let in_range = match arena.kind(e) {
            Kind::Component(of, k) | Kind::Item(of, k) if is_index(*k) => match arena.ty(*of) {
                Type::Vector { length, .. } | Type::Sequence { length, .. } => {
                    self.is_safe(arena, *of, walk) && self.is_size(arena, length, walk)
                }
                _ => false,
            },
            _ => false,
        };
        let mut safe = in_range || !self.may_fail.own(arena, e);
        if !in_range {
            let operands = |operand| safe = safe && self.is_safe(arena, operand, walk);
            arena.kind(e).operands(operands);
        }
        safe
    }

    /// Whether a length is that of the range, or is compared with it.
    fn is_size(&self, arena: &Arena, length: &Dimension, walk: &Walk) -> bool {
        let is = |e: ExprId| matches!(arena.kind(e), Kind::Size(size) if size == length);
        *length == walk.size || walk.agreed.iter().any(|(a, b)| is(*a) || is(*b))
    }
}

/// Whether an expression is a variable, or the number of the element that it is.
fn is_number_of(arena: &Arena, e: ExprId, variable: VariableId) -> bool {
    let is_variable = |e: ExprId| *arena.kind(e) == Kind::Variable(variable);
    match *arena.kind(e) {
        Kind::Unary(Unary::ToInteger, a) => is_variable(a),
        _ => is_variable(e),
    }
}

/// A loop over elements as one over their numbers, which are what a matrix stores.
fn by_numbers(
    arena: &mut Arena,
    variable: VariableId,
    condition: Option<ExprId>,
    body: ExprId,
) -> (VariableId, Option<ExprId>, ExprId) {
    let ty = arena.variable_type(variable).clone();
    if !ty.is_element() {
        return (variable, condition, body);
    }
    let number = arena.new_variable("k", Type::INTEGER);
    let k = arena.variable(number);
    let element = arena.add(Kind::Unary(Unary::ToElement, k), ty);
    let element = HashMap::from([(variable, element)]);
    let mut put = |e: ExprId| {
        let e = rewrite::substitute(arena, e, &element);
        rewrite::upward(arena, e, &mut HashMap::new(), &mut |arena, e| {
            let Kind::Unary(Unary::ToInteger, a) = *arena.kind(e) else {
                return e;
            };
            match *arena.kind(a) {
                Kind::Unary(Unary::ToElement, number) if number == k => k,
                _ => e,
            }
        })
    };
    (number, condition.map(&mut put), put(body))
}

/// The entries of sparse matrices that a term is 0 with.
fn entries(arena: &Arena, term: ExprId, variable: VariableId) -> Vec<Walk> {
    match *arena.kind(term) {
        Kind::At(matrix, row, column) => {
            let Type::Matrix {
                rows,
                columns,
                sparse: true,
                ..
            } = arena.ty(matrix)
            else {
                return Vec::new();
            };
            let is_index = |k: ExprId| is_number_of(arena, k, variable);
            let (axis, index, size, other) = match (is_index(row), is_index(column)) {
                (false, true) => (0, row, columns, rows),
                (true, false) => (1, column, rows, columns),
                _ => return Vec::new(),
            };
            let named = matches!(arena.kind(matrix), Kind::Global(_) | Kind::Input(_));
            if !named || arena.depends_on(index, variable) {
                return Vec::new();
            }
            vec![Walk {
                variable,
                entry: term,
                matrix,
                axis,
                index,
                agreed: Vec::new(),
                size: size.clone(),
                other: other.clone(),
            }]
        }
        Kind::Unary(Unary::Negate, a) | Kind::Binary(Binary::Divide, a, _) => {
            entries(arena, a, variable)
        }
        Kind::Binary(Binary::Multiply, a, b) => {
            let mut all = entries(arena, a, variable);
            all.extend(entries(arena, b, variable));
            all
        }
        _ => Vec::new(),
    }
}
