//! Attributes of declarations: integers that are numbers of the host, from 0, or elements of a mesh.

use super::Checker;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Kind, Unary};
use crate::span::Span;
use crate::syntax::ast::{Attribute, Declaration};
use crate::types::{Element, ElementKind, Number, Type, element_dimension, mesh_dimension};

impl Checker<'_> {
    /// The declared type as its attribute makes it.
    pub(super) fn with_attribute(&mut self, declaration: &Declaration, ty: Type) -> Type {
        let Some((attribute, span)) = declaration.attribute else {
            return ty;
        };
        if ty.is_error() {
            return ty;
        }
        let kind = match attribute {
            Attribute::Index if has_integers(&ty) => return ty,
            Attribute::Index => None,
            Attribute::Vertices => Some(ElementKind::Vertex),
            Attribute::Edges => Some(ElementKind::Edge),
            Attribute::Faces => Some(ElementKind::Face),
            Attribute::Cells => Some(ElementKind::Cell),
        };
        let element = match kind {
            None => None,
            Some(kind) => match self.element_of_only_mesh(kind, span) {
                Some(element) => Some(element),
                None => return Type::Error,
            },
        };
        match element.and_then(|element| with_elements(&ty, element)) {
            Some(ty) => ty,
            None => {
                let found = ty.described();
                let message = format!("there is nothing to index with in {found}");
                self.report(
                    Diagnostic::error(declaration.ty.span, message)
                        .here(format!("this is {found}"))
                        .label(span, "this is said of integers")
                        .help(
                            "write ℤ, as in `k ∈ ℤ index`, `S ∈ {ℤ} vertices`, `P ∈ {ℤ × ℤ} index`",
                        ),
                );
                Type::Error
            }
        }
    }

    fn element_of_only_mesh(&mut self, kind: ElementKind, span: Span) -> Option<Element> {
        let mesh = self.only_mesh(span)?;
        let of = &self.program.mesh(mesh);
        if element_dimension(kind) <= mesh_dimension(of.kind) {
            return Some(Element { kind, mesh });
        }
        let ty = Type::Mesh(of.kind, mesh).described();
        let kinds = crate::types::display::plural(kind);
        let message = format!("{ty} has no {kinds}");
        self.report(Diagnostic::error(span, message).help("declare a mesh that has them"));
        None
    }

    /// What formulas see of a parameter: integers that the host counts from 0 are counted from 1.
    pub(super) fn counted(
        &mut self,
        declaration: &Declaration,
        name: &str,
        input: ExprId,
    ) -> ExprId {
        if !matches!(declaration.attribute, Some((Attribute::Index, _))) || self.is_error(input) {
            return input;
        }
        let ty = self.ty(input).clone();
        let counted = self.add(Kind::Unary(Unary::FromHost, input), ty);
        let name = format!("{name}, from 1");
        self.named(&name, counted, declaration.span)
    }

    /// Reports an attribute of a parameter of a function, which the host does not count.
    pub(super) fn no_index(&mut self, declaration: &Declaration) {
        if let Some((Attribute::Index, span)) = declaration.attribute {
            self.report(
                Diagnostic::error(span, "only parameters of a module are counted from 0 by the host")
                    .help("remove `index`: arguments of functions are numbered from 1 like all else in formulas"),
            );
        }
    }
}

/// Whether there are integers in the values of a type.
fn has_integers(ty: &Type) -> bool {
    match ty {
        Type::Set(item) | Type::Sequence { item, .. } => has_integers(item),
        Type::Tuple(items) => items.len() <= 4 && items.iter().all(has_integers),
        ty => ty.is_integer(),
    }
}

/// A type with elements in place of integers; nothing where there are none.
fn with_elements(ty: &Type, element: Element) -> Option<Type> {
    Some(match ty {
        Type::Scalar(Number::Integer) => Type::Element(element),
        Type::Set(item) => Type::set_of(with_elements(item, element)?),
        Type::Tuple(items) => {
            let items = items.iter().map(|item| with_elements(item, element));
            Type::Tuple(items.collect::<Option<_>>()?)
        }
        Type::Sequence {
            item,
            length,
            index,
        } => Type::Sequence {
            item: Box::new(with_elements(item, element)?),
            length: length.clone(),
            index: *index,
        },
        _ => return None,
    })
}
