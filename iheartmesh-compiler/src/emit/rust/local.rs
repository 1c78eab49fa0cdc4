//! Values that the rows of a key share: computed before the loop over the rows, and read in it.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Context;
use super::block::{Body, Mode, row_name};
use super::plan::PlanCode;
use crate::ir::{FunctionId, Kind, VariableId};
use crate::optimize::{Local, Rows, is_read_from_row};

impl Context<'_> {
    /// The function that gives the value of a function from its row.
    pub(super) fn row_function_name(&self, id: FunctionId) -> Ident {
        format_ident!("row_{}", self.function_name(id))
    }

    /// Table, row and number of columns of a function that reads nothing but its row.
    pub(super) fn row_of_function(&self, id: FunctionId) -> Option<(Ident, Ident, Literal)> {
        if !is_read_from_row(self.staged, id) {
            return None;
        }
        let space = self.staged.functions[&id].plan.spaces.first()?;
        let n = Literal::usize_unsuffixed(space.columns.len());
        Some((self.table_name(space.variable), row_name(space.variable), n))
    }

    /// The table of local rows.
    pub(super) fn local_plan(&self, local: &Local, code: &mut PlanCode) {
        let Some((of, _, n)) = self.row_of_function(local.function) else {
            return;
        };
        let (name, table) = (plan_name(local), self.table_name(local.space));
        let count = Literal::usize_unsuffixed(local.calls.len());
        let columns = local.calls.iter().map(|c| Literal::u32_unsuffixed(c.1));
        code.fields
            .extend(quote!(pub #name: rt::Locals<#n, #count>,));
        code.names.extend(quote!(#name,));
        code.statements
            .extend(quote!(let #name = rt::Locals::build(&#table, [#(#columns),*], &#of)?;));
    }
}

impl Body<'_> {
    fn locals_of(&self, space: VariableId) -> Vec<Local> {
        let of_space = |l: &&Local| l.space == space && self.mode == Mode::Dynamic;
        self.plan.locals.iter().filter(of_space).cloned().collect()
    }

    /// What is computed before the loop over the rows of a space; its calls are read from there.
    pub(super) fn bind_locals(&mut self, space: VariableId) -> TokenStream {
        let mut statements = TokenStream::new();
        for local in self.locals_of(space) {
            let (plan, values, slots) =
                (plan_name(&local), values_name(&local), slots_name(&local));
            let function = self.context.row_function_name(local.function);
            let Some(parent) = self.plan.space(space).and_then(|s| s.parent) else {
                continue;
            };
            let key = self.row_number(parent);
            statements.extend(
                quote!(let #values = s.plans.#plan.values(#key, |row| #function(s, row))?;),
            );
            for (k, (call, _)) in local.calls.iter().enumerate() {
                let Kind::Call(_, arguments) = self.kind(*call) else {
                    continue;
                };
                let (k, site) = (
                    Literal::usize_unsuffixed(k),
                    self.context.site(self.column_value(arguments[0])),
                );
                let value = quote!((*rt::of_element(&#values[..], #slots[#k], #site)?));
                self.calls.insert(*call, value);
            }
        }
        statements
    }

    /// `for row in rows`, with the slots of local values beside each row.
    pub(super) fn with_slots(
        &self,
        space: VariableId,
        row: TokenStream,
        rows: TokenStream,
        key: &TokenStream,
    ) -> TokenStream {
        let locals = self.locals_of(space);
        let is_below_key = self
            .plan
            .space(space)
            .and_then(|s| self.plan.space(s.parent?))
            .is_some_and(|parent| matches!(parent.rows, Rows::Key(_)));
        if locals.is_empty() || !is_below_key {
            return quote!(for #row in #rows);
        }
        let table = self.context.table_name(space);
        let (mut pattern, mut iterator) = (row, quote!(#rows.iter()));
        for local in &locals {
            let (plan, slots) = (plan_name(local), slots_name(local));
            pattern = quote!((#pattern, #slots));
            iterator = quote!(#iterator.zip(s.plans.#plan.slots(s.plans.#table.range(#key))));
        }
        quote!(for #pattern in #iterator)
    }
}

fn plan_name(local: &Local) -> Ident {
    format_ident!("locals{}_{}", local.space.0, local.function.0)
}

fn values_name(local: &Local) -> Ident {
    format_ident!("local{}_{}", local.space.0, local.function.0)
}

fn slots_name(local: &Local) -> Ident {
    format_ident!("slots{}_{}", local.space.0, local.function.0)
}
