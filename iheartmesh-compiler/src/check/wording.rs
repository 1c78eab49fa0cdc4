//! What messages have in common: how types and meshes are called, and where a symbol comes from.

use super::Checker;
use super::scope::Binding;
use crate::diagnostic::Diagnostic;
use crate::ir::Kind;
use crate::resolve::Meaning;
use crate::span::Span;
use crate::syntax::ast::{Expr, ExprKind, Name};
use crate::types::{MeshId, Type};

/// What to do about elements in arithmetic.
pub(super) const NOT_NUMBERS: &str =
    "elements of a mesh are not numbers; use the values that belong to them, as in `x_v`";

/// What to do about sums of sequences.
pub(super) const ITEM_BY_ITEM: &str =
    "sequences are added item by item, as in `z_i = x_i + y_i` or `y_i += x_i`";

/// What to do about several meshes.
pub(super) const ONE_MESH: &str =
    "elements, sets and matrices of one expression must belong to one mesh";

/// Vertices are no edges.
pub(super) const KINDS: &str = "vertices, edges, faces and cells are different kinds of elements";

impl Checker<'_> {
    /// The name of a mesh.
    pub(super) fn mesh_name(&self, mesh: MeshId) -> String {
        self.program.mesh(mesh).name.clone()
    }

    /// How a sentence calls two values that meet: with their meshes where these differ.
    pub(super) fn described_both(&self, a: &Type, b: &Type) -> (String, String) {
        match (a.owner(), b.owner()) {
            (Some(x), Some(y)) if x != y => (
                format!("{} of `{}`", a.described(), self.mesh_name(x)),
                format!("{} of `{}`", b.described(), self.mesh_name(y)),
            ),
            _ => (a.described(), b.described()),
        }
    }

    /// What to do where the subscript of a definition stands for an element but counts.
    pub(super) fn counted_help(&self, given: &Expr) -> Option<String> {
        let name = &symbol(given)?.text;
        let binding = self
            .scopes
            .iter()
            .rev()
            .find_map(|scope| scope.names.get(name))?;
        let counts = match binding {
            Binding::Value(value) => match self.program.arena.kind(*value) {
                Kind::Variable(variable) => self.index_uses.contains_key(variable),
                _ => false,
            },
            _ => false,
        };
        counts.then(|| {
            format!(
                "the subscript `{name}` counts from 1, since nothing says that it is an element: declare what is defined, as in \
                 `y ∈ ℝ^(#V)`, or make the subscript a parameter, with `where {name} ∈ V` behind the definition"
            )
        })
    }

    /// Marks where the symbols in these expressions are declared or defined.
    pub(super) fn with_origins(&self, mut diagnostic: Diagnostic, of: &[&Expr]) -> Diagnostic {
        for e in of {
            if let Some(name) = symbol(e)
                && let Some((span, text)) = self.origin(name)
                && diagnostic.labels.iter().all(|label| label.span != span)
            {
                diagnostic = diagnostic.label(span, text);
            }
        }
        diagnostic
    }

    fn origin(&self, name: &Name) -> Option<(Span, String)> {
        let text = &name.text;
        for scope in self.scopes.iter().rev() {
            if let Some(span) = scope.spans.get(text) {
                return Some((*span, format!("`{text}` is declared here")));
            }
        }
        let symbol = self.resolved.module(self.module).symbols.get(text)?;
        match symbol.meanings.first()? {
            Meaning::Parameter { .. } | Meaning::Argument(..) => {
                Some((symbol.span, format!("`{text}` is declared here")))
            }
            Meaning::Definition { .. } | Meaning::Functions(_) => {
                Some((symbol.span, format!("`{text}` is defined here")))
            }
            Meaning::Dimension | Meaning::Import(..) | Meaning::Builtin(_) => None,
        }
    }
}

/// The symbol that an expression gets its type from.
fn symbol(e: &Expr) -> Option<&Name> {
    match &e.kind {
        ExprKind::Name(name) => Some(name),
        ExprKind::Subscript { base, .. } => symbol(base),
        ExprKind::Call { function, .. } => Some(function),
        _ => None,
    }
}

/// How a message calls an expression: by its name, or as `this`.
pub(super) fn called(e: &Expr) -> String {
    match &e.kind {
        ExprKind::Name(name) => format!("`{}`", name.text),
        _ => "this".to_owned(),
    }
}

/// The arguments of a call in a sentence.
pub(super) fn arguments(described: &[String]) -> String {
    match described {
        [] => "no arguments".to_owned(),
        [one] => one.clone(),
        _ => format!("({})", described.join(", ")),
    }
}
