//! Sums of blocks whose places depend on the mesh alone: what is known of them before values are.
//!
//! The sum is one or several loops, terms by themselves among them. Of these remains what gives the places: the loops, the
//! conditions that are static, and for each block where it goes. Where a condition depends on values, both branches are
//! taken, so that the pattern never depends on values.
//!
//! A sum stays what [`super::assemble`] makes of it, with the entries of a sparse one sorted at every evaluation, where
//! - its places, loops or the sizes of its blocks depend on values other than sets, elements and integers,
//! - a part of the sum is no block, but a matrix at hand whose pattern may depend on values.

use std::collections::{BTreeMap, BTreeSet};

use super::Context;
use super::slot_finder::Finder;
use crate::ir::{Block, ExprId, GlobalId, InputId, Kind, Range};
use crate::optimize::{Plan, Rows};
use crate::types::{Shape, Type};

/// One step of what gives the places.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// A block in parts of a height and a width.
    Block {
        /// The array that it is added to.
        array: usize,
        rows: Vec<ExprId>,
        columns: Vec<ExprId>,
        height: usize,
        width: usize,
    },
    /// Blocks in parts of a height, one in each column of the result: this is how many it has.
    Columns {
        array: usize,
        rows: Vec<ExprId>,
        columns: ExprId,
        height: usize,
    },
    /// A block whose eigenvalues are replaced, put together from others: the mesh decides how many rows it has. See
    /// [`super::slot_locals`].
    Local {
        array: usize,
        steps: Vec<Step>,
        /// Of the largest parts.
        height: usize,
        added: Added,
    },
    /// A branch that depends on values, with loops inside: the plan says how much is passed over where it is not taken.
    Branch(Vec<Step>),
    /// The loop of a sum.
    Loop { fold: ExprId, steps: Vec<Step> },
    /// A static condition.
    Choice {
        condition: ExprId,
        then: Vec<Step>,
        otherwise: Vec<Step>,
    },
}

impl Step {
    /// The height or width of the largest part of the blocks in some steps.
    pub(super) fn largest_of(steps: &[Self]) -> usize {
        let largest = steps.iter().map(|step| match step {
            Self::Block { height, width, .. } => *height.max(width),
            Self::Columns { height, .. } | Self::Local { height, .. } => *height,
            Self::Branch(steps) | Self::Loop { steps, .. } => Self::largest_of(steps),
            Self::Choice {
                then, otherwise, ..
            } => Self::largest_of(then).max(Self::largest_of(otherwise)),
        });
        largest.max().unwrap_or(0)
    }
}

/// What of a block is added.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Added {
    /// The block itself.
    Block,
    /// Its product with a vector.
    Vector,
    /// Its product with a matrix of so many columns.
    Columns(ExprId),
}

/// How many values and pieces of columns some steps have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Count {
    pub(super) values: usize,
    pub(super) pieces: usize,
}

/// What is passed over where a branch is not taken: the values of each of the two, array by array.
#[derive(Clone, Debug)]
pub(super) struct Branches {
    /// Nothing where it is known only from the plan: there are loops in it.
    pub(super) then: Option<Vec<Count>>,
    pub(super) otherwise: Option<Vec<Count>>,
    /// Both are at the same places.
    pub(super) same: bool,
}

/// The block of one element, whose eigenvalues are replaced.
#[derive(Clone, Debug)]
pub(super) struct Unit {
    pub(super) places: Vec<ExprId>,
    pub(super) height: usize,
    /// Only its product is asked for: its sizes are not those of the sum.
    pub(super) is_multiplied: bool,
}

/// What a term of a sum is multiplied or divided by, outside of its loops.
#[derive(Clone, Copy, Debug)]
pub(super) enum Scale {
    Negated,
    Times(ExprId),
    Over(ExprId),
}

/// What a term of a sum is made of.
#[derive(Clone, Debug)]
pub(super) enum Parts {
    /// Blocks, with what gives their places.
    Blocks(Vec<Step>),
    /// Another definition that is a sum with planned places.
    Definition(GlobalId),
    /// A sparse matrix that depends on the mesh, on sets, elements, integers and sizes alone: it is kept with the places.
    Steady,
}

/// A term of a sum.
#[derive(Clone, Debug)]
pub(super) struct Term {
    pub(super) value: ExprId,
    /// From the outside to the inside.
    pub(super) scales: Vec<Scale>,
    pub(super) parts: Parts,
}

/// An array that blocks are added to.
#[derive(Clone, Debug, Default)]
pub(super) struct Sizes {
    pub(super) sparse: bool,
    /// Its numbers of rows and columns.
    pub(super) sizes: Vec<ExprId>,
}

/// A sum of blocks with planned places, or several that are computed in one pass.
#[derive(Clone, Debug, Default)]
pub(super) struct SlotSum {
    pub(super) terms: Vec<Term>,
    /// What it is put together in.
    pub(super) arrays: Vec<Sizes>,
    /// How many numbers are added up beside the arrays.
    pub(super) totals: usize,
    /// The tuples of a pass, with sums, choices and loops of them.
    pub(super) tuples: BTreeSet<ExprId>,
    /// What its loops and places depend on besides the mesh: sizes.
    pub(super) keys: Vec<ExprId>,
    /// The same: sets, elements and integers.
    pub(super) inputs: BTreeSet<InputId>,
    /// The choices and loops whose conditions depend on values.
    pub(super) branches: BTreeMap<ExprId, Branches>,
    /// The blocks whose eigenvalues are replaced, of fixed sizes. All others are put together by the plan.
    pub(super) units: BTreeMap<ExprId, Unit>,
    /// The choices and loops inside of the others whose conditions depend on values; of each whether both branches are at the
    /// same places.
    pub(super) local_branches: BTreeMap<ExprId, bool>,
}

impl SlotSum {
    /// What there is in a value of this type, or in a tuple of several.
    pub(super) fn of(ty: &Type) -> Self {
        let mut sum = Self::default();
        let items = match ty {
            Type::Tuple(items) => items,
            ty => std::slice::from_ref(ty),
        };
        for item in items {
            match item.is_scalar() {
                true => sum.totals += 1,
                false => sum.arrays.push(Sizes {
                    sparse: item.is_sparse(),
                    sizes: Vec::new(),
                }),
            }
        }
        sum
    }

    /// All that the slots are made for: sizes, of the matrix and of what the loops run over.
    pub(super) fn sizes_and_keys(&self) -> impl Iterator<Item = ExprId> {
        let sizes = || self.arrays.iter().flat_map(|array| &array.sizes);
        let keys = self.keys.iter();
        let keys = keys.filter(move |key| !sizes().any(|size| size == *key));
        sizes().chain(keys).copied()
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
            let is_pass = self.program().pass(*id).is_some();
            if !is_pass && !arena.ty(staged.body).is_of_any_size() {
                continue;
            }
            let terms = match (is_pass, arena.kind(staged.body)) {
                (true, Kind::Tuple(terms)) => terms.clone(),
                _ => vec![staged.body],
            };
            let mut finder = Finder::new(self, &staged.plan, &found, arena.ty(terms[0]));
            let mut terms = terms.into_iter();
            let all = terms.try_for_each(|term| finder.terms(term, &mut Vec::new()));
            let sum = finder.sum;
            if all.is_some() && sum.arrays.iter().all(|array| !array.sizes.is_empty()) {
                found.insert(*id, sum);
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
