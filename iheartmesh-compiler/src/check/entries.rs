//! Definitions in several parts: a base, entries, rows and columns that replace those of the base, and what `+=` adds.
//!
//! All parts are one definition, whose value is what the last one leaves. In a part the symbol stands for what the parts
//! above make of it.

use super::Checker;
use super::scope::{Binding, Scope};
use super::wording::ITEM_BY_ITEM;
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, ExprId, Kind, Layout, Unary};
use crate::resolve::{Meaning, ModuleId};
use crate::span::Span;
use crate::syntax::ast::{self, CompareOp, Expr, ExprKind, ItemKind, Name, Subscript};
use crate::types::{Number, Type};

/// The parts of a definition.
pub(super) struct Parts<'a> {
    definitions: Vec<&'a ast::Definition>,
    declaration: Option<(&'a ast::Declaration, usize)>,
}

impl<'a> Checker<'a> {
    /// The parts of the definition that a symbol stands for; `None` where there is only one without a declaration.
    pub(super) fn parts(&self, module: ModuleId, item: usize, name: &str) -> Option<Parts<'a>> {
        let module = self.resolved.module(module);
        let meaning = module.symbols.get(name)?.meanings.first()?;
        if !matches!(meaning, Meaning::Definition { item: first, .. } if *first == item) {
            return None;
        }
        let items = module.further.get(name).into_iter().flatten();
        let definition = |item: usize| match &module.syntax.items[item].kind {
            ItemKind::Definition(definition) => Some(definition),
            _ => None,
        };
        let definitions: Vec<_> = [item]
            .iter()
            .chain(items)
            .filter_map(|item| definition(*item))
            .collect();
        let declaration = module.declared.get(name).and_then(|place| {
            let ItemKind::Parameters(block) = &module.syntax.items[place.0].kind else {
                return None;
            };
            Some((block.get(place.1)?, place.2))
        });
        let plain = declaration.is_none() && definitions.len() == 1 && !definitions[0].add;
        (!plain).then_some(Parts {
            definitions,
            declaration,
        })
    }

    /// The value that all parts make.
    pub(super) fn by_parts(&mut self, module: ModuleId, parts: &Parts<'a>) -> ExprId {
        let declared = match parts.declaration {
            None => None,
            Some((declaration, target)) => {
                let ty = self.declared(declaration, target).ty;
                if ty.is_error() {
                    return self.error();
                }
                let span = declaration.targets[target].name.span;
                if module == ModuleId(0) {
                    let mut given = std::mem::take(&mut self.given);
                    let before = given.len();
                    self.report_sizes(&ty, span, &mut given);
                    let known = given.len() == before;
                    self.given = given;
                    if !known {
                        return self.error();
                    }
                }
                if !self.may_have_entries(&ty, span) {
                    return self.error();
                }
                Some(ty)
            }
        };
        let mut value: Option<ExprId> = None;
        let mut written = Vec::new();
        for (k, definition) in parts.definitions.iter().enumerate() {
            let [target] = definition.targets.as_slice() else {
                return self.several_at_once(definition);
            };
            let mut scope = Scope::default();
            if let Some(value) = value {
                let name = target.name.text.clone();
                scope.spans.insert(name.clone(), target.name.span);
                scope.names.insert(name, Binding::Value(value));
            }
            if !self.is_written_once(definition, &mut written) {
                return self.error();
            }
            let part = self.with_scope(scope, |checker| {
                checker.part(definition, value, declared.as_ref())
            });
            if self.is_error(part) {
                return part;
            }
            value = Some(match parts.definitions.get(k + 1) {
                // computed once, although the part below may look at every entry
                Some(next) if looks_at(next, &target.name) => {
                    let name = format!("{}, part {}", target.name.text, k + 1);
                    self.named(&name, part, definition.span)
                }
                _ => part,
            });
        }
        value.unwrap_or_else(|| self.error())
    }

    /// Whether a type is one whose entries can be defined.
    fn may_have_entries(&mut self, ty: &Type, span: Span) -> bool {
        let of_reals = !matches!(
            ty,
            Type::Vector {
                number: Number::Integer,
                ..
            } | Type::Matrix {
                number: Number::Integer,
                ..
            }
        );
        if of_reals
            && matches!(
                ty,
                Type::Vector { .. } | Type::Matrix { .. } | Type::Sequence { .. }
            )
        {
            return true;
        }
        let found = ty.described();
        let message = format!("the entries of {found} cannot be defined");
        self.report(
            Diagnostic::error(span, message)
                .here(format!("this is {found}"))
                .help(
                    "entries are those of vectors and matrices of real numbers, and of sequences",
                ),
        );
        false
    }

    fn part(
        &mut self,
        definition: &'a ast::Definition,
        base: Option<ExprId>,
        declared: Option<&Type>,
    ) -> ExprId {
        let target = &definition.targets[0];
        let all = target.subscripts.is_empty();
        if definition.add && base.is_none() && (all || declared.is_none()) {
            let name = &target.name.text;
            let message = format!("there is no `{name}` above to add to");
            return self.report(
                Diagnostic::error(definition.span, message)
                    .help(format!("write `{name} = …` above, or `=` instead of `+=`")),
            );
        }
        if !target.subscripts.is_empty() {
            return self.entries(definition, base, declared);
        }
        let value = self.expr(&definition.value);
        match base {
            Some(base) if !self.is_error(value) => self.added(definition, base, value),
            _ => value,
        }
    }

    /// `base + value`, for a part with `+=`.
    pub(super) fn added(
        &mut self,
        definition: &'a ast::Definition,
        base: ExprId,
        value: ExprId,
    ) -> ExprId {
        let (ta, tb) = (self.ty(base).clone(), self.ty(value).clone());
        match self.sum_of(definition.span, Binary::Add, base, value) {
            Some(sum) => sum,
            None => {
                let (a, b) = self.described_both(&ta, &tb);
                let message = format!("cannot add {b} to {a}");
                let name = &definition.targets[0].name;
                let help = match (&ta, &tb) {
                    (Type::Sequence { .. }, Type::Sequence { .. }) => ITEM_BY_ITEM,
                    _ => "both sides of `+=` must have the same type and size",
                };
                self.report(
                    Diagnostic::error(definition.value.span, message)
                        .here(format!("this is {b}"))
                        .label(name.span, format!("this is {a}"))
                        .help(help),
                )
            }
        }
    }

    /// A definition with subscripts on its left.
    pub(super) fn entries(
        &mut self,
        definition: &'a ast::Definition,
        base: Option<ExprId>,
        declared: Option<&Type>,
    ) -> ExprId {
        let left = &definition.targets[0];
        let mut names: Vec<(usize, &'a Name)> = Vec::new();
        let mut single = Vec::new();
        for (position, subscript) in left.subscripts.iter().enumerate() {
            match subscript {
                Subscript::Expr(Expr {
                    kind: ExprKind::Name(name),
                    ..
                }) => names.push((position, name)),
                Subscript::All(_) => single.push(None),
                Subscript::Expr(other) => single.push(Some(other)),
            }
        }
        if names.is_empty() {
            return self.single(definition, &single, base, declared);
        }
        if let Some(entry) = single.iter().flatten().next() {
            let message = "an index beside a single subscript on the left side";
            return self.report(
                Diagnostic::error(entry.span, message)
                    .help("define a row or a column at once, as in `A_1,* = v`, or all entries, as in `A_ij = …`"),
            );
        }
        let known = base.map(|base| self.ty(base).clone()).or(declared.cloned());
        let diagonal = matches!(names.as_slice(), [(_, a), (_, b)] if a.text == b.text);
        if base.is_some() && !definition.add && !diagonal {
            let name = &left.name;
            let message = format!("all entries of `{}` are defined above", name.text);
            return self.report(
                Diagnostic::error(name.span, message)
                    .help("`+=` adds to them; single entries are replaced by `y_1 = …`, the diagonal by `A_ii = …`"),
            );
        }
        if let (
            Some(Type::Matrix { .. }),
            false,
            ExprKind::Piecewise {
                branches,
                otherwise,
            },
        ) = (&known, diagonal, &definition.value.kind)
            && let [first, second] = names.as_slice()
            && (base.is_none() || known.as_ref().is_some_and(Type::is_sparse))
        {
            let ty = known.unwrap_or(Type::Error);
            let cells = self.sparse_cells(
                definition,
                [first.1, second.1],
                branches,
                otherwise.as_deref(),
                &ty,
            );
            return match base {
                Some(base) if !self.is_error(cells) => self.added(definition, base, cells),
                _ => cells,
            };
        }
        let value = self.elementwise(definition, &names, known.as_ref());
        if self.is_error(value) {
            return value;
        }
        match (base, known) {
            (Some(base), _) if self.ty(base).is_sparse() => self.added(definition, base, value),
            (Some(base), _) if diagonal => self.with_diagonal(definition, base, value),
            (Some(base), Some(Type::Sequence { .. })) => self.added_items(definition, base, value),
            (Some(base), _) => self.added(definition, base, value),
            (None, Some(ty)) => self.as_declared(definition, value, &ty),
            (None, None) => value,
        }
    }

    /// A value by its entries, as the type that it is declared with.
    fn as_declared(&mut self, definition: &'a ast::Definition, value: ExprId, ty: &Type) -> ExprId {
        let found = self.ty(value).clone();
        let fits = match (ty, &found) {
            (Type::Sequence { item, .. }, Type::Sequence { item: found, .. }) => item == found,
            _ => {
                matches!((ty.shape(), found.shape()), (Some(a), Some(b)) if !super::operator::differ(&a, &b))
            }
        };
        if !fits {
            let (a, b) = (ty.described(), found.described());
            let name = &definition.targets[0].name;
            let message = format!(
                "`{}` is declared as {a}, but its entries make {b}",
                name.text
            );
            return self.report(
                Diagnostic::error(name.span, message)
                    .label(definition.value.span, "these are the entries")
                    .help("change the declaration, or leave it out"),
            );
        }
        let of_elements = matches!(
            self.program.arena.kind(value),
            Kind::Tabulate { layout: Layout::Diagonal, variables, .. }
                if self.program.arena.variable_type(variables[0]).is_element()
        );
        match ty {
            Type::Sequence { .. } => value,
            // nobody wants all pairs of elements
            _ if of_elements => value,
            // a diagonal of a matrix that is declared as dense
            ty => {
                let value = self.real(value);
                self.represented(value, ty)
            }
        }
    }

    /// A dense matrix with its diagonal replaced by that of `value`, or with that added.
    fn with_diagonal(
        &mut self,
        definition: &'a ast::Definition,
        base: ExprId,
        value: ExprId,
    ) -> ExprId {
        let Kind::Tabulate {
            layout: Layout::Diagonal,
            variables,
            sizes,
            body,
        } = self.program.arena.kind(value).clone()
        else {
            return self.error();
        };
        let ty = self.ty(base).with_reals();
        let base = self.real(base);
        let row = self.program.arena.variable(variables[0]);
        let name = self.program.arena.variable_name(variables[0]).to_owned();
        let index = self.ty(row).clone();
        let other = self.program.arena.new_variable(&name, index.clone());
        let column = self.program.arena.variable(other);
        let mut places = [row, column];
        for place in &mut places {
            if index.is_element() {
                *place = self.add(Kind::Unary(Unary::ToInteger, *place), Type::INTEGER);
            }
        }
        let entry = Kind::At(base, places[0], places[1]);
        let entry = self.add_at(definition.span, entry, Type::REAL);
        let body = match definition.add {
            true => self.add(Kind::Binary(Binary::Add, entry, body), Type::REAL),
            false => body,
        };
        let on_diagonal = self.add(Kind::Compare(CompareOp::Equal, row, column), Type::Boolean);
        let body = self.add(Kind::If(on_diagonal, body, entry), Type::REAL);
        self.add_at(
            definition.span,
            Kind::Tabulate {
                layout: Layout::Matrix,
                variables: vec![variables[0], other],
                sizes: vec![sizes[0], sizes[0]],
                body,
            },
            ty,
        )
    }

    /// Two sequences of one length, added item by item.
    fn added_items(
        &mut self,
        definition: &'a ast::Definition,
        base: ExprId,
        value: ExprId,
    ) -> ExprId {
        let Type::Sequence { item, .. } = self.ty(base).clone() else {
            return self.added(definition, base, value);
        };
        let Kind::Tabulate {
            layout,
            variables,
            sizes,
            body,
        } = self.program.arena.kind(value).clone()
        else {
            return self.error();
        };
        let index = self.program.arena.variable(variables[0]);
        let own = self.add_at(definition.span, Kind::Item(base, index), *item.clone());
        let sum = self.added(definition, own, body);
        if self.is_error(sum) {
            return sum;
        }
        let sum = self.convert(sum, &item);
        self.add_at(
            definition.span,
            Kind::Tabulate {
                layout,
                variables,
                sizes,
                body: sum,
            },
            self.ty(base).clone(),
        )
    }
}

/// Whether a part needs more of the parts above than something to replace entries of.
fn looks_at(definition: &ast::Definition, name: &Name) -> bool {
    let mut looks = false;
    let mut found = |other: &Name| looks |= other.text == name.text;
    crate::resolve::symbols::walk_definition(definition, &mut found);
    let all = |subscripts: &[Subscript]| {
        subscripts.is_empty()
            || subscripts
                .iter()
                .any(|s| matches!(s, Subscript::Expr(e) if matches!(e.kind, ExprKind::Name(_))))
    };
    looks || definition.add || definition.targets.iter().any(|t| all(&t.subscripts))
}
