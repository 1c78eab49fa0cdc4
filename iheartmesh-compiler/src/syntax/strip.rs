//! Trees without spans, to compare what was written and not where.

use super::ast::*;
use crate::span::Span;

/// Sets every span of a module to the same place, so that equality compares the trees only.
pub fn strip_spans(module: &mut Module) {
    each_expression(module, &mut |_| {});
}

/// Calls `visit` for each expression of a module, those inside of others after them; strips the spans on its way.
pub(super) fn each_expression(module: &mut Module, visit: &mut dyn FnMut(&Expr)) {
    Walk { visit }.module(module);
}

struct Walk<'a> {
    visit: &'a mut dyn FnMut(&Expr),
}

impl Walk<'_> {
    fn module(&mut self, module: &mut Module) {
        for item in &mut module.items {
            item.span = Span::default();
            match &mut item.kind {
                ItemKind::Import(node) => {
                    for import in node.names.iter_mut().flatten() {
                        self.name(&mut import.name);
                        import.rename.iter_mut().for_each(|node| self.name(node));
                    }
                    self.name(&mut node.module);
                    node.arguments.iter_mut().for_each(|node| self.name(node));
                }
                ItemKind::Parameters(list) => {
                    list.iter_mut().for_each(|node| self.declaration(node))
                }
                ItemKind::Function(node) => {
                    self.name(&mut node.name);
                    node.subscripts.iter_mut().for_each(|node| self.name(node));
                    node.parameters
                        .iter_mut()
                        .flatten()
                        .for_each(|node| self.name(node));
                    self.expr(&mut node.body);
                    node.declarations
                        .iter_mut()
                        .for_each(|node| self.declaration(node));
                    node.locals
                        .iter_mut()
                        .for_each(|node| self.definition(node));
                }
                ItemKind::Definition(node) => self.definition(node),
                ItemKind::Expression(node) => self.expr(node),
            }
        }
    }

    fn name(&mut self, name: &mut Name) {
        name.span = Span::default();
    }

    fn declaration(&mut self, node: &mut Declaration) {
        node.span = Span::default();
        for target in &mut node.targets {
            self.name(&mut target.name);
            target.subscript.iter_mut().for_each(|node| self.name(node));
        }
        self.ty(&mut node.ty);
        if let Some((_, span)) = &mut node.attribute {
            *span = Span::default();
        }
    }

    fn ty(&mut self, node: &mut Type) {
        node.span = Span::default();
        match &mut node.kind {
            TypeKind::Vector { length, .. } => self.expr(length),
            TypeKind::Matrix { rows, columns, .. } => {
                self.expr(rows);
                self.expr(columns);
            }
            TypeKind::Set(parts) | TypeKind::SetOfAlternatives(parts) | TypeKind::Tuple(parts) => {
                parts.iter_mut().for_each(|node| self.ty(node));
            }
            TypeKind::Function {
                parameters,
                results,
            } => parameters
                .iter_mut()
                .chain(results)
                .for_each(|node| self.ty(node)),
            TypeKind::Mapping { from, to } => {
                self.name(from);
                self.ty(to);
            }
            TypeKind::Named(set) => self.name(set),
            TypeKind::Members(set) => self.expr(set),
            TypeKind::Scalar(_)
            | TypeKind::Mesh(_)
            | TypeKind::ElementSet(_)
            | TypeKind::CellularSet => {}
        }
    }

    fn definition(&mut self, node: &mut Definition) {
        node.span = Span::default();
        for target in &mut node.targets {
            self.name(&mut target.name);
            target
                .subscripts
                .iter_mut()
                .for_each(|node| self.subscript(node));
        }
        self.expr(&mut node.value);
    }

    fn subscript(&mut self, node: &mut Subscript) {
        match node {
            Subscript::Expr(node) => self.expr(node),
            Subscript::All(span) => *span = Span::default(),
        }
    }

    fn expr(&mut self, node: &mut Expr) {
        (self.visit)(node);
        node.span = Span::default();
        match &mut node.kind {
            ExprKind::Integer(_)
            | ExprKind::Real(_)
            | ExprKind::Pi
            | ExprKind::Infinity
            | ExprKind::Error => {}
            ExprKind::Name(node) => self.name(node),
            ExprKind::Subscript { base, subscripts } => {
                self.expr(base);
                subscripts.iter_mut().for_each(|node| self.subscript(node));
            }
            ExprKind::Call {
                function,
                subscripts,
                arguments,
            } => {
                self.name(function);
                subscripts
                    .iter_mut()
                    .chain(arguments)
                    .for_each(|node| self.expr(node));
            }
            ExprKind::Unary { operand, .. }
            | ExprKind::Laplacian(operand)
            | ExprKind::Divergence(operand) => self.expr(operand),
            ExprKind::Binary {
                left,
                right,
                op_span,
                ..
            } => {
                self.expr(left);
                self.expr(right);
                *op_span = Span::default();
            }
            ExprKind::Norm {
                operand, subscript, ..
            } => {
                self.expr(operand);
                if let Some(NormSubscript::Expr(node)) = subscript {
                    self.expr(node);
                }
            }
            ExprKind::Inner {
                left,
                right,
                weight,
            } => {
                self.expr(left);
                self.expr(right);
                weight.iter_mut().for_each(|node| self.expr(node));
            }
            ExprKind::Vector(parts) | ExprKind::Set(parts) => {
                parts.iter_mut().for_each(|node| self.expr(node))
            }
            ExprKind::Matrix(rows) => rows.iter_mut().flatten().for_each(|node| self.expr(node)),
            ExprKind::NumberMatrix { rows, columns, .. } => {
                self.expr(rows);
                columns.iter_mut().for_each(|node| self.expr(node));
            }
            ExprKind::Derivative {
                numerator,
                denominators,
                ..
            } => {
                self.expr(numerator);
                denominators
                    .iter_mut()
                    .for_each(|(node, _)| self.expr(node));
            }
            ExprKind::Gradient { variable, operand } => {
                variable.iter_mut().for_each(|node| self.expr(node));
                self.expr(operand);
            }
            ExprKind::Builder { .. }
            | ExprKind::Big { .. }
            | ExprKind::Piecewise { .. }
            | ExprKind::Optimise { .. }
            | ExprKind::Integral { .. } => self.binder(node),
        }
    }

    /// The expressions that bind names or hold conditions.
    fn binder(&mut self, node: &mut Expr) {
        match &mut node.kind {
            ExprKind::Builder {
                element,
                variables,
                range,
                condition: test,
            } => {
                self.expr(element);
                variables.iter_mut().for_each(|node| self.name(node));
                self.expr(range);
                test.iter_mut().for_each(|node| self.condition(node));
            }
            ExprKind::Big {
                head, body, locals, ..
            } => {
                match head {
                    Head::Index(index) => self.name(index),
                    Head::Filtered(index, test) => {
                        self.name(index);
                        self.condition(test);
                    }
                    Head::Members(indices, range) => {
                        indices.iter_mut().for_each(|node| self.name(node));
                        self.expr(range);
                    }
                    Head::Range(index, from, to) => {
                        self.name(index);
                        self.expr(from);
                        self.expr(to);
                    }
                }
                self.expr(body);
                locals.iter_mut().for_each(|node| self.definition(node));
            }
            ExprKind::Piecewise {
                branches,
                otherwise,
            } => {
                for (value, test) in branches {
                    self.expr(value);
                    self.condition(test);
                }
                otherwise.iter_mut().for_each(|node| self.expr(node));
            }
            ExprKind::Optimise {
                variables,
                objective,
                constraints,
                initial,
                ..
            } => {
                variables.iter_mut().for_each(|node| self.declaration(node));
                self.expr(objective);
                constraints.iter_mut().for_each(|node| self.condition(node));
                initial.iter_mut().for_each(|node| self.definition(node));
            }
            ExprKind::Integral {
                variable,
                from,
                to,
                body,
            } => {
                self.name(variable);
                self.expr(from);
                self.expr(to);
                self.expr(body);
            }
            _ => {}
        }
    }

    fn condition(&mut self, node: &mut Condition) {
        node.span = Span::default();
        match &mut node.kind {
            ConditionKind::And(left, right) | ConditionKind::Or(left, right) => {
                self.condition(left);
                self.condition(right);
            }
            ConditionKind::Compare { left, right, .. } => {
                self.expr(left);
                self.expr(right);
            }
            ConditionKind::Member { item, set, .. } => {
                self.expr(item);
                self.expr(set);
            }
            ConditionKind::Error => {}
        }
    }
}
