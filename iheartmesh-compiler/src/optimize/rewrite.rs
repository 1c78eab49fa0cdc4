//! Rewriting of expressions from the operands upward.

use std::collections::HashMap;

use crate::ir::{Arena, ExprId, Kind, Program, Range, Unary, VariableId};
use crate::types::{Atom, Dimension, Type};

/// Rewrites every definition and function of a program: `rule` sees each expression after its operands have been
/// rewritten, and gives what takes its place.
pub fn program(program: &mut Program, mut rule: impl FnMut(&mut Arena, ExprId) -> ExprId) {
    let mut memo = HashMap::new();
    for k in 0..program.globals.len() {
        let value = program.globals[k].value;
        program.globals[k].value = upward(&mut program.arena, value, &mut memo, &mut rule);
    }
    for k in 0..program.functions.len() {
        let body = program.functions[k].body;
        program.functions[k].body = upward(&mut program.arena, body, &mut memo, &mut rule);
    }
}

/// Rewrites one expression.
pub fn upward(
    arena: &mut Arena,
    e: ExprId,
    memo: &mut HashMap<ExprId, ExprId>,
    rule: &mut impl FnMut(&mut Arena, ExprId) -> ExprId,
) -> ExprId {
    if let Some(&done) = memo.get(&e) {
        return done;
    }
    let kind = arena.kind(e).clone();
    let mapped = kind.map_operands(|operand| upward(arena, operand, memo, rule));
    let rebuilt = if mapped == kind {
        e
    } else {
        let ty = arena.ty(e).clone();
        let rebuilt = arena.add(mapped, ty);
        if let Some(span) = arena.origin(e) {
            arena.note_origin(rebuilt, span);
        }
        rebuilt
    };
    let done = rule(arena, rebuilt);
    memo.insert(e, done);
    done
}

/// Replaces variables that nothing inside binds, by expressions whose variables nothing inside binds either; binders stay
/// as they are. The memo is that of one map.
pub fn put(
    arena: &mut Arena,
    e: ExprId,
    variables: &HashMap<VariableId, ExprId>,
    memo: &mut HashMap<ExprId, ExprId>,
) -> ExprId {
    let node = arena.node(e);
    if !node.free.iter().any(|v| variables.contains_key(v)) {
        return e;
    }
    if let Kind::Variable(variable) = &node.kind {
        return variables[variable];
    }
    if let Some(&done) = memo.get(&e) {
        return done;
    }
    let (kind, ty) = (node.kind.clone(), node.ty.clone());
    let kind = kind.map_operands(|operand| put(arena, operand, variables, memo));
    let done = arena.add(kind, ty);
    if let Some(span) = arena.origin(e) {
        arena.note_origin(done, span);
    }
    memo.insert(e, done);
    done
}

/// The variable and range of a loop over all numbers of a size, and the place that it is at: over elements where there is one
/// for each number, so that it is one over the rows of a plan.
pub fn each(arena: &mut Arena, dimension: &Dimension, size: ExprId) -> (VariableId, ExprId, Range) {
    let (range, ty) = match dimension.as_atom() {
        Some(Atom::Count(element)) => {
            let ty = Type::Element(*element);
            let all = Kind::AllElements(*element);
            let all = arena.add(all, Type::Set(Box::new(ty.clone())));
            (Range::Set(all), ty)
        }
        _ => (Range::Integers(arena.integer(1), size), Type::INTEGER),
    };
    let variable = arena.new_variable("k", ty);
    (variable, arena.variable(variable), range)
}

/// The element with the number of an element is this element.
pub fn at_elements(arena: &mut Arena, e: ExprId) -> ExprId {
    upward(arena, e, &mut HashMap::new(), &mut |arena, e| {
        let Kind::Unary(Unary::ToElement, number) = *arena.kind(e) else {
            return e;
        };
        match *arena.kind(number) {
            Kind::Unary(Unary::ToInteger, element) if arena.ty(element) == arena.ty(e) => element,
            _ => e,
        }
    })
}

/// Replaces variables by expressions. Binders inside get new variables, so that each variable keeps one binder.
pub fn substitute(arena: &mut Arena, e: ExprId, variables: &HashMap<VariableId, ExprId>) -> ExprId {
    let mut substitution = Substitution {
        variables: variables.clone(),
        memo: HashMap::new(),
    };
    substitution.expr(arena, e)
}

struct Substitution {
    /// What takes the place of each variable in the current scope.
    variables: HashMap<VariableId, ExprId>,
    /// What has been done, by what took the place of the variables in it: a variable may be bound again further in.
    memo: HashMap<(ExprId, Vec<Option<ExprId>>), ExprId>,
}

impl Substitution {
    fn expr(&mut self, arena: &mut Arena, e: ExprId) -> ExprId {
        let free = arena.node(e).free.iter();
        let key = (e, free.map(|v| self.variables.get(v).copied()).collect());
        if let Some(&done) = self.memo.get(&key) {
            return done;
        }
        let mut kind = arena.kind(e).clone();
        let done = if let Kind::Variable(v) = kind {
            self.variables.get(&v).copied().unwrap_or(e)
        } else {
            let outside: Vec<_> = bound_variables(&mut kind)
                .iter_mut()
                .map(|variable| self.bind(arena, variable))
                .collect();
            let kind = kind.map_operands(|operand| self.expr(arena, operand));
            for (variable, value) in outside.into_iter().rev() {
                match value {
                    Some(value) => self.variables.insert(variable, value),
                    None => self.variables.remove(&variable),
                };
            }
            let ty = arena.ty(e).clone();
            let done = arena.add(kind, ty);
            if let Some(span) = arena.origin(e) {
                arena.note_origin(done, span);
            }
            done
        };
        self.memo.insert(key, done);
        done
    }

    /// A new variable in place of a bound one; gives the old one with what took its place outside.
    fn bind(
        &mut self,
        arena: &mut Arena,
        variable: &mut VariableId,
    ) -> (VariableId, Option<ExprId>) {
        let old = *variable;
        let (name, ty) = (
            arena.variable_name(old).to_owned(),
            arena.variable_type(old).clone(),
        );
        *variable = arena.new_variable(&name, ty);
        let value = arena.variable(*variable);
        (old, self.variables.insert(old, value))
    }
}

/// The variables that an expression binds.
pub fn bound_variables(kind: &mut Kind) -> &mut [VariableId] {
    match kind {
        Kind::Fold { variable, .. }
        | Kind::Scatter { variable, .. }
        | Kind::Integral { variable, .. } => std::slice::from_mut(variable),
        Kind::Tabulate { variables, .. } | Kind::Optimum { variables, .. } => variables,
        _ => &mut [],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{Binary, Fold, Range};
    use crate::types::Type;

    /// The variable and the body of a sum.
    fn parts(arena: &Arena, sum: ExprId) -> (VariableId, ExprId) {
        match *arena.kind(sum) {
            Kind::Fold { variable, body, .. } => (variable, body),
            _ => panic!("no sum"),
        }
    }

    #[test]
    fn a_variable_bound_twice_keeps_its_scopes() {
        let mut arena = Arena::default();
        let n = arena.new_variable("n", Type::INTEGER);
        let value = arena.variable(n);
        let sum = |arena: &mut Arena, last, body| {
            let [from, to] = [1, last].map(|k| arena.add(Kind::Integer(k), Type::INTEGER));
            let kind = Kind::Fold {
                op: Fold::Sum,
                variable: n,
                range: Range::Integers(from, to),
                condition: None,
                body,
            };
            arena.add(kind, Type::INTEGER)
        };
        // ∑_(n from 1 to 3) n (∑_(n from 1 to 2) n) n
        let inner = sum(&mut arena, 2, value);
        let product = Kind::Binary(Binary::Multiply, value, inner);
        let product = arena.add(product, Type::INTEGER);
        let product = Kind::Binary(Binary::Multiply, product, value);
        let product = arena.add(product, Type::INTEGER);
        let outer = sum(&mut arena, 3, product);

        let done = substitute(&mut arena, outer, &HashMap::new());
        let (outer, product) = parts(&arena, done);
        let Kind::Binary(_, first, last) = *arena.kind(product) else {
            panic!("no product");
        };
        let Kind::Binary(_, first, sum) = *arena.kind(first) else {
            panic!("no product");
        };
        let (inner, body) = parts(&arena, sum);
        assert_ne!(inner, outer);
        assert_eq!(*arena.kind(body), Kind::Variable(inner));
        assert_eq!(*arena.kind(first), Kind::Variable(outer));
        assert_eq!(*arena.kind(last), Kind::Variable(outer));
    }
}
