//! Sums of blocks whose places depend on the mesh alone: what is known of them before values are.
//!
//! The sum is one or several loops, terms by themselves among them. Of these remains what gives the places: the loops, the
//! conditions that are static, and for each block where it goes. Where a condition depends on values, both branches are
//! taken, so that the pattern never depends on values.
//!
//! A sum stays what [`super::assemble`] makes of it, with the entries of a sparse one sorted at every evaluation, where
//! - its places, loops or the sizes of its blocks depend on values other than sets, elements and integers,
//! - a loop stands below a condition that depends on values, or inside of `psd`,
//! - a block inside of `psd` is in parts of several heights,
//! - a part of the sum is no block: a matrix that is at hand.

use std::collections::{BTreeMap, BTreeSet};

use super::Context;
use crate::ir::{Binary, Block, ExprId, Fold, GlobalId, InputId, Kind, Range, Unary, VariableId};
use crate::optimize::{Plan, Rows};
use crate::types::{Shape, Type};

/// One step of what gives the places.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// A block in parts of a height and a width.
    Block {
        rows: Vec<ExprId>,
        columns: Vec<ExprId>,
        height: usize,
        width: usize,
    },
    /// The loop of a sum.
    Loop { fold: ExprId, steps: Vec<Step> },
    /// A static condition.
    Choice {
        condition: ExprId,
        then: Vec<Step>,
        otherwise: Vec<Step>,
    },
}

/// How many values and pieces of columns some steps have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Count {
    pub(super) values: usize,
    pub(super) pieces: usize,
}

/// What is passed over where a branch is not taken: the values of each of the two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Branches {
    pub(super) then: Count,
    pub(super) otherwise: Count,
    /// Both are at the same places.
    pub(super) same: bool,
}

/// The block of one element, whose eigenvalues are replaced.
#[derive(Clone, Debug)]
pub(super) struct Unit {
    pub(super) places: Vec<ExprId>,
    pub(super) height: usize,
}

/// A sum of blocks with planned places.
#[derive(Clone, Debug, Default)]
pub(super) struct SlotSum {
    /// Its terms, with what gives their places.
    pub(super) terms: Vec<(ExprId, Vec<Step>)>,
    /// Its numbers of rows and columns.
    pub(super) sizes: Vec<ExprId>,
    /// What its loops and places depend on besides the mesh: sizes.
    pub(super) keys: Vec<ExprId>,
    /// The same: sets, elements and integers.
    pub(super) inputs: BTreeSet<InputId>,
    /// The choices and loops whose conditions depend on values.
    pub(super) branches: BTreeMap<ExprId, Branches>,
    /// The blocks whose eigenvalues are replaced.
    pub(super) units: BTreeMap<ExprId, Unit>,
}

impl SlotSum {
    /// All that the slots are made for: sizes, of the matrix and of what the loops run over.
    pub(super) fn sizes_and_keys(&self) -> impl Iterator<Item = ExprId> {
        let keys = self.keys.iter().filter(|key| !self.sizes.contains(key));
        self.sizes.iter().chain(keys).copied()
    }
}

impl Context<'_> {
    /// The definitions that are sums of blocks with planned places.
    pub(super) fn find_slot_sums(&self) -> BTreeMap<GlobalId, SlotSum> {
        let mut found = BTreeMap::new();
        if !self.staged.optimizations.plan || !self.staged.optimizations.slots {
            return found;
        }
        for (id, staged) in &self.staged.globals {
            let arena = &self.program().arena;
            if !is_of_any_size(arena.ty(staged.body)) {
                continue;
            }
            let mut finder = Finder {
                context: self,
                plan: &staged.plan,
                sum: SlotSum::default(),
                seen: BTreeSet::new(),
                choices: 0,
            };
            if finder.terms(staged.body).is_some() && !finder.sum.sizes.is_empty() {
                found.insert(*id, finder.sum);
            }
        }
        found
    }

    /// Numbers of rows and columns, where the program fixes them.
    pub(super) fn fixed_shape(&self, value: ExprId) -> Option<(usize, usize)> {
        let ty = self.program().arena.ty(value);
        let (rows, columns) = match ty.shape() {
            _ if ty.is_sparse() || ty.is_integer() => return None,
            Some(Shape::Scalar) => (1, 1),
            Some(Shape::Vector(n)) => (n.value()?, 1),
            Some(Shape::Matrix(n, m)) => (n.value()?, m.value()?),
            None => return None,
        };
        Some((usize::try_from(rows).ok()?, usize::try_from(columns).ok()?))
    }

    /// Into how many pieces of columns a block falls.
    pub(super) fn pieces(&self, block: &Block) -> Option<usize> {
        let (_, columns) = self.fixed_shape(block.value)?;
        Some(match block.columns.is_empty() {
            true => block.rows.len(),
            false => block.rows.len() * columns,
        })
    }
}

struct Finder<'a> {
    context: &'a Context<'a>,
    plan: &'a Plan,
    sum: SlotSum,
    seen: BTreeSet<ExprId>,
    /// How many choices inside of blocks with replaced eigenvalues were met.
    choices: usize,
}

impl Finder<'_> {
    fn kind(&self, e: ExprId) -> &Kind {
        self.context.program().arena.kind(e)
    }

    fn terms(&mut self, e: ExprId) -> Option<()> {
        if let Kind::Binary(Binary::Add, a, b) = self.kind(e) {
            let (a, b) = (*a, *b);
            self.once(e)?;
            self.terms(a)?;
            return self.terms(b);
        }
        let steps = self.steps(e, &mut Vec::new())?;
        self.sum.terms.push((e, steps));
        Some(())
    }

    /// What is written in two places is computed once, as a matrix; only single blocks are not.
    fn once(&mut self, e: ExprId) -> Option<()> {
        self.seen.insert(e).then_some(())
    }

    fn steps(&mut self, e: ExprId, bound: &mut Vec<VariableId>) -> Option<Vec<Step>> {
        match self.kind(e).clone() {
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
                self.unit(e, a, bound)
            }
            Kind::Binary(Binary::Multiply, _, a) => {
                self.once(e)?;
                self.steps(a, bound)
            }
            Kind::Binary(Binary::Add, a, b) => {
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
                let branches = Branches {
                    then: self.count(&then)?,
                    otherwise: self.count(&otherwise)?,
                    same,
                };
                self.sum.branches.insert(e, branches);
                let mut steps = then;
                if !same {
                    steps.extend(otherwise);
                }
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
                let steps = steps?;
                if !is_steady {
                    let branches = Branches {
                        then: self.count(&steps)?,
                        otherwise: Count::default(),
                        same: false,
                    };
                    self.sum.branches.insert(e, branches);
                }
                Some(vec![Step::Loop { fold: e, steps }])
            }
            _ => None,
        }
    }

    fn sizes(&mut self, sizes: &[ExprId]) -> Option<()> {
        for size in sizes {
            self.steady(*size, &[])?;
        }
        if self.sum.sizes.is_empty() {
            self.sum.sizes = sizes.to_vec();
        }
        (self.sum.sizes == sizes).then_some(())
    }

    /// A block whose eigenvalues are replaced: all its places, each with each.
    fn unit(&mut self, e: ExprId, a: ExprId, bound: &[VariableId]) -> Option<Vec<Step>> {
        let mut unit = Unit {
            places: Vec::new(),
            height: 0,
        };
        let before = self.choices;
        self.local(a, bound, &mut unit)?;
        // places are named beside the block, and must be known there: outside of branches
        let is_known = |e: &ExprId| matches!(self.kind(*e), Kind::Column(..) | Kind::Variable(_));
        let branches = self.choices > before;
        if unit.places.is_empty() || branches && !unit.places.iter().all(is_known) {
            return None;
        }
        self.sum.units.insert(e, unit.clone());
        Some(vec![Step::Block {
            rows: unit.places.clone(),
            columns: unit.places,
            height: unit.height,
            width: unit.height,
        }])
    }

    fn local(&mut self, e: ExprId, bound: &[VariableId], unit: &mut Unit) -> Option<()> {
        match self.kind(e).clone() {
            Kind::Assemble { sizes, blocks } => {
                self.sizes(&sizes)?;
                for block in &blocks {
                    let (rows, columns) = self.context.fixed_shape(block.value)?;
                    if let Some(core) = block.core {
                        self.context.fixed_shape(core)?;
                    }
                    for (size, places) in [(rows, &block.rows), (columns, &block.columns)] {
                        let height = parts(size, places.len())?;
                        if unit.height != 0 && unit.height != height {
                            return None;
                        }
                        unit.height = height;
                        for place in places {
                            self.steady(*place, bound)?;
                            if !unit.places.contains(place) {
                                unit.places.push(*place);
                            }
                        }
                    }
                }
                Some(())
            }
            Kind::Binary(Binary::Add, a, b) | Kind::If(_, a, b) => {
                self.once(e)?;
                self.choices += usize::from(matches!(self.kind(e), Kind::If(..)));
                self.local(a, bound, unit)?;
                self.local(b, bound, unit)
            }
            Kind::Binary(Binary::Multiply, _, a) => {
                self.once(e)?;
                self.local(a, bound, unit)
            }
            _ => None,
        }
    }

    fn count(&self, steps: &[Step]) -> Option<Count> {
        let mut all = Count::default();
        for step in steps {
            let count = match step {
                Step::Block {
                    rows,
                    columns,
                    height,
                    width,
                } => {
                    let pieces = rows.len() * columns.len().max(1) * width;
                    Count {
                        values: pieces * height,
                        pieces,
                    }
                }
                Step::Choice {
                    condition,
                    then,
                    otherwise,
                } => {
                    let count = self.count(then)?;
                    let arena = &self.context.program().arena;
                    let may_fail = self.context.may_fail.expr(arena, *condition)
                        || may_hold_mark(self.context, self.plan, *condition);
                    if may_fail || self.count(otherwise)? != count {
                        return None;
                    }
                    count
                }
                Step::Loop { .. } => return None,
            };
            all.values += count.values;
            all.pieces += count.pieces;
        }
        Some(all)
    }

    fn is_steady(&mut self, e: ExprId, bound: &[VariableId]) -> bool {
        self.steady(e, bound).is_some()
    }

    /// Whether an expression depends only on the mesh, on variables of loops, on sets, elements, integers and sizes;
    /// what of these it depends on is noted.
    fn steady(&mut self, e: ExprId, bound: &[VariableId]) -> Option<()> {
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

/// Whether a type is that of sparse matrices, or of vectors and matrices whose size the program does not fix.
pub(super) fn is_of_any_size(ty: &Type) -> bool {
    let fixed = |n: &crate::types::Dimension| n.value().is_some();
    match ty.shape() {
        _ if ty.is_integer() => false,
        Some(Shape::Matrix(n, m)) => ty.is_sparse() || !(fixed(&n) && fixed(&m)),
        Some(Shape::Vector(n)) => !ty.is_sparse() && !fixed(&n),
        _ => false,
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

fn parts(size: usize, n: usize) -> Option<usize> {
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

/// Whether a loop can be done in pieces, each by the numbers of its rounds.
pub(super) fn is_in_rounds(context: &Context<'_>, plan: &Plan, fold: ExprId) -> bool {
    let arena = &context.program().arena;
    let Kind::Fold {
        variable, range, ..
    } = arena.kind(fold)
    else {
        return false;
    };
    match range {
        Range::Integers(..) => true,
        Range::Set(set) => matches!(arena.kind(*set), Kind::AllElements(_)),
        Range::Rows { .. } => plan.space(*variable).is_some_and(|space| match space.rows {
            Rows::Universe(_) => true,
            Rows::Members(_) => space.parent.is_none(),
            Rows::Corners(_) | Rows::Key(_) => false,
        }),
    }
}
