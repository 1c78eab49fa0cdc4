//! Blocks whose eigenvalues are replaced and whose number of rows the mesh decides, in sums with planned places: the sum of a
//! loop around an element, say. The plan lists the rows of each and where its parts go among them; the values of the parts are
//! added in the same order.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::block::Body;
use super::place::Part;
use super::slots::{Added, Step};
use crate::ir::{Binary, Block, ExprId, Kind, Unary};

impl Body<'_> {
    /// Statements that note the places of a block; `steps` notes those of its parts.
    pub(super) fn places_of_local(&mut self, step: &Step, steps: &TokenStream) -> TokenStream {
        let Step::Local {
            array,
            height,
            added,
            ..
        } = step
        else {
            panic!("bug in iheartmesh: no block");
        };
        let [array, height] = [*array, *height].map(Literal::usize_unsuffixed);
        let end = match added {
            Added::Block => quote!(places.end_local(#height);),
            Added::Vector => quote!(places.end_local_product(#height, 1);),
            Added::Columns(columns) => {
                let columns = self.owned(*columns);
                quote!(places.end_local_product(#height, rt::size(#columns));)
            }
        };
        quote!(places.array(#array); places.start_local(); #steps #end)
    }

    /// The block with its eigenvalues replaced, or its product with a vector or a dense matrix.
    pub(super) fn local(&mut self, op: Unary, a: ExprId, factor: Option<ExprId>) -> TokenStream {
        let (steps, array) = (self.local_sum(a), self.array_number());
        let part = match op {
            Unary::PositivePart => quote!(rt::Part::Positive),
            _ => quote!(rt::Part::Absolute),
        };
        let end = match factor {
            None => quote!(terms[#array].end_local(#part);),
            Some(factor) => {
                let factor = self.reference(factor);
                quote!(terms[#array].end_local_product(#part, #factor);)
            }
        };
        quote!(terms[#array].start_local(); #steps #end)
    }

    /// Statements that add to the block.
    fn local_sum(&mut self, e: ExprId) -> TokenStream {
        let array = self.array_number();
        match self.kind(e) {
            Kind::Assemble { blocks, .. } => {
                let blocks = blocks.iter().map(|block| self.add_to_local(e, block));
                blocks.collect()
            }
            Kind::Unary(Unary::Negate, a) => {
                let steps = self.local_sum(*a);
                self.scaled_local(&quote!(-1.0), &steps)
            }
            Kind::Binary(Binary::Multiply, k, a) => {
                let (k, steps) = (self.owned(*k), self.local_sum(*a));
                self.scaled_local(&k, &steps)
            }
            Kind::Binary(Binary::Divide, a, k) => {
                let (k, steps) = (self.owned(*k), self.local_sum(*a));
                self.scaled_local(&quote!(1.0 / #k), &steps)
            }
            Kind::Binary(Binary::Subtract, a, b) => {
                let (a, b) = (self.local_sum(*a), self.local_sum(*b));
                let b = self.scaled_local(&quote!(-1.0), &b);
                quote!(#a #b)
            }
            Kind::Binary(_, a, b) => {
                let (a, b) = (self.local_sum(*a), self.local_sum(*b));
                quote!(#a #b)
            }
            Kind::If(condition, a, b) => {
                let condition = self.owned(*condition);
                let branches = [(Part::Then, *a), (Part::Else, *b)].map(|(part, value)| {
                    let region = self.placement.part(e, part);
                    let statements = self.statements(region, &[]);
                    let steps = self.local_sum(value);
                    quote!(#statements #steps)
                });
                let [then, otherwise] = branches;
                match self.local_branch(e) {
                    None | Some(true) => {
                        quote!(if #condition { #then } else { #otherwise })
                    }
                    Some(false) => quote! {
                        if #condition {
                            terms[#array].enter_local();
                            #then
                            terms[#array].pass_local();
                        } else {
                            terms[#array].pass_local();
                            terms[#array].enter_local();
                            #otherwise
                        }
                    },
                }
            }
            Kind::Fold { body, .. } => {
                let body = *body;
                let (start, otherwise) = match self.local_branch(e) {
                    None => (TokenStream::new(), TokenStream::new()),
                    Some(_) => (
                        quote!(terms[#array].enter_local();),
                        quote!(else { terms[#array].pass_local(); }),
                    ),
                };
                let step = |this: &mut Self| {
                    let steps = this.local_sum(body);
                    quote!(#start #steps)
                };
                self.looped_or(e, step, otherwise)
            }
            other => panic!("bug in iheartmesh: no blocks in {other:?}"),
        }
    }

    /// Of a choice or loop whose condition depends on values, whether both branches are at the same places.
    fn local_branch(&self, e: ExprId) -> Option<bool> {
        self.slots
            .and_then(|sum| sum.local_branches.get(&e).copied())
    }

    fn scaled_local(&self, factor: &TokenStream, steps: &TokenStream) -> TokenStream {
        let array = self.array_number();
        quote!({
            let around = terms[#array].scale_local(#factor);
            #steps
            terms[#array].set_local_scale(around);
        })
    }

    fn add_to_local(&mut self, e: ExprId, block: &Block) -> TokenStream {
        let value = self.reference(block.value);
        let (site, array) = (self.context.site(e), self.array_number());
        let [rows, columns] =
            [&block.rows, &block.columns].map(|places| Literal::usize_unsuffixed(places.len()));
        let core = block.core.and_then(|core| {
            let (n, _) = self.context.fixed_shape(core)?;
            Some((core, Literal::usize_unsuffixed(n)))
        });
        let known = match core {
            None => quote!(terms[#array].without_core();),
            Some((core, n)) => {
                let core = self.reference(core);
                quote!(terms[#array].with_core::<#n>(#core);)
            }
        };
        quote!(terms[#array].add_local::<#rows, #columns>(#value, #site)?; #known)
    }
}
