//! Types as they are written, and the inputs of a module.

use super::Checker;
use super::scope::Found;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Input, InputId, Kind, MeshInput};
use crate::resolve::ModuleId;
use crate::syntax::ast::{self, Declaration, Expr, ExprKind, ItemKind, Relation, TypeKind};
use crate::types::{Atom, Dimension, MeshId, Type};

/// A declared type with the set that its value must be a member or a part of.
pub(super) struct Declared {
    pub(super) ty: Type,
    pub(super) within: Option<ExprId>,
    pub(super) within_name: String,
}

impl Declared {
    fn plain(ty: Type) -> Self {
        Self {
            ty,
            within: None,
            within_name: String::new(),
        }
    }
}

impl Checker<'_> {
    /// Declares the inputs of the compiled module, in order of the text. Meshes come first, so that element sets
    /// can be used in the types of the others.
    pub(super) fn declare_inputs(&mut self) {
        let module = self.resolved.module(ModuleId(0));
        let mut places = Vec::new();
        for (item, syntax) in module.syntax.items.iter().enumerate() {
            if let ItemKind::Parameters(block) = &syntax.kind {
                for (d, declaration) in block.iter().enumerate() {
                    for (target, t) in declaration.targets.iter().enumerate() {
                        if module.declared.contains_key(&t.name.text) {
                            continue;
                        }
                        places.push(((item, d, target), declaration));
                    }
                }
            }
        }
        for (place, declaration) in &places {
            if let TypeKind::Mesh(kind) = declaration.ty.kind {
                if declaration.relation == Relation::Subset && place.2 == 0 {
                    self.no_subset(declaration);
                }
                let name = &declaration.targets[place.2].name;
                self.program.meshes.push(MeshInput {
                    name: name.text.clone(),
                    kind,
                });
                let mesh = MeshId(self.program.meshes.len() as u32 - 1);
                self.declare_input(*place, declaration, Declared::plain(Type::Mesh(kind, mesh)));
            }
        }
        for (place, _) in &places {
            self.input(*place);
        }
        // back to the order of the text
        let order: Vec<InputId> = places
            .iter()
            .filter_map(|(place, _)| {
                let value = self.inputs.get(place)?;
                self.input_of(*value).map(|(id, _)| id)
            })
            .collect();
        self.program.input_order = order;
    }

    /// The value of an input; it is declared when it is first needed, since the set that it belongs to may be an
    /// input that stands further down.
    pub(super) fn input(&mut self, place: (usize, usize, usize)) -> Option<ExprId> {
        if let Some(value) = self.inputs.get(&place) {
            return Some(*value);
        }
        let items = &self.resolved.module(ModuleId(0)).syntax.items;
        let ItemKind::Parameters(block) = &items.get(place.0)?.kind else {
            return None;
        };
        let declaration = block.get(place.1)?;
        let name = &declaration.targets.get(place.2)?.name;
        if !self.declaring.insert(place) {
            self.circular = true;
            let message = format!("the declaration of `{}` depends on itself", name.text);
            self.report(
                Diagnostic::error(name.span, message)
                    .help("a symbol is declared as a member or subset of another set"),
            );
            return None;
        }
        let declared = self.in_module(ModuleId(0), |checker| {
            checker.declared(declaration, place.2)
        });
        self.declare_input(place, declaration, declared);
        self.inputs.get(&place).copied()
    }

    fn declare_input(
        &mut self,
        place: (usize, usize, usize),
        declaration: &Declaration,
        declared: Declared,
    ) {
        let target = &declaration.targets[place.2];
        let id = InputId(self.program.inputs.len() as u32);
        self.program.inputs.push(Input {
            name: target.name.text.clone(),
            ty: declared.ty.clone(),
            within: declared.within,
            indexed_by: Vec::new(),
            pairs: Vec::new(),
            description: declaration.description.clone(),
            span: target.name.span,
        });
        let value = self.add(Kind::Input(id), declared.ty);
        let value = self.counted(declaration, &target.name.text, value);
        self.inputs.insert(place, value);
    }

    /// The type that a declaration gives to one of its targets.
    pub(super) fn declared(&mut self, declaration: &Declaration, target: usize) -> Declared {
        let letter = declaration.targets[target].subscript.as_ref();
        let mut declared = if let TypeKind::Named(set) = &declaration.ty.kind {
            let declared = self.declared_by_set(declaration, set);
            self.with_attribute(declaration, declared.ty.clone());
            declared
        } else if declaration.relation == Relation::Subset {
            self.no_subset(declaration);
            return Declared::plain(Type::Error);
        } else {
            self.letter = letter.map(|letter| letter.text.clone());
            let ty = self.written_type(&declaration.ty);
            self.letter = None;
            Declared::plain(self.with_attribute(declaration, ty))
        };
        let Some(letter) = letter else {
            return declared;
        };
        let item = match declared.ty {
            Type::Sequence { .. } => {
                let target = &declaration.targets[target];
                let name = &target.name.text;
                let message = format!("`{name}` is indexed by `{}` and by a set", letter.text);
                self.report(
                    Diagnostic::error(declaration.ty.span, message)
                        .label(target.name.span, "the subscript makes a sequence already")
                        .help(format!(
                            "write `{name} : V → …` without the subscript, or `{name}_{} ∈ …` with the type of an item",
                            letter.text
                        )),
                );
                Type::Error
            }
            item => item,
        };
        declared.ty = sequence_of(item, &letter.text);
        declared
    }

    fn no_subset(&mut self, declaration: &Declaration) {
        self.report(
            Diagnostic::error(declaration.ty.span, "after `⊂` stands a set, not a type").help(
                "write `∈` for a value of this type, `S ∈ {T}` for a set of values of type `T`",
            ),
        );
    }

    pub(super) fn declared_by_set(
        &mut self,
        declaration: &Declaration,
        set: &ast::Name,
    ) -> Declared {
        let value = match self.find(set) {
            Found::Value(value) => value,
            Found::Error => return Declared::plain(Type::Error),
            Found::Functions(_) => {
                self.not_a_set(set, "a function", None);
                return Declared::plain(Type::Error);
            }
            Found::Dimension => {
                self.not_a_set(set, "a size", None);
                return Declared::plain(Type::Error);
            }
        };
        let ty = self.ty(value).clone();
        let ty = match (&ty, declaration.relation) {
            (Type::Error, _) => Type::Error,
            (Type::Set(_), Relation::Subset) => ty,
            (Type::Set(item), Relation::Member) => (**item).clone(),
            (Type::Set(_), Relation::Colon) => {
                self.report(
                    Diagnostic::error(
                        declaration.span,
                        format!("`{}` is a set, not a type", set.text),
                    )
                    .label(set.span, format!("this is {}", ty.described()))
                    .help(format!(
                        "write `∈ {0}` for an element or `⊂ {0}` for a subset",
                        set.text
                    )),
                );
                Type::Error
            }
            (other, _) => {
                let found = other.described();
                self.not_a_set(set, &found, Some(other));
                Type::Error
            }
        };
        Declared {
            ty,
            within: Some(value),
            within_name: set.text.clone(),
        }
    }

    #[track_caller]
    fn not_a_set(&mut self, set: &ast::Name, found: &str, ty: Option<&Type>) {
        let name = &set.text;
        let help = match ty {
            Some(Type::Mesh(..)) => format!(
                "`V, E, F = ElementSets({name})` names the sets of its elements; write `∈ V`"
            ),
            _ => "after `∈` stands a set or a type such as `ℝ³`, after `⊂` a set".to_owned(),
        };
        let expr = Expr {
            kind: ExprKind::Name(set.clone()),
            span: set.span,
        };
        let diagnostic = Diagnostic::error(set.span, format!("`{name}` is not a set"))
            .here(format!("this is {found}"))
            .help(help);
        let diagnostic = self.with_origins(diagnostic, &[&expr]);
        self.report(diagnostic);
    }

    /// A type as it is written.
    pub(super) fn written_type(&mut self, ty: &ast::Type) -> Type {
        match &ty.kind {
            TypeKind::Scalar(number) => Type::Scalar(*number),
            TypeKind::Vector {
                number,
                length,
                sparse,
            } => {
                let length = self.written_dimension(length);
                Type::Vector {
                    number: *number,
                    length,
                    sparse: *sparse,
                    space: None,
                }
            }
            TypeKind::Matrix {
                number,
                rows,
                columns,
                sparse,
            } => {
                let (rows, columns) = (
                    self.written_dimension(rows),
                    self.written_dimension(columns),
                );
                Type::Matrix {
                    number: *number,
                    rows,
                    columns,
                    sparse: *sparse,
                    spaces: None,
                }
            }
            TypeKind::Set(items) => {
                let mut items: Vec<Type> = items.iter().map(|t| self.written_type(t)).collect();
                Type::set_of(if items.len() == 1 {
                    items.remove(0)
                } else {
                    Type::Tuple(items)
                })
            }
            TypeKind::SetOfAlternatives(_) => {
                self.unsupported(ty.span, "sets of alternatives are");
                Type::Error
            }
            TypeKind::Tuple(items) => {
                Type::Tuple(items.iter().map(|t| self.written_type(t)).collect())
            }
            TypeKind::Function {
                parameters,
                results,
            } => {
                let parameters = parameters.iter().map(|t| self.written_type(t)).collect();
                let mut results: Vec<Type> = results.iter().map(|t| self.written_type(t)).collect();
                Type::Function {
                    parameters,
                    result: Box::new(match results.len() {
                        1 => results.remove(0),
                        _ => Type::Tuple(results),
                    }),
                }
            }
            TypeKind::Mapping { from, to } => {
                let item = self.written_type(to);
                let element = match self.find(from) {
                    Found::Value(value) => match (self.program.arena.kind(value), self.ty(value)) {
                        (_, Type::Error) => return Type::Error,
                        (Kind::AllElements(element), _) => Some(*element),
                        _ => None,
                    },
                    Found::Error => return Type::Error,
                    _ => None,
                };
                let Some(element) = element else {
                    let message = format!(
                        "`{}` is not all vertices, edges, faces or cells of a mesh",
                        from.text
                    );
                    let expr = Expr {
                        kind: ExprKind::Name(from.clone()),
                        span: from.span,
                    };
                    let diagnostic = Diagnostic::error(from.span, message).help(
                        "before `→` stands one of the sets of `V, E, F = ElementSets(M)`, as in `x : V → ℝ³`",
                    );
                    let diagnostic = self.with_origins(diagnostic, &[&expr]);
                    self.report(diagnostic);
                    return Type::Error;
                };
                Type::Sequence {
                    item: Box::new(item),
                    length: Dimension::atom(Atom::Count(element)),
                    index: Some(element),
                }
            }
            TypeKind::Mesh(kind) => {
                self.report(
                    Diagnostic::error(
                        ty.span,
                        format!(
                            "{} can only be a parameter of the module",
                            Type::Mesh(*kind, MeshId(0)).described()
                        ),
                    )
                    .help("declare it on a line of its own, as in `M : FaceMesh`"),
                );
                Type::Error
            }
            TypeKind::ElementSet(kind) => {
                let Some(mesh) = self.only_mesh(ty.span) else {
                    return Type::Error;
                };
                Type::set_of(Type::Element(crate::types::Element { kind: *kind, mesh }))
            }
            TypeKind::CellularSet => {
                Type::CellularSet((self.program.meshes.len() == 1).then_some(MeshId(0)))
            }
            TypeKind::Members(set) => {
                self.unsupported(set.span, "sets in the place of types are");
                Type::Error
            }
            TypeKind::Named(name) => {
                let help = format!(
                    "write `⊂ {}` for a set of its members; types are ℝ, ℤ, ℝ³, {{ℤ}} and the like",
                    name.text
                );
                let message = format!("`{}` is not a type", name.text);
                self.report(Diagnostic::error(name.span, message).help(help));
                Type::Error
            }
        }
    }

    /// The mesh of an element set that is declared by its kind alone.
    pub(super) fn only_mesh(&mut self, span: crate::span::Span) -> Option<MeshId> {
        if self.program.meshes.len() == 1 {
            return Some(MeshId(0));
        }
        self.report(
            Diagnostic::error(span, "it is not known which mesh these elements belong to")
                .help("write `S ⊂ V` with the `V` of `V, E, F = ElementSets(M)`"),
        );
        None
    }
}

/// The sequence that a subscript behind a declared name makes of its type.
fn sequence_of(item: Type, letter: &str) -> Type {
    Type::Sequence {
        item: Box::new(item),
        length: Dimension::atom(Atom::Length(letter.to_owned())),
        index: None,
    }
}
