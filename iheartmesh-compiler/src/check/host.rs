//! Calls of functions that the host hands in.

use super::Checker;
use super::sizes::{Sizes, fit};
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Kind};
use crate::resolve::symbols::count;
use crate::span::Span;
use crate::syntax::ast::{Expr, Name};
use crate::types::{Dimension, Type};

impl<'a> Checker<'a> {
    /// A call of a function that the host hands in.
    pub(super) fn host_call(
        &mut self,
        span: Span,
        name: &'a Name,
        called: ExprId,
        (parameters, result): (&[Type], &Type),
        arguments: &[&'a Expr],
    ) -> ExprId {
        let values: Vec<ExprId> = arguments.iter().map(|a| self.expr(a)).collect();
        if values.iter().any(|v| self.is_error(*v)) {
            return self.error();
        }
        let shown: Vec<String> = parameters.iter().map(Type::described).collect();
        let help = format!("`{}` takes ({})", name.text, shown.join(", "));
        if values.len() != parameters.len() {
            let message = format!(
                "`{}` takes {} but is given {}",
                name.text,
                count(parameters.len(), "argument"),
                values.len()
            );
            return self.report(Diagnostic::error(span, message).help(help));
        }
        let mut sizes = Sizes::default();
        for (k, (value, parameter)) in values.iter().zip(parameters).enumerate() {
            let ty = self.ty(*value).clone();
            if fit(parameter, &ty, &|_| false, &mut sizes).is_none() {
                let given = ty.described();
                let message = format!(
                    "`{}` takes {} but is given {given}",
                    name.text,
                    parameter.described()
                );
                return self.report(
                    Diagnostic::error(arguments[k].span, message)
                        .here(format!("this is {given}"))
                        .help(help),
                );
            }
        }
        let values = values
            .iter()
            .zip(parameters)
            .map(|(v, ty)| self.convert(*v, ty))
            .collect();
        self.host_value(span, Kind::HostCall(called, values), result)
    }

    /// What a function of the host returns: its sizes are compared with those that are declared.
    fn host_value(&mut self, span: Span, call: Kind, declared: &Type) -> ExprId {
        let mut found = declared.clone();
        let sizes: Vec<Dimension> = match &mut found {
            // the type in Rust has these sizes
            _ if declared.is_fixed() => Vec::new(),
            Type::Vector { length, .. } => vec![length],
            Type::Matrix { rows, columns, .. } => vec![rows, columns],
            _ => Vec::new(),
        }
        .into_iter()
        .map(|size| std::mem::replace(size, self.new_dimension()))
        .collect();
        let returned = self.add_at(span, call, found);
        let mut value = returned;
        for (axis, size) in sizes.iter().enumerate() {
            if let Some(wanted) = self.size(size) {
                let found = self.extent(returned, axis as u8);
                value = self.add_at(span, Kind::Agree(wanted, found, value), declared.clone());
            }
        }
        match self.ty(value) == declared {
            true => value,
            false => self.represented(value, declared),
        }
    }
}
