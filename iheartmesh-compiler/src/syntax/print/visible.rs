//! Which words need no back-ticks: those that reading the printed text will find declared.

use std::collections::BTreeSet;

use super::super::ast::*;
use super::super::builtin;

type Words = BTreeSet<String>;

/// The words of a module: imports, parameters with the names in their types, definitions, functions.
pub(super) fn module(module: &Module) -> Words {
    let mut words: Words = builtin::ALWAYS
        .iter()
        .map(|word| word.to_string())
        .collect();
    for item in &module.items {
        match &item.kind {
            ItemKind::Import(node) => {
                for import in node.names.iter().flatten() {
                    let name = import.rename.as_ref().unwrap_or(&import.name);
                    words.insert(name.text.clone());
                }
            }
            ItemKind::Parameters(list) => {
                list.iter().for_each(|node| declaration(node, &mut words))
            }
            ItemKind::Function(node) => drop(words.insert(node.name.text.clone())),
            ItemKind::Definition(node) => left_sides(node, &mut words),
            ItemKind::Expression(_) => {}
        }
    }
    words
}

/// The words of an item: parameters, locals, bound variables.
pub(super) fn item(item: &Item) -> Words {
    let mut words = Words::new();
    match &item.kind {
        ItemKind::Function(node) => {
            let parameters = node.parameters.iter().flatten().chain(&node.subscripts);
            words.extend(parameters.map(|name| name.text.clone()));
            node.declarations
                .iter()
                .for_each(|node| declaration(node, &mut words));
            expr(&node.body, &mut words);
            node.locals.iter().for_each(|node| local(node, &mut words));
        }
        ItemKind::Definition(node) => expr(&node.value, &mut words),
        ItemKind::Expression(node) => expr(node, &mut words),
        ItemKind::Import(_) | ItemKind::Parameters(_) => {}
    }
    words
}

fn left_sides(node: &Definition, words: &mut Words) {
    words.extend(node.targets.iter().map(|target| target.name.text.clone()));
}

fn local(node: &Definition, words: &mut Words) {
    left_sides(node, words);
    expr(&node.value, words);
}

fn declaration(node: &Declaration, words: &mut Words) {
    words.extend(node.targets.iter().map(|target| target.name.text.clone()));
    ty(&node.ty, words);
}

fn ty(node: &Type, words: &mut Words) {
    match &node.kind {
        TypeKind::Vector { length, .. } => dimension(length, words),
        TypeKind::Matrix { rows, columns, .. } => {
            dimension(rows, words);
            dimension(columns, words);
        }
        TypeKind::Set(parts) | TypeKind::SetOfAlternatives(parts) | TypeKind::Tuple(parts) => {
            parts.iter().for_each(|part| ty(part, words));
        }
        TypeKind::Function {
            parameters,
            results,
        } => parameters
            .iter()
            .chain(results)
            .for_each(|part| ty(part, words)),
        TypeKind::Mapping { from, to } => {
            words.insert(from.text.clone());
            ty(to, words);
        }
        TypeKind::Named(name) => drop(words.insert(name.text.clone())),
        TypeKind::Members(set) => expr(set, words),
        _ => {}
    }
}

fn dimension(node: &Expr, words: &mut Words) {
    match &node.kind {
        ExprKind::Name(name) => drop(words.insert(name.text.clone())),
        ExprKind::Binary { left, right, .. } => {
            dimension(left, words);
            dimension(right, words);
        }
        ExprKind::Unary { operand, .. } => dimension(operand, words),
        ExprKind::Subscript { base, .. } => dimension(base, words),
        _ => {}
    }
}

/// Collects bound variables in an expression.
fn expr(node: &Expr, words: &mut Words) {
    let add = |names: &[Name], words: &mut Words| {
        words.extend(names.iter().map(|name| name.text.clone()));
    };
    match &node.kind {
        ExprKind::Builder {
            variables,
            condition: test,
            ..
        } => {
            add(variables, words);
            test.iter().for_each(|node| condition(node, words));
        }
        ExprKind::Big { head, locals, .. } => {
            match head {
                Head::Index(name) | Head::Range(name, ..) => drop(words.insert(name.text.clone())),
                Head::Filtered(name, test) => {
                    words.insert(name.text.clone());
                    condition(test, words);
                }
                Head::Members(names, _) => add(names, words),
            }
            locals.iter().for_each(|node| local(node, words));
        }
        ExprKind::Piecewise { branches, .. } => {
            branches.iter().for_each(|(_, test)| condition(test, words));
        }
        ExprKind::Optimise {
            variables,
            constraints,
            initial,
            ..
        } => {
            variables.iter().for_each(|node| declaration(node, words));
            constraints.iter().for_each(|node| condition(node, words));
            initial.iter().for_each(|node| local(node, words));
        }
        ExprKind::Integral { variable, .. } => drop(words.insert(variable.text.clone())),
        _ => {}
    }
    children(node, &mut |child| expr(child, words));
}

fn condition(node: &Condition, words: &mut Words) {
    match &node.kind {
        ConditionKind::And(left, right) | ConditionKind::Or(left, right) => {
            condition(left, words);
            condition(right, words);
        }
        ConditionKind::Compare { left, right, .. } => {
            expr(left, words);
            expr(right, words);
        }
        ConditionKind::Member { item, set, .. } => {
            expr(item, words);
            expr(set, words);
        }
        ConditionKind::Error => {}
    }
}

/// Calls `visit` for each direct operand, but not for conditions and definitions.
fn children(node: &Expr, visit: &mut dyn FnMut(&Expr)) {
    let subscript = |list: &[Subscript], visit: &mut dyn FnMut(&Expr)| {
        for part in list {
            if let Subscript::Expr(node) = part {
                visit(node);
            }
        }
    };
    match &node.kind {
        ExprKind::Subscript { base, subscripts } => {
            visit(base);
            subscript(subscripts, visit);
        }
        ExprKind::Call {
            subscripts,
            arguments,
            ..
        } => subscripts.iter().chain(arguments).for_each(visit),
        ExprKind::Unary { operand, .. }
        | ExprKind::Norm { operand, .. }
        | ExprKind::Gradient { operand, .. }
        | ExprKind::Laplacian(operand)
        | ExprKind::Divergence(operand) => visit(operand),
        ExprKind::Binary { left, right, .. } | ExprKind::Inner { left, right, .. } => {
            visit(left);
            visit(right);
        }
        ExprKind::Vector(parts) | ExprKind::Set(parts) => parts.iter().for_each(visit),
        ExprKind::Matrix(rows) => rows.iter().flatten().for_each(visit),
        ExprKind::Builder { element, range, .. } => {
            visit(element);
            visit(range);
        }
        ExprKind::NumberMatrix { rows, columns, .. } => {
            visit(rows);
            columns.iter().for_each(|node| visit(node));
        }
        ExprKind::Big { head, body, .. } => {
            match head {
                Head::Members(_, range) => visit(range),
                Head::Range(_, from, to) => {
                    visit(from);
                    visit(to);
                }
                Head::Index(_) | Head::Filtered(..) => {}
            }
            visit(body);
        }
        ExprKind::Piecewise {
            branches,
            otherwise,
        } => {
            branches.iter().for_each(|(value, _)| visit(value));
            otherwise.iter().for_each(|node| visit(node));
        }
        ExprKind::Optimise { objective, .. } => visit(objective),
        ExprKind::Integral { from, to, body, .. } => {
            visit(from);
            visit(to);
            visit(body);
        }
        ExprKind::Derivative { numerator, .. } => visit(numerator),
        _ => {}
    }
}
