//! Element-wise definitions.

use proc_macro2::TokenStream;
use quote::quote;

use super::block::Body;
use super::place::Part;
use crate::ir::{ExprId, Kind};
use crate::types::Type;

impl Body<'_> {
    /// An element-wise definition.
    pub(super) fn tabulate(&mut self, e: ExprId) -> TokenStream {
        let Kind::Tabulate {
            layout,
            variables,
            sizes,
            body,
        } = self.kind(e)
        else {
            panic!("bug in iheartmesh: no element-wise definition");
        };
        let names: Vec<TokenStream> = variables.iter().map(|v| self.variable_name(*v)).collect();
        let sizes: Vec<TokenStream> = sizes.iter().map(|s| self.owned(*s)).collect();
        let outside = self.placement.part(e, Part::Loop);
        let before = self.statements(outside, &[]);
        let ty = self.context.inner_type(self.ty(e));
        if let ([first, second], [n, m]) = (names.as_slice(), sizes.as_slice()) {
            let inside = self.placement.part(e, Part::Taken);
            let statements = self.statements(inside, &[]);
            let value = self.owned(*body);
            return quote!({
                let (n, m) = (#n, #m);
                let mut all = <#ty as rt::Build>::zeros(rt::size(n), rt::size(m));
                for #first in 1..=n {
                    #before
                    for #second in 1..=m {
                        #statements
                        let value = #value;
                        rt::Build::set(&mut all, (#first - 1) as usize, (#second - 1) as usize, value);
                    }
                }
                all
            });
        }
        let (first, n) = (&names[0], &sizes[0]);
        match layout {
            crate::ir::Layout::Vector | crate::ir::Layout::Matrix => {
                let value = self.owned(*body);
                quote!({
                    let n = #n;
                    let mut all = <#ty as rt::Build>::zeros(rt::size(n), 1);
                    for #first in 1..=n {
                        #before
                        let value = #value;
                        rt::Build::set(&mut all, (#first - 1) as usize, 0, value);
                    }
                    all
                })
            }
            crate::ir::Layout::Sequence | crate::ir::Layout::Diagonal => {
                let value = self.owned(*body);
                let finish = match layout {
                    crate::ir::Layout::Diagonal => quote!(rt::sparse_diagonal(&all)),
                    _ => quote!(all),
                };
                quote!({
                    let mut all = ::std::vec::Vec::new();
                    for #first in 1..=(#n) {
                        #before
                        all.push(#value);
                    }
                    #finish
                })
            }
            crate::ir::Layout::Rows | crate::ir::Layout::Columns => {
                let value = self.owned(*body);
                // without items the type says how long they would be
                let length = match self.ty(*body) {
                    Type::Vector { length, .. } => self.context.known_size(length, &self.sizes),
                    _ => None,
                };
                let length = length.map_or(quote!(0usize), |n| quote!(rt::size(#n)));
                let (rows, columns, put) = match layout {
                    crate::ir::Layout::Rows => (
                        quote!(items.len()),
                        quote!(items.first().map_or(#length, |item| rt::Array::rows(item))),
                        quote!(rt::Array::entry(&items[i], j, 0)),
                    ),
                    _ => (
                        quote!(items.first().map_or(#length, |item| rt::Array::rows(item))),
                        quote!(items.len()),
                        quote!(rt::Array::entry(&items[j], i, 0)),
                    ),
                };
                quote!({
                    let mut items = ::std::vec::Vec::new();
                    for #first in 1..=(#n) {
                        #before
                        items.push(#value);
                    }
                    <#ty as rt::Build>::build(#rows, #columns, |i, j| #put)
                })
            }
        }
    }
}
