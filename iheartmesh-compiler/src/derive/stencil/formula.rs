//! Terms of a few items of a variable as formulas of the entries of these items: vectors and matrices by their entries,
//! determinants and inverses by minors, norms by sums of squares.

use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

use super::array::Array;
use super::numbers::Numbers;
use crate::derive::algebra::SMALL;
use crate::derive::normal::{Normal, is_vector};
use crate::ir::{Binary, ExprId, Fold, Kind, Range, Unary};
use crate::syntax::ast::CompareOp;
use crate::types::{Shape, Type};

/// Why something has no formula.
#[derive(Debug)]
pub(super) enum Stop {
    /// It is not of this kind.
    Unknown,
    /// It depends on a condition which of two it is.
    Cases(ExprId),
}

type Found<T> = Result<T, Stop>;

/// An item of the variable.
#[derive(Clone, Debug)]
pub(super) struct Item {
    /// Its place: an element, or a number from 1.
    pub(super) place: ExprId,
    /// Its entries.
    pub(super) entries: Vec<ExprId>,
}

/// Makes formulas of terms.
pub(super) struct Formulas<'n, 'a> {
    pub(super) normal: &'n mut Normal<'a>,
    pub(super) x: ExprId,
    /// Conditions that are known to hold, or not to.
    facts: Vec<(ExprId, bool)>,
    /// The items that have been met.
    pub(super) items: BTreeMap<ExprId, Item>,
    /// Reciprocals that fail where they do not exist, by what stands for them.
    pub(super) reciprocals: HashMap<ExprId, ExprId>,
    memo: HashMap<ExprId, Rc<Array>>,
}

impl<'n, 'a> Formulas<'n, 'a> {
    pub(super) fn new(normal: &'n mut Normal<'a>, x: ExprId, facts: &[(ExprId, bool)]) -> Self {
        Self {
            normal,
            x,
            facts: facts.to_vec(),
            items: BTreeMap::new(),
            reciprocals: HashMap::new(),
            memo: HashMap::new(),
        }
    }

    pub(super) fn numbers(&mut self) -> Numbers<'_> {
        Numbers {
            arena: &mut self.normal.program.arena,
        }
    }

    pub(super) fn is_active(&mut self, e: ExprId) -> bool {
        let x = self.x;
        self.normal.changes_with(e, x)
    }

    /// The formula of a number in normal form.
    pub(super) fn number(&mut self, e: ExprId) -> Found<ExprId> {
        let array = self.array(e)?;
        let array = array.expanded(&mut self.numbers());
        match array.entries.as_slice() {
            [value] => Ok(*value),
            _ => Err(Stop::Unknown),
        }
    }

    /// A condition with formulas in place of what is compared.
    pub(super) fn condition(&mut self, e: ExprId) -> ExprId {
        match self.normal.kind(e) {
            Kind::Compare(op, a, b) => {
                let mut sides = [a, b];
                for side in &mut sides {
                    if *self.normal.program.arena.ty(*side) != Type::REAL {
                        return e;
                    }
                    let Ok(normal) = self.normal.expr(*side) else {
                        return e;
                    };
                    if self.is_active(normal) {
                        let Ok(number) = self.number(normal) else {
                            return e;
                        };
                        *side = number;
                    }
                }
                self.numbers().compare(op, sides[0], sides[1])
            }
            Kind::Not(a) => {
                let a = self.condition(a);
                self.normal.program.arena.add(Kind::Not(a), Type::Boolean)
            }
            Kind::And(a, b) => {
                let (a, b) = (self.condition(a), self.condition(b));
                self.normal
                    .program
                    .arena
                    .add(Kind::And(a, b), Type::Boolean)
            }
            Kind::Or(a, b) => {
                let (a, b) = (self.condition(a), self.condition(b));
                self.normal.program.arena.add(Kind::Or(a, b), Type::Boolean)
            }
            _ => e,
        }
    }

    fn array(&mut self, e: ExprId) -> Found<Rc<Array>> {
        if let Some(found) = self.memo.get(&e) {
            return Ok(found.clone());
        }
        let (rows, columns) = self.normal.algebra().fixed(e).ok_or(Stop::Unknown)?;
        if rows < 1 || columns < 1 || rows * columns > 4 * SMALL {
            return Err(Stop::Unknown);
        }
        let (rows, columns) = (rows as usize, columns as usize);
        let array = match self.is_active(e) {
            true => self.active(e)?,
            false => self.constant(e, rows, columns)?,
        };
        // vectors are columns, and a matrix of another shape is a mistake
        if (array.rows, array.columns) != (rows, columns) {
            return Err(Stop::Unknown);
        }
        let array = Rc::new(array);
        self.memo.insert(e, array.clone());
        Ok(array)
    }

    /// What does not change with the variable, by its entries.
    fn constant(&mut self, e: ExprId, rows: usize, columns: usize) -> Found<Array> {
        let ty = self.normal.program.arena.ty(e).clone();
        if ty.is_scalar() {
            let value = match ty.is_integer() {
                true => self
                    .normal
                    .program
                    .arena
                    .add(Kind::Unary(Unary::ToReal, e), Type::REAL),
                false => e,
            };
            return Ok(Array::number(value));
        }
        if ty.is_integer() || ty.is_sparse() {
            return Err(Stop::Unknown);
        }
        let mut entries = Vec::new();
        for j in 1..=columns as i64 {
            for i in 1..=rows as i64 {
                let arena = &mut self.normal.program.arena;
                let (i, j) = (arena.integer(i), arena.integer(j));
                let raw = self.normal.algebra().at(e, i, j);
                let entry = match self.normal.kind(raw) {
                    Kind::Component(..) | Kind::At(..) => self.normal.rule(raw),
                    _ => Ok(raw),
                };
                entries.push(entry.map_err(|_| Stop::Unknown)?);
            }
        }
        Ok(Array::new(rows, columns, entries))
    }

    /// The entries of an item of the variable.
    fn item(&mut self, e: ExprId, place: ExprId) -> Found<Array> {
        let (rows, columns) = self.normal.algebra().fixed(e).ok_or(Stop::Unknown)?;
        let ty = self.normal.program.arena.ty(e).clone();
        let mut entries = Vec::new();
        for j in 1..=columns {
            for i in 1..=rows {
                let arena = &mut self.normal.program.arena;
                let (i, j) = (arena.integer(i), arena.integer(j));
                entries.push(self.normal.algebra().at(e, i, j));
            }
        }
        if ty.is_integer() || entries.len() as i64 > SMALL {
            return Err(Stop::Unknown);
        }
        let item = Item {
            place,
            entries: entries.clone(),
        };
        self.items.insert(place, item);
        Ok(Array::new(rows as usize, columns as usize, entries))
    }

    fn index(&self, k: ExprId) -> Found<usize> {
        match self.normal.program.arena.kind(k) {
            Kind::Integer(k) if *k >= 1 => Ok(*k as usize - 1),
            _ => Err(Stop::Unknown),
        }
    }

    /// A choice by a condition, if it is known which.
    fn decided(&self, condition: ExprId) -> Found<bool> {
        let known = self.facts.iter().find(|(fact, _)| *fact == condition);
        known.map(|(_, holds)| *holds).ok_or(Stop::Cases(condition))
    }

    fn active(&mut self, e: ExprId) -> Found<Array> {
        let x = self.x;
        let kind = self.normal.kind(e);
        match kind {
            Kind::Item(s, place) if s == x => self.item(e, place),
            Kind::Component(s, k) if s == x => self.item(e, k),
            _ if e == x => Err(Stop::Unknown),
            Kind::Component(a, k) => {
                let (a, k) = (self.array(a)?, self.index(k)?);
                self.entry(&a, k)
            }
            Kind::At(a, i, j) => {
                let (a, i, j) = (self.array(a)?, self.index(i)?, self.index(j)?);
                if i >= a.rows || j >= a.columns {
                    return Err(Stop::Unknown);
                }
                self.entry(&a, i + j * a.rows)
            }
            Kind::ColumnOf(a, j) => {
                let (a, j) = (self.array(a)?, self.index(j)?);
                if j >= a.columns {
                    return Err(Stop::Unknown);
                }
                let a = a.expanded(&mut self.numbers());
                Ok(Array::new(a.rows, 1, a.column(j).to_vec()))
            }
            Kind::RowOf(a, i) => {
                let (a, i) = (self.array(a)?, self.index(i)?);
                if i >= a.rows {
                    return Err(Stop::Unknown);
                }
                let a = a.transposed().expanded(&mut self.numbers());
                Ok(Array::new(a.rows, 1, a.column(i).to_vec()))
            }
            Kind::Vector(items) => {
                let mut entries = Vec::new();
                for item in items {
                    entries.push(self.number(item)?);
                }
                Ok(Array::new(entries.len(), 1, entries))
            }
            Kind::Blocks(rows) => self.blocks(&rows),
            Kind::If(condition, a, b) => match self.decided(condition)? {
                true => Ok((*self.array(a)?).clone()),
                false => Ok((*self.array(b)?).clone()),
            },
            Kind::Fold {
                op: op @ (Fold::Sum | Fold::Product),
                variable,
                range: Range::Integers(from, to),
                condition: None,
                body,
            } => {
                let (from, to) = (self.index(from)?, self.index(to)?);
                let terms = from..=to;
                let mut all: Option<Array> = None;
                if to < from || to - from >= SMALL as usize {
                    return Err(Stop::Unknown);
                }
                for k in terms {
                    let k = self.normal.program.arena.integer(k as i64 + 1);
                    let term = self.normal.beta(body, &[(variable, k)]);
                    let term = self.array(term.map_err(|_| Stop::Unknown)?)?;
                    let mut s = self.numbers();
                    all = Some(match (all, op) {
                        (None, _) => (*term).clone(),
                        (Some(all), Fold::Sum) => all
                            .zip(&mut s, &term, |s, a, b| s.add(a, b))
                            .ok_or(Stop::Unknown)?,
                        (Some(all), _) => all
                            .zip(&mut s, &term, |s, a, b| s.multiply(a, b))
                            .ok_or(Stop::Unknown)?,
                    });
                }
                all.ok_or(Stop::Unknown)
            }
            Kind::Unary(op, a) => self.unary(e, op, a),
            Kind::Binary(op, a, b) => self.binary(e, op, a, b),
            _ => Err(Stop::Unknown),
        }
    }

    fn entry(&mut self, a: &Array, k: usize) -> Found<Array> {
        let value = *a.entries.get(k).ok_or(Stop::Unknown)?;
        Ok(Array::number(match a.factor {
            Some(factor) => self.numbers().multiply(factor, value),
            None => value,
        }))
    }

    /// A matrix of blocks.
    fn blocks(&mut self, rows: &[Vec<ExprId>]) -> Found<Array> {
        let mut lines: Vec<Vec<ExprId>> = Vec::new();
        for row in rows {
            let mut parts = Vec::new();
            for block in row {
                let part = self.array(*block)?;
                parts.push(part.expanded(&mut self.numbers()));
            }
            let height = parts.first().map_or(0, |part| part.rows);
            if parts.iter().any(|part| part.rows != height) {
                return Err(Stop::Unknown);
            }
            for i in 0..height {
                let across = parts
                    .iter()
                    .flat_map(|p| (0..p.columns).map(move |j| p.at(i, j)));
                lines.push(across.collect());
            }
        }
        let width = lines.first().map_or(0, Vec::len);
        if lines.iter().any(|line| line.len() != width) {
            return Err(Stop::Unknown);
        }
        let entries = (0..width).flat_map(|j| lines.iter().map(move |line| line[j]));
        Ok(Array::new(lines.len(), width, entries.collect()))
    }

    /// The reciprocal of the determinant of a matrix whose inverse fails where it is 0.
    fn reciprocal(&mut self, inverse: ExprId, determinant: ExprId) -> ExprId {
        let mut s = self.numbers();
        let zero = s.real(0.0);
        let ops = [CompareOp::Greater, CompareOp::Less, CompareOp::NotEqual];
        let differs = ops.map(|op| s.compare(op, determinant, zero));
        let (value, one) = (s.reciprocal(determinant), s.arena.integer(1));
        if self
            .facts
            .iter()
            .any(|(fact, holds)| *holds && differs.contains(fact))
        {
            return value;
        }
        // where there is none, the inverse says so
        let fails = self.normal.algebra().at(inverse, one, one);
        let guarded = self.numbers().choose(differs[2], value, fails);
        self.reciprocals.insert(guarded, determinant);
        guarded
    }

    fn inverse(&mut self, e: ExprId, a: &Array) -> Found<Array> {
        let mut plain = a.clone();
        plain.factor = None;
        let determinant = plain.determinant(&mut self.numbers());
        let reciprocal = self.reciprocal(e, determinant.ok_or(Stop::Unknown)?);
        let inverse = a.inverse(&mut self.numbers(), |_, _| reciprocal);
        inverse.ok_or(Stop::Unknown)
    }

    fn unary(&mut self, e: ExprId, op: Unary, operand: ExprId) -> Found<Array> {
        let a = self.array(operand)?;
        let mut s = self.numbers();
        Ok(match op {
            Unary::Negate => a.map(&mut s, |s, a| s.negate(a)),
            Unary::Absolute | Unary::SquareRoot | Unary::Apply(_) => {
                a.map(&mut s, |s, entry| s.unary(op, entry))
            }
            Unary::Norm => {
                let square = a.inner(&mut s, &a).ok_or(Stop::Unknown)?;
                Array::number(s.unary(Unary::SquareRoot, square))
            }
            Unary::Transpose => a.transposed(),
            Unary::Reshape if a.rows == 1 || a.columns == 1 => {
                let (rows, columns) = self.normal.algebra().fixed(e).ok_or(Stop::Unknown)?;
                let mut a = (*a).clone();
                (a.rows, a.columns) = (rows as usize, columns as usize);
                a
            }
            Unary::Stack => {
                let mut a = (*a).clone();
                (a.rows, a.columns) = (a.entries.len(), 1);
                a
            }
            Unary::Determinant => Array::number(a.determinant(&mut s).ok_or(Stop::Unknown)?),
            Unary::Trace if a.rows == a.columns => {
                let a = a.expanded(&mut s);
                let zero = s.real(0.0);
                let diagonal = (0..a.rows).map(|k| a.at(k, k));
                Array::number(diagonal.fold(zero, |sum, entry| s.add(sum, entry)))
            }
            Unary::Diagonal if a.columns == 1 && a.rows > 1 => {
                let a = a.expanded(&mut s);
                let zero = s.real(0.0);
                let n = a.rows;
                let entry = |k: usize| if k / n == k % n { a.at(k % n, 0) } else { zero };
                Array::new(n, n, (0..n * n).map(entry).collect())
            }
            Unary::Diagonal if a.rows == a.columns => {
                let a = a.expanded(&mut s);
                Array::new(a.rows, 1, (0..a.rows).map(|k| a.at(k, k)).collect())
            }
            Unary::Inverse => self.inverse(e, &a)?,
            _ => return Err(Stop::Unknown),
        })
    }

    fn binary(&mut self, e: ExprId, op: Binary, left: ExprId, right: ExprId) -> Found<Array> {
        let (a, b) = (self.array(left)?, self.array(right)?);
        let mut s = self.numbers();
        let single = |a: &Array, s: &mut Numbers<'_>| a.expanded(s).entries[0];
        let found = match op {
            Binary::Add => a.zip(&mut s, &b, |s, a, b| s.add(a, b)),
            Binary::Subtract => a.zip(&mut s, &b, |s, a, b| s.subtract(a, b)),
            Binary::Hadamard => a.zip(&mut s, &b, |s, a, b| s.multiply(a, b)),
            Binary::Multiply => {
                let k = single(&a, &mut s);
                Some(b.scaled(&mut s, k))
            }
            Binary::Divide => {
                let k = single(&b, &mut s);
                let k = s.reciprocal(k);
                Some(a.scaled(&mut s, k))
            }
            Binary::Power => {
                let p = s.number(right).ok_or(Stop::Unknown)?;
                let a = single(&a, &mut s);
                Some(Array::number(s.power(a, p)))
            }
            Binary::Dot | Binary::Frobenius => a.inner(&mut s, &b).map(Array::number),
            Binary::Cross => a.cross(&mut s, &b),
            Binary::Atan2 => {
                let (y, x) = (single(&a, &mut s), single(&b, &mut s));
                Some(Array::number(s.atan2(y, x)))
            }
            Binary::Min | Binary::Max => {
                let (p, q) = (single(&a, &mut s), single(&b, &mut s));
                let op = match op {
                    Binary::Min => CompareOp::LessOrEqual,
                    _ => CompareOp::GreaterOrEqual,
                };
                let first = s.compare(op, p, q);
                Some(Array::number(match self.decided(first)? {
                    true => p,
                    false => q,
                }))
            }
            Binary::Product => {
                let vector = is_vector(&self.normal.algebra().ty(left));
                let row = vector && a.columns == 1 && b.rows != 1;
                match row {
                    true => None,
                    false => a.product(&mut self.numbers(), &b),
                }
            }
            Binary::Kronecker => Some(a.kronecker(&mut s, &b)),
            Binary::Solve => {
                let inverse = self.inverse(e, &a)?;
                inverse.product(&mut self.numbers(), &b)
            }
            Binary::Unstack => {
                let shape = self.normal.algebra().ty(e).shape();
                let (n, m) = match shape {
                    Some(Shape::Matrix(..)) => (a.rows, a.columns),
                    _ => (a.entries.len(), 1),
                };
                let mut b = (*b).clone();
                (b.rows, b.columns) = (n, m);
                (b.entries.len() == n * m).then_some(b)
            }
            _ => None,
        };
        found.ok_or(Stop::Unknown)
    }
}
