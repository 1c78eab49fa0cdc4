//! Where each expression of a body is evaluated.
//!
//! A body is a tree of *regions*: the body itself, the inside of each loop, each branch of a choice. An expression
//! is evaluated in the innermost region that holds all its uses; it is moved out of loops whose variable it does not
//! depend on, if it cannot fail. What takes long, a loop or an operation with arrays of any size, leaves such loops also where it
//! may fail or stands in a branch: done in each round it would make the time quadratic. Where an expression that may fail is
//! evaluated where it may not be needed, it is *uncertain*: there it is a value or a failure, and fails where it is used.

use std::collections::{BTreeMap, BTreeSet};

use crate::ir::{Arena, ExprId, Kind, Restriction, VariableId};
use crate::types::Type;

/// A region.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RegionId(pub usize);

/// Which part of an expression is a region of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Part {
    /// The inside of a loop.
    Loop,
    /// The inside of a loop past its condition.
    Taken,
    /// The first branch of a choice.
    Then,
    /// The second branch of a choice.
    Else,
    /// The right side of `and` and `or`.
    Right,
}

#[derive(Clone, Debug)]
struct Region {
    parent: Option<RegionId>,
    depth: usize,
    /// The variables of a loop, of a function that is searched or integrated.
    variables: Vec<VariableId>,
    /// The expressions that are evaluated in it, operands first.
    placed: Vec<ExprId>,
    /// The branches of the choices that are surely evaluated in it.
    choices: Vec<[RegionId; 2]>,
}

/// The regions of a body and what is evaluated in each.
#[derive(Clone, Debug)]
pub struct Placement {
    regions: Vec<Region>,
    parts: BTreeMap<(ExprId, Part), RegionId>,
    place: BTreeMap<ExprId, RegionId>,
    uses: BTreeMap<ExprId, usize>,
    /// Where each expression is surely needed: where one of its uses is evaluated, itself not uncertain.
    needed: BTreeMap<ExprId, BTreeSet<RegionId>>,
    uncertain: BTreeSet<ExprId>,
    /// The region of an uncertain expression while its operands are met.
    unsure: Option<RegionId>,
}

/// What an emitter wants to be evaluated.
#[derive(Clone, Debug, Default)]
pub struct Roots {
    regions: Vec<(Option<usize>, Option<VariableId>)>,
    roots: Vec<(usize, ExprId)>,
}

impl Roots {
    /// A region of the emitter's own: the body itself, or a loop that it writes inside of another of its regions.
    pub fn region(&mut self, parent: Option<usize>, variable: Option<VariableId>) -> usize {
        self.regions.push((parent, variable));
        self.regions.len() - 1
    }

    /// An expression that is needed in a region.
    pub fn need(&mut self, region: usize, e: ExprId) {
        self.roots.push((region, e));
    }
}

impl Placement {
    /// Places all that the roots need. `may_fail` says which expressions fail by themselves; `is_guarded` which stay in their
    /// branch, since they may have no end elsewhere, or may be seen to be evaluated; `hoist` whether expressions are moved out
    /// of loops.
    pub fn new(
        arena: &Arena,
        roots: &Roots,
        may_fail: impl Fn(ExprId) -> bool,
        is_guarded: impl Fn(ExprId) -> bool,
        hoist: bool,
    ) -> Self {
        let mut placement = Self {
            regions: Vec::new(),
            parts: BTreeMap::new(),
            place: BTreeMap::new(),
            uses: BTreeMap::new(),
            needed: BTreeMap::new(),
            uncertain: BTreeSet::new(),
            unsure: None,
        };
        for (parent, variable) in &roots.regions {
            placement.add_region(parent.map(RegionId), variable.iter().copied());
        }
        let mut pending: BTreeMap<ExprId, RegionId> = BTreeMap::new();
        for (region, e) in &roots.roots {
            placement.use_in(&mut pending, *e, RegionId(*region));
        }
        let (mut fails, mut guarded) = (BTreeMap::new(), BTreeMap::new());
        // an operand comes before its uses, so that going backward meets all uses first
        while let Some((e, used)) = pending.pop_last() {
            let mut region = used;
            let may_fail = deep(arena, e, &may_fail, &mut fails);
            if hoist && takes_long(arena, e) && !deep(arena, e, &is_guarded, &mut guarded) {
                region = placement.outside_of_loops(arena, e, region);
            }
            if may_fail && (region != used || !placement.is_needed_in(e, region)) {
                placement.uncertain.insert(e);
                placement.unsure = Some(region);
            }
            if hoist && !may_fail {
                while let Some(outer) = placement.outside_of_loop(arena, e, region) {
                    region = outer;
                }
            }
            placement.place.insert(e, region);
            placement.regions[region.0].placed.push(e);
            placement.use_operands(arena, &mut pending, e, region);
            placement.unsure = None;
        }
        for region in &mut placement.regions {
            region.placed.reverse();
        }
        placement
    }

    /// Whether the value of an expression is needed whenever a region is entered: in it, or in both branches of a choice.
    fn is_needed_in(&self, e: ExprId, region: RegionId) -> bool {
        let Some(needed) = self.needed.get(&e) else {
            return false;
        };
        needed.contains(&region)
            || self.regions[region.0]
                .choices
                .iter()
                .any(|branches| branches.iter().all(|branch| self.is_needed_in(e, *branch)))
    }

    /// Whether an expression that may fail is evaluated where it may not be needed.
    pub fn is_uncertain(&self, e: ExprId) -> bool {
        self.uncertain.contains(&e)
    }

    fn add_region(
        &mut self,
        parent: Option<RegionId>,
        variables: impl IntoIterator<Item = VariableId>,
    ) -> RegionId {
        let depth = parent.map_or(0, |p| self.regions[p.0].depth + 1);
        self.regions.push(Region {
            parent,
            depth,
            variables: variables.into_iter().collect(),
            placed: Vec::new(),
            choices: Vec::new(),
        });
        RegionId(self.regions.len() - 1)
    }

    fn use_in(&mut self, pending: &mut BTreeMap<ExprId, RegionId>, e: ExprId, region: RegionId) {
        *self.uses.entry(e).or_insert(0) += 1;
        if self.unsure != Some(region) {
            self.needed.entry(e).or_default().insert(region);
        }
        let region = match pending.get(&e) {
            Some(&other) => self.common(other, region),
            None => region,
        };
        pending.insert(e, region);
    }

    fn use_operands(
        &mut self,
        arena: &Arena,
        pending: &mut BTreeMap<ExprId, RegionId>,
        e: ExprId,
        region: RegionId,
    ) {
        match arena.kind(e) {
            Kind::If(condition, a, b) => {
                let (a, b) = (*a, *b);
                self.use_in(pending, *condition, region);
                let branches = [(Part::Then, a), (Part::Else, b)].map(|(part, branch)| {
                    let inside = self.add_region(Some(region), []);
                    self.parts.insert((e, part), inside);
                    self.use_in(pending, branch, inside);
                    inside
                });
                if self.unsure.is_none() {
                    self.regions[region.0].choices.push(branches);
                }
            }
            Kind::And(a, b) | Kind::Or(a, b) => {
                let b = *b;
                self.use_in(pending, *a, region);
                let inside = self.add_region(Some(region), []);
                self.parts.insert((e, Part::Right), inside);
                self.use_in(pending, b, inside);
            }
            Kind::Fold {
                variable,
                condition,
                body,
                range,
                ..
            } => {
                match range {
                    crate::ir::Range::Set(set) => self.use_in(pending, *set, region),
                    crate::ir::Range::Integers(from, to) => {
                        self.use_in(pending, *from, region);
                        self.use_in(pending, *to, region);
                    }
                    crate::ir::Range::Rows { .. } => {}
                }
                let mut inside = self.add_region(Some(region), [*variable]);
                self.parts.insert((e, Part::Loop), inside);
                if let Some(condition) = condition {
                    self.use_in(pending, *condition, inside);
                    inside = self.add_region(Some(inside), []);
                    self.parts.insert((e, Part::Taken), inside);
                }
                self.use_in(pending, *body, inside);
            }
            Kind::Scatter {
                variable,
                set,
                sizes,
                place,
                body,
            } => {
                for outside in [set].into_iter().chain(sizes) {
                    self.use_in(pending, *outside, region);
                }
                let inside = self.add_region(Some(region), Some(*variable));
                self.parts.insert((e, Part::Loop), inside);
                for inner in place.iter().chain([body]) {
                    self.use_in(pending, *inner, inside);
                }
            }
            Kind::Tabulate {
                variables,
                sizes,
                body,
                ..
            } => {
                for size in sizes {
                    self.use_in(pending, *size, region);
                }
                let mut inside = region;
                for (variable, part) in variables.iter().zip([Part::Loop, Part::Taken]) {
                    inside = self.add_region(Some(inside), [*variable]);
                    self.parts.insert((e, part), inside);
                }
                self.use_in(pending, *body, inside);
            }
            Kind::Optimum {
                variables,
                start,
                restrictions,
                objective,
                ..
            } => {
                let inside = self.add_region(Some(region), variables.iter().copied());
                self.parts.insert((e, Part::Loop), inside);
                for value in start {
                    self.use_in(pending, *value, region);
                }
                for restriction in restrictions {
                    match restriction {
                        Restriction::Equal(value) | Restriction::AtMost(value) => {
                            self.use_in(pending, *value, inside);
                        }
                        Restriction::Lower(_, bound) | Restriction::Upper(_, bound) => {
                            self.use_in(pending, *bound, region);
                        }
                    }
                }
                self.use_in(pending, *objective, inside);
            }
            Kind::Integral {
                variable,
                from,
                to,
                body,
            } => {
                self.use_in(pending, *from, region);
                self.use_in(pending, *to, region);
                let inside = self.add_region(Some(region), [*variable]);
                self.parts.insert((e, Part::Loop), inside);
                self.use_in(pending, *body, inside);
            }
            kind => kind.operands(|operand| self.use_in(pending, operand, region)),
        }
    }

    /// The region around the loop that a region is the inside of, if the expression does not depend on its variable.
    fn outside_of_loop(&self, arena: &Arena, e: ExprId, region: RegionId) -> Option<RegionId> {
        let region = &self.regions[region.0];
        let mut variables = region.variables.iter();
        match region.variables.is_empty() || variables.any(|v| arena.depends_on(e, *v)) {
            true => None,
            false => region.parent,
        }
    }

    /// The region around the outermost loop that an expression can leave, branches on the way included.
    fn outside_of_loops(&self, arena: &Arena, e: ExprId, region: RegionId) -> RegionId {
        let (mut found, mut at) = (region, region);
        loop {
            let Region {
                parent, variables, ..
            } = &self.regions[at.0];
            let Some(parent) = *parent else {
                return found;
            };
            if variables.iter().any(|v| arena.depends_on(e, *v)) {
                return found;
            }
            if !variables.is_empty() {
                found = parent;
            }
            at = parent;
        }
    }

    fn common(&self, mut a: RegionId, mut b: RegionId) -> RegionId {
        while a != b {
            let (da, db) = (self.regions[a.0].depth, self.regions[b.0].depth);
            let up = |r: RegionId| self.regions[r.0].parent;
            if da >= db {
                match up(a) {
                    Some(parent) => a = parent,
                    // regions of different trees have no common one; the emitter never asks for this
                    None => return b,
                }
            } else {
                match up(b) {
                    Some(parent) => b = parent,
                    None => return a,
                }
            }
        }
        a
    }

    /// The expressions that are evaluated in a region, operands first.
    pub fn placed(&self, region: RegionId) -> &[ExprId] {
        &self.regions[region.0].placed
    }

    /// Whether an expression is evaluated inside of a loop, or of a function that is searched or integrated.
    pub fn is_in_loop(&self, e: ExprId) -> bool {
        let mut region = self.place.get(&e).copied();
        while let Some(RegionId(r)) = region {
            if !self.regions[r].variables.is_empty() {
                return true;
            }
            region = self.regions[r].parent;
        }
        false
    }

    /// The region that a part of an expression is.
    pub fn part(&self, e: ExprId, part: Part) -> RegionId {
        self.parts[&(e, part)]
    }

    /// How often the value of an expression is used where it is evaluated; more than 1 where it is used from a region
    /// further in. `is_result` says that its single use is as the result of the region.
    pub fn uses(&self, arena: &Arena, e: ExprId, is_result: bool) -> usize {
        let uses = self.uses.get(&e).copied().unwrap_or(0);
        if uses != 1 || is_result {
            return uses;
        }
        // a single use from further in must not be written there: it would be evaluated again and again
        let here = self.place[&e];
        let used_here = self.regions[here.0].placed.iter().any(|&user| {
            let mut found = false;
            match arena.kind(user) {
                Kind::If(condition, ..) => found = *condition == e,
                Kind::And(a, _) | Kind::Or(a, _) => found = *a == e,
                Kind::Fold { range, .. } => {
                    found = match range {
                        crate::ir::Range::Set(set) => *set == e,
                        crate::ir::Range::Integers(from, to) => *from == e || *to == e,
                        crate::ir::Range::Rows { .. } => false,
                    }
                }
                Kind::Tabulate { sizes, .. } => found = sizes.contains(&e),
                Kind::Scatter { set, sizes, .. } => found = *set == e || sizes.contains(&e),
                Kind::Optimum {
                    start, restrictions, ..
                } => {
                    found = start.contains(&e)
                        || restrictions.iter().any(|r| {
                            matches!(r, Restriction::Lower(_, b) | Restriction::Upper(_, b) if *b == e)
                        });
                }
                Kind::Integral { from, to, .. } => found = *from == e || *to == e,
                kind => kind.operands(|operand| found |= operand == e),
            }
            found
        });
        if used_here { 1 } else { 2 }
    }

    /// Whether an expression is the direct result of the region it is evaluated in: a branch, or the body of a loop.
    pub fn is_result_here(&self, arena: &Arena, e: ExprId) -> bool {
        let here = self.place[&e];
        self.parts.iter().any(|((owner, part), region)| {
            *region == here && match (arena.kind(*owner), part) {
                (Kind::If(_, a, _), Part::Then) => *a == e,
                (Kind::If(_, _, b), Part::Else) => *b == e,
                (Kind::And(_, b) | Kind::Or(_, b), Part::Right) => *b == e,
                (Kind::Fold { condition, .. }, Part::Loop) if *condition == Some(e) => true,
                (
                    Kind::Fold { body, .. } | Kind::Tabulate { body, .. },
                    Part::Loop | Part::Taken,
                ) => *body == e,
                (Kind::Scatter { place, body, .. }, Part::Loop) => *body == e || place.contains(&e),
                (Kind::Integral { body, .. }, Part::Loop) => *body == e,
                (
                    Kind::Optimum {
                        objective,
                        restrictions,
                        ..
                    },
                    Part::Loop,
                ) => *objective == e
                    || restrictions.iter().any(
                        |r| matches!(r, Restriction::Equal(v) | Restriction::AtMost(v) if *v == e),
                    ),
                _ => false,
            }
        })
    }

    /// All expressions that are evaluated somewhere.
    pub fn all(&self) -> BTreeSet<ExprId> {
        self.place.keys().copied().collect()
    }
}

/// Whether an expression is a loop over numbers, or an operation with arrays of any size.
fn takes_long(arena: &Arena, e: ExprId) -> bool {
    let is_array = |e: ExprId| matches!(arena.ty(e), Type::Vector { .. } | Type::Matrix { .. });
    let is_any_size = |e: ExprId| is_array(e) && !arena.ty(e).is_fixed();
    match arena.kind(e) {
        Kind::Fold { .. } => is_array(e) || matches!(arena.ty(e), Type::Scalar(_)),
        Kind::Unary(_, a) => is_any_size(e) || is_any_size(*a),
        Kind::Binary(_, a, b) => is_any_size(e) || is_any_size(*a) || is_any_size(*b),
        Kind::Assemble { blocks, .. } => !blocks.is_empty() && is_any_size(e),
        Kind::Tabulate { .. } | Kind::Scatter { .. } => is_any_size(e),
        _ => false,
    }
}

/// Whether an expression or one inside of it has a property.
fn deep(
    arena: &Arena,
    e: ExprId,
    own: &impl Fn(ExprId) -> bool,
    memo: &mut BTreeMap<ExprId, bool>,
) -> bool {
    if let Some(&known) = memo.get(&e) {
        return known;
    }
    let mut any = own(e);
    arena
        .kind(e)
        .operands(|operand| any = any || deep(arena, operand, own, memo));
    memo.insert(e, any);
    any
}
