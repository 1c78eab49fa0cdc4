//! What depends only on the mesh is computed once per mesh and stored in tables: the plan.
//!
//! ```text
//! ∑_(f ∈ Faces(v)) g(x_j) where j = next(f, v)  ⟶  ∑ over rows of v: g(x_⟨column 0⟩)
//! ```
//!
//! A loop over a static set becomes a loop over the rows of a *space*; a static element, integer or condition that
//! dynamic code uses becomes a *column* of the deepest space that it depends on. A function of one element has the
//! rows of its plan keyed by that element.

use std::collections::HashMap;

use super::binding::{Binding, Expressions};
use super::{Column, Plan, Rows, Space, Staged, StagedProgram};
use crate::ir::{
    Arena, Binary, ExprId, Fold, Function, FunctionId, GlobalId, Kind, Layout, Program, Range,
    Unary, VariableId, is_of_unknown_size, unproven,
};
use crate::types::{Element, Type};

/// Stages every function and definition that depends on values. Without `tabulate` the plans are empty.
pub fn run(staged: &mut StagedProgram, binding: &Binding, tabulate: bool) {
    let may_fail = MayFail::of(&staged.program);
    for id in staged.program.function_ids() {
        if binding.functions[id.0 as usize] {
            continue;
        }
        let function = staged.program.function(id).clone();
        let variables = function.parameters.iter().filter(|p| p.ty.is_element());
        let variables = variables.map(|p| p.variable).collect();
        let key = tabulate.then(|| key(&function)).flatten();
        let result = stage(
            &mut staged.program,
            binding,
            &may_fail,
            variables,
            key,
            function.body,
            tabulate,
        );
        staged.functions.insert(id, result);
    }
    for k in 0..staged.program.globals.len() {
        if !binding.globals[k] {
            let value = staged.program.globals[k].value;
            let result = stage(
                &mut staged.program,
                binding,
                &may_fail,
                Vec::new(),
                None,
                value,
                tabulate,
            );
            staged.globals.insert(GlobalId(k as u32), result);
        }
    }
}

/// The parameter that the rows of a function's plan are keyed by: its only element.
fn key(function: &Function) -> Option<(VariableId, Element)> {
    let mut elements = function.parameters.iter().filter_map(|p| match p.ty {
        Type::Element(element) => Some((p.variable, element)),
        _ => None,
    });
    match (elements.next(), elements.next()) {
        (Some(key), None) => Some(key),
        _ => None,
    }
}

fn stage(
    program: &mut Program,
    binding: &Binding,
    may_fail: &MayFail,
    variables: Vec<VariableId>,
    key: Option<(VariableId, Element)>,
    body: ExprId,
    tabulate: bool,
) -> Staged {
    if !tabulate {
        return Staged {
            body,
            plan: Plan::default(),
            whole: None,
        };
    }
    // binding times of everything in the body, before the arena grows
    let mut times = HashMap::new();
    {
        let mut expressions = binding.expression(program, variables);
        collect(&program.arena, body, &mut expressions, &mut times);
    }
    let mut stager = Stager {
        arena: &mut program.arena,
        times,
        may_fail,
        plan: Plan::default(),
        chains: HashMap::new(),
        memo: HashMap::new(),
    };
    if let Some((variable, element)) = key {
        stager.plan.spaces.push(Space {
            variable,
            parent: None,
            rows: Rows::Key(element),
            columns: Vec::new(),
        });
        stager.chains.insert(variable, vec![variable]);
    }
    let body = stager.expr(body);
    let mut plan = stager.plan;
    // a key without columns and without rows below it needs no table
    let is_used = |space: &Space, all: &[Space]| {
        !space.columns.is_empty()
            || !matches!(space.rows, Rows::Key(_))
            || all.iter().any(|s| s.parent == Some(space.variable))
    };
    let all = plan.spaces.clone();
    plan.spaces.retain(|space| is_used(space, &all));
    Staged {
        body,
        plan,
        whole: None,
    }
}

fn collect(
    arena: &Arena,
    e: ExprId,
    expressions: &mut Expressions<'_>,
    times: &mut HashMap<ExprId, bool>,
) {
    if times.contains_key(&e) {
        return;
    }
    times.insert(e, expressions.is_static(e));
    arena
        .kind(e)
        .operands(|operand| collect(arena, operand, expressions, times));
}

struct Stager<'a> {
    arena: &'a mut Arena,
    times: HashMap<ExprId, bool>,
    may_fail: &'a MayFail,
    plan: Plan,
    /// For each space the variables that its rows are known by, the own one last.
    chains: HashMap<VariableId, Vec<VariableId>>,
    memo: HashMap<ExprId, ExprId>,
}

impl Stager<'_> {
    fn is_static(&self, e: ExprId) -> bool {
        self.times.get(&e).copied().unwrap_or(false)
    }

    fn expr(&mut self, e: ExprId) -> ExprId {
        if let Some(&done) = self.memo.get(&e) {
            return done;
        }
        let done = self.column(e).unwrap_or_else(|| self.inside(e));
        self.memo.insert(e, done);
        done
    }

    /// The expression as a column of a space, where it can be one.
    fn column(&mut self, e: ExprId) -> Option<ExprId> {
        let ty = self.arena.ty(e).clone();
        if !self.is_static(e) || !matches!(ty, Type::Element(_) | Type::INTEGER | Type::Boolean) {
            return None;
        }
        if matches!(
            self.arena.kind(e),
            Kind::Integer(_) | Kind::Boolean(_) | Kind::Fail
        ) {
            return None;
        }
        let space = self.deepest(e)?;
        let position = self.plan.spaces.iter().position(|s| s.variable == space)?;
        let rows = self.plan.spaces[position].rows;
        if *self.arena.kind(e) == Kind::Variable(space) && !matches!(rows, Rows::Members(_)) {
            return None;
        }
        let may_fail = self.may_fail.expr(self.arena, e);
        let columns = &mut self.plan.spaces[position].columns;
        let index = columns
            .iter()
            .position(|c| c.value == e)
            .unwrap_or_else(|| {
                columns.push(Column { value: e, may_fail });
                columns.len() - 1
            });
        let column = self.arena.add(Kind::Column(space, index as u32), ty);
        if let Some(span) = self.arena.origin(e) {
            self.arena.note_origin(column, span);
        }
        Some(column)
    }

    /// The space that an expression belongs to: the deepest one whose rows determine all its variables.
    fn deepest(&self, e: ExprId) -> Option<VariableId> {
        let free = &self.arena.node(e).free;
        let deepest = free
            .iter()
            .filter_map(|v| self.chains.get(v))
            .max_by_key(|chain| chain.len())?;
        let known = free.iter().all(|v| deepest.contains(v));
        known.then(|| deepest[deepest.len() - 1])
    }

    fn inside(&mut self, e: ExprId) -> ExprId {
        let mut kind = self.arena.kind(e).clone();
        if let Kind::Fold {
            variable,
            range: Range::Set(set),
            ..
        } = kind
            && !self.is_static(e)
            && let Some(space) = self.space(variable, set)
        {
            let chain = space.parent.map_or(Vec::new(), |p| self.chains[&p].clone());
            self.chains
                .insert(variable, chain.into_iter().chain([variable]).collect());
            let parent = space.parent;
            self.plan.spaces.push(space);
            if let Kind::Fold { range, .. } = &mut kind {
                *range = Range::Rows { of: parent };
            }
        }
        let kind = kind.map_operands(|operand| self.expr(operand));
        let ty = self.arena.ty(e).clone();
        let done = self.arena.add(kind, ty);
        if let Some(span) = self.arena.origin(e) {
            self.arena.note_origin(done, span);
        }
        done
    }

    /// The rows of a loop over a static set, if they can be stored.
    fn space(&self, variable: VariableId, set: ExprId) -> Option<Space> {
        if !self.is_static(set) || !self.arena.variable_type(variable).is_element() {
            return None;
        }
        let (parent, rows) = match self.arena.kind(set) {
            Kind::AllElements(element) => (None, Rows::Universe(*element)),
            _ if self.may_fail.expr(self.arena, set) => return None,
            _ if self.arena.node(set).free.is_empty() => (None, Rows::Members(set)),
            _ => (Some(self.deepest(set)?), Rows::Members(set)),
        };
        Some(Space {
            variable,
            parent,
            rows,
            columns: Vec::new(),
        })
    }
}

/// Which expressions may fail when they are evaluated.
#[derive(Clone, Debug)]
pub struct MayFail {
    functions: Vec<bool>,
    globals: Vec<bool>,
}

impl MayFail {
    /// What may fail in a program. A function that recurses may, since nothing says that it ends.
    pub fn of(program: &Program) -> Self {
        let mut all = Self {
            functions: program.functions.iter().map(|f| f.recursive).collect(),
            globals: vec![false; program.globals.len()],
        };
        loop {
            let before = all.clone();
            for (k, function) in program.functions.iter().enumerate() {
                all.functions[k] =
                    before.functions[k] || before.expr(&program.arena, function.body);
            }
            for (k, global) in program.globals.iter().enumerate() {
                all.globals[k] = before.globals[k] || before.expr(&program.arena, global.value);
            }
            if all.functions == before.functions && all.globals == before.globals {
                return all;
            }
        }
    }

    /// Whether a function may fail.
    pub fn function(&self, id: FunctionId) -> bool {
        self.functions[id.0 as usize]
    }

    /// Whether evaluating an expression may fail.
    pub fn expr(&self, arena: &Arena, e: ExprId) -> bool {
        let mut seen = std::collections::BTreeSet::new();
        let mut open = vec![e];
        while let Some(e) = open.pop() {
            if !seen.insert(e) {
                continue;
            }
            if self.own(arena, e) {
                return true;
            }
            arena.kind(e).operands(|operand| open.push(operand));
        }
        false
    }

    /// Whether an expression itself may fail, when its operands do not.
    pub fn own(&self, arena: &Arena, e: ExprId) -> bool {
        if !unproven(arena, e).is_empty() {
            return true;
        }
        match arena.kind(e) {
            Kind::Fail
            | Kind::SetItem(..)
            | Kind::Neighbor(..)
            | Kind::Sized(..)
            | Kind::Agree(..) => true,
            Kind::At(..) => !is_within(arena, e),
            Kind::RowOf(..) | Kind::ColumnOf(..) | Kind::Stored(..) => true,
            Kind::Optimum { .. } | Kind::Integral { .. } => true,
            Kind::Scatter { .. } | Kind::Update(..) => true,
            Kind::Assemble { blocks, .. } => !blocks.is_empty(),
            Kind::Unary(
                Unary::Inverse
                | Unary::Least
                | Unary::Greatest
                | Unary::Rank
                | Unary::NullSpace
                | Unary::OrthogonalBasis,
                _,
            ) => true,
            Kind::Filled(_, sizes) => sizes.iter().any(|n| !is_literal(arena, *n)),
            Kind::Identity(n) => !is_literal(arena, *n),
            Kind::Binary(Binary::Solve | Binary::MatrixPower | Binary::Unstack, ..) => true,
            Kind::Fold { op, .. } => {
                matches!(op, Fold::Min | Fold::Max | Fold::ArgMin | Fold::ArgMax)
                    || matches!(op, Fold::Sum | Fold::Product) && *arena.ty(e) == Type::INTEGER
                    || is_of_unknown_size(arena.ty(e))
            }
            Kind::Binary(Binary::Add | Binary::Subtract | Binary::Multiply, ..)
            | Kind::Unary(Unary::Negate | Unary::Absolute, _) => may_overflow(arena, e),
            Kind::Tabulate {
                layout: Layout::Rows | Layout::Columns,
                body,
                ..
            } => is_of_unknown_size(arena.ty(*body)),
            Kind::Component(vector, index) => {
                !matches!(arena.kind(*index), Kind::Integer(_))
                    || arena.ty(*vector).fixed_vector().is_none()
            }
            // the lengths of inputs that elements index are checked beforehand
            Kind::Item(sequence, index) => {
                !arena.ty(*index).is_element() || !matches!(arena.kind(*sequence), Kind::Input(_))
            }
            Kind::Call(id, _) => self.function(*id),
            // a pass may have added some since
            Kind::Global(id) => self.globals.get(id.0 as usize).copied().unwrap_or(true),
            _ => false,
        }
    }
}

/// Whether an operation on integers may leave the range of `i64`: it cannot with numbers of elements, entries of
/// boundary matrices and small numbers.
pub fn may_overflow(arena: &Arena, e: ExprId) -> bool {
    fn bits(arena: &Arena, e: ExprId) -> u32 {
        match arena.kind(e) {
            Kind::Integer(value) => 65 - value.unsigned_abs().leading_zeros(),
            Kind::Entry(..) => 2,
            Kind::Cardinality(_) | Kind::Extent(..) => 34,
            Kind::Unary(Unary::ToInteger, _) => 34,
            Kind::Unary(Unary::Negate | Unary::Absolute, a) => bits(arena, *a),
            Kind::Binary(Binary::Add | Binary::Subtract, a, b) => {
                bits(arena, *a).max(bits(arena, *b)) + 1
            }
            Kind::Binary(Binary::Multiply, a, b) => bits(arena, *a) + bits(arena, *b),
            _ => 64,
        }
    }
    *arena.ty(e) == Type::INTEGER
        && matches!(
            arena.kind(e),
            Kind::Binary(Binary::Add | Binary::Subtract | Binary::Multiply, ..)
                | Kind::Unary(Unary::Negate | Unary::Absolute, _)
        )
        && bits(arena, e) > 63
}

/// Whether an entry of a matrix is known to exist: its numbers and the sizes are in the text.
pub fn is_within(arena: &Arena, e: ExprId) -> bool {
    let Kind::At(matrix, i, j) = arena.kind(e) else {
        return false;
    };
    let within = |k: ExprId, size: &crate::types::Dimension| match (arena.kind(k), size.value()) {
        (Kind::Integer(k), Some(n)) => (1..=n).contains(k),
        _ => false,
    };
    match arena.ty(*matrix) {
        Type::Matrix {
            rows,
            columns,
            sparse: false,
            ..
        } => within(*i, rows) && within(*j, columns),
        _ => false,
    }
}

fn is_literal(arena: &Arena, e: ExprId) -> bool {
    matches!(arena.kind(e), Kind::Integer(_))
}
