//! Sizes as they are written in types, and what the names in them stand for.

use super::Checker;
use super::extent::arithmetic;
use super::scope::Found;
use crate::diagnostic::Diagnostic;
use crate::ir::Kind;
use crate::resolve::{Meaning, ModuleId};
use crate::syntax::ast::{self, Expr, ExprKind, ItemKind, Subscript, TypeKind, UnaryOp};
use crate::types::{Atom, Dimension, Type};

impl Checker<'_> {
    /// The sizes that differ from item to item of the module's parameters that are sequences.
    pub(super) fn find_ragged(&mut self) {
        let module = self.resolved.module(ModuleId(0));
        for (item, syntax) in module.syntax.items.iter().enumerate() {
            let ItemKind::Parameters(block) = &syntax.kind else {
                continue;
            };
            for (d, declaration) in block.iter().enumerate() {
                let sizes: [Option<&Expr>; 2] = match &declaration.ty.kind {
                    TypeKind::Vector { length, .. } => [Some(length), None],
                    TypeKind::Matrix { rows, columns, .. } => [Some(rows), Some(columns)],
                    _ => continue,
                };
                for (axis, size) in sizes.into_iter().flatten().enumerate() {
                    if let ExprKind::Subscript { base, .. } = &size.kind
                        && let ExprKind::Name(name) = &base.kind
                    {
                        let place = ((item, d, 0), axis as u8);
                        self.ragged.entry(name.text.clone()).or_insert(place);
                    }
                }
            }
        }
    }

    /// The size that a name in a type stands for. What has another meaning in the module is no size.
    fn size_name(&mut self, name: &ast::Name) -> Option<Dimension> {
        let symbol = Dimension::atom(Atom::Symbol(name.text.clone()));
        let known = self.resolved.module(self.module).symbols.get(&name.text);
        let Some(known) = known.filter(|known| !known.meanings.is_empty()) else {
            return Some(symbol);
        };
        let (span, is_size) = (known.span, known.meanings == [Meaning::Dimension]);
        if is_size {
            return match self.ragged.get(&name.text) {
                Some(_) if self.module == ModuleId(0) => {
                    self.two_sizes(name);
                    None
                }
                _ => Some(symbol),
            };
        }
        let (what, ty) = match self.find_in_module(self.module, &name.text) {
            Found::Dimension => return Some(symbol),
            Found::Error => return None,
            Found::Functions(_) => ("a function".to_owned(), None),
            Found::Value(value) => {
                let value = match self.program.arena.kind(value) {
                    Kind::Global(id) => self.program.global(*id).value,
                    _ => value,
                };
                match self.program.arena.kind(value) {
                    Kind::Integer(n) => return Some(Dimension::known(*n)),
                    Kind::Size(size) => return Some(size.clone()),
                    Kind::Input(id) if *self.ty(value) == Type::INTEGER => {
                        let name = self.program.inputs[id.0 as usize].name.clone();
                        return Some(Dimension::atom(Atom::Symbol(name)));
                    }
                    _ => {}
                }
                let ty = self.ty(value).clone();
                if ty.is_error() {
                    return None;
                }
                if let Some(size) = self.defined_size(&name.text) {
                    return Some(size);
                }
                (ty.described(), Some(ty))
            }
        };
        let text = &name.text;
        if !self.misfits.insert((self.module, format!("size {text}"))) {
            return None;
        }
        let help = match ty {
            Some(Type::Scalar(crate::types::Number::Integer)) => {
                "a size is a number, a parameter, or follows from the size of one; others have no value yet when parameters are checked"
                    .to_owned()
            }
            _ => format!("rename one of the two, or write `{text} ∈ ℤ` for a size that is handed in"),
        };
        self.report(
            Diagnostic::error(name.span, format!("`{text}` is not a size"))
                .here("it stands for a size here")
                .label(span, format!("this is {what}"))
                .help(help),
        );
        None
    }

    /// The size that a definition is: arithmetic over other sizes.
    fn defined_size(&mut self, name: &str) -> Option<Dimension> {
        let module = self.resolved.module(self.module);
        let [Meaning::Definition { item, .. }] = module.symbols.get(name)?.meanings[..] else {
            return None;
        };
        let ItemKind::Definition(definition) = &module.syntax.items[item].kind else {
            return None;
        };
        match definition.targets.len() {
            1 => self.symbolic(&definition.value),
            _ => None,
        }
    }

    fn two_sizes(&mut self, name: &ast::Name) {
        let text = &name.text;
        if !self.misfits.insert((ModuleId(0), text.clone())) {
            return;
        }
        self.report(
            Diagnostic::error(
                name.span,
                format!("`{text}` is one size here, and a size for each item elsewhere"),
            )
            .help(format!(
                "rename one of the two; `ℝ^({text}_i)` is the type of items with a size for each"
            )),
        );
    }

    /// Whether a name may stand for the sizes of items.
    fn has_item_sizes(&mut self, name: &ast::Name) -> bool {
        let Some(known) = self.resolved.module(self.module).symbols.get(&name.text) else {
            return true;
        };
        let (span, meanings) = (known.span, known.meanings.clone());
        if meanings.is_empty() || meanings == [Meaning::Dimension] {
            return true;
        }
        let what = match self.find_in_module(self.module, &name.text) {
            Found::Dimension => return true,
            Found::Error => return false,
            Found::Functions(_) => "a function".to_owned(),
            Found::Value(value) => match self.ty(value) {
                Type::Error => return false,
                Type::Sequence { item, .. }
                    if **item == Type::INTEGER
                        && matches!(self.program.arena.kind(value), Kind::Input(_)) =>
                {
                    return true;
                }
                ty => ty.described(),
            },
        };
        let text = &name.text;
        let message = format!("`{text}` is not a size for each item");
        self.report(
            Diagnostic::error(name.span, message)
                .here("it stands for the sizes of items here")
                .label(span, format!("this is {what}"))
                .help(format!(
                    "rename one of the two, or write `{text}_i ∈ ℤ` for sizes that are handed in"
                )),
        );
        false
    }

    fn wrong_letter(&mut self, e: &Expr, name: &ast::Name, letter: &ast::Name) {
        let (n, i) = (&name.text, &letter.text);
        let (message, help) = match &self.letter {
            Some(own) => (
                format!(
                    "a sequence with the subscript `{own}` has no sizes with the subscript `{i}`"
                ),
                format!("write `{n}_{own}`: the size of each item"),
            ),
            None => (
                format!("`{n}_{i}` is a size for each item of a sequence"),
                format!("write `x_{i} ∈ ℝ^({n}_{i})` for a sequence, `{n}` for one size"),
            ),
        };
        self.report(Diagnostic::error(e.span, message).help(help));
    }

    /// A size as it is written.
    pub(super) fn written_dimension(&mut self, e: &Expr) -> Dimension {
        let dimension = self.dimension(e);
        let is_number = dimension.atoms().next().is_none();
        if is_number && dimension.value().is_none_or(|value| value < 0) {
            let message = format!("a size cannot be {dimension}");
            self.report(
                Diagnostic::error(e.span, message).help("sizes are integers, 0 or greater"),
            );
            return Dimension::known(0);
        }
        dimension
    }

    /// The same for a part of it.
    fn dimension(&mut self, e: &Expr) -> Dimension {
        let dimension = match &e.kind {
            ExprKind::Integer(value) => Some(Dimension::known(*value)),
            ExprKind::Name(name) => match self.size_name(name) {
                Some(dimension) => Some(dimension),
                None => return Dimension::known(0),
            },
            ExprKind::Subscript { base, subscripts } => match (&base.kind, &subscripts[..]) {
                (
                    ExprKind::Name(name),
                    [
                        Subscript::Expr(Expr {
                            kind: ExprKind::Name(letter),
                            ..
                        }),
                    ],
                ) => {
                    if self.letter.as_ref() != Some(&letter.text) {
                        self.wrong_letter(e, name, letter);
                        return Dimension::known(0);
                    }
                    if !self.has_item_sizes(name) {
                        return Dimension::known(0);
                    }
                    let symbol = Box::new(Atom::Symbol(name.text.clone()));
                    Some(Dimension::atom(Atom::Item(symbol, None)))
                }
                _ => None,
            },
            ExprKind::Binary {
                op, left, right, ..
            } => {
                let (left, right) = (self.dimension(left), self.dimension(right));
                arithmetic(left, *op, &right)
            }
            ExprKind::Unary {
                op: UnaryOp::Negate,
                operand,
            } => self.dimension(operand).negate(),
            ExprKind::Unary { .. } | ExprKind::Norm { .. } => self.symbolic(e),
            _ => None,
        };
        dimension.unwrap_or_else(|| {
            let message = "a size cannot be written like this";
            self.report(Diagnostic::error(e.span, message).help(
                "sizes are numbers and symbols, put together with `+`, `-`, products, and division by a number",
            ));
            Dimension::known(0)
        })
    }
}
