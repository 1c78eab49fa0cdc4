//! Brings what is differentiated to a form with few constructs: calls are replaced by bodies, entries and items are
//! taken of what they come from, norms are written with their entries, `‖u‖²` is `u ⋅ u`.

use std::collections::HashMap;

use super::Trouble;
use super::algebra::Algebra;
use crate::ir::{
    Binary, ExprId, Fold, FunctionId, Kind, Layout, Program, Range, Unary, VariableId,
};
use crate::optimize::rewrite;
use crate::types::{Shape, Type};

/// Whether values of a type change continuously.
pub(super) fn is_differentiable(ty: &Type) -> bool {
    match ty {
        Type::Sequence { item, .. } | Type::Set(item) => is_differentiable(item),
        Type::Tuple(items) => items.iter().any(is_differentiable),
        ty => ty.shape().is_some() && !ty.is_integer(),
    }
}

/// Rewrites expressions that depend on a variable.
pub(super) struct Normal<'a> {
    pub(super) program: &'a mut Program,
    /// Inputs and parameters.
    variables: Vec<ExprId>,
    depends: HashMap<ExprId, bool>,
    depends_on: HashMap<(ExprId, ExprId), bool>,
    /// Whether an expression takes items of some variables only.
    pub(super) local: HashMap<(ExprId, Vec<ExprId>), bool>,
    memo: HashMap<ExprId, ExprId>,
    open: Vec<FunctionId>,
}

impl<'a> Normal<'a> {
    pub(super) fn new(program: &'a mut Program, variables: &[ExprId]) -> Self {
        Self {
            program,
            variables: variables.to_vec(),
            depends: HashMap::new(),
            depends_on: HashMap::new(),
            local: HashMap::new(),
            memo: HashMap::new(),
            open: Vec::new(),
        }
    }

    pub(super) fn algebra(&mut self) -> Algebra<'_> {
        Algebra {
            arena: &mut self.program.arena,
        }
    }

    /// Whether an expression depends on one of the variables, through the functions that it calls, too.
    pub(super) fn depends(&mut self, e: ExprId) -> bool {
        if let Some(&known) = self.depends.get(&e) {
            return known;
        }
        // a function that calls itself depends on what else is in it
        self.depends.insert(e, false);
        let kind = self.program.arena.kind(e).clone();
        let mut found = self.variables.contains(&e);
        match &kind {
            Kind::Call(id, _) => {
                let body = self.program.function(*id).body;
                found = found || self.depends(body);
            }
            Kind::Global(id) => {
                let value = self.program.global(*id).value;
                found = found || self.depends(value);
            }
            _ => {}
        }
        // integers, elements and conditions stay the same nearby
        kind.operands(|operand| found = found || self.is_active(operand));
        self.depends.insert(e, found);
        found
    }

    /// Whether the value of an expression changes with a variable.
    pub(super) fn is_active(&mut self, e: ExprId) -> bool {
        // a function that calls itself is called before its type is known
        let ty = match self.program.arena.kind(e) {
            Kind::Call(id, _) => &self.program.function(*id).ty,
            _ => self.program.arena.ty(e),
        };
        is_differentiable(ty) && self.depends(e)
    }

    /// Whether an expression in normal form changes with one of the variables.
    pub(super) fn changes_with(&mut self, e: ExprId, x: ExprId) -> bool {
        if !is_differentiable(self.program.arena.ty(e)) {
            return false;
        }
        if let Some(&known) = self.depends_on.get(&(e, x)) {
            return known;
        }
        let kind = self.program.arena.kind(e).clone();
        let mut found = e == x;
        kind.operands(|operand| found = found || self.changes_with(operand, x));
        self.depends_on.insert((e, x), found);
        found
    }

    pub(super) fn kind(&self, e: ExprId) -> Kind {
        self.program.arena.kind(e).clone()
    }

    pub(super) fn expr(&mut self, e: ExprId) -> Result<ExprId, Trouble> {
        if !self.is_active(e) {
            return Ok(e);
        }
        if let Some(&done) = self.memo.get(&e) {
            return Ok(done);
        }
        let done = self.inside(e)?;
        self.memo.insert(e, done);
        Ok(done)
    }

    fn inside(&mut self, e: ExprId) -> Result<ExprId, Trouble> {
        let mut kind = self.kind(e);
        match &mut kind {
            Kind::Global(id) => {
                let value = self.program.global(*id).value;
                return self.expr(value);
            }
            Kind::Call(id, arguments) => {
                let function = self.program.function(*id);
                if function.recursive || self.open.contains(id) || function.ty.is_error() {
                    let name = function.name.clone();
                    return Err(Trouble::new(
                        self.program.arena.origin(e),
                        format!("`{name}` calls itself and cannot be differentiated"),
                        "write the recursion as a sum, or differentiate what does not depend on it",
                    ));
                }
                let body = function.body;
                let parameters: Vec<_> = function.parameters.iter().map(|p| p.variable).collect();
                // first the arguments: in `h(h(x))`, `h` does not call itself
                let arguments = self.arguments(arguments)?;
                let values = parameters.into_iter().zip(arguments).collect();
                let body = rewrite::substitute(&mut self.program.arena, body, &values);
                self.open.push(*id);
                let body = self.expr(body);
                self.open.pop();
                return body;
            }
            _ => kind = self.rebound(kind),
        }
        let mut trouble = None;
        let kind = kind.map_operands(|operand| match self.expr(operand) {
            Ok(done) => done,
            Err(found) => {
                trouble.get_or_insert(found);
                operand
            }
        });
        if let Some(trouble) = trouble {
            return Err(trouble);
        }
        let ty = self.program.arena.ty(e).clone();
        let origin = self.program.arena.origin(e);
        let rebuilt = self.program.arena.add(kind, ty);
        let done = self.rule(rebuilt)?;
        if let Some(span) = origin {
            for e in [rebuilt, done] {
                self.program.arena.note_origin(e, span);
            }
        }
        Ok(done)
    }

    /// Arguments of a call in normal form, which they stay where the body names them.
    fn arguments(&mut self, arguments: &[ExprId]) -> Result<Vec<ExprId>, Trouble> {
        let mut done = Vec::with_capacity(arguments.len());
        for &argument in arguments {
            let argument = self.expr(argument)?;
            self.memo.insert(argument, argument);
            done.push(argument);
        }
        Ok(done)
    }

    /// A new integer variable.
    pub(super) fn index(&mut self, name: &str) -> (VariableId, ExprId) {
        let arena = &mut self.program.arena;
        let variable = arena.new_variable(name, Type::INTEGER);
        (variable, arena.variable(variable))
    }

    /// A function of an index where the index has a value.
    pub(super) fn beta(
        &mut self,
        body: ExprId,
        values: &[(VariableId, ExprId)],
    ) -> Result<ExprId, Trouble> {
        let mut all = HashMap::new();
        for (variable, value) in values {
            let ty = self.program.arena.variable_type(*variable).clone();
            let value = match ty.is_element() {
                true => self.algebra().element(*value, ty),
                false => self.algebra().place(*value),
            };
            all.insert(*variable, value);
        }
        let has_elements = values
            .iter()
            .any(|(_, value)| self.program.arena.ty(*value).is_element());
        let mut body = rewrite::substitute(&mut self.program.arena, body, &all);
        if has_elements {
            body = rewrite::at_elements(&mut self.program.arena, body);
        }
        self.expr(body)
    }

    pub(super) fn rule(&mut self, e: ExprId) -> Result<ExprId, Trouble> {
        match self.kind(e) {
            Kind::Project(tuple, k) => self.project(e, tuple, k),
            Kind::Item(sequence, index) => self.item(e, sequence, index),
            Kind::Component(vector, k) => self.component(e, vector, k),
            Kind::At(a, i, j) => self.at(e, a, i, j),
            Kind::RowOf(a, i) => self.row_of(e, a, i),
            Kind::ColumnOf(a, j) => self.column_of(e, a, j),
            Kind::Unary(op, a) => self.unary(e, op, a),
            Kind::Binary(op, a, b) => self.binary(e, op, a, b),
            Kind::Fold {
                op: op @ (Fold::Min | Fold::Max),
                variable,
                range: Range::Set(set),
                condition: None,
                body,
            } if *self.program.arena.kind(body) == Kind::Variable(variable) => {
                Ok(self.extreme_of_set(op, set).unwrap_or(e))
            }
            _ => Ok(e),
        }
    }

    /// The least or greatest member of a set is that of the values that it is collected from.
    fn extreme_of_set(&mut self, op: Fold, set: ExprId) -> Option<ExprId> {
        match self.kind(set) {
            Kind::Fold {
                op: Fold::Collect,
                variable,
                range,
                condition,
                body,
            } => {
                let kind = Kind::Fold {
                    op,
                    variable,
                    range,
                    condition,
                    body,
                };
                Some(self.program.arena.add(kind, Type::REAL))
            }
            Kind::Set(members) => {
                let op = match op {
                    Fold::Min => Binary::Min,
                    _ => Binary::Max,
                };
                let mut algebra = self.algebra();
                let first = members.iter().copied();
                first.reduce(|best, member| algebra.binary(op, best, member, Type::REAL))
            }
            _ => None,
        }
    }

    fn project(&mut self, e: ExprId, tuple: ExprId, k: u32) -> Result<ExprId, Trouble> {
        let ty = self.program.arena.ty(e).clone();
        match self.kind(tuple) {
            Kind::Tuple(items) => Ok(items[k as usize]),
            Kind::If(condition, a, b) => {
                let mut sides = [a, b];
                for side in &mut sides {
                    let item = self.program.arena.add(Kind::Project(*side, k), ty.clone());
                    *side = self.rule(item)?;
                }
                Ok(self.algebra().choose(condition, sides[0], sides[1]))
            }
            _ => Ok(e),
        }
    }

    fn item(&mut self, e: ExprId, sequence: ExprId, index: ExprId) -> Result<ExprId, Trouble> {
        let ty = self.program.arena.ty(e).clone();
        match self.kind(sequence) {
            Kind::Tabulate {
                layout: Layout::Sequence,
                variables,
                body,
                ..
            } => self.beta(body, &[(variables[0], index)]),
            Kind::If(condition, a, b) => {
                let mut sides = [a, b];
                for side in &mut sides {
                    let item = self.program.arena.add(Kind::Item(*side, index), ty.clone());
                    *side = self.item(item, *side, index)?;
                }
                Ok(self.algebra().choose(condition, sides[0], sides[1]))
            }
            Kind::Agree(_, _, inner) => {
                let item = self.program.arena.add(Kind::Item(inner, index), ty);
                self.item(item, inner, index)
            }
            Kind::Sequence(items) => match self.kind(index) {
                Kind::Integer(k) if k >= 1 && k <= items.len() as i64 => Ok(items[k as usize - 1]),
                _ => {
                    let place = self.algebra().place(index);
                    let mut value = self.program.arena.add(Kind::Fail, ty);
                    for (k, item) in items.into_iter().enumerate().rev() {
                        let k = self.program.arena.integer(k as i64 + 1);
                        let equal = crate::syntax::ast::CompareOp::Equal;
                        let here = self.algebra().compare(equal, place, k);
                        value = self.algebra().choose(here, item, value);
                    }
                    Ok(value)
                }
            },
            Kind::Binary(Binary::Append, first, last) => {
                let end = self.algebra().size(first, 0);
                let place = self.algebra().place(index);
                let within = crate::syntax::ast::CompareOp::LessOrEqual;
                let within = self.algebra().compare(within, place, end);
                let item = self.program.arena.add(Kind::Item(first, index), ty);
                let item = self.item(item, first, index)?;
                Ok(self.algebra().choose(within, item, last))
            }
            Kind::Binary(Binary::Unstack, _, entries) => self.unstacked(&ty, entries, index),
            _ => Ok(e),
        }
    }

    fn unary(&mut self, e: ExprId, op: Unary, a: ExprId) -> Result<ExprId, Trouble> {
        let kind = self.kind(a);
        let sequence = matches!(self.program.arena.ty(a), Type::Sequence { .. });
        let scalar = self.program.arena.ty(a).is_scalar();
        match (op, kind) {
            (Unary::SquareRoot, Kind::Binary(Binary::Dot | Binary::Frobenius, u, v)) if u == v => {
                Ok(self.algebra().unary(Unary::Norm, u, Type::REAL))
            }
            (Unary::SquareRoot, Kind::Binary(Binary::Power, b, p))
                if self.algebra().number(p) == Some(2.0) =>
            {
                Ok(self.algebra().unary(Unary::Absolute, b, Type::REAL))
            }
            (Unary::SquareRoot, Kind::Binary(Binary::Multiply, b, c)) if b == c => {
                Ok(self.algebra().unary(Unary::Absolute, b, Type::REAL))
            }
            (Unary::NormOne, _) => self.sum_of_entries(a, |algebra, entry| {
                algebra.unary(Unary::Absolute, entry, Type::REAL)
            }),
            (Unary::NormMax, _) => self.extreme(Fold::Max, a, |algebra, entry| {
                algebra.unary(Unary::Absolute, entry, Type::REAL)
            }),
            (Unary::Least, _) => self.extreme(Fold::Min, a, |_, entry| entry),
            (Unary::Greatest, _) => self.extreme(Fold::Max, a, |_, entry| entry),
            (Unary::Determinant, _) => match self.algebra().fixed(a) {
                Some((n, m)) if n == m && n <= 4 => {
                    let lines: Vec<i64> = (1..=n).collect();
                    self.determinant(a, &lines, &lines)
                }
                _ => Ok(e),
            },
            (Unary::Trace, Kind::Binary(Binary::Product, b, c)) => {
                let transposed = |this: &Self, a: ExprId| match this.kind(a) {
                    Kind::Unary(Unary::Transpose, a) if !is_vector(this.program.arena.ty(a)) => {
                        Some(a)
                    }
                    _ => None,
                };
                // tr(Bᵀ C) is B : C, and tr(Bᵀ M C) is B : M C
                if let Some(b) = transposed(self, b) {
                    return self.inner(b, c);
                }
                if let Kind::Binary(Binary::Product, b, m) = self.kind(b)
                    && let Some(b) = transposed(self, b)
                {
                    let ty = self.algebra().dense(b);
                    let product = self.algebra().product(m, c, &ty);
                    return self.inner(b, product);
                }
                Ok(e)
            }
            (Unary::Apply(_), _) if !scalar && !sequence => {
                self.entry_by_entry(e, a, |algebra, entry| algebra.unary(op, entry, Type::REAL))
            }
            _ => Ok(e),
        }
    }

    fn binary(&mut self, e: ExprId, op: Binary, a: ExprId, b: ExprId) -> Result<ExprId, Trouble> {
        let exponent = self.algebra().number(b);
        match (op, self.kind(a), exponent) {
            (Binary::Power, kind, Some(p)) if p >= 2.0 && p % 2.0 == 0.0 => {
                let square = match kind {
                    Kind::Unary(Unary::Norm, u) => self.inner(u, u)?,
                    Kind::Unary(Unary::SquareRoot, s) => s,
                    _ => return Ok(e),
                };
                let half = self.algebra().real(p / 2.0);
                Ok(match p {
                    2.0 => square,
                    _ => self
                        .algebra()
                        .binary(Binary::Power, square, half, Type::REAL),
                })
            }
            (Binary::Multiply, Kind::Unary(Unary::Norm, u), _) if a == b => self.inner(u, u),
            (Binary::Dot | Binary::Frobenius, _, _) => self.inner_of_entries(a, b, e),
            (Binary::Multiply, Kind::Unary(Unary::SquareRoot, s), _) if a == b => Ok(s),
            (Binary::Product, _, _)
                if self.program.arena.ty(e).is_scalar() && is_vector(self.program.arena.ty(b)) =>
            {
                Ok(self.row_times(a, b)?.unwrap_or(e))
            }
            (Binary::NormWeighted, _, _) => {
                let ty = self.algebra().dense(a);
                let weighted = self.algebra().product(b, a, &ty);
                let square = self.algebra().inner(a, weighted);
                Ok(self.algebra().unary(Unary::SquareRoot, square, Type::REAL))
            }
            (Binary::NormPower, _, _) => {
                let sum = self.sum_of_entries(a, |algebra, entry| {
                    let size = algebra.unary(Unary::Absolute, entry, Type::REAL);
                    algebra.binary(Binary::Power, size, b, Type::REAL)
                })?;
                let mut algebra = self.algebra();
                let one = algebra.real(1.0);
                let inverse = algebra.divide(one, b);
                Ok(algebra.binary(Binary::Power, sum, inverse, Type::REAL))
            }
            (Binary::MatrixPower, _, Some(p)) if p.fract() == 0.0 && p.abs() <= 64.0 => {
                let ty = self.algebra().dense(e);
                let mut algebra = self.algebra();
                let factor = match p < 0.0 {
                    true => algebra.unary(Unary::Inverse, a, ty.clone()),
                    false => a,
                };
                if p == 0.0 {
                    let n = algebra.size(a, 0);
                    return Ok(algebra.arena.add(Kind::Identity(n), ty));
                }
                let mut power = factor;
                for _ in 1..p.abs() as i64 {
                    power = algebra.product(power, factor, &ty);
                }
                Ok(power)
            }
            _ => Ok(e),
        }
    }

    /// The product of a row and a vector: `(k uᵀ M) v` is `k (u ⋅ M v)`.
    fn row_times(&mut self, row: ExprId, v: ExprId) -> Result<Option<ExprId>, Trouble> {
        match self.kind(row) {
            Kind::Unary(Unary::Transpose, u) if is_vector(self.program.arena.ty(u)) => {
                self.inner(u, v).map(Some)
            }
            Kind::Unary(Unary::Negate, row) => {
                let product = self.row_times(row, v)?;
                Ok(product.map(|product| self.algebra().negate(product)))
            }
            Kind::Binary(Binary::Multiply, k, row) => {
                let product = self.row_times(row, v)?;
                Ok(product.map(|product| self.algebra().scale(k, product)))
            }
            Kind::Binary(Binary::Divide, row, k) => {
                let product = self.row_times(row, v)?;
                Ok(product.map(|product| self.algebra().divide(product, k)))
            }
            Kind::Binary(Binary::Product, row, m) => {
                let Some(Shape::Matrix(n, _)) = self.program.arena.ty(m).shape() else {
                    return Ok(None);
                };
                let product = self.algebra().product(m, v, &Type::real_vector(n));
                self.row_times(row, product)
            }
            _ => Ok(None),
        }
    }
}

pub(super) fn is_vector(ty: &Type) -> bool {
    matches!(ty.shape(), Some(Shape::Vector(_)))
}
