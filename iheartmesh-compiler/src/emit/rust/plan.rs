//! Plans: their tables, and the code that fills them.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Context;
use super::block::{Body, Mode, row_name, variable_ident};
use super::place::{RegionId, Roots};
use crate::ir::{ExprId, VariableId};
use crate::optimize::{Corners, Plan, Rows, Space};
use crate::types::Element;

/// What a staged program stores once per mesh.
#[derive(Default)]
pub(super) struct PlanCode {
    /// Fields of the struct `Plans`.
    pub(super) fields: TokenStream,
    /// Statements that compute them, for `t`.
    pub(super) statements: TokenStream,
    /// Their names.
    pub(super) names: TokenStream,
    /// The functions that the statements call.
    pub(super) functions: TokenStream,
}

impl Context<'_> {
    /// The table that holds the rows of a space.
    pub(super) fn table_name(&self, space: VariableId) -> Ident {
        let table = self.staged.tables.of.get(&space).unwrap_or(&space);
        format_ident!("rows{}", table.0)
    }

    /// The code of all plans.
    pub(super) fn plans(&self) -> PlanCode {
        let mut code = PlanCode::default();
        let staged = self.staged;
        let tables = &staged.tables.plan;
        for root in tables.below(None) {
            self.tree(tables, root, &mut code);
        }
        let functions = staged.functions.values();
        for plan in functions.chain(staged.globals.values()).map(|s| &s.plan) {
            for corners in &plan.corners {
                self.turned(plan, corners, &mut code);
            }
        }
        for (id, staged) in &staged.functions {
            for local in &staged.plan.locals {
                self.local_plan(local, &mut code);
            }
            if let Some(orbit) = staged.whole.as_ref().and_then(|w| w.orbit.as_ref()) {
                self.orbit_plan(*id, orbit, &mut code);
            }
        }
        code
    }

    /// The tables of a space and of all below it.
    fn tree(&self, plan: &Plan, root: &Space, code: &mut PlanCode) {
        let mut spaces = Vec::new();
        subtree(plan, root, &mut spaces);
        let stored: Vec<&Space> = spaces.iter().copied().filter(|s| is_stored(s)).collect();
        if stored.is_empty() {
            return;
        }
        let tables: Vec<_> = stored.iter().map(|s| self.table_name(s.variable)).collect();
        let types: Vec<_> = stored.iter().map(|s| self.table_type(s)).collect();
        let build = format_ident!("build{}", root.variable.0);
        code.fields.extend(quote!(#(pub #tables: #types,)*));
        code.names.extend(quote!(#(#tables,)*));
        code.statements
            .extend(quote!(let (#(#tables,)*) = #build(t)?;));

        let mut roots = Roots::default();
        let outside = roots.region(None, None);
        let mut regions = std::collections::BTreeMap::new();
        self.regions(plan, root, outside, &mut roots, &mut regions);
        let mut body = Body::new(self, Mode::Build, plan, &roots);
        let before = body.statements(RegionId(outside), &[]);
        let fill = self.fill(plan, root, &regions, &mut body);
        // the rows of a deeper space are numbered by those of the one above it
        let is_flat = spaces
            .iter()
            .all(|s| s.variable == root.variable || s.parent == Some(root.variable));
        let (n, keys, head) = match root.rows {
            Rows::Key(element) | Rows::Universe(element) => {
                let name = variable_ident(self, root.variable);
                let keys = match is_flat {
                    true => self.keys(element),
                    false => quote!(rt::Keys::in_order()),
                };
                let around = filled_below(plan, root)
                    .find_map(|space| match space.rows {
                        Rows::Members(set) => body.faces_around(set, root.variable),
                        _ => None,
                    })
                    .filter(|_| is_flat);
                let head = match around {
                    Some(mesh) => quote!(for #name in keys.at_with_faces(t.#mesh, range)),
                    None => quote!(for #name in keys.at(range)),
                };
                (self.count(element), keys, head)
            }
            Rows::Members(_) | Rows::Corners(_) => (
                quote!(1usize),
                quote!(rt::Keys::in_order()),
                quote!(for _ in range),
            ),
        };
        let rows = stored.iter().map(|s| {
            let ty = self.table_type(s);
            quote!(<#ty as rt::Rows>::with_capacity(range.len()))
        });
        let merged = (0..stored.len()).map(Literal::usize_unsuffixed);
        code.functions.extend(quote! {
            fn #build(t: &Topology<'_>) -> ::std::result::Result<(#(#types,)*), rt::PlanError> {
                let keys = #keys;
                let mut chunks = rt::in_chunks(#n, |range: ::std::ops::Range<u32>| {
                    #(let mut #tables = #rows;)*
                    #before
                    #head { #fill }
                    ::std::result::Result::Ok((#(#tables,)*))
                })?;
                ::std::result::Result::Ok((#(keys.sorted(rt::concatenated(&mut chunks, |chunk| &mut chunk.#merged)?),)*))
            }
        });
    }

    /// The table of rows that are turned; the others stay where they are.
    fn turned(&self, plan: &Plan, corners: &Corners, code: &mut PlanCode) {
        let (Some(space), Some(of)) = (plan.space(corners.space), plan.space(corners.of)) else {
            return;
        };
        let (turned, rows) = (
            self.table_name(space.variable),
            self.table_name(of.variable),
        );
        let ty = self.table_type(space);
        let circle = corners.circle.map(Literal::u32_unsuffixed);
        let kept = corners.kept.iter().map(|k| Literal::u32_unsuffixed(*k));
        let merged = corners.merged.iter().map(|(column, place)| {
            let (column, place) = (
                Literal::u32_unsuffixed(*column),
                Literal::u32_unsuffixed(*place),
            );
            quote!((#column, #place))
        });
        code.fields.extend(quote!(pub #turned: #ty,));
        code.names.extend(quote!(#turned,));
        code.statements.extend(quote! {
            let (#turned, #rows) = rt::corners(&#rows, [#(#circle),*], &[#(#merged),*], &[#(#kept),*])?;
        });
    }

    /// The order in which the rows of all elements of a kind are made.
    pub(super) fn keys(&self, element: Element) -> TokenStream {
        let mesh = self.mesh_field(element.mesh);
        match crate::types::element_dimension(element.kind) {
            0 => quote!(rt::Keys::vertices(t.#mesh.complex())),
            _ => quote!(rt::Keys::in_order()),
        }
    }

    fn table_type(&self, space: &Space) -> TokenStream {
        let n = Literal::usize_unsuffixed(space.columns.len());
        match space.rows {
            Rows::Members(_) | Rows::Corners(_) => quote!(rt::Table<#n>),
            _ => quote!(rt::Dense<#n>),
        }
    }

    /// The regions of a space and of all below it, with what is needed in each.
    fn regions(
        &self,
        plan: &Plan,
        space: &Space,
        outside: usize,
        roots: &mut Roots,
        regions: &mut std::collections::BTreeMap<VariableId, usize>,
    ) {
        if let Rows::Members(set) = space.rows {
            roots.need(outside, set);
        }
        let inside = roots.region(Some(outside), Some(space.variable));
        regions.insert(space.variable, inside);
        for column in &space.columns {
            roots.need(inside, column.value);
        }
        for below in filled_below(plan, space) {
            self.regions(plan, below, inside, roots, regions);
        }
    }

    /// What is done for each row of a space.
    fn fill(
        &self,
        plan: &Plan,
        space: &Space,
        regions: &std::collections::BTreeMap<VariableId, usize>,
        body: &mut Body<'_>,
    ) -> TokenStream {
        let table = self.table_name(space.variable);
        let region = RegionId(regions[&space.variable]);
        let results: Vec<ExprId> = space.columns.iter().map(|c| c.value).collect();
        let name = variable_ident(self, space.variable);
        let inside = |body: &mut Body<'_>| {
            let statements = body.statements(region, &results);
            let columns: Vec<TokenStream> = space
                .columns
                .iter()
                .map(|c| self.stored(body, c.value))
                .collect();
            let push = match is_stored(space) {
                true => quote!(#table.push([#(#columns),*]);),
                false => TokenStream::new(),
            };
            let below: TokenStream = filled_below(plan, space)
                .map(|below| self.fill(plan, below, regions, body))
                .collect();
            quote!(#statements #push #below)
        };
        match space.rows {
            Rows::Members(set) => {
                let set = match body.kind(set) {
                    crate::ir::Kind::AllElements(element) => {
                        let n = self.count(*element);
                        quote!(0..#n as u32)
                    }
                    _ => {
                        let set = body.ids(set);
                        quote!((#set).iter().copied())
                    }
                };
                let inside = inside(body);
                quote! {
                    for #name in #set { #inside }
                    #table.finish_key()?;
                }
            }
            _ => inside(body),
        }
    }

    /// A column as it is stored.
    fn stored(&self, body: &mut Body<'_>, value: ExprId) -> TokenStream {
        let may_fail = body.may_fail(value);
        let owned = body.owned(value);
        let (encode, otherwise) = match body.ty(value) {
            crate::types::Type::Element(_) => (owned, quote!(unwrap_or_else(rt::missing))),
            crate::types::Type::Boolean => {
                (quote!(u32::from(#owned)), quote!(unwrap_or(rt::NO_INTEGER)))
            }
            _ => (
                quote!(rt::encoded(#owned)?),
                quote!(unwrap_or(rt::NO_INTEGER)),
            ),
        };
        match may_fail {
            true => {
                quote!((|| -> rt::Fallible<u32> { ::std::result::Result::Ok(#encode) })().#otherwise)
            }
            false => encode,
        }
    }

    /// The current row of the key of a plan, at the start of a function.
    pub(super) fn key_row(&self, plan: &Plan) -> TokenStream {
        let Some(space) = plan.spaces.iter().find(|s| matches!(s.rows, Rows::Key(_))) else {
            return TokenStream::new();
        };
        if !is_stored(space) {
            return TokenStream::new();
        }
        let (table, row) = (self.table_name(space.variable), row_name(space.variable));
        let name = variable_ident(self, space.variable);
        quote!(let #row = s.plans.#table.row(#name as usize);)
    }
}

/// Whether a space has a table: members always have one, since their number is stored.
pub(super) fn is_stored(space: &Space) -> bool {
    space.rows.is_several() || !space.columns.is_empty()
}

/// The spaces below one that are filled with it; the others are made of these.
fn filled_below<'a>(plan: &'a Plan, space: &Space) -> impl Iterator<Item = &'a Space> {
    plan.below(Some(space.variable))
        .filter(|s| !matches!(s.rows, Rows::Corners(_)))
}

fn subtree<'a>(plan: &'a Plan, root: &'a Space, found: &mut Vec<&'a Space>) {
    found.push(root);
    for below in filled_below(plan, root) {
        subtree(plan, below, found);
    }
}
