//! Element-wise definitions.

use proc_macro2::TokenStream;
use quote::quote;

use super::block::Body;
use super::place::Part;
use crate::ir::{ExprId, Kind, Layout, Range, VariableId};
use crate::types::Type;

/// An index of an element-wise definition: an element, or an integer from 1.
struct Index {
    name: TokenStream,
    is_element: bool,
}

impl Index {
    /// What it runs over, where there are `n`.
    fn range(&self, n: &TokenStream) -> TokenStream {
        match self.is_element {
            true => quote!(0..#n as u32),
            false => quote!(1..=#n),
        }
    }

    /// Where its value stands, from 0.
    fn place(&self) -> TokenStream {
        let name = &self.name;
        match self.is_element {
            true => quote!(#name as usize),
            false => quote!((#name - 1) as usize),
        }
    }
}

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
        let arena = &self.context.program().arena;
        let indices: Vec<Index> = variables.iter().map(|v| self.index(*v)).collect();
        let sizes: Vec<TokenStream> = sizes.iter().map(|s| self.owned(*s)).collect();
        let outside = self.placement.part(e, Part::Loop);
        let before = self.statements(outside, &[]);
        let ty = self.context.inner_type(self.ty(e));
        if let ([first, second], [n, m]) = (indices.as_slice(), sizes.as_slice()) {
            let inside = self.placement.part(e, Part::Taken);
            let statements = self.statements(inside, &[]);
            let value = self.owned(*body);
            let (row, column) = (first.place(), second.place());
            let (start, put, finish) = match layout {
                Layout::Sparse => (
                    quote!(rt::sparse_blocks(rt::size(n), rt::size(m))),
                    quote!(rt::put_sparse(&mut all, #row, #column, &value)),
                    quote!(all.to_csc()),
                ),
                _ => (
                    quote!(<#ty as rt::Build>::zeros(rt::size(n), rt::size(m))),
                    quote!(rt::Build::set(&mut all, #row, #column, value)),
                    quote!(all),
                ),
            };
            let (rows, columns) = (first.range(&quote!(n)), second.range(&quote!(m)));
            let (first, second) = (&first.name, &second.name);
            return quote!({
                let (n, m) = (#n, #m);
                let mut all = #start;
                for #first in #rows {
                    #before
                    for #second in #columns {
                        #statements
                        let value = #value;
                        #put;
                    }
                }
                #finish
            });
        }
        let kind = match arena.variable_type(variables[0]) {
            Type::Element(element) => Some(element.kind),
            _ => None,
        };
        let named = kind.is_some() && self.may_fail(*body) && self.may_name_rounds(e);
        // each item by itself, or all in a closure that can be called again
        let looped = |range: TokenStream,
                      n: TokenStream,
                      first: &TokenStream,
                      inside: TokenStream| match named {
            false => quote!(for #first in #range { #inside }),
            true => {
                let kind = super::heads::kind_name(kind);
                quote! {
                    rt::rounds(#kind, #n, |range| {
                        for #first in range.start as u32..range.end as u32 { #inside }
                        ::std::result::Result::Ok(())
                    })?;
                }
            }
        };
        let (n, place) = (&sizes[0], indices[0].place());
        let (first, range) = (&indices[0].name, indices[0].range(&quote!((#n))));
        match layout {
            Layout::Vector | Layout::Matrix | Layout::Sparse => {
                let value = self.owned(*body);
                let range = indices[0].range(&quote!(n));
                let inside =
                    quote!(#before let value = #value; rt::Build::set(&mut all, #place, 0, value););
                let looped = looped(range, quote!(rt::size(n)), first, inside);
                quote!({
                    let n = #n;
                    let mut all = <#ty as rt::Build>::zeros(rt::size(n), 1);
                    #looped
                    all
                })
            }
            Layout::Sequence | Layout::Diagonal => {
                let value = self.owned(*body);
                let finish = match layout {
                    Layout::Diagonal => quote!(rt::sparse_diagonal(&all)),
                    _ => quote!(all),
                };
                let inside = quote!(#before all.push(#value););
                let looped = looped(range, quote!(rt::size(#n)), first, inside);
                quote!({
                    let mut all = ::std::vec::Vec::new();
                    #looped
                    #finish
                })
            }
            Layout::Rows | Layout::Columns => {
                let value = self.owned(*body);
                // without items the type says how long they would be
                let length = match self.ty(*body) {
                    Type::Vector { length, .. } => self.context.known_size(length, &self.sizes),
                    _ => None,
                };
                let length = length.map_or(quote!(0usize), |n| quote!(rt::size(#n)));
                let check = crate::ir::is_of_unknown_size(self.ty(*body)).then(|| {
                    let site = self.context.site(e);
                    quote! {
                        for item in &items {
                            rt::agree(rt::Array::rows(item) as i64, rt::Array::rows(&items[0]) as i64, #site)?;
                        }
                    }
                });
                let (rows, columns, put) = match layout {
                    Layout::Rows => (
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
                    for #first in #range {
                        #before
                        items.push(#value);
                    }
                    #check
                    <#ty as rt::Build>::build(#rows, #columns, |i, j| #put)
                })
            }
        }
    }

    fn index(&self, variable: VariableId) -> Index {
        Index {
            name: self.variable_name(variable),
            is_element: self
                .context
                .program()
                .arena
                .variable_type(variable)
                .is_element(),
        }
    }

    /// A sparse matrix by the places and numbers of the members of a set.
    pub(super) fn scatter(&mut self, e: ExprId) -> TokenStream {
        let Kind::Scatter {
            variable,
            set,
            sizes: [rows, columns],
            place: [row, column],
            body,
        } = self.kind(e)
        else {
            panic!("bug in iheartmesh: no places");
        };
        let (rows, columns) = (self.owned(*rows), self.owned(*columns));
        let head = self.loop_head(*variable, &Range::Set(*set));
        let inside = self.placement.part(e, Part::Loop);
        let statements = self.statements(inside, &[]);
        let (row, column, value) = (self.owned(*row), self.owned(*column), self.owned(*body));
        let site = self.context.site(e);
        quote!({
            let mut all = rt::sparse_blocks(rt::size(#rows), rt::size(#columns));
            #head {
                #statements
                rt::add_at(&mut all, #row, #column, #value, #site)?;
            }
            all.to_csc()
        })
    }

    /// A value with entries replaced.
    pub(super) fn update(
        &mut self,
        e: ExprId,
        base: ExprId,
        entries: &[(Vec<Option<ExprId>>, ExprId)],
    ) -> TokenStream {
        let site = self.context.site(e);
        let is_sequence = matches!(self.ty(e), crate::types::Type::Sequence { .. });
        let base = self.owned(base);
        let mut sets = TokenStream::new();
        for (subscripts, value) in entries {
            let subscripts: Vec<Option<TokenStream>> = subscripts
                .iter()
                .map(|s| s.map(|s| self.owned(s)))
                .collect();
            sets.extend(match subscripts.as_slice() {
                [Some(k)] if is_sequence => {
                    let value = self.owned(*value);
                    quote!(*rt::entry_mut(&mut all, #k, #site)? = #value;)
                }
                [Some(row), None] => {
                    let value = self.reference(*value);
                    quote!(rt::set_row(&mut all, #row, #value, #site)?;)
                }
                [None, Some(column)] => {
                    let value = self.reference(*value);
                    quote!(rt::set_column(&mut all, #column, #value, #site)?;)
                }
                [Some(row), rest @ ..] => {
                    let column = rest.first().cloned().flatten().unwrap_or(quote!(1));
                    let value = self.owned(*value);
                    quote!(rt::set_at(&mut all, #row, #column, #value, #site)?;)
                }
                _ => panic!("bug in iheartmesh: no place"),
            });
        }
        quote!({
            let mut all = #base;
            #sets
            all
        })
    }
}
