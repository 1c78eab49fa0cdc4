//! Finds the sums of blocks whose places depend on the mesh alone, see [`super::slots`].

use std::collections::{BTreeMap, BTreeSet};

use super::Context;
use super::slots::{Added, Branches, Count, Parts, Scale, SlotSum, Step, Term};
use crate::ir::{Binary, ExprId, Fold, GlobalId, Kind, Range, Unary, VariableId, unproven};
use crate::optimize::{Plan, reachable};
use crate::types::Type;

pub(super) struct Finder<'a> {
    pub(super) context: &'a Context<'a>,
    plan: &'a Plan,
    /// Those of earlier definitions.
    others: &'a BTreeMap<GlobalId, SlotSum>,
    pub(super) sum: SlotSum,
    /// The array that blocks are added to.
    pub(super) array: usize,
    seen: BTreeSet<ExprId>,
    /// How many choices inside of blocks with replaced eigenvalues were met.
    pub(super) choices: usize,
    /// Inside of a block whose number of rows the mesh decides; whether only its product is asked for.
    pub(super) local: Option<bool>,
}

impl<'a> Finder<'a> {
    /// For a value of this type, or a tuple of several.
    pub(super) fn new(
        context: &'a Context<'a>,
        plan: &'a Plan,
        others: &'a BTreeMap<GlobalId, SlotSum>,
        ty: &Type,
    ) -> Self {
        Self {
            context,
            plan,
            others,
            sum: SlotSum::of(ty),
            array: 0,
            seen: BTreeSet::new(),
            choices: 0,
            local: None,
        }
    }

    pub(super) fn kind(&self, e: ExprId) -> &Kind {
        self.context.program().arena.kind(e)
    }

    /// The terms of a sum; all of them are scaled by what stands around it.
    pub(super) fn terms(&mut self, e: ExprId, scales: &mut Vec<Scale>) -> Option<()> {
        self.note_tuple(e);
        let inner = match *self.kind(e) {
            Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
                self.once(e)?;
                if !unproven(&self.context.program().arena, e).is_empty() {
                    return None;
                }
                self.terms(a, scales)?;
                if op == Binary::Add {
                    return self.terms(b, scales);
                }
                Some((Scale::Negated, b))
            }
            Kind::Unary(Unary::Negate, a) => Some((Scale::Negated, a)),
            Kind::Binary(Binary::Multiply, k, a) => Some((Scale::Times(k), a)),
            Kind::Binary(Binary::Divide, a, k) => Some((Scale::Over(k), a)),
            _ => None,
        };
        if let Some((scale, inner)) = inner {
            scales.push(scale);
            let done = self.terms(inner, scales);
            scales.pop();
            return done;
        }
        let parts = match self.whole(e) {
            Some(parts) => parts,
            None => Parts::Blocks(self.steps(e, &mut Vec::new())?),
        };
        self.sum.terms.push(Term {
            value: e,
            scales: scales.clone(),
            parts,
        });
        Some(())
    }

    /// A sparse matrix that is at hand, and whose pattern does not depend on values.
    fn whole(&mut self, e: ExprId) -> Option<Parts> {
        if !self.context.program().arena.ty(e).is_sparse() {
            return None;
        }
        if let Kind::Global(id) = self.kind(e)
            && let Some(other) = self.others.get(id)
        {
            let id = *id;
            for key in &other.keys {
                if !self.sum.keys.contains(key) {
                    self.sum.keys.push(*key);
                }
            }
            let sizes = &other.arrays.first()?.sizes;
            for size in sizes {
                self.steady(*size, &[])?;
            }
            self.sum.inputs.extend(&other.inputs);
            let known = &mut self.sum.arrays.get_mut(self.array)?.sizes;
            if known.is_empty() {
                known.clone_from(sizes);
            }
            return Some(Parts::Definition(id));
        }
        let mut has_blocks = false;
        reachable(&self.context.program().arena, e, &mut |kind| {
            has_blocks |= matches!(kind, Kind::Assemble { .. });
        });
        (!has_blocks && self.is_steady(e, &[])).then_some(Parts::Steady)
    }

    /// What is written in two places is computed once, as a matrix; only single blocks are not.
    fn once(&mut self, e: ExprId) -> Option<()> {
        (self.local.is_some() || self.seen.insert(e)).then_some(())
    }

    fn note_tuple(&mut self, e: ExprId) {
        if matches!(self.context.program().arena.ty(e), Type::Tuple(_)) {
            self.sum.tuples.insert(e);
        }
    }

    pub(super) fn steps(&mut self, e: ExprId, bound: &mut Vec<VariableId>) -> Option<Vec<Step>> {
        self.note_tuple(e);
        match self.kind(e).clone() {
            Kind::Tuple(items) => {
                let mut steps = Vec::new();
                let arrays = items.into_iter().take(self.sum.arrays.len());
                for (array, item) in arrays.enumerate() {
                    self.array = array;
                    steps.extend(self.steps(item, bound)?);
                }
                Some(steps)
            }
            Kind::Assemble { sizes, blocks } => {
                self.sizes(&sizes)?;
                let mut steps = Vec::new();
                for block in &blocks {
                    for place in block.rows.iter().chain(&block.columns) {
                        self.steady(*place, bound)?;
                    }
                    let (rows, columns) = self.context.fixed_shape(block.value)?;
                    let (height, width) = match (sizes.len(), block.columns.len()) {
                        // column by column
                        (1, 0) => (parts(rows * columns, block.rows.len())?, 1),
                        (2, n) => (parts(rows, block.rows.len())?, parts(columns, n)?),
                        _ => return None,
                    };
                    steps.push(Step::Block {
                        array: self.array,
                        rows: block.rows.clone(),
                        columns: block.columns.clone(),
                        height,
                        width,
                    });
                }
                Some(steps)
            }
            Kind::Unary(Unary::PositivePart | Unary::AbsolutePart, a) => {
                self.once(e)?;
                if self.local.is_some() {
                    return None;
                }
                let Some(unit) = self.unit(e, a, bound, false) else {
                    return self.local(a, bound, Added::Block);
                };
                Some(vec![Step::Block {
                    array: self.array,
                    rows: unit.places.clone(),
                    columns: unit.places,
                    height: unit.height,
                    width: unit.height,
                }])
            }
            Kind::Binary(Binary::Product, block, factor) => {
                self.once(e)?;
                self.product(block, factor, bound)
            }
            Kind::Binary(Binary::Multiply, _, a)
            | Kind::Binary(Binary::Divide, a, _)
            | Kind::Unary(Unary::Negate, a) => {
                self.once(e)?;
                self.steps(a, bound)
            }
            Kind::Binary(Binary::Add | Binary::Subtract, a, b) => {
                self.once(e)?;
                let mut steps = self.steps(a, bound)?;
                steps.extend(self.steps(b, bound)?);
                Some(steps)
            }
            Kind::If(condition, a, b) => {
                self.once(e)?;
                let (then, otherwise) = (self.steps(a, bound)?, self.steps(b, bound)?);
                if self.is_steady(condition, bound) {
                    return Some(vec![Step::Choice {
                        condition,
                        then,
                        otherwise,
                    }]);
                }
                let same = then == otherwise;
                if self.local.is_some() {
                    self.sum.local_branches.insert(e, same);
                    return Some(match same {
                        true => then,
                        false => vec![Step::Branch(then), Step::Branch(otherwise)],
                    });
                }
                let branches = Branches {
                    then: self.count(&then),
                    otherwise: self.count(&otherwise),
                    same,
                };
                let [a, b] = [&branches.then, &branches.otherwise].map(Option::is_some);
                self.sum.branches.insert(e, branches);
                if same {
                    return Some(then);
                }
                let mut steps = branch(then, a);
                steps.extend(branch(otherwise, b));
                Some(steps)
            }
            Kind::Fold {
                op: Fold::Sum,
                variable,
                range,
                condition,
                body,
            } => {
                self.once(e)?;
                match range {
                    Range::Set(set) => self.steady(set, bound)?,
                    Range::Integers(from, to) => {
                        self.steady(from, bound)?;
                        self.steady(to, bound)?;
                    }
                    Range::Rows { .. } => {}
                }
                bound.push(variable);
                let steps = self.steps(body, bound);
                let is_steady = condition.is_none_or(|c| self.is_steady(c, bound));
                bound.pop();
                let mut steps = steps?;
                if !is_steady && self.local.is_some() {
                    self.sum.local_branches.insert(e, false);
                    steps = vec![Step::Branch(steps)];
                } else if !is_steady {
                    let then = self.count(&steps);
                    steps = branch(steps, then.is_some());
                    let branches = Branches {
                        then,
                        otherwise: Some(Vec::new()),
                        same: false,
                    };
                    self.sum.branches.insert(e, branches);
                }
                Some(vec![Step::Loop { fold: e, steps }])
            }
            _ => None,
        }
    }

    pub(super) fn sizes(&mut self, sizes: &[ExprId]) -> Option<()> {
        for size in sizes {
            self.steady(*size, &[])?;
        }
        if self.local == Some(true) {
            return Some(());
        }
        let known = &mut self.sum.arrays.get_mut(self.array)?.sizes;
        if known.is_empty() {
            *known = sizes.to_vec();
        }
        (known == sizes).then_some(())
    }

    /// The values of some steps in each array; nothing where only the plan knows.
    fn count(&self, steps: &[Step]) -> Option<Vec<Count>> {
        let mut all = vec![Count::default(); self.sum.arrays.len()];
        for step in steps {
            let (array, pieces, height) = match step {
                Step::Block {
                    array,
                    rows,
                    columns,
                    height,
                    width,
                } => (*array, rows.len() * columns.len().max(1) * width, height),
                Step::Columns {
                    array,
                    rows,
                    columns,
                    height,
                } => {
                    let Kind::Integer(columns) = self.kind(*columns) else {
                        return None;
                    };
                    let columns = usize::try_from(*columns).ok()?;
                    (*array, rows.len() * columns, height)
                }
                Step::Choice {
                    condition,
                    then,
                    otherwise,
                } => {
                    let counts = self.count(then)?;
                    let arena = &self.context.program().arena;
                    let may_fail = self.context.may_fail.expr(arena, *condition)
                        || may_hold_mark(self.context, self.plan, *condition);
                    if may_fail || self.count(otherwise)? != counts {
                        return None;
                    }
                    for (sum, count) in all.iter_mut().zip(counts) {
                        sum.values += count.values;
                        sum.pieces += count.pieces;
                    }
                    continue;
                }
                Step::Local { .. } | Step::Loop { .. } | Step::Branch(_) => return None,
            };
            all[array].values += pieces * height;
            all[array].pieces += pieces;
        }
        Some(all)
    }

    fn is_steady(&mut self, e: ExprId, bound: &[VariableId]) -> bool {
        self.steady(e, bound).is_some()
    }

    /// Whether an expression depends only on the mesh, on variables of loops, on sets, elements, integers and sizes;
    /// what of these it depends on is noted.
    pub(super) fn steady(&mut self, e: ExprId, bound: &[VariableId]) -> Option<()> {
        let program = self.context.program();
        let free = &program.arena.node(e).free;
        if !free.iter().all(|variable| bound.contains(variable)) {
            return None;
        }
        let (mut keys, mut inputs) = (Vec::new(), BTreeSet::new());
        let (mut seen, mut open) = (BTreeSet::new(), vec![e]);
        while let Some(e) = open.pop() {
            if !seen.insert(e) {
                continue;
            }
            match program.arena.kind(e) {
                Kind::Extent(a, _) if matches!(self.kind(*a), Kind::Input(_)) => {
                    keys.push(e);
                    continue;
                }
                Kind::Size(size) if !size.is_of_meshes() => keys.push(e),
                Kind::Input(id) if !matches!(program.input(*id).ty, Type::Mesh(..)) => {
                    if !is_discrete(&program.input(*id).ty) {
                        return None;
                    }
                    inputs.insert(*id);
                }
                Kind::Global(id) if !self.context.is_static_global(*id) => return None,
                Kind::Call(id, _) if !self.context.is_static_function(*id) => return None,
                Kind::Field(..) | Kind::HostCall(..) => return None,
                _ => {}
            }
            program.arena.kind(e).operands(|operand| open.push(operand));
        }
        for key in keys {
            if !self.sum.keys.contains(&key) {
                self.sum.keys.push(key);
            }
        }
        self.sum.inputs.extend(inputs);
        Some(())
    }
}

/// Whether a row may hold a mark in place of something that an expression uses.
fn may_hold_mark(context: &Context<'_>, plan: &Plan, e: ExprId) -> bool {
    let mut found = false;
    crate::optimize::reachable(&context.program().arena, e, &mut |kind| {
        found |= super::block::Body::column_may_fail(plan, kind);
    });
    found
}

/// The steps of a branch that depends on values, where they are so many.
fn branch(steps: Vec<Step>, is_counted: bool) -> Vec<Step> {
    match is_counted {
        true => steps,
        false => vec![Step::Branch(steps)],
    }
}

pub(super) fn parts(size: usize, n: usize) -> Option<usize> {
    (n > 0 && size > 0 && size.is_multiple_of(n)).then(|| size / n)
}

/// Whether values of a type are not real numbers, nor hold any.
fn is_discrete(ty: &Type) -> bool {
    match ty {
        Type::Boolean | Type::Element(_) | Type::CellularSet(_) => true,
        Type::Set(item) | Type::Sequence { item, .. } => is_discrete(item),
        Type::Tuple(items) => items.iter().all(is_discrete),
        _ => ty.is_integer(),
    }
}
