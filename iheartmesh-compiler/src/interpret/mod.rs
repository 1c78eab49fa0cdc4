//! The meaning of the typed program, written down directly: a walk over each expression that computes its value.
//!
//! It is the reference that generated code is compared with, and what a tool can use to evaluate a program without
//! compiling Rust. It does nothing cleverly: what an expression needs is evaluated where it stands, sparse matrices
//! are stored with their zeros, and a boundary matrix is a list of entries. Only the value of a definition is kept,
//! since it is one value. It interprets a program as `check` gives it, one that passes have rewritten, and staged
//! bodies over their plans ([`Interpreter::staged`]): a row of a plan is a member of the set it was made from, a column the
//! expression that it stores, a field the function that it holds.
//!
//! What generated code reports as a failure is a [`Fault`] here. Reals follow IEEE 754 in both, though an optimised
//! program may differ in the last bits.
//!
//! **Stack.** A call of a function is a call here: 500 of them inside of each other, which is as deep as a program may
//! recurse, need about 32 MiB.

mod arguments;
mod array;
mod assemble;
mod entries;
mod eval;
mod factor;
mod loops;
mod mesh;
mod operation;
mod value;

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, HashMap};

pub use arguments::{Argument, HostFunction};
pub use mesh::Mesh;
pub use value::Value;

use crate::ir::{ExprId, FunctionId, GlobalId, InputId, Program, VariableId, failure};
use crate::optimize::{Plan, StagedProgram};
use crate::types::{Atom, Dimension, MeshId, Type};

/// Why an expression has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The expression, where it is one that failed.
    pub expression: Option<ExprId>,
    /// What is missing, as generated code says it, without the place.
    pub reason: String,
}

/// The most calls of recursive functions inside of each other.
const DEEPEST_RECURSION: u32 = 500;

/// A program with all that the host hands in.
pub struct Interpreter<'a> {
    program: &'a Program,
    staged: Option<&'a StagedProgram>,
    meshes: BTreeMap<MeshId, &'a dyn Mesh>,
    values: BTreeMap<InputId, Value>,
    functions: Vec<HostFunction<'a>>,
    sizes: BTreeMap<Atom, i64>,
    globals: RefCell<BTreeMap<GlobalId, Result<Value, Fault>>>,
    depth: Cell<u32>,
}

/// What the names in an expression stand for.
#[derive(Default)]
struct Scope<'a> {
    variables: BTreeMap<VariableId, Value>,
    /// For each variable how often a name was bound before it was.
    bound: BTreeMap<VariableId, u64>,
    /// The last value of each expression, with `bound` of its variables: formulas share what they are made of, and
    /// without it derivatives would take as long as formulas that do not.
    known: HashMap<ExprId, (Vec<u64>, Value)>,
    binds: u64,
    /// Sizes that the arguments of a function give.
    sizes: BTreeMap<Atom, i64>,
    plan: Option<&'a Plan>,
}

impl Scope<'_> {
    fn bind(&mut self, variable: VariableId, value: Value) {
        self.variables.insert(variable, value);
        self.bound.insert(variable, self.binds);
        self.binds += 1;
    }
}

impl<'a> Interpreter<'a> {
    /// A program with its parameters, by their names.
    ///
    /// # Errors
    /// A parameter is missing, is not of its type, or does not fit to the others or to the mesh.
    pub fn new(
        program: &'a Program,
        arguments: impl IntoIterator<Item = (String, Argument<'a>)>,
    ) -> Result<Self, String> {
        let mut interpreter = Self {
            program,
            staged: None,
            meshes: BTreeMap::new(),
            values: BTreeMap::new(),
            functions: Vec::new(),
            sizes: BTreeMap::new(),
            globals: RefCell::default(),
            depth: Cell::new(0),
        };
        interpreter.take(arguments.into_iter().collect())?;
        Ok(interpreter)
    }

    /// An optimised program: functions and definitions are evaluated by their staged bodies.
    ///
    /// # Errors
    /// As of [`Interpreter::new`].
    pub fn staged(
        staged: &'a StagedProgram,
        arguments: impl IntoIterator<Item = (String, Argument<'a>)>,
    ) -> Result<Self, String> {
        let mut interpreter = Self::new(&staged.program, arguments)?;
        // what the checks of the arguments found, found the bodies that are not staged
        interpreter.globals = RefCell::default();
        interpreter.staged = Some(staged);
        Ok(interpreter)
    }

    /// The value of a definition.
    ///
    /// # Errors
    /// The definition has no value.
    pub fn global(&self, id: GlobalId) -> Result<Value, Fault> {
        if let Some(known) = self.globals.borrow().get(&id) {
            return known.clone();
        }
        let staged = self.staged.and_then(|staged| staged.globals.get(&id));
        let body = staged.map_or(self.program.global(id).value, |staged| staged.body);
        let mut scope = Scope {
            plan: staged.map(|staged| &staged.plan),
            ..Scope::default()
        };
        let found = self.eval(&mut scope, body);
        self.globals.borrow_mut().insert(id, found.clone());
        found
    }

    /// The value of a function for arguments from the host.
    ///
    /// # Errors
    /// An argument is not of its type or not of the set that it is declared in, or the function has no value.
    pub fn call(&self, id: FunctionId, arguments: &[Value]) -> Result<Value, Fault> {
        self.check_arguments(id, arguments)
            .map_err(|reason| Fault {
                expression: None,
                reason,
            })?;
        self.apply(id, arguments.to_vec())
    }

    /// The value of a function.
    fn apply(&self, id: FunctionId, arguments: Vec<Value>) -> Result<Value, Fault> {
        let staged = self.staged.and_then(|staged| staged.functions.get(&id));
        let plan = staged.map(|staged| &staged.plan);
        let function = self.program.function(id);
        self.apply_body(
            id,
            arguments,
            plan,
            staged.map_or(function.body, |s| s.body),
        )
    }

    /// The value of a function by the body that evaluates it for all elements at once, for the one at hand; `None` where
    /// there is no such body.
    pub fn whole(&self, id: FunctionId, element: u32) -> Option<Result<Value, Fault>> {
        let staged = self.staged?.functions.get(&id)?;
        let body = staged.whole.as_ref()?.body;
        let arguments = vec![Value::Element(element)];
        Some(self.apply_body(id, arguments, Some(&staged.plan), body))
    }

    fn apply_body(
        &self,
        id: FunctionId,
        arguments: Vec<Value>,
        plan: Option<&'a Plan>,
        body: ExprId,
    ) -> Result<Value, Fault> {
        let function = self.program.function(id);
        let mut scope = Scope {
            plan,
            ..Scope::default()
        };
        for (parameter, argument) in function.parameters.iter().zip(arguments) {
            for (dimension, size) in arguments::axes(&argument, &parameter.ty) {
                if let Some(atom) = dimension.as_atom() {
                    scope.sizes.entry(atom.clone()).or_insert(size);
                }
            }
            scope.bind(parameter.variable, argument);
        }
        if !function.recursive {
            return self.eval(&mut scope, body);
        }
        if self.depth.get() >= DEEPEST_RECURSION {
            return Err(Fault {
                expression: None,
                reason: format!("`{}` calls itself more than 500 times", function.name),
            });
        }
        self.depth.set(self.depth.get() + 1);
        let value = self.eval(&mut scope, body);
        self.depth.set(self.depth.get() - 1);
        value
    }

    /// The value of a size: symbols of the function at hand, of the parameters, numbers of elements.
    fn size(&self, scope: &Scope<'a>, dimension: &Dimension) -> Option<i64> {
        let value = |atom: &Atom| {
            let known = scope.sizes.get(atom).or_else(|| self.sizes.get(atom));
            match (known, atom) {
                (Some(known), _) => Some(*known),
                (None, Atom::Count(element)) => {
                    let mesh = self.meshes.get(&element.mesh)?;
                    Some(mesh.count(crate::types::element_dimension(element.kind)) as i64)
                }
                _ => None,
            }
        };
        let sum = dimension.terms().try_fold(0i64, |sum, (k, atoms)| {
            let product = atoms
                .iter()
                .try_fold(k, |product, atom| product.checked_mul(value(atom)?))?;
            sum.checked_add(product)
        })?;
        Some(sum / dimension.denominator())
    }

    fn ty(&self, e: ExprId) -> &'a Type {
        self.program.arena.ty(e)
    }

    fn fault(&self, e: ExprId) -> Fault {
        Fault {
            expression: Some(e),
            reason: failure(self.program, e),
        }
    }
}
