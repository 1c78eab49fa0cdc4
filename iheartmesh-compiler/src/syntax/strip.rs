//! Trees without spans, to compare what was written and not where.

use super::ast::*;
use crate::span::Span;

/// Sets every span of a module to the same place, so that equality compares the trees only.
pub fn strip_spans(module: &mut Module) {
    for item in &mut module.items {
        item.span = Span::default();
        match &mut item.kind {
            ItemKind::Import(node) => {
                for import in node.names.iter_mut().flatten() {
                    name(&mut import.name);
                    import.rename.iter_mut().for_each(name);
                }
                name(&mut node.module);
                node.arguments.iter_mut().for_each(name);
            }
            ItemKind::Parameters(list) => list.iter_mut().for_each(declaration),
            ItemKind::Function(node) => {
                name(&mut node.name);
                node.subscripts.iter_mut().for_each(name);
                node.parameters.iter_mut().flatten().for_each(name);
                expr(&mut node.body);
                node.declarations.iter_mut().for_each(declaration);
                node.locals.iter_mut().for_each(definition);
            }
            ItemKind::Definition(node) => definition(node),
            ItemKind::Expression(node) => expr(node),
        }
    }
}

fn name(name: &mut Name) {
    name.span = Span::default();
}

fn declaration(node: &mut Declaration) {
    node.span = Span::default();
    for target in &mut node.targets {
        name(&mut target.name);
        target.subscript.iter_mut().for_each(name);
    }
    ty(&mut node.ty);
    if let Some((_, span)) = &mut node.attribute {
        *span = Span::default();
    }
}

fn ty(node: &mut Type) {
    node.span = Span::default();
    match &mut node.kind {
        TypeKind::Vector { length, .. } => expr(length),
        TypeKind::Matrix { rows, columns, .. } => {
            expr(rows);
            expr(columns);
        }
        TypeKind::Set(parts) | TypeKind::SetOfAlternatives(parts) | TypeKind::Tuple(parts) => {
            parts.iter_mut().for_each(ty);
        }
        TypeKind::Function {
            parameters,
            results,
        } => parameters.iter_mut().chain(results).for_each(ty),
        TypeKind::Mapping { from, to } => {
            name(from);
            ty(to);
        }
        TypeKind::Named(set) => name(set),
        TypeKind::Scalar(_)
        | TypeKind::Mesh(_)
        | TypeKind::ElementSet(_)
        | TypeKind::CellularSet => {}
    }
}

fn definition(node: &mut Definition) {
    node.span = Span::default();
    for target in &mut node.targets {
        name(&mut target.name);
        target.subscripts.iter_mut().for_each(subscript);
    }
    expr(&mut node.value);
}

fn subscript(node: &mut Subscript) {
    match node {
        Subscript::Expr(node) => expr(node),
        Subscript::All(span) => *span = Span::default(),
    }
}

fn expr(node: &mut Expr) {
    node.span = Span::default();
    match &mut node.kind {
        ExprKind::Integer(_)
        | ExprKind::Real(_)
        | ExprKind::Pi
        | ExprKind::Infinity
        | ExprKind::Error => {}
        ExprKind::Name(node) => name(node),
        ExprKind::Subscript { base, subscripts } => {
            expr(base);
            subscripts.iter_mut().for_each(subscript);
        }
        ExprKind::Call {
            function,
            subscripts,
            arguments,
        } => {
            name(function);
            subscripts.iter_mut().chain(arguments).for_each(expr);
        }
        ExprKind::Unary { operand, .. }
        | ExprKind::Laplacian(operand)
        | ExprKind::Divergence(operand) => expr(operand),
        ExprKind::Binary {
            left,
            right,
            op_span,
            ..
        } => {
            expr(left);
            expr(right);
            *op_span = Span::default();
        }
        ExprKind::Norm {
            operand, subscript, ..
        } => {
            expr(operand);
            if let Some(NormSubscript::Expr(node)) = subscript {
                expr(node);
            }
        }
        ExprKind::Inner {
            left,
            right,
            weight,
        } => {
            expr(left);
            expr(right);
            weight.iter_mut().for_each(|node| expr(node));
        }
        ExprKind::Vector(parts) | ExprKind::Set(parts) => parts.iter_mut().for_each(expr),
        ExprKind::Matrix(rows) => rows.iter_mut().flatten().for_each(expr),
        ExprKind::NumberMatrix { rows, columns, .. } => {
            expr(rows);
            columns.iter_mut().for_each(|node| expr(node));
        }
        ExprKind::Derivative {
            numerator,
            denominators,
            ..
        } => {
            expr(numerator);
            denominators.iter_mut().for_each(|(node, _)| expr(node));
        }
        ExprKind::Gradient { variable, operand } => {
            variable.iter_mut().for_each(|node| expr(node));
            expr(operand);
        }
        ExprKind::Builder { .. }
        | ExprKind::Big { .. }
        | ExprKind::Piecewise { .. }
        | ExprKind::Optimise { .. }
        | ExprKind::Integral { .. } => binder(node),
    }
}

/// The expressions that bind names or hold conditions.
fn binder(node: &mut Expr) {
    match &mut node.kind {
        ExprKind::Builder {
            element,
            variables,
            range,
            condition: test,
        } => {
            expr(element);
            variables.iter_mut().for_each(name);
            expr(range);
            test.iter_mut().for_each(|node| condition(node));
        }
        ExprKind::Big {
            head, body, locals, ..
        } => {
            match head {
                Head::Index(index) => name(index),
                Head::Filtered(index, test) => {
                    name(index);
                    condition(test);
                }
                Head::Members(indices, range) => {
                    indices.iter_mut().for_each(name);
                    expr(range);
                }
                Head::Range(index, from, to) => {
                    name(index);
                    expr(from);
                    expr(to);
                }
            }
            expr(body);
            locals.iter_mut().for_each(definition);
        }
        ExprKind::Piecewise {
            branches,
            otherwise,
        } => {
            for (value, test) in branches {
                expr(value);
                condition(test);
            }
            otherwise.iter_mut().for_each(|node| expr(node));
        }
        ExprKind::Optimise {
            variables,
            objective,
            constraints,
            initial,
            ..
        } => {
            variables.iter_mut().for_each(declaration);
            expr(objective);
            constraints.iter_mut().for_each(condition);
            initial.iter_mut().for_each(definition);
        }
        ExprKind::Integral {
            variable,
            from,
            to,
            body,
        } => {
            name(variable);
            expr(from);
            expr(to);
            expr(body);
        }
        _ => {}
    }
}

fn condition(node: &mut Condition) {
    node.span = Span::default();
    match &mut node.kind {
        ConditionKind::And(left, right) | ConditionKind::Or(left, right) => {
            condition(left);
            condition(right);
        }
        ConditionKind::Compare { left, right, .. } => {
            expr(left);
            expr(right);
        }
        ConditionKind::Member { item, set, .. } => {
            expr(item);
            expr(set);
        }
        ConditionKind::Error => {}
    }
}
