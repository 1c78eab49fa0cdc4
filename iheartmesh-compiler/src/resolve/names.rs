//! Which names an expression uses that it does not bind itself.

use crate::syntax::ast::{
    Condition, ConditionKind, Declaration, Definition, Expr, ExprKind, Head, Name, NormSubscript,
    Subscript, Type, TypeKind,
};

/// Walks expressions and calls back with every name that is not bound on the way.
pub struct FreeNames<'a> {
    bound: Vec<String>,
    found: &'a mut dyn FnMut(&Name),
    /// All names that were bound on the way.
    pub binders: Vec<Name>,
    /// The names that stand alone as subscripts and are not bound there.
    pub indices: Vec<Name>,
}

impl<'a> FreeNames<'a> {
    /// A walk under binders of these names.
    pub fn new(bound: Vec<String>, found: &'a mut dyn FnMut(&Name)) -> Self {
        Self {
            bound,
            found,
            binders: Vec::new(),
            indices: Vec::new(),
        }
    }

    fn name(&mut self, name: &Name) {
        if !self.bound.contains(&name.text) {
            (self.found)(name);
        }
    }

    fn under(&mut self, names: &[&Name], walk: impl FnOnce(&mut Self)) {
        let depth = self.bound.len();
        self.bound.extend(names.iter().map(|n| n.text.clone()));
        self.binders.extend(names.iter().copied().cloned());
        walk(self);
        self.bound.truncate(depth);
    }

    fn subscripts(&mut self, subscripts: &[Subscript]) {
        for subscript in subscripts {
            if let Subscript::Expr(e) = subscript {
                if let ExprKind::Name(name) = &e.kind
                    && !self.bound.contains(&name.text)
                {
                    self.indices.push(name.clone());
                }
                self.expr(e);
            }
        }
    }

    /// The names of an expression.
    pub fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Integer(_)
            | ExprKind::Real(_)
            | ExprKind::Pi
            | ExprKind::Infinity
            | ExprKind::Error => {}
            ExprKind::Name(name) => self.name(name),
            ExprKind::Subscript { base, subscripts } => {
                self.expr(base);
                self.subscripts(subscripts);
            }
            ExprKind::Call {
                function,
                subscripts,
                arguments,
            } => {
                self.name(function);
                subscripts
                    .iter()
                    .chain(arguments)
                    .for_each(|e| self.expr(e));
            }
            ExprKind::Unary { operand, .. } => self.expr(operand),
            ExprKind::Binary { left, right, .. } => {
                self.expr(left);
                self.expr(right);
            }
            ExprKind::Norm {
                operand, subscript, ..
            } => {
                self.expr(operand);
                if let Some(NormSubscript::Expr(e)) = subscript
                    && !matches!(&e.kind, ExprKind::Name(n) if n.text == "F")
                {
                    self.expr(e);
                }
            }
            ExprKind::Inner {
                left,
                right,
                weight,
            } => {
                self.expr(left);
                self.expr(right);
                weight.iter().for_each(|e| self.expr(e));
            }
            ExprKind::Vector(items) | ExprKind::Set(items) => {
                items.iter().for_each(|e| self.expr(e))
            }
            ExprKind::Matrix(rows) => rows.iter().flatten().for_each(|e| self.expr(e)),
            ExprKind::Builder {
                element,
                variables,
                range,
                condition,
            } => {
                self.expr(range);
                let names: Vec<_> = variables.iter().collect();
                self.under(&names, |walk| {
                    walk.expr(element);
                    condition.iter().for_each(|c| walk.condition(c));
                });
            }
            ExprKind::NumberMatrix { rows, columns, .. } => {
                self.expr(rows);
                columns.iter().for_each(|e| self.expr(e));
            }
            ExprKind::Big {
                head, body, locals, ..
            } => {
                let (names, condition): (Vec<&Name>, Option<&Condition>) = match head {
                    Head::Index(name) => (vec![name], None),
                    Head::Filtered(name, condition) => (vec![name], Some(condition)),
                    Head::Members(names, range) => {
                        self.expr(range);
                        (names.iter().collect(), None)
                    }
                    Head::Range(name, from, to) => {
                        self.expr(from);
                        self.expr(to);
                        (vec![name], None)
                    }
                };
                self.under(&names, |walk| {
                    walk.locals(locals, |walk| {
                        condition.iter().for_each(|c| walk.condition(c));
                        walk.expr(body);
                    });
                });
            }
            ExprKind::Piecewise {
                branches,
                otherwise,
            } => {
                for (value, condition) in branches {
                    self.condition(condition);
                    self.expr(value);
                }
                otherwise.iter().for_each(|e| self.expr(e));
            }
            ExprKind::Optimise {
                variables,
                objective,
                constraints,
                initial,
                ..
            } => {
                initial.iter().for_each(|d| self.definition(d));
                // a set may depend on the variables before
                let depth = self.bound.len();
                for declaration in variables {
                    self.declaration(declaration);
                    let names = declaration.targets.iter().map(|t| &t.name);
                    self.bound.extend(names.clone().map(|n| n.text.clone()));
                    self.binders.extend(names.cloned());
                }
                self.expr(objective);
                for condition in constraints {
                    self.under(&subscript_letters(condition), |walk| {
                        walk.condition(condition)
                    });
                }
                self.bound.truncate(depth);
            }
            ExprKind::Integral {
                variable,
                from,
                to,
                body,
            } => {
                self.expr(from);
                self.expr(to);
                self.under(&[variable], |walk| walk.expr(body));
            }
            ExprKind::Derivative {
                numerator,
                denominators,
                ..
            } => {
                self.expr(numerator);
                denominators.iter().for_each(|(e, _)| self.expr(e));
            }
            ExprKind::Gradient { variable, operand } => {
                variable.iter().for_each(|e| self.expr(e));
                self.expr(operand);
            }
            ExprKind::Laplacian(operand) | ExprKind::Divergence(operand) => self.expr(operand),
        }
    }

    /// The names of a condition.
    pub fn condition(&mut self, condition: &Condition) {
        match &condition.kind {
            ConditionKind::And(a, b) | ConditionKind::Or(a, b) => {
                self.condition(a);
                self.condition(b);
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

    /// The names of the values of local definitions and of what stands in their scope.
    pub fn locals(&mut self, locals: &[Definition], scope: impl FnOnce(&mut Self)) {
        let names: Vec<&Name> = locals
            .iter()
            .flat_map(|d| &d.targets)
            .map(|t| &t.name)
            .collect();
        self.under(&names, |walk| {
            locals.iter().for_each(|d| walk.definition(d));
            scope(walk);
        });
    }

    /// The names of a definition's value and subscripts. Subscripts on the left bind, where they are names.
    pub fn definition(&mut self, definition: &Definition) {
        let names: Vec<&Name> = left_indices(definition);
        self.under(&names, |walk| {
            walk.left_entries(definition);
            walk.expr(&definition.value);
        });
    }

    /// The names in subscripts on the left side of a definition that are no indices.
    pub fn left_entries(&mut self, definition: &Definition) {
        for subscript in definition.targets.iter().flat_map(|t| &t.subscripts) {
            if let Subscript::Expr(e) = subscript
                && !matches!(e.kind, ExprKind::Name(_))
            {
                self.expr(e);
            }
        }
    }

    /// The names that a declaration's type uses, except those that may declare a size.
    pub fn declaration(&mut self, declaration: &Declaration) {
        self.ty(&declaration.ty);
    }

    fn ty(&mut self, ty: &Type) {
        match &ty.kind {
            TypeKind::Set(items) | TypeKind::SetOfAlternatives(items) | TypeKind::Tuple(items) => {
                items.iter().for_each(|t| self.ty(t))
            }
            TypeKind::Function {
                parameters,
                results,
            } => parameters.iter().chain(results).for_each(|t| self.ty(t)),
            TypeKind::Mapping { from, to } => {
                self.name(from);
                self.ty(to);
            }
            TypeKind::Named(name) => self.name(name),
            TypeKind::Members(set) => self.expr(set),
            TypeKind::Scalar(_)
            | TypeKind::Vector { .. }
            | TypeKind::Matrix { .. }
            | TypeKind::Mesh(_)
            | TypeKind::ElementSet(_)
            | TypeKind::CellularSet => {}
        }
    }
}

/// The names that stand alone as subscripts in a restriction: where they mean nothing else, it holds for all of them.
pub fn subscript_letters(condition: &Condition) -> Vec<&Name> {
    fn expr<'e>(e: &'e Expr, found: &mut Vec<&'e Name>) {
        match &e.kind {
            ExprKind::Subscript { base, subscripts } => {
                expr(base, found);
                for subscript in subscripts {
                    match subscript {
                        Subscript::Expr(Expr {
                            kind: ExprKind::Name(name),
                            ..
                        }) if found.iter().all(|n| n.text != name.text) => found.push(name),
                        _ => {}
                    }
                }
            }
            ExprKind::Unary { operand, .. } | ExprKind::Norm { operand, .. } => {
                expr(operand, found)
            }
            ExprKind::Binary { left, right, .. } | ExprKind::Inner { left, right, .. } => {
                expr(left, found);
                expr(right, found);
            }
            ExprKind::Call { arguments, .. } => arguments.iter().for_each(|a| expr(a, found)),
            ExprKind::Matrix(rows) => rows.iter().flatten().for_each(|a| expr(a, found)),
            _ => {}
        }
    }
    let mut found = Vec::new();
    match &condition.kind {
        ConditionKind::Compare { left, right, .. } => {
            expr(left, &mut found);
            expr(right, &mut found);
        }
        ConditionKind::Member { item, set, .. } => {
            expr(item, &mut found);
            expr(set, &mut found);
        }
        ConditionKind::And(a, b) | ConditionKind::Or(a, b) => {
            for name in subscript_letters(a).into_iter().chain(subscript_letters(b)) {
                if found.iter().all(|n: &&Name| n.text != name.text) {
                    found.push(name);
                }
            }
        }
        ConditionKind::Error => {}
    }
    found
}

/// The indices that an element-wise definition binds: the names among the subscripts on its left side.
pub fn left_indices(definition: &Definition) -> Vec<&Name> {
    definition
        .targets
        .iter()
        .flat_map(|t| &t.subscripts)
        .filter_map(|s| match s {
            Subscript::Expr(Expr {
                kind: ExprKind::Name(name),
                ..
            }) => Some(name),
            _ => None,
        })
        .collect()
}

/// The names that the sizes in a type use: they are declared by it, unless something else declares them.
pub fn dimension_names(ty: &Type, found: &mut dyn FnMut(&Name)) {
    match &ty.kind {
        TypeKind::Vector { length, .. } => size_names(length, found),
        TypeKind::Matrix { rows, columns, .. } => {
            size_names(rows, found);
            size_names(columns, found);
        }
        TypeKind::Set(items) | TypeKind::SetOfAlternatives(items) | TypeKind::Tuple(items) => {
            items.iter().for_each(|t| dimension_names(t, found))
        }
        TypeKind::Function {
            parameters,
            results,
        } => parameters
            .iter()
            .chain(results)
            .for_each(|t| dimension_names(t, found)),
        TypeKind::Mapping { to, .. } => dimension_names(to, found),
        _ => {}
    }
}

/// The names that a size uses; the subscript of `n_i` is that of the sequence.
fn size_names(e: &Expr, found: &mut dyn FnMut(&Name)) {
    match &e.kind {
        ExprKind::Subscript { base, .. } => size_names(base, found),
        ExprKind::Binary { left, right, .. } => {
            size_names(left, found);
            size_names(right, found);
        }
        _ => FreeNames::new(Vec::new(), found).expr(e),
    }
}
