//! Binding times: what depends only on the mesh is *static*, the rest is *dynamic*.
//!
//! Elements that are parameters of a function count as static, since a plan can be keyed by them; so do variables
//! that run over static sets.

use std::collections::HashMap;

use crate::ir::{ExprId, Kind, Program, Range, Unary, VariableId};
use crate::types::Type;

/// Which functions and definitions are static.
#[derive(Clone, Debug)]
pub struct Binding {
    /// By function: its value depends only on the mesh and its parameters.
    pub functions: Vec<bool>,
    /// By definition: its value depends only on the mesh.
    pub globals: Vec<bool>,
}

impl Binding {
    /// The binding times of a program. A function is static until something dynamic is found in it.
    pub fn of(program: &Program) -> Self {
        let mut binding = Self {
            functions: vec![true; program.functions.len()],
            globals: vec![true; program.globals.len()],
        };
        loop {
            let mut changed = false;
            for (k, global) in program.globals.iter().enumerate() {
                if binding.globals[k]
                    && !binding
                        .expression(program, Vec::new())
                        .is_static(global.value)
                {
                    binding.globals[k] = false;
                    changed = true;
                }
            }
            for (k, function) in program.functions.iter().enumerate() {
                if !binding.functions[k] {
                    continue;
                }
                let parameters = function.parameters.iter().map(|p| p.variable).collect();
                if !binding
                    .expression(program, parameters)
                    .is_static(function.body)
                {
                    binding.functions[k] = false;
                    changed = true;
                }
            }
            if !changed {
                return binding;
            }
        }
    }

    /// The binding times of expressions under static variables.
    pub fn expression<'a>(
        &'a self,
        program: &'a Program,
        variables: Vec<VariableId>,
    ) -> Expressions<'a> {
        Expressions {
            binding: self,
            program,
            variables,
            memo: HashMap::new(),
        }
    }
}

/// Binding times of the expressions of one body.
pub struct Expressions<'a> {
    binding: &'a Binding,
    program: &'a Program,
    variables: Vec<VariableId>,
    memo: HashMap<ExprId, bool>,
}

impl Expressions<'_> {
    /// Whether an expression depends only on the mesh and on static variables.
    pub fn is_static(&mut self, e: ExprId) -> bool {
        if let Some(&known) = self.memo.get(&e) {
            return known;
        }
        let program = self.program;
        let kind = program.arena.kind(e);
        let own = match kind {
            Kind::Variable(v) => self.variables.contains(v),
            Kind::Input(id) => matches!(program.input(*id).ty, Type::Mesh(..)),
            Kind::Global(id) => self.binding.globals[id.0 as usize],
            Kind::Call(id, _) => self.binding.functions[id.0 as usize],
            // a vector or matrix of numbers is no table of the plan
            Kind::Unary(Unary::ToReal, a) if !program.arena.ty(*a).is_scalar() => false,
            Kind::Field(..) | Kind::Column(..) | Kind::HostCall(..) => false,
            Kind::Size(size) => size.is_of_meshes(),
            Kind::Tabulate { variables, .. } => {
                self.variables.extend(variables);
                true
            }
            Kind::Scatter { variable, set, .. } => {
                let is_static = self.is_static(*set);
                if is_static {
                    self.variables.push(*variable);
                }
                is_static
            }
            Kind::Fold {
                variable, range, ..
            } => {
                let range_is_static = match range {
                    Range::Set(set) => self.is_static(*set),
                    Range::Integers(from, to) => self.is_static(*from) && self.is_static(*to),
                    Range::Rows { .. } => false,
                };
                if range_is_static {
                    self.variables.push(*variable);
                }
                range_is_static
            }
            _ => true,
        };
        let mut all = own;
        kind.operands(|operand| all = self.is_static(operand) && all);
        self.memo.insert(e, all);
        all
    }
}
