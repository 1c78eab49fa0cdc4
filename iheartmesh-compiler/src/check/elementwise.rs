//! Indices whose range follows from where they stand, and definitions entry by entry.

use super::index::counted_through;
use super::scope::{Binding, Scope};
use super::{Checker, IndexUse};
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Kind, Layout, VariableId};
use crate::syntax::ast::{self, Expr, Name, Subscript};
use crate::types::{Atom, Dimension, Element, Number, Shape, Type};

impl<'a> Checker<'a> {
    /// Binds an index whose range is not yet known.
    pub(super) fn bind_index(&mut self, scope: &mut Scope<'a>, name: &Name) -> VariableId {
        let variable = self.bind(scope, name, Type::INTEGER);
        self.index_uses.insert(variable, Vec::new());
        variable
    }

    /// Binds an index that runs over all elements of a kind.
    pub(super) fn bind_element(
        &mut self,
        scope: &mut Scope<'a>,
        name: &Name,
        element: Element,
    ) -> VariableId {
        let variable = self.bind(scope, name, Type::Element(element));
        self.all_elements.insert(variable);
        variable
    }

    /// Notes that an index stands alone as a subscript.
    pub(super) fn note_index_use(&mut self, index: (&'a Expr, ExprId), base: ExprId, axis: u8) {
        let variable = match (
            self.program.arena.kind(index.1),
            self.index_items.get(&index.1),
        ) {
            (Kind::Variable(variable), _) | (_, Some(variable)) => *variable,
            _ => return,
        };
        let element = match self.program.arena.variable_type(variable) {
            Type::Element(element) => self.all_elements.contains(&variable).then_some(*element),
            _ => None,
        };
        if element.is_none() && !self.index_uses.contains_key(&variable) {
            return;
        }
        let (dimension, of_sequence) = match (self.ty(base), axis) {
            (Type::Sequence { length, .. }, _) => (length.clone(), true),
            (Type::Vector { length, .. }, _) => (length.clone(), false),
            (Type::Matrix { rows, .. }, 0) => (rows.clone(), false),
            (Type::Matrix { columns, .. }, _) => (columns.clone(), false),
            _ => return,
        };
        if let Some(element) = element {
            // sequences are compared with the mesh
            if !of_sequence {
                let count = Dimension::atom(Atom::Count(element));
                let index = self.program.arena.variable_name(variable).to_owned();
                self.tie([&dimension, &count], &index);
            }
            return;
        }
        let size = self.extent(base, axis);
        let shown = match (self.ty(base), axis) {
            (ty @ Type::Matrix { .. }, 0) => format!("the rows of {ty}"),
            (ty @ Type::Matrix { .. }, _) => format!("the columns of {ty}"),
            (ty, _) => ty.described(),
        };
        if let Some(uses) = self.index_uses.get_mut(&variable) {
            uses.push(IndexUse {
                size,
                dimension,
                of_sequence,
                span: index.0.span,
                shown,
            });
        }
    }

    /// Notes that two sizes must be the same, so that they are compared once; whether that is possible.
    pub(super) fn tie(&mut self, sizes: [&Dimension; 2], index: &str) -> bool {
        let is_number = |size: &Dimension| size.value().is_some();
        let is_known = |size: &Dimension| {
            is_number(size)
                || matches!(size.as_atom(), Some(Atom::Count(_)))
                || self.program.is_given(size)
        };
        if self.guarded || sizes[0] == sizes[1] || !sizes.into_iter().all(is_known) {
            return sizes[0] == sizes[1];
        }
        let tie = crate::ir::Tie {
            sizes: sizes.map(Clone::clone),
            index: index.to_owned(),
        };
        let same = |other: &crate::ir::Tie| {
            let [a, b] = &other.sizes;
            other.sizes == tie.sizes || [b, a] == [&tie.sizes[0], &tie.sizes[1]]
        };
        if !self.program.ties.iter().any(same) {
            self.program.ties.push(tie);
        }
        true
    }

    /// How far an index runs: the size of what it indexes. All of them must agree; the length of a sequence may do so at
    /// run time.
    pub(super) fn index_range(
        &mut self,
        variable: VariableId,
        name: &Name,
    ) -> Option<(Dimension, ExprId)> {
        let help =
            "its range follows from what it indexes; otherwise write `∑_(i ∈ S)` or `∑_(i = 1)^n`";
        self.index_range_or(variable, name, help)
    }

    /// [`Self::index_range`], with the help for an index that indexes nothing.
    fn index_range_or(
        &mut self,
        variable: VariableId,
        name: &Name,
        help: &str,
    ) -> Option<(Dimension, ExprId)> {
        let uses = self.index_uses.remove(&variable).unwrap_or_default();
        // a size that depends on an index inside of this one is not known outside
        let known = |checker: &Self, u: &IndexUse| {
            let free = &checker.program.arena.node(u.size).free;
            free.iter().all(|v| checker.is_visible(*v))
        };
        let uses: Vec<IndexUse> = uses.into_iter().filter(|u| known(self, u)).collect();
        let Some(first) = uses
            .iter()
            .find(|u| !u.of_sequence)
            .or(uses.first())
            .cloned()
        else {
            self.report(
                Diagnostic::error(
                    name.span,
                    format!("index `{}` is not used as a subscript", name.text),
                )
                .help(help),
            );
            return None;
        };
        let mut size = first.size;
        for other in &uses {
            if other.dimension == first.dimension || other.size == first.size {
                continue;
            }
            if other.of_sequence || first.of_sequence || !other.dimension.differs(&first.dimension)
            {
                let stored = |e: ExprId| {
                    matches!(self.program.arena.kind(e), Kind::Size(_) | Kind::Integer(_))
                };
                if stored(other.size)
                    && stored(first.size)
                    && self.tie([&first.dimension, &other.dimension], &name.text)
                {
                    continue;
                }
                size = self.add_at(
                    other.span,
                    Kind::Agree(other.size, first.size, size),
                    Type::INTEGER,
                );
                continue;
            }
            let message = format!(
                "index `{}` runs to {} and to {}",
                name.text, first.dimension, other.dimension
            );
            self.report(
                Diagnostic::error(other.span, message)
                    .here(format!("here it indexes {}", other.shown))
                    .label(first.span, format!("here it indexes {}", first.shown))
                    .help("what one index stands at must have one size"),
            );
            return None;
        }
        Some((first.dimension, size))
    }

    /// The one size of vectors that are put together: known only at run time where it differs between them.
    fn common_size(&mut self, size: Dimension, variable: VariableId) -> Dimension {
        let ty = Type::real_vector(size.clone());
        let ty = self.with_new_sizes(&ty, &|arena, e| arena.depends_on(e, variable), false);
        match ty {
            Type::Vector { length, .. } => length,
            _ => size,
        }
    }

    /// Whether a variable is bound in an enclosing scope.
    fn is_visible(&self, variable: VariableId) -> bool {
        self.scopes
            .iter()
            .flat_map(|s| s.names.values())
            .any(|binding| match binding {
                Binding::Value(value) => self.program.arena.depends_on(*value, variable),
                _ => false,
            })
    }

    /// Notes how far an index runs on the left side of a definition whose type is known.
    pub(super) fn note_left_index(
        &mut self,
        variable: VariableId,
        name: &Name,
        ty: &Type,
        axis: usize,
    ) {
        let (dimension, of_sequence) = match (ty, axis) {
            (Type::Sequence { length, .. }, _) => (length.clone(), true),
            (Type::Vector { length, .. }, _) => (length.clone(), false),
            (Type::Matrix { rows, .. }, 0) => (rows.clone(), false),
            (Type::Matrix { columns, .. }, _) => (columns.clone(), false),
            _ => return,
        };
        let Some(size) = self.size(&dimension) else {
            return;
        };
        let shown = match (ty, axis) {
            (Type::Matrix { .. }, 0) => format!("the rows of {ty}"),
            (Type::Matrix { .. }, _) => format!("the columns of {ty}"),
            _ => ty.described(),
        };
        self.index_uses.entry(variable).or_default().push(IndexUse {
            size,
            dimension,
            of_sequence,
            span: name.span,
            shown,
        });
    }

    /// `y_i = …`, `A_ij = …`, `A_i,* = …`, `D_ii = …`; of a type that is declared or that the lines above give.
    pub(super) fn elementwise(
        &mut self,
        definition: &'a ast::Definition,
        names: &[(usize, &'a Name)],
        ty: Option<&Type>,
    ) -> ExprId {
        let left = &definition.targets[0];
        let slice = left
            .subscripts
            .iter()
            .position(|s| matches!(s, Subscript::All(_)));
        let diagonal = matches!(names, [(_, first), (_, second)] if first.text == second.text);
        let distinct = if diagonal { &names[..1] } else { names };
        if names.len() > 2 || (slice.is_some() && names.len() != 1) {
            return self.unsupported(definition.span, "this element-wise definition is");
        }
        let mut scope = Scope::default();
        let mut elements = Vec::new();
        let mut variables = Vec::new();
        for (_, name) in distinct {
            let mut places = names.iter().filter(|(_, other)| other.text == name.text);
            let left = places.find_map(|(axis, _)| counted_through(ty?, *axis));
            let element = self.element_index(name, &[&definition.value], &[], left);
            elements.push(element);
            variables.push(match element {
                Some(element) => self.bind_element(&mut scope, name, element),
                None => self.bind_index(&mut scope, name),
            });
        }
        if let Some(ty) = ty {
            for (axis, name) in names {
                let known = distinct
                    .iter()
                    .position(|(_, other)| other.text == name.text);
                let k = known.unwrap_or_default();
                match elements[k] {
                    Some(element) => {
                        if !self.is_counted_by(ty, *axis, element, name) {
                            return self.error();
                        }
                    }
                    None => self.note_left_index(variables[k], name, ty, *axis),
                }
            }
        }
        let body = self.with_scope(scope, |checker| checker.expr(&definition.value));
        let mut ranges = Vec::new();
        let mut failed = self.is_error(body);
        for ((variable, (_, name)), element) in variables.iter().zip(distinct).zip(elements) {
            if failed {
                self.index_uses.remove(variable);
                continue;
            }
            if let Some(element) = element {
                ranges.push(self.count(element));
                continue;
            }
            let help = "its range follows from what it indexes on the right side; where it indexes nothing, \
                        declare the left side, as in `y ∈ ℝ^3`";
            match self.index_range_or(*variable, name, help) {
                Some(range) => ranges.push(range),
                None => failed = true,
            }
        }
        if failed {
            return self.error();
        }
        self.tabulate(definition, variables, ranges, body, slice, (diagonal, ty))
    }

    fn sequence_of_reals(&self, ty: Option<&Type>) -> bool {
        matches!(ty, Some(Type::Sequence { item, .. }) if **item == Type::REAL)
    }

    fn tabulate(
        &mut self,
        definition: &'a ast::Definition,
        variables: Vec<VariableId>,
        ranges: Vec<(Dimension, ExprId)>,
        body: ExprId,
        slice: Option<usize>,
        (diagonal, known): (bool, Option<&Type>),
    ) -> ExprId {
        let ty = self.ty(body).clone();
        let element = match self.program.arena.variable_type(variables[0]) {
            Type::Element(element) => Some(*element),
            _ => None,
        };
        let (dimensions, sizes): (Vec<Dimension>, Vec<ExprId>) = ranges.into_iter().unzip();
        let first = dimensions[0].clone();
        let sequence = matches!(known, Some(Type::Sequence { .. }));
        let sparse = known.is_some_and(Type::is_sparse);
        let (layout, result, body) = match (ty.shape(), variables.len(), slice) {
            (Some(Shape::Scalar), 1, None) if diagonal => (
                Layout::Diagonal,
                Type::sparse_matrix(first.clone(), first),
                self.real(body),
            ),
            // numbers that belong to elements may be subscripts
            (Some(Shape::Scalar), 1, None) if !sequence && element.is_some() && ty.is_integer() => {
                let integers = Type::Vector {
                    number: Number::Integer,
                    length: first,
                    sparse: false,
                    space: None,
                };
                (Layout::Vector, integers, body)
            }
            (Some(Shape::Scalar), 1, None) if !sequence => {
                (Layout::Vector, Type::real_vector(first), self.real(body))
            }
            (Some(Shape::Scalar), 2, None) if sparse => (
                Layout::Sparse,
                Type::sparse_matrix(first, dimensions[1].clone()),
                self.real(body),
            ),
            (Some(Shape::Scalar), 2, None) => (
                Layout::Matrix,
                Type::real_matrix(first, dimensions[1].clone()),
                self.real(body),
            ),
            (Some(Shape::Vector(n)), 1, Some(1)) => {
                let n = self.common_size(n, variables[0]);
                (Layout::Rows, Type::real_matrix(first, n), self.real(body))
            }
            (Some(Shape::Vector(n)), 1, Some(0)) => {
                let n = self.common_size(n, variables[0]);
                (
                    Layout::Columns,
                    Type::real_matrix(n, first),
                    self.real(body),
                )
            }
            (Some(Shape::Scalar), 1, None) if self.sequence_of_reals(known) => (
                Layout::Sequence,
                Type::Sequence {
                    item: Box::new(Type::REAL),
                    length: first,
                    index: element,
                },
                self.real(body),
            ),
            (_, 1, None) if !diagonal && !matches!(ty, Type::Sequence { .. } | Type::Mesh(..)) => (
                Layout::Sequence,
                Type::Sequence {
                    item: Box::new(self.type_of_all(&ty, variables[0], element.is_none())),
                    length: first,
                    index: element,
                },
                body,
            ),
            _ => {
                let ty = ty.described();
                let name = &definition.targets[0].name;
                let message = format!("`{}` cannot be defined entry by entry by {ty}", name.text);
                return self.report(
                    Diagnostic::error(name.span, message)
                        .label(definition.value.span, format!("this is {ty}"))
                        .help("`A_ij` is a number, `A_i,*` and `A_*,j` are vectors, `x_i` may be anything"),
                );
            }
        };
        self.add_at(
            definition.span,
            Kind::Tabulate {
                layout,
                variables,
                sizes,
                body,
            },
            result,
        )
    }
}
