//! The search over the real variables of an optimisation.

use super::Checker;
use super::scope::Scope;
use super::variable::{Real, Task};
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Kind};
use crate::syntax::ast::Declaration;
use crate::types::Type;

impl<'a> Checker<'a> {
    /// The search over the real variables.
    pub(super) fn real_optimum(&mut self, task: &Task<'a>) -> Option<ExprId> {
        let mut start = Vec::new();
        for real in &task.reals {
            let declared = match real.interval {
                Some(_) => Type::REAL,
                None => self.declared(real.declaration, real.target).ty,
            };
            let is_correct =
                !declared.is_error() && self.are_sizes_known_in(&declared, real.declaration);
            if !is_correct {
                return None;
            }
            start.push(self.start_value(task, real, &declared)?);
        }
        let mut scope = Scope::default();
        let mut variables = Vec::new();
        for (real, start) in task.reals.iter().zip(&start) {
            let ty = self.ty(*start).clone();
            variables.push(self.bind(&mut scope, real.name, ty));
        }
        let (restrictions, objective) = self.with_scope(scope, |checker| {
            let restrictions = checker.restrictions(&task.reals, &task.restrictions);
            (restrictions, checker.objective(task.objective))
        });
        let (restrictions, objective) = (restrictions?, objective?);
        let objective = self.real(objective);
        let types = variables
            .iter()
            .map(|v| self.program.arena.variable_type(*v).clone());
        let ty = Type::Tuple([Type::REAL].into_iter().chain(types).collect());
        let kind = Kind::Optimum {
            greatest: task.greatest,
            variables,
            start,
            restrictions,
            objective,
        };
        Some(self.add_at(task.e.span, kind, ty))
    }

    fn are_sizes_known_in(&mut self, ty: &Type, declaration: &Declaration) -> bool {
        !matches!(
            ty,
            Type::Vector { .. } | Type::Matrix { .. } | Type::Sequence { .. }
        ) || self.are_sizes_known(ty, declaration.span)
    }

    /// Where the search begins: at what stands behind `with initial`, otherwise at 0.
    fn start_value(&mut self, task: &Task<'a>, real: &Real<'a>, declared: &Type) -> Option<ExprId> {
        let zero = self.zeros(declared)?;
        for definition in task.initial {
            let Some(k) = definition
                .targets
                .iter()
                .position(|t| t.name.text == real.name.text)
            else {
                continue;
            };
            let value = self.definition_values(definition)[k];
            if self.is_error(value) {
                return None;
            }
            let value = self.convert(value, declared);
            let found = self.ty(value).clone();
            let fits = match (&found, declared) {
                (
                    Type::Sequence {
                        item: a, length: n, ..
                    },
                    Type::Sequence {
                        item: b, length: m, ..
                    },
                ) => a == b && !n.differs(m),
                _ => found == *declared,
            };
            if !fits {
                let (a, b) = (declared.described(), found.described());
                let message = format!(
                    "the start value of `{}` must be {a}, not {b}",
                    real.name.text
                );
                let diagnostic = Diagnostic::error(definition.value.span, message)
                    .here(format!("this is {b}"))
                    .label(real.declaration.span, format!("this is {a}"))
                    .help("a start value has the type and the size of its variable");
                let diagnostic = self.with_origins(diagnostic, &[&definition.value]);
                self.report(diagnostic);
                return None;
            }
            // the sizes of the variable are those that it is declared with
            return Some(value);
        }
        Some(zero)
    }
}
