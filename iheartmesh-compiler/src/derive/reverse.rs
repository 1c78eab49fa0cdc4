//! Reverse mode: from a value back to what it depends on, each expression once.
//!
//! A body is a tree of regions: the inside of each loop, each branch of a choice. The adjoint of an expression, the
//! derivative of the result by it, is formed in the innermost region that holds all its uses: sums over loops carry
//! what comes from further in. What is not evaluated, such as the branch that is not taken, has no part in it.

use std::collections::{BTreeMap, HashMap};

use super::Trouble;
use super::algebra::Algebra;
use super::hessian::is_local;
use super::normal::Normal;
use crate::ir::{Binary, Block, ExprId, Fold, Kind, Range, Unary, VariableId};
use crate::optimize::{MayFail, rewrite};
use crate::syntax::ast::CompareOp;
use crate::types::{Shape, Type};

/// What a region is.
#[derive(Clone, Debug)]
enum Part {
    /// All of it.
    Whole,
    /// The inside of a loop.
    Loop(VariableId, Range, Option<ExprId>),
    /// What is evaluated where a condition holds; the other branch.
    Then(ExprId, usize),
    /// What is evaluated where a condition does not hold; the other branch.
    Else(ExprId, usize),
}

#[derive(Clone, Debug)]
struct Region {
    part: Part,
    parent: usize,
    depth: usize,
}

/// The shape in which derivatives are collected.
#[derive(Clone, Debug)]
pub(super) enum Target {
    /// The derivative by a number.
    Number,
    /// A vector of this length with the type.
    Vector(ExprId, Type),
    /// A row of a matrix: its number, the sizes of the matrix, its type.
    Row(ExprId, [ExprId; 2], Type),
}

impl Target {
    /// 0 in this shape.
    pub(super) fn zero(&self, algebra: &mut Algebra<'_>) -> ExprId {
        self.blocks(algebra, Vec::new())
    }

    fn blocks(&self, algebra: &mut Algebra<'_>, blocks: Vec<Block>) -> ExprId {
        let (sizes, ty) = match self {
            Target::Number => return algebra.real(0.0),
            Target::Vector(n, ty) => (vec![*n], ty),
            Target::Row(_, sizes, ty) => (sizes.to_vec(), ty),
        };
        algebra
            .arena
            .add(Kind::Assemble { sizes, blocks }, ty.clone())
    }
}

#[derive(Debug)]
struct Pending {
    region: usize,
    adjoints: Vec<(usize, ExprId)>,
}

/// One derivative on its way.
pub(super) struct Reverse<'n, 'a> {
    pub(super) normal: &'n mut Normal<'a>,
    x: ExprId,
    target: Target,
    may_fail: MayFail,
    regions: Vec<Region>,
    pending: BTreeMap<ExprId, Pending>,
    leaves: Vec<(usize, ExprId)>,
    fails: HashMap<ExprId, bool>,
}

impl<'n, 'a> Reverse<'n, 'a> {
    /// The derivative of a number by `x`; both in normal form.
    pub(super) fn of(
        normal: &'n mut Normal<'a>,
        y: ExprId,
        x: ExprId,
        target: Target,
    ) -> Result<ExprId, Trouble> {
        let may_fail = MayFail::of(normal.program);
        let mut reverse = Self {
            normal,
            x,
            target,
            may_fail,
            regions: vec![Region {
                part: Part::Whole,
                parent: 0,
                depth: 0,
            }],
            pending: BTreeMap::new(),
            leaves: Vec::new(),
            fails: HashMap::new(),
        };
        let one = reverse.algebra().real(1.0);
        reverse.give(y, 0, one);
        while let Some((e, pending)) = reverse.pending.pop_last() {
            let (mut to, mut region) = (pending.region, pending.region);
            while let Some((outer, used)) = reverse.outside(e, region) {
                (to, region) = (outer, used);
            }
            let zero = |algebra: &mut Algebra<'_>| algebra.zero(e);
            let adjoint = reverse.gather(pending.adjoints, to, zero);
            if !reverse.algebra().is_zero(adjoint) {
                reverse.propagate(e, region, adjoint)?;
            }
        }
        let leaves = std::mem::take(&mut reverse.leaves);
        let target = reverse.target.clone();
        Ok(reverse.gather(leaves, 0, |algebra| target.zero(algebra)))
    }

    pub(super) fn algebra(&mut self) -> Algebra<'_> {
        self.normal.algebra()
    }

    /// Adds to the adjoint of an expression that is used in a region.
    pub(super) fn give(&mut self, e: ExprId, region: usize, adjoint: ExprId) {
        if !self.is_active(e) {
            return;
        }
        let ty = self.algebra().dense(e);
        let adjoint = self.algebra().represented(adjoint, &ty);
        let pending = self.pending.remove(&e);
        let common = match &pending {
            Some(pending) => self.common(pending.region, region),
            None => region,
        };
        let mut adjoints = pending.map_or(Vec::new(), |p| p.adjoints);
        adjoints.push((region, adjoint));
        self.pending.insert(
            e,
            Pending {
                region: common,
                adjoints,
            },
        );
    }

    /// Whether an expression changes with the variable.
    pub(super) fn is_active(&mut self, e: ExprId) -> bool {
        let x = self.x;
        self.normal.changes_with(e, x)
    }

    fn common(&self, mut a: usize, mut b: usize) -> usize {
        while a != b {
            match self.regions[a].depth >= self.regions[b].depth {
                true => a = self.regions[a].parent,
                false => b = self.regions[b].parent,
            }
        }
        a
    }

    /// The region around a loop, where an expression does not depend on the loop: what comes from all rounds goes on from
    /// there at once. An expression without a value matters only if there is a round that uses it: it goes on in the second
    /// region, then.
    fn outside(&mut self, e: ExprId, mut region: usize) -> Option<(usize, usize)> {
        let mut taken = Vec::new();
        let (variable, range, condition) = loop {
            let Region { part, parent, .. } = self.regions[region].clone();
            match part {
                Part::Whole => return None,
                Part::Loop(variable, range, condition) => break (variable, range, condition),
                Part::Then(condition, _) => taken.push(condition),
                Part::Else(condition, _) => {
                    let not = Kind::Not(condition);
                    taken.push(self.algebra().arena.add(not, Type::Boolean));
                }
            }
            region = parent;
        };
        let outer = self.regions[region].parent;
        if self.normal.program.arena.depends_on(e, variable) {
            return None;
        }
        if !self.fails(e) {
            return Some((outer, outer));
        }
        // few items are added to in each round as fast
        if is_local(self.normal, e, &[self.x]) {
            return None;
        }
        taken.extend(condition);
        let is_used = self.has_rounds(variable, range, taken);
        Some((outer, self.branches(outer, is_used).0))
    }

    /// Whether a loop has a round in which conditions hold, the last of them the first that is asked.
    fn has_rounds(
        &mut self,
        mut variable: VariableId,
        range: Range,
        conditions: Vec<ExprId>,
    ) -> ExprId {
        let fresh = self.normal.fresh(&mut [&mut variable]);
        let arena = &mut self.normal.program.arena;
        let zero = arena.integer(0);
        let all = conditions
            .into_iter()
            .map(|c| rewrite::substitute(arena, c, &fresh))
            .collect::<Vec<_>>();
        let condition = all
            .into_iter()
            .rev()
            .reduce(|first, then| arena.add(Kind::And(first, then), Type::Boolean));
        let count = match (range, condition) {
            (Range::Integers(from, to), None) => {
                return self.algebra().compare(CompareOp::LessOrEqual, from, to);
            }
            (Range::Set(set), None) => arena.add(Kind::Cardinality(set), Type::INTEGER),
            _ => {
                let kind = Kind::Fold {
                    op: Fold::Sum,
                    variable,
                    range,
                    condition,
                    body: arena.integer(1),
                };
                arena.add(kind, Type::INTEGER)
            }
        };
        self.algebra().compare(CompareOp::NotEqual, count, zero)
    }

    fn fails(&mut self, e: ExprId) -> bool {
        if let Some(&known) = self.fails.get(&e) {
            return known;
        }
        let arena = &self.normal.program.arena;
        let mut fails = self.may_fail.own(arena, e);
        arena.kind(e).clone().operands(|operand| {
            fails = fails || self.fails(operand);
        });
        self.fails.insert(e, fails);
        fails
    }

    fn region(&mut self, part: Part, parent: usize) -> usize {
        let depth = self.regions[parent].depth + 1;
        self.regions.push(Region {
            part,
            parent,
            depth,
        });
        self.regions.len() - 1
    }

    /// The inside of a loop.
    pub(super) fn inside_of_loop(
        &mut self,
        parent: usize,
        variable: VariableId,
        range: Range,
        condition: Option<ExprId>,
    ) -> usize {
        self.region(Part::Loop(variable, range, condition), parent)
    }

    /// The two branches of a choice.
    pub(super) fn branches(&mut self, parent: usize, condition: ExprId) -> (usize, usize) {
        let then = self.regions.len();
        self.region(Part::Then(condition, then + 1), parent);
        self.region(Part::Else(condition, then), parent);
        (then, then + 1)
    }

    /// The sum, in a region, of what comes from regions further in.
    fn gather(
        &mut self,
        values: Vec<(usize, ExprId)>,
        to: usize,
        zero: impl Fn(&mut Algebra<'_>) -> ExprId,
    ) -> ExprId {
        // the deepest region is last
        let mut sums: BTreeMap<(usize, usize), ExprId> = BTreeMap::new();
        let put = |this: &mut Self, sums: &mut BTreeMap<_, _>, region: usize, value| {
            let key = (this.regions[region].depth, region);
            let sum = match sums.remove(&key) {
                Some(sum) => this.algebra().add(sum, value),
                None => value,
            };
            sums.insert(key, sum);
        };
        for (region, value) in values {
            put(self, &mut sums, region, value);
        }
        while let Some(((_, region), value)) = sums.pop_last() {
            if region == to {
                return value;
            }
            let Region {
                part,
                parent,
                depth,
            } = self.regions[region].clone();
            let wrapped = match part {
                Part::Whole => return value,
                Part::Loop(variable, range, condition) => {
                    self.normal.summed(variable, range, condition, value)
                }
                Part::Then(condition, other) | Part::Else(condition, other) => {
                    let other = sums.remove(&(depth, other));
                    let mut algebra = self.algebra();
                    let other = other.unwrap_or_else(|| zero(&mut algebra));
                    match part {
                        Part::Then(..) => algebra.choose(condition, value, other),
                        _ => algebra.choose(condition, other, value),
                    }
                }
            };
            put(self, &mut sums, parent, wrapped);
        }
        zero(&mut self.algebra())
    }

    fn propagate(&mut self, e: ExprId, region: usize, adjoint: ExprId) -> Result<(), Trouble> {
        if e == self.x {
            self.whole(region, adjoint);
            return Ok(());
        }
        if self.access(e, region, adjoint) {
            return Ok(());
        }
        self.rule(e, region, adjoint)
    }

    /// The variable itself.
    fn whole(&mut self, region: usize, adjoint: ExprId) {
        let one = self.algebra().arena.integer(1);
        let ty = self.normal.program.arena.ty(self.x).clone();
        let stacked = match (self.algebra().kind(adjoint), &self.target, ty.shape()) {
            (_, Target::Number, _) => adjoint,
            (Kind::Binary(Binary::Unstack, _, entries), ..) => entries,
            (_, _, Some(Shape::Scalar | Shape::Vector(_))) => adjoint,
            (_, Target::Vector(_, ty), _) => {
                let ty = ty.clone();
                self.algebra().unary(Unary::Stack, adjoint, ty)
            }
            (_, Target::Row(_, _, ty), _) => {
                let Type::Matrix { columns, .. } = ty.clone() else {
                    return;
                };
                let ty = Type::real_vector(columns);
                self.algebra().unary(Unary::Stack, adjoint, ty)
            }
        };
        match self.target.clone() {
            Target::Number => self.leaves.push((region, adjoint)),
            Target::Vector(_, ty) => {
                let stacked = self.algebra().represented(stacked, &ty);
                self.leaves.push((region, stacked));
            }
            Target::Row(..) => self.block(region, one, stacked),
        }
    }

    /// A block of the derivative at a place of the variable.
    fn block(&mut self, region: usize, place: ExprId, value: ExprId) {
        let target = self.target.clone();
        let block = match &target {
            Target::Number => {
                self.leaves.push((region, value));
                return;
            }
            Target::Vector(..) => Block {
                rows: vec![place],
                columns: Vec::new(),
                value,
                core: None,
            },
            Target::Row(row, ..) => {
                let mut algebra = self.normal.algebra();
                let value = match algebra.ty(value).shape() {
                    Some(Shape::Scalar) => value,
                    Some(Shape::Matrix(n, m)) => {
                        let n = n.multiply(&m).unwrap_or(n);
                        let stacked = algebra.unary(Unary::Stack, value, Type::real_vector(n));
                        algebra.transpose(stacked)
                    }
                    _ => algebra.transpose(value),
                };
                Block {
                    rows: vec![*row],
                    columns: vec![place],
                    value,
                    core: None,
                }
            }
        };
        let leaf = target.blocks(&mut self.normal.algebra(), vec![block]);
        self.leaves.push((region, leaf));
    }

    /// An item, entry, row or column of the variable: a block of the derivative.
    fn access(&mut self, e: ExprId, region: usize, adjoint: ExprId) -> bool {
        let x = self.x;
        let ty = self.algebra().ty(x);
        let kind = self.algebra().kind(e);
        match (&ty, kind) {
            (Type::Sequence { .. }, Kind::Item(s, index)) if s == x => {
                self.block(region, index, adjoint);
            }
            (Type::Sequence { .. }, Kind::Component(item, k)) => {
                let Kind::Item(s, index) = self.algebra().kind(item) else {
                    return false;
                };
                let small = self.algebra().fixed(item).is_some_and(|(n, _)| n <= 4);
                let known = matches!(self.algebra().kind(k), Kind::Integer(_));
                if s != x || small && known {
                    return false;
                }
                let n = self.algebra().size(item, 0);
                let place = self.algebra().inside(index, n, k);
                self.block(region, place, adjoint);
            }
            (Type::Sequence { .. }, Kind::At(item, i, j)) => {
                let Kind::Item(s, index) = self.algebra().kind(item) else {
                    return false;
                };
                if s != x {
                    return false;
                }
                let mut algebra = self.algebra();
                let (n, m) = (algebra.size(item, 0), algebra.size(item, 1));
                let size = algebra.count(Binary::Multiply, n, m);
                let inner = algebra.inside(j, n, i);
                let place = algebra.inside(index, size, inner);
                self.block(region, place, adjoint);
            }
            (Type::Vector { .. }, Kind::Component(s, k)) if s == x => {
                let small = self.algebra().fixed(x).is_some_and(|(n, _)| n <= 4);
                if small {
                    return false;
                }
                self.block(region, k, adjoint);
            }
            (Type::Matrix { .. }, Kind::At(s, i, j)) if s == x => {
                let n = self.algebra().size(x, 0);
                let place = self.algebra().inside(j, n, i);
                self.block(region, place, adjoint);
            }
            (Type::Matrix { .. }, Kind::ColumnOf(s, j)) if s == x => {
                self.block(region, j, adjoint);
            }
            (Type::Matrix { .. }, Kind::RowOf(s, i)) if s == x => {
                let (j, column) = self.normal.index("j");
                let m = self.algebra().size(x, 1);
                let one = self.algebra().arena.integer(1);
                let inner = self.inside_of_loop(region, j, Range::Integers(one, m), None);
                let n = self.algebra().size(x, 0);
                let place = self.algebra().inside(column, n, i);
                let entry = self.algebra().entry(adjoint, column);
                self.block(inner, place, entry);
            }
            _ => return false,
        }
        true
    }
}
