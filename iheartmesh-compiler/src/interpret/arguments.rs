//! What the host hands in: parameters of a program, and arguments of its functions.

use std::collections::{BTreeMap, BTreeSet};

use super::{Interpreter, Mesh, Scope, Value};
use crate::ir::{ExprId, FunctionId};
use crate::types::{Atom, Dimension, Element, Number, Type, element_dimension};

/// A function that the host hands in.
pub type HostFunction<'a> = Box<dyn Fn(&[Value]) -> Value + 'a>;

/// A parameter of a program.
pub enum Argument<'a> {
    /// A value.
    Value(Value),
    /// A mesh.
    Mesh(&'a dyn Mesh),
    /// A function.
    Function(HostFunction<'a>),
    /// A sequence of functions.
    Functions(Vec<HostFunction<'a>>),
}

impl<'a> Interpreter<'a> {
    /// Takes the parameters of the program, and checks them.
    pub(super) fn take(
        &mut self,
        mut arguments: BTreeMap<String, Argument<'a>>,
    ) -> Result<(), String> {
        let program = self.program;
        for id in &program.input_order {
            let input = program.input(*id);
            let name = &input.name;
            let given = arguments.remove(name);
            match (&input.ty, given) {
                (Type::Mesh(_, mesh), Some(Argument::Mesh(given))) => {
                    self.meshes.insert(*mesh, given);
                }
                (Type::Function { .. }, Some(Argument::Function(given))) => {
                    self.values
                        .insert(*id, Value::Function(self.functions.len()));
                    self.functions.push(given);
                }
                (Type::Sequence { item, .. }, Some(Argument::Functions(given)))
                    if matches!(**item, Type::Function { .. }) =>
                {
                    let first = self.functions.len();
                    let items = (first..first + given.len()).map(Value::Function);
                    self.values.insert(*id, Value::Sequence(items.collect()));
                    self.functions.extend(given);
                }
                (ty, Some(Argument::Value(value))) => {
                    has_type(&value, ty).map_err(|found| {
                        format!("`{name}` is {found} but should be {}", ty.described())
                    })?;
                    self.values.insert(*id, value);
                }
                (ty, Some(_)) => return Err(format!("`{name}` is not {}", ty.described())),
                (_, None) => return Err(format!("`{name}` is missing")),
            }
        }
        if let Some(name) = arguments.keys().next() {
            return Err(format!("there is no parameter `{name}`"));
        }
        self.find_sizes();
        self.check_inputs()
    }

    /// Gives each symbol of a size its value: an integer parameter of its name, or else the first place where it
    /// stands alone.
    fn find_sizes(&mut self) {
        let program = self.program;
        let mut found = Vec::new();
        for id in &program.input_order {
            if let Some(value) = self.values.get(id) {
                for (dimension, size) in axes(value, &program.input(*id).ty) {
                    if let Some(atom) = dimension.as_atom().filter(|_| !dimension.is_ragged()) {
                        found.push((atom.clone(), size));
                    }
                }
            }
        }
        for (id, value) in &self.values {
            let atom = Atom::Symbol(program.input(*id).name.clone());
            if let Value::Integer(k) = value {
                self.sizes.insert(atom, *k);
            }
        }
        for (atom, size) in found {
            self.sizes.entry(atom).or_insert(size);
        }
    }

    fn check_inputs(&self) -> Result<(), String> {
        for tie in &self.program.ties {
            let scope = Scope::default();
            let [a, b] = tie.sizes.each_ref().map(|size| self.size(&scope, size));
            if a != b {
                let [a, b] = &tie.sizes;
                return Err(format!(
                    "`{a}` and `{b}` differ: `{}` runs to both",
                    tie.index
                ));
            }
        }
        for (id, value) in &self.values {
            let input = self.program.input(*id);
            for (dimension, found) in axes(value, &input.ty) {
                if let Some(expected) = self.size(&Scope::default(), &dimension)
                    && expected != found
                {
                    return Err(format!(
                        "a size of `{}` is {found} but should be {expected}: it is `{dimension}`",
                        input.name
                    ));
                }
            }
            self.check_items(&input.name, value, &input.ty)?;
            let index = match &input.ty {
                Type::Sequence { index, .. } => *index,
                _ => None,
            };
            let indexed: BTreeSet<Element> =
                index.iter().chain(&input.indexed_by).copied().collect();
            for element in &indexed {
                let (n, found) = (self.count(*element), length(value));
                if found < n || indexed.len() == 1 && found != n {
                    return Err(format!("`{}` has {found} items but needs {n}", input.name));
                }
            }
            self.check_elements(&input.name, value, &input.ty, input.within)?;
        }
        Ok(())
    }

    /// Checks the sizes of items that may differ.
    fn check_items(&self, name: &str, value: &Value, ty: &Type) -> Result<(), String> {
        let (Value::Sequence(items), Type::Sequence { item, .. }) = (value, ty) else {
            return Ok(());
        };
        for (k, value) in items.iter().enumerate() {
            let mut scope = Scope::default();
            for (_, (symbol, size)) in self.item_sizes(k) {
                scope.sizes.entry(symbol).or_insert(size);
            }
            for (dimension, found) in axes(value, item) {
                if let Some(expected) = self.size(&scope, &dimension)
                    && dimension.is_ragged()
                    && expected != found
                {
                    return Err(format!(
                        "a size of item {} of `{name}` is {found} but should be {expected}: it is `{dimension}`",
                        k + 1
                    ));
                }
            }
        }
        Ok(())
    }

    /// The sizes that the items number `k` give: sequences of numbers first.
    fn item_sizes(&self, k: usize) -> Vec<(bool, (Atom, i64))> {
        let mut found = Vec::new();
        for id in &self.program.input_order {
            let input = self.program.input(*id);
            let (Some(Value::Sequence(items)), Type::Sequence { item, .. }) =
                (self.values.get(id), &input.ty)
            else {
                continue;
            };
            let Some(value) = items.get(k) else {
                continue;
            };
            if let Value::Integer(size) = value {
                let symbol = Box::new(Atom::Symbol(input.name.clone()));
                found.push((false, (Atom::Item(symbol, None), *size)));
            }
            for (dimension, size) in axes(value, item) {
                if let Some(atom @ Atom::Item(..)) = dimension.as_atom() {
                    found.push((true, (atom.clone(), size)));
                }
            }
        }
        found.sort_by_key(|(derived, _)| *derived);
        found
    }

    /// Checks arguments of a function from the host.
    pub(super) fn check_arguments(
        &self,
        id: FunctionId,
        arguments: &[Value],
    ) -> Result<(), String> {
        let function = self.program.function(id);
        if function.parameters.len() != arguments.len() {
            return Err(format!(
                "`{}` takes {} arguments, not {}",
                function.name,
                function.parameters.len(),
                arguments.len()
            ));
        }
        let mut scope = Scope::default();
        for (parameter, value) in function.parameters.iter().zip(arguments) {
            let (name, ty) = (&parameter.name, &parameter.ty);
            for (dimension, found) in axes(value, ty) {
                // the length of a sequence is its own, whatever its letter
                if matches!(dimension.as_atom(), Some(Atom::Length(_))) || dimension.is_ragged() {
                    continue;
                }
                match (self.size(&scope, &dimension), dimension.as_atom()) {
                    (Some(expected), _) if expected != found => {
                        return Err(format!(
                            "a size of `{name}` is {found} but should be {expected}: it is `{dimension}`"
                        ));
                    }
                    // the first place gives a size of the function its value
                    (None, Some(atom)) => {
                        scope.sizes.insert(atom.clone(), found);
                    }
                    _ => {}
                }
            }
            has_type(value, ty)
                .map_err(|found| format!("`{name}` is {found} but should be {}", ty.described()))?;
            self.check_elements(name, value, ty, parameter.within)?;
        }
        Ok(())
    }

    /// Checks that elements are of their mesh, and of the set that they are declared in.
    fn check_elements(
        &self,
        name: &str,
        value: &Value,
        ty: &Type,
        within: Option<ExprId>,
    ) -> Result<(), String> {
        let members: &[Value] = match (value, ty) {
            (Value::Sequence(items), Type::Sequence { item, .. }) => {
                return items
                    .iter()
                    .try_for_each(|value| self.check_elements(name, value, item, within));
            }
            (Value::Set(members), _) => members,
            _ => std::slice::from_ref(value),
        };
        let element = match ty {
            Type::Element(element) => Some(*element),
            ty => ty.element_of_set(),
        };
        if let Some(element) = element {
            let n = self.count(element);
            let outside =
                |member: &&Value| matches!(member, Value::Element(id) if *id as usize >= n);
            if let Some(member) = members.iter().find(outside) {
                return Err(format!("`{name}` is {member}, which is not in the mesh"));
            }
        }
        let within = within.map(|set| self.eval(&mut Scope::default(), set));
        let set = match within {
            None => return Ok(()),
            Some(Ok(Value::Set(set))) => set,
            Some(Ok(other)) => panic!("bug in iheartmesh: {other} is no set"),
            Some(Err(fault)) => return Err(fault.reason),
        };
        match members.iter().find(|member| !member.is_in(&set)) {
            Some(member) => Err(format!("`{name}` is {member}, which is not in its set")),
            None => Ok(()),
        }
    }

    pub(super) fn count(&self, element: Element) -> usize {
        self.meshes[&element.mesh].count(element_dimension(element.kind))
    }
}

fn length(value: &Value) -> usize {
    match value {
        Value::Sequence(items) => items.len(),
        _ => 1,
    }
}

/// The sizes in the type of a value, with what they are of the value.
pub(super) fn axes(value: &Value, ty: &Type) -> Vec<(Dimension, i64)> {
    let (rows, columns) = super::array::shape(value);
    match (ty, value) {
        (
            Type::Vector {
                length,
                space: None,
                ..
            },
            _,
        ) => vec![(length.clone(), rows as i64)],
        (
            Type::Matrix {
                rows: n,
                columns: m,
                spaces: None,
                ..
            },
            _,
        ) => vec![(n.clone(), rows as i64), (m.clone(), columns as i64)],
        (Type::Sequence { item, length, .. }, Value::Sequence(items)) => {
            let mut all = vec![(length.clone(), items.len() as i64)];
            all.extend(items.iter().flat_map(|value| axes(value, item)));
            all
        }
        _ => Vec::new(),
    }
}

/// Whether a value is of a type, sizes aside; what it is instead.
fn has_type(value: &Value, ty: &Type) -> Result<(), String> {
    let all = |items: &[Value], ty: &Type| items.iter().try_for_each(|item| has_type(item, ty));
    match (value, ty) {
        (Value::Real(_), Type::Scalar(Number::Real))
        | (Value::Integer(_), Type::Scalar(Number::Integer))
        | (Value::Boolean(_), Type::Boolean)
        | (Value::Element(_), Type::Element(_))
        | (Value::Chain(_), Type::Vector { space: Some(_), .. }) => Ok(()),
        (Value::Reals(a), Type::Vector { .. }) if !ty.is_integer() && a.ncols() == 1 => Ok(()),
        (Value::Integers(a), Type::Vector { .. }) if ty.is_integer() && a.ncols() == 1 => Ok(()),
        (Value::Reals(_), Type::Matrix { .. }) if !ty.is_integer() => Ok(()),
        (Value::Integers(_), Type::Matrix { .. }) if ty.is_integer() => Ok(()),
        (Value::Sequence(items), Type::Sequence { item, .. }) => all(items, item),
        (Value::Set(members), Type::Set(item)) => all(members, item),
        (Value::Tuple(items), Type::Tuple(types)) if items.len() == types.len() => items
            .iter()
            .zip(types)
            .try_for_each(|(i, t)| has_type(i, t)),
        (Value::Tuple(sets), Type::CellularSet(_)) if sets.len() == 4 => Ok(()),
        _ => Err(value.to_string()),
    }
}
