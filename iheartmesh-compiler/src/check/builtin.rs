//! Functions of the built-in modules, and those that are always there.

use super::Checker;
use super::wording::ONE_MESH;
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, Boundary, Elementary, ExprId, Fold, Kind, Range, Unary};
use crate::resolve::symbols::{count, given};
use crate::span::Span;
use crate::syntax::ast::{Expr, Name};
use crate::types::display::plural;
use crate::types::{ELEMENT_KINDS, Element, ElementKind, MeshId, Shape, Type, mesh_dimension};

const ORDINALS: [&str; 4] = ["first", "second", "third", "fourth"];

/// What sparse vectors over elements are.
fn elementary(name: &str) -> Option<Elementary> {
    Some(match name {
        "sin" => Elementary::Sin,
        "cos" => Elementary::Cos,
        "tan" => Elementary::Tan,
        "cot" => Elementary::Cot,
        "sec" => Elementary::Sec,
        "csc" => Elementary::Csc,
        "asin" | "arcsin" => Elementary::Asin,
        "acos" | "arccos" => Elementary::Acos,
        "atan" | "arctan" => Elementary::Atan,
        "sinh" => Elementary::Sinh,
        "cosh" => Elementary::Cosh,
        "tanh" => Elementary::Tanh,
        "asinh" | "arsinh" => Elementary::Asinh,
        "acosh" | "arcosh" => Elementary::Acosh,
        "atanh" | "artanh" => Elementary::Atanh,
        "exp" => Elementary::Exp,
        "log" | "ln" => Elementary::Ln,
        "log_2" => Elementary::Log2,
        "log_10" => Elementary::Log10,
        _ => return None,
    })
}

impl<'a> Checker<'a> {
    /// A call of a built-in function by its name there.
    pub(super) fn builtin(
        &mut self,
        span: Span,
        name: &'a Name,
        builtin: &str,
        arguments: &[&'a Expr],
    ) -> ExprId {
        let values: Vec<ExprId> = arguments.iter().map(|a| self.expr(a)).collect();
        if values.iter().any(|v| self.is_wrong(*v)) {
            return self.error();
        }
        let call = Builtin {
            span,
            name,
            builtin,
            arguments,
            values: &values,
        };
        if let Some(function) = elementary(builtin) {
            return self.elementary(&call, function);
        }
        match builtin {
            "sqrt" => {
                if !self.takes(&call, 1) {
                    return self.error();
                }
                match self.ty(values[0]) {
                    Type::Scalar(_) => {
                        let value = self.real(values[0]);
                        self.add(Kind::Unary(Unary::SquareRoot, value), Type::REAL)
                    }
                    _ => self.wrong(&call, 0, "a number"),
                }
            }
            "atan2" => {
                if !self.takes(&call, 2) {
                    return self.error();
                }
                for (k, value) in values.iter().enumerate() {
                    if !self.ty(*value).is_scalar() {
                        return self.wrong(&call, k, "two numbers");
                    }
                }
                let (y, x) = (self.real(values[0]), self.real(values[1]));
                self.add(Kind::Binary(Binary::Atan2, y, x), Type::REAL)
            }
            "sequence" => self.sequence(&call),
            _ if super::linear::is_linear(builtin) => self.linear_algebra(&call, builtin),
            "min" | "max" => self.extremum(&call, builtin == "min"),
            "tuple" => {
                let types = values.iter().map(|v| self.ty(*v).clone()).collect();
                self.add(Kind::Tuple(values.clone()), Type::Tuple(types))
            }
            "ElementSets" => self.element_sets(&call),
            "BoundaryMatrices" => self.boundary_matrices(&call, true),
            "UnsignedBoundaryMatrices" => self.boundary_matrices(&call, false),
            "IndicatorVector" => self.indicator(&call),
            "NonZeros" => self.elements_by_value(&call, false),
            "ValueSet" => self.elements_by_value(&call, true),
            "vertexset" => self.tagged_set(&call, ElementKind::Vertex),
            "edgeset" => self.tagged_set(&call, ElementKind::Edge),
            "faceset" => self.tagged_set(&call, ElementKind::Face),
            "cellset" => self.tagged_set(&call, ElementKind::Cell),
            "CellularSet" => self.cellular_set(&call),
            _ => self.unsupported(span, &format!("`{}` is", name.text)),
        }
    }

    fn elementary(&mut self, call: &Builtin<'_, 'a>, function: Elementary) -> ExprId {
        // the base of a logarithm may be its subscript
        if function == Elementary::Ln && call.values.len() == 2 {
            let base = match self.program.arena.kind(call.values[0]) {
                Kind::Integer(2) => Elementary::Log2,
                Kind::Integer(10) => Elementary::Log10,
                _ => {
                    let base = call.arguments[0].span;
                    let error = Diagnostic::error(base, "the base of a logarithm is 2 or 10");
                    return self
                        .report(error.help(
                            "divide by the logarithm of another base, as in `log(x)/log(b)`",
                        ));
                }
            };
            let call = Builtin {
                span: call.span,
                name: call.name,
                builtin: call.builtin,
                arguments: &call.arguments[1..],
                values: &call.values[1..],
            };
            return self.elementary(&call, base);
        }
        if !self.takes(call, 1) {
            return self.error();
        }
        let ty = self.ty(call.values[0]).clone();
        match ty.shape() {
            Some(shape) if !ty.is_sparse() => {
                let value = self.real(call.values[0]);
                self.add(Kind::Unary(Unary::Apply(function), value), shape.real())
            }
            _ => self.wrong(call, 0, "a number, a vector or a matrix"),
        }
    }

    fn extremum(&mut self, call: &Builtin<'_, 'a>, least: bool) -> ExprId {
        let (binary, fold) = match least {
            true => (Binary::Min, Fold::Min),
            false => (Binary::Max, Fold::Max),
        };
        if let [value] = call.values {
            let item = match self.ty(*value) {
                Type::Set(item) if item.is_scalar() => (**item).clone(),
                Type::Set(_) => return self.wrong(call, 0, "a set of numbers"),
                Type::Sequence { item, .. } if item.is_scalar() => {
                    let op = if least { Unary::Least } else { Unary::Greatest };
                    let item = (**item).clone();
                    return self.add_at(call.span, Kind::Unary(op, *value), item);
                }
                ty => match ty.shape() {
                    Some(Shape::Vector(_) | Shape::Matrix(..)) => {
                        let op = if least { Unary::Least } else { Unary::Greatest };
                        let value = self.real(*value);
                        return self.add_at(call.span, Kind::Unary(op, value), Type::REAL);
                    }
                    Some(Shape::Scalar) => return *value,
                    None => {
                        return self.wrong(
                            call,
                            0,
                            "numbers, or a set, vector, matrix or sequence of them",
                        );
                    }
                },
            };
            let variable = self.program.arena.new_variable("x", item.clone());
            let body = self.program.arena.variable(variable);
            return self.add_at(
                call.span,
                Kind::Fold {
                    op: fold,
                    variable,
                    range: Range::Set(*value),
                    condition: None,
                    body,
                },
                item,
            );
        }
        let Some((&first, rest)) = call.values.split_first() else {
            return self.wrong_count(call, "at least 1 argument");
        };
        for (k, value) in call.values.iter().enumerate() {
            if !self.ty(*value).is_scalar() {
                return self.wrong(call, k, "numbers, or one set of numbers");
            }
        }
        rest.iter().fold(first, |a, &b| {
            let (a, b) = self.common(a, b);
            let ty = self.ty(a).clone();
            self.add(Kind::Binary(binary, a, b), ty)
        })
    }

    /// The mesh that the only argument is.
    fn mesh_argument(&mut self, call: &Builtin<'_, 'a>) -> Option<(MeshId, usize)> {
        if !self.takes(call, 1) {
            return None;
        }
        match self.ty(call.values[0]) {
            Type::Mesh(kind, mesh) => Some((*mesh, mesh_dimension(*kind))),
            _ => {
                self.wrong(call, 0, "a mesh");
                None
            }
        }
    }

    fn element_sets(&mut self, call: &Builtin<'_, 'a>) -> ExprId {
        let Some((mesh, dimension)) = self.mesh_argument(call) else {
            return self.error();
        };
        let mut sets = Vec::new();
        let mut types = Vec::new();
        for &kind in &ELEMENT_KINDS[..=dimension] {
            let element = Element { kind, mesh };
            let ty = Type::set_of(Type::Element(element));
            sets.push(self.add(Kind::AllElements(element), ty.clone()));
            types.push(ty);
        }
        self.add(Kind::Tuple(sets), Type::Tuple(types))
    }

    fn boundary_matrices(&mut self, call: &Builtin<'_, 'a>, signed: bool) -> ExprId {
        let Some((mesh, dimension)) = self.mesh_argument(call) else {
            return self.error();
        };
        let mut matrices = Vec::new();
        let mut types = Vec::new();
        for dimension in 1..=dimension as u8 {
            let matrix = self.boundary(Boundary {
                mesh,
                dimension,
                signed,
                transposed: false,
            });
            matrices.push(matrix);
            types.push(self.ty(matrix).clone());
        }
        if let [matrix] = matrices.as_slice() {
            return *matrix;
        }
        self.add(Kind::Tuple(matrices), Type::Tuple(types))
    }

    fn tagged_set(&mut self, call: &Builtin<'_, 'a>, kind: ElementKind) -> ExprId {
        if !self.takes(call, 1) {
            return self.error();
        }
        match self.ty(call.values[0]).element_of_set() {
            Some(element) if element.kind == kind => call.values[0],
            Some(_) => self.wrong_because(
                call,
                0,
                &format!("a set of {}", plural(kind)),
                "it only says what a set holds and cannot change it; `Vertices`, `Edges` and `Faces` from `Neighborhoods(M)` go from one kind to another",
            ),
            None if self.ty(call.values[0]) == &Type::set_of(Type::INTEGER) => {
                self.unsupported(call.span, "turning integers into elements is")
            }
            None => self.wrong(call, 0, &format!("a set of {}", plural(kind))),
        }
    }

    fn cellular_set(&mut self, call: &Builtin<'_, 'a>) -> ExprId {
        if call.values.is_empty() || call.values.len() > 4 {
            return self.wrong_count(call, "1 to 4 sets");
        }
        let mut mesh = None;
        for (k, value) in call.values.iter().enumerate() {
            // an empty literal has the kind of its place
            if self.is_empty_set(*value) {
                continue;
            }
            let kind = ELEMENT_KINDS[k];
            let element = self.ty(*value).element_of_set();
            let Some(element) = element.filter(|element| element.kind == kind) else {
                let takes = format!("a set of {} as its {} argument", plural(kind), ORDINALS[k]);
                return self.wrong_because(
                    call,
                    k,
                    &takes,
                    "its arguments are sets of vertices, edges, faces and cells, in this order; `{}` where there are none",
                );
            };
            if let Some(before) = mesh.filter(|m| *m != element.mesh) {
                let (of, given) = (self.mesh_name(before), self.mesh_name(element.mesh));
                let message = format!(
                    "`{}` takes sets of one mesh, not of `{of}` and `{given}`",
                    call.name.text
                );
                let diagnostic = Diagnostic::error(call.arguments[k].span, message)
                    .here(format!("this is of `{given}`"))
                    .help(ONE_MESH);
                let diagnostic = self.with_origins(diagnostic, &[call.arguments[k]]);
                return self.report(diagnostic);
            }
            mesh = Some(element.mesh);
        }
        let Some(mesh) = mesh else {
            return self.wrong_because(
                call,
                0,
                "at least one set that is not the literal `{}`",
                "which mesh it belongs to follows from its sets",
            );
        };
        let mut sets = Vec::new();
        for (k, &kind) in ELEMENT_KINDS.iter().enumerate() {
            let ty = Type::set_of(Type::Element(Element { kind, mesh }));
            match call.values.get(k) {
                Some(value) if !self.is_empty_set(*value) => sets.push(*value),
                _ => sets.push(self.add(Kind::Set(Vec::new()), ty)),
            }
        }
        self.add(Kind::Tuple(sets), Type::CellularSet(Some(mesh)))
    }

    #[track_caller]
    pub(super) fn takes(&mut self, call: &Builtin<'_, 'a>, n: usize) -> bool {
        if call.values.len() == n {
            return true;
        }
        self.wrong_count(call, &count(n, "argument"));
        false
    }

    #[track_caller]
    pub(super) fn wrong_count(&mut self, call: &Builtin<'_, 'a>, takes: &str) -> ExprId {
        let name = &call.name.text;
        let message = format!(
            "`{name}` takes {takes} but is given {}",
            given(call.values.len())
        );
        let help = format!("write it as in `{}`", usage(call.builtin, name));
        self.report(Diagnostic::error(call.span, message).help(help))
    }

    /// An argument is not what the function takes.
    #[track_caller]
    pub(super) fn wrong(&mut self, call: &Builtin<'_, 'a>, k: usize, takes: &str) -> ExprId {
        let help = match (call.builtin, self.ty(call.values[k])) {
            ("IndicatorVector", Type::Element(_)) => {
                "`{v}` is the set with one member `v`".to_owned()
            }
            ("NonZeros" | "ValueSet", Type::Set(item)) if item.is_element() && k == 0 => {
                "`IndicatorVector(S)` is the chain of a set `S`".to_owned()
            }
            ("ElementSets" | "BoundaryMatrices" | "UnsignedBoundaryMatrices", _) => {
                "a mesh is declared as in `M : FaceMesh`".to_owned()
            }
            _ => format!("write it as in `{}`", usage(call.builtin, &call.name.text)),
        };
        self.wrong_because(call, k, takes, &help)
    }

    #[track_caller]
    fn wrong_because(
        &mut self,
        call: &Builtin<'_, 'a>,
        k: usize,
        takes: &str,
        help: &str,
    ) -> ExprId {
        let given = self.ty(call.values[k]).described();
        let message = format!("`{}` takes {takes}, not {given}", call.name.text);
        let diagnostic = Diagnostic::error(call.arguments[k].span, message)
            .here(format!("this is {given}"))
            .help(help);
        let diagnostic = self.with_origins(diagnostic, &[call.arguments[k]]);
        self.report(diagnostic)
    }
}

/// How a built-in function is written, under its local name.
fn usage(builtin: &str, name: &str) -> String {
    let arguments = match builtin {
        "atan2" => "(y, x)",
        "min" | "max" => "(a, b)",
        "tuple" => "(a, b)",
        "ElementSets" | "BoundaryMatrices" | "UnsignedBoundaryMatrices" => "(M)",
        "IndicatorVector" | "vertexset" | "edgeset" | "faceset" | "cellset" => "(S)",
        "NonZeros" => "(B IndicatorVector(S))",
        "ValueSet" => "(B IndicatorVector(S), 1)",
        "CellularSet" => "(S, H, G)",
        "trace" | "tr" | "det" | "rank" | "inv" | "null" | "orth" | "svd" | "psd" | "psd_abs" => {
            "(A)"
        }
        "vec⁻¹" | "inversevec" => "_x(v)",
        "sequence" => "(a, b)",
        _ => "(x)",
    };
    format!("{name}{arguments}")
}

/// A call of a built-in function.
pub(super) struct Builtin<'c, 'a> {
    pub(super) span: Span,
    pub(super) name: &'a Name,
    /// Its name in the built-in module.
    pub(super) builtin: &'c str,
    pub(super) arguments: &'c [&'a Expr],
    pub(super) values: &'c [ExprId],
}
