//! From the program as it was written to one that runs fast: what depends only on the mesh is split from what
//! depends on values.
//!
//! Each pass is a file with a function `run`; [`Optimizations`] turns each one off, so that tests can compare.

mod binders;
pub mod binding;
mod cores;
mod corners;
mod fields;
mod inline;
mod locals;
pub use inline::reachable;
pub use locals::is_read_from_row;
mod nonzeros;
pub mod operations;
mod orbits;
mod parts;
mod plan;
mod products;
pub use plan::{MayFail, is_within, may_overflow};
pub mod rewrite;
mod share;
pub mod show;
mod steps;
mod sums;
pub mod tables;
mod together;
mod traverse;
mod triangles;

use std::collections::BTreeMap;

use crate::ir::{ExprId, FunctionId, GlobalId, Program, VariableId};
use crate::types::Element;

/// Which optimisations are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Optimizations {
    /// Unsigned products of boundary matrices and indicators become traversals.
    pub traverse: bool,
    /// Calls of functions that mix topology and values are replaced by their bodies.
    pub inline: bool,
    /// Products of sums of blocks and vectors do not form the matrix.
    pub products: bool,
    /// Sums along rows and columns of sparse matrices run over their stored entries.
    pub nonzeros: bool,
    /// Neighbours are found in tables of the mesh instead of sets.
    pub steps: bool,
    /// Expressions are brought to a common form, and computed once outside of loops.
    pub share: bool,
    /// What depends only on the mesh is computed once per mesh and stored in tables.
    pub plan: bool,
    /// Rows that name the corners of a triangle are turned so that the key comes first.
    pub corners: bool,
    /// Values of functions of one element are computed once for all elements where a whole field needs them often, and
    /// once for each element around a key where a single value needs them.
    pub fields: bool,
    /// Terms of a sum that share their elements are computed together and scattered.
    pub orbits: bool,
    /// The entries of sparse sums of blocks get their places once per mesh, where these depend on it alone.
    pub slots: bool,
}

impl Optimizations {
    /// All of them.
    pub const ALL: Self = Self {
        traverse: true,
        inline: true,
        products: true,
        nonzeros: true,
        steps: true,
        share: true,
        plan: true,
        corners: true,
        fields: true,
        orbits: true,
        slots: true,
    };
    /// None of them.
    pub const NONE: Self = Self {
        traverse: false,
        inline: false,
        products: false,
        nonzeros: false,
        steps: false,
        share: false,
        plan: false,
        corners: false,
        fields: false,
        orbits: false,
        slots: false,
    };

    /// Names of the switches, in the order of the passes.
    pub const NAMES: [&'static str; 11] = [
        "traverse", "inline", "products", "nonzeros", "steps", "share", "plan", "corners",
        "fields", "orbits", "slots",
    ];

    /// Sets a switch by its name; `false` when there is none of this name.
    pub fn set(&mut self, name: &str, on: bool) -> bool {
        let switch = match name {
            "traverse" => &mut self.traverse,
            "inline" => &mut self.inline,
            "products" => &mut self.products,
            "share" => &mut self.share,
            "plan" => &mut self.plan,
            "corners" => &mut self.corners,
            "fields" => &mut self.fields,
            "nonzeros" => &mut self.nonzeros,
            "steps" => &mut self.steps,
            "orbits" => &mut self.orbits,
            "slots" => &mut self.slots,
            _ => return false,
        };
        *switch = on;
        true
    }
}

/// One value of a row of a plan.
#[derive(Clone, Debug)]
pub struct Column {
    /// What is stored: an element, an integer or the outcome of a condition.
    pub value: ExprId,
    /// Whether computing it may fail; the row then holds a mark, and using it fails.
    pub may_fail: bool,
}

/// What the rows of a space stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rows {
    /// One row for each element: the key of the plan.
    Key(Element),
    /// One row for each element, for a loop over all of them.
    Universe(Element),
    /// The members of a set, for each row of the space above; without one, of a single set.
    Members(ExprId),
    /// The rows of another space that hold the key, turned so that it comes first.
    Corners(VariableId),
}

impl Rows {
    /// Whether there are several rows for each row of the space above.
    pub fn is_several(self) -> bool {
        matches!(self, Self::Members(_) | Self::Corners(_))
    }
}

/// A level of a plan.
#[derive(Clone, Debug)]
pub struct Space {
    /// The key, or the variable of the loop: the name of the space.
    pub variable: VariableId,
    /// The space above.
    pub parent: Option<VariableId>,
    /// What the rows stand for.
    pub rows: Rows,
    /// What is stored in each row.
    pub columns: Vec<Column>,
}

/// What is computed once per mesh for a function or definition, and the body that uses it.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// Levels, each after the one above it.
    pub spaces: Vec<Space>,
    /// How rows are turned.
    pub corners: Vec<Corners>,
    /// Values that the rows of a key share.
    pub locals: Vec<Local>,
}

/// How the rows of a space are turned so that the key comes first: a row of the new space holds the two corners after the
/// key, then further columns.
#[derive(Clone, Debug)]
pub struct Corners {
    /// The new space.
    pub space: VariableId,
    /// The space whose rows are turned; those that cannot be stay in it.
    pub of: VariableId,
    /// The columns that are turned in a circle.
    pub circle: [u32; 3],
    /// Columns that must be what stands in the circle one or two places after the key, with this number.
    pub merged: Vec<(u32, u32)>,
    /// Columns that are kept.
    pub kept: Vec<u32>,
}

/// Calls of a function of one element in the rows of a space, whose values are computed once for each element around
/// the key.
#[derive(Clone, Debug)]
pub struct Local {
    /// The space.
    pub space: VariableId,
    /// The function.
    pub function: FunctionId,
    /// The calls, with the columns that hold their elements.
    pub calls: Vec<(ExprId, u32)>,
}

impl Plan {
    /// A space by its name.
    pub fn space(&self, variable: VariableId) -> Option<&Space> {
        self.spaces.iter().find(|s| s.variable == variable)
    }

    /// The spaces below one, or those that have none above.
    pub fn below(&self, parent: Option<VariableId>) -> impl Iterator<Item = &Space> {
        self.spaces.iter().filter(move |s| s.parent == parent)
    }
}

/// A way to evaluate a function for all elements at once.
#[derive(Clone, Debug)]
pub struct Whole {
    /// The body in which calls of functions of one element read their values from fields.
    pub body: ExprId,
    /// Those functions.
    pub fields: Vec<FunctionId>,
    /// The sum whose terms are computed together, if there is one.
    pub orbit: Option<Orbit>,
}

/// A sum over rows whose terms come in groups: exchanging the elements of a row gives another row of the same group,
/// and its term shares most of its work.
#[derive(Clone, Debug)]
pub struct Orbit {
    /// The space of the sum.
    pub space: VariableId,
    /// The sum in the body of [`Whole`].
    pub sum: ExprId,
    /// Stand-ins for the elements of a row: first the key, then the columns.
    pub elements: Vec<VariableId>,
    /// Columns that the elements after the first stand for.
    pub columns: Vec<u32>,
    /// Where each element goes under the exchange.
    pub permutation: Vec<usize>,
    /// The terms of a group: the first is that of the row itself.
    pub terms: Vec<ExprId>,
    /// The body with the sum replaced by this variable.
    pub rest: ExprId,
    /// Stands for the sum in `rest`.
    pub sum_variable: VariableId,
}

/// How a function or definition is evaluated.
#[derive(Clone, Debug)]
pub struct Staged {
    /// The body over the plan; without a plan the body itself.
    pub body: ExprId,
    /// What is computed once per mesh.
    pub plan: Plan,
    /// How the whole field is evaluated, where that differs.
    pub whole: Option<Whole>,
}

/// A program with its plans.
#[derive(Clone, Debug)]
pub struct StagedProgram {
    /// The program.
    pub program: Program,
    /// Functions that depend only on the mesh and their parameters.
    pub static_functions: Vec<bool>,
    /// Definitions that depend only on the mesh.
    pub static_globals: Vec<bool>,
    /// How functions that depend on values are evaluated.
    pub functions: BTreeMap<FunctionId, Staged>,
    /// How definitions that depend on values are evaluated.
    pub globals: BTreeMap<GlobalId, Staged>,
    /// Where the rows of all plans are stored.
    pub tables: tables::Tables,
    /// Which optimisations were made.
    pub optimizations: Optimizations,
}

/// Optimises a program that has no errors.
pub fn optimize(mut program: Program, optimizations: Optimizations) -> StagedProgram {
    if optimizations.traverse {
        traverse::run(&mut program);
    }
    if optimizations.inline {
        inline::run(&mut program);
    }
    if optimizations.products {
        products::run(&mut program);
    }
    if optimizations.nonzeros {
        nonzeros::run(&mut program);
    }
    if optimizations.steps {
        steps::run(&mut program);
    }
    if optimizations.share {
        share::run(&mut program);
        binders::run(&mut program);
        sums::run(&mut program);
    }
    together::run(&mut program);
    if optimizations.slots {
        parts::run(&mut program);
    }
    cores::run(&mut program);
    debug_assert_eq!(crate::ir::validate::validate(&program), Ok(()));
    let binding = binding::Binding::of(&program);
    let mut staged = StagedProgram {
        static_functions: binding.functions.clone(),
        static_globals: binding.globals.clone(),
        functions: BTreeMap::new(),
        globals: BTreeMap::new(),
        tables: tables::Tables::default(),
        optimizations,
        program,
    };
    plan::run(&mut staged, &binding, optimizations.plan);
    if optimizations.plan && optimizations.corners {
        corners::run(&mut staged);
    }
    if optimizations.plan && optimizations.fields {
        fields::run(&mut staged);
        locals::run(&mut staged);
    }
    if optimizations.plan && optimizations.orbits {
        orbits::run(&mut staged);
    }
    tables::run(&mut staged, optimizations.share);
    staged
}
