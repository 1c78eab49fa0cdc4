//! Heads of loops: over sets, integers and the rows of a plan.

use proc_macro2::TokenStream;
use quote::quote;

use super::block::{Body, Mode, is_copy, number_name, row_name};
use super::slots::is_in_rounds;
use crate::ir::{ExprId, Fold, Kind, Range, VariableId};
use crate::optimize::Rows;
use crate::types::{Element, ElementKind, Type};

impl Body<'_> {
    /// `for … in …`, binding what the inside of a loop needs.
    pub(super) fn loop_head(&mut self, variable: VariableId, range: &Range) -> TokenStream {
        if self.rounds == Some(variable) {
            return self.rounds_head(variable, range);
        }
        let name = self.variable_name(variable);
        match range {
            Range::Integers(from, to) => {
                let (from, to) = (self.owned(*from), self.owned(*to));
                quote!(for #name in (#from)..=(#to))
            }
            Range::Set(set) => match (self.kind(*set), self.ty(*set)) {
                (Kind::AllElements(element), _) => {
                    let n = self.context.count(*element);
                    quote!(for #name in 0..#n as u32)
                }
                (_, ty) if ty.element_of_set().is_some() => {
                    if let Some(head) = self.column_with_signs(variable, *set) {
                        return head;
                    }
                    let set = self.ids(*set);
                    quote!(for &#name in #set)
                }
                (_, Type::Set(item)) if is_copy(item) => {
                    let set = self.reference(*set);
                    quote!(for &#name in (#set).iter())
                }
                _ => {
                    let set = self.reference(*set);
                    quote!(for #name in (#set).iter())
                }
            },
            Range::Rows { .. } => self.rows_head(variable),
        }
    }

    /// A loop over the rows of a plan.
    fn rows_head(&mut self, variable: VariableId) -> TokenStream {
        let Some(space) = self.plan.space(variable) else {
            panic!("bug in iheartmesh: no rows for a loop");
        };
        let table = self.context.table_name(variable);
        let row = row_name(variable);
        let name = self.variable_name(variable);
        match space.rows {
            Rows::Universe(element) => {
                let n = self.context.count(element);
                match space.columns.is_empty() {
                    true => quote!(for #name in 0..#n as u32),
                    false => quote!(for (#name, #row) in s.plans.#table.enumerate()),
                }
            }
            Rows::Members(_) | Rows::Corners(_) => {
                let parent = match space.parent {
                    None => quote!(0),
                    Some(parent) => self.row_number(parent),
                };
                let has_inner = self.plan.below(Some(variable)).next().is_some();
                match has_inner {
                    true => {
                        let number = number_name(variable);
                        quote!(for (#number, #row) in s.plans.#table.enumerate_rows_of(#parent))
                    }
                    false => self.with_slots(
                        variable,
                        quote!(#row),
                        match self.plan.corners.iter().any(|c| c.of == variable) {
                            true => quote!(s.plans.#table.few_rows_of(#parent)),
                            false => quote!(s.plans.#table.rows_of(#parent)),
                        },
                        &parent,
                    ),
                }
            }
            Rows::Key(_) => panic!("bug in iheartmesh: a loop over the key of a plan"),
        }
    }

    /// A loop over the rows of an outermost space with their numbers in `range`.
    fn some_rows_head(&mut self, variable: VariableId) -> TokenStream {
        let (table, row) = (self.context.table_name(variable), row_name(variable));
        let name = self.variable_name(variable);
        let is_universe = self
            .plan
            .space(variable)
            .map(|space| (space.rows, space.columns.is_empty()));
        match is_universe {
            Some((Rows::Universe(_), true)) => {
                quote!(for #name in range.start as u32..range.end as u32)
            }
            Some((Rows::Universe(_), false)) => {
                quote!(for (#name, #row) in s.plans.#table.enumerate_some(range.clone()))
            }
            _ if self.plan.below(Some(variable)).next().is_some() => {
                let number = number_name(variable);
                quote!(for (#number, #row) in s.plans.#table.enumerate_rows_of(0).skip(range.start).take(range.len()))
            }
            _ => quote!(for #row in &s.plans.#table.rows_of(0)[range.clone()]),
        }
    }

    /// The number of the current row of a space.
    pub(super) fn row_number(&self, variable: VariableId) -> TokenStream {
        match self.plan.space(variable).map(|s| s.rows) {
            Some(rows) if rows.is_several() => {
                let number = number_name(variable);
                quote!(#number)
            }
            _ => {
                let name = self.variable_name(variable);
                quote!(#name as usize)
            }
        }
    }

    /// The rounds of a sum that is done in pieces, by several threads where there are many: one over elements, not inside of
    /// another loop. Of which kind these are if they are all of a mesh, and how many.
    pub(super) fn rounds_of_total(&self, e: ExprId) -> Option<TokenStream> {
        let Kind::Fold {
            op: Fold::Sum,
            variable,
            range,
            ..
        } = self.kind(e)
        else {
            return None;
        };
        let ty = self.ty(e);
        let is_number = is_copy(ty) && !ty.is_integer();
        if self.mode != Mode::Dynamic
            || !is_number
            || !self.may_name_rounds(e)
            || !is_in_rounds(self.context, self.plan, e)
        {
            return None;
        }
        let n = match range {
            Range::Integers(..) => return None,
            _ => match self.element_of_rounds(e) {
                Some(element) => self.context.count(element),
                None => {
                    let table = self.context.table_name(*variable);
                    quote!(s.plans.#table.range(0).len())
                }
            },
        };
        let kind = self.kind_of_rounds(e);
        Some(quote!(#kind, #n))
    }

    /// The rounds of a loop over all elements that may fail in one of them, not inside of another loop, so that this one
    /// is named: of which kind they are, and how many.
    pub(super) fn rounds_with_names(&self, e: ExprId) -> Option<TokenStream> {
        let Kind::Fold {
            body, condition, ..
        } = self.kind(e)
        else {
            return None;
        };
        let element = self.element_of_rounds(e)?;
        let may_fail = self.may_fail(*body) || condition.is_some_and(|c| self.may_fail(c));
        if !may_fail || !self.may_name_rounds(e) {
            return None;
        }
        let (kind, n) = (kind_name(Some(element.kind)), self.context.count(element));
        Some(quote!(#kind, #n))
    }

    /// Whether a loop is where its rounds can be done once more.
    pub(super) fn may_name_rounds(&self, e: ExprId) -> bool {
        self.mode != Mode::Build && self.slots.is_none() && !self.placement.is_in_loop(e)
    }

    /// Of which elements the rounds of a loop are, if they are all of a mesh in order.
    fn element_of_rounds(&self, fold: ExprId) -> Option<Element> {
        let Kind::Fold {
            variable, range, ..
        } = self.kind(fold)
        else {
            return None;
        };
        match range {
            Range::Integers(..) => None,
            Range::Set(set) => match self.kind(*set) {
                Kind::AllElements(element) => Some(*element),
                _ => None,
            },
            Range::Rows { .. } => match self.plan.space(*variable)?.rows {
                Rows::Universe(element) => Some(element),
                _ => None,
            },
        }
    }

    /// The kind of these elements, so that what fails can name one.
    pub(super) fn kind_of_rounds(&self, fold: ExprId) -> TokenStream {
        kind_name(self.element_of_rounds(fold).map(|element| element.kind))
    }

    /// The head of the loop over a variable, for the rounds in `range`.
    fn rounds_head(&mut self, variable: VariableId, range: &Range) -> TokenStream {
        let name = self.variable_name(variable);
        match range {
            Range::Integers(from, _) => {
                let from = self.owned(*from);
                quote!(for #name in (#from + range.start as i64)..(#from + range.end as i64))
            }
            Range::Set(_) => quote!(for #name in range.start as u32..range.end as u32),
            Range::Rows { .. } => self.some_rows_head(variable),
        }
    }
}

/// A kind of elements, or none, as generated code names it.
pub(super) fn kind_name(kind: Option<ElementKind>) -> TokenStream {
    let kind = match kind {
        None => return quote!(::std::option::Option::None),
        Some(ElementKind::Vertex) => quote!(Vertex),
        Some(ElementKind::Edge) => quote!(Edge),
        Some(ElementKind::Face) => quote!(Face),
        Some(ElementKind::Cell) => quote!(Cell),
    };
    quote!(::std::option::Option::Some(rt::ElementKind::#kind))
}
