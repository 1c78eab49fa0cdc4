//! Arrays that blocks are added to: one buffer, with loops and branches that add to it. The entries of sparse ones are collected
//! and sorted; where their places are known beforehand, [`super::slots`] does better.

use proc_macro2::TokenStream;
use quote::quote;

use super::block::Body;
use super::place::Part;
use crate::ir::{Binary, Block, ExprId, Fold, Kind, Unary};

impl Body<'_> {
    /// Whether an expression is a sum of blocks, over loops and in branches.
    pub(super) fn is_assembled(&self, e: ExprId) -> bool {
        match self.kind(e) {
            Kind::Assemble { .. } => true,
            Kind::Binary(Binary::Add, a, b) | Kind::If(_, a, b) if !self.ty(e).is_scalar() => {
                self.is_assembled(*a) || self.is_assembled(*b)
            }
            Kind::Fold {
                op: Fold::Sum,
                body,
                ..
            } if !self.ty(e).is_scalar() => self.is_assembled(*body),
            // a sparse block by itself, before it is added
            Kind::Unary(Unary::PositivePart | Unary::AbsolutePart, a)
            | Kind::Binary(Binary::Multiply, _, a)
                if self.ty(e).is_sparse() =>
            {
                self.is_assembled(*a)
            }
            // a multiple of such a product
            Kind::Binary(Binary::Multiply, _, a) => self.is_product_of_block(*a),
            _ => self.is_product_of_block(e),
        }
    }

    /// Whether an expression is the product of a sparse block whose eigenvalues are replaced, and a vector or dense matrix.
    fn is_product_of_block(&self, e: ExprId) -> bool {
        match self.kind(e) {
            Kind::Binary(Binary::Product, block, factor) => {
                matches!(
                    self.kind(*block),
                    Kind::Unary(Unary::PositivePart | Unary::AbsolutePart, _)
                ) && self.ty(*block).is_sparse()
                    && !self.ty(*factor).is_sparse()
                    && self.is_assembled(*block)
            }
            _ => false,
        }
    }

    /// The sizes of a sum of blocks.
    fn assembled_sizes(&mut self, e: ExprId) -> Option<Vec<TokenStream>> {
        match self.kind(e) {
            Kind::Assemble { sizes, .. } => Some(sizes.iter().map(|s| self.owned(*s)).collect()),
            Kind::Binary(Binary::Product, block, factor) if self.is_product_of_block(e) => {
                let mut sizes = self.assembled_sizes(*block)?;
                sizes.truncate(1);
                let factor = self.reference(*factor);
                sizes.push(quote!((rt::Array::columns(#factor) as i64)));
                Some(sizes)
            }
            Kind::Binary(Binary::Add, a, b) | Kind::If(_, a, b) => {
                let first = self.assembled_sizes(*a);
                first.or_else(|| self.assembled_sizes(*b))
            }
            Kind::Fold { body: a, .. }
            | Kind::Unary(_, a)
            | Kind::Binary(Binary::Multiply, _, a) => self.assembled_sizes(*a),
            _ => None,
        }
    }

    /// A sum of blocks in a buffer of its own.
    pub(super) fn assemble(&mut self, e: ExprId) -> TokenStream {
        let Some(sizes) = self.assembled_sizes(e) else {
            panic!("bug in iheartmesh: blocks without a size");
        };
        let rows = &sizes[0];
        let columns = sizes.get(1).cloned().unwrap_or(quote!(1i64));
        let sparse = self.ty(e).is_sparse();
        let start = match sparse {
            true => quote!(rt::Triplets::new(rt::size(#rows), rt::size(#columns))),
            false => {
                let ty = self.context.inner_type(self.ty(e));
                quote!(<#ty as rt::Build>::zeros(rt::size(#rows), rt::size(#columns)))
            }
        };
        let steps = self.assembling(e);
        let finish = match sparse {
            true => quote!(all.into_matrix()),
            false => quote!(all),
        };
        quote!({ let mut all = #start; #steps #finish })
    }

    /// Statements that add an expression to `all`.
    fn assembling(&mut self, e: ExprId) -> TokenStream {
        // zeros, which may have a name
        if matches!(self.kind(e), Kind::Assemble { blocks, .. } if blocks.is_empty()) {
            return TokenStream::new();
        }
        if self.names.contains_key(&e) || !self.is_assembled(e) {
            let value = self.reference(e);
            return quote!(rt::add_all(&mut all, #value););
        }
        match self.kind(e) {
            Kind::Assemble { blocks, .. } => {
                let blocks: Vec<TokenStream> = blocks
                    .iter()
                    .map(|block| self.add_block(e, block))
                    .collect();
                quote!(#(#blocks)*)
            }
            Kind::Unary(op, a) => {
                let block = self.block_of(*a);
                let part = replacing(*op);
                quote!({ let block = #block; rt::add_with_eigenvalues(&mut all, block, #part); })
            }
            Kind::Binary(Binary::Multiply, k, a) => {
                let k = self.owned(*k);
                let block = self.block_of(*a);
                quote!({ let (k, block) = (#k, #block); rt::add_scaled(&mut all, k, block); })
            }
            Kind::Binary(Binary::Product, block, factor) => {
                let Kind::Unary(op, a) = self.kind(*block) else {
                    panic!("bug in iheartmesh: no block");
                };
                let part = replacing(*op);
                let (steps, factor) = (self.assembling(*a), self.reference(*factor));
                quote!({
                    let rows = rt::Accumulate::sizes(&all).0;
                    let block = {
                        let mut all = rt::Triplets::new(rows, rows);
                        #steps
                        all
                    };
                    rt::add_product_with_eigenvalues(&mut all, block, #part, #factor);
                })
            }
            Kind::Binary(_, a, b) => {
                let (a, b) = (self.assembling(*a), self.assembling(*b));
                quote!(#a #b)
            }
            Kind::If(condition, a, b) => {
                let condition = self.owned(*condition);
                let branch = |this: &mut Self, part, value| {
                    let region = this.placement.part(e, part);
                    let statements = this.statements(region, &[]);
                    let steps = this.assembling(value);
                    quote!({ #statements #steps })
                };
                let then = branch(self, Part::Then, *a);
                let otherwise = branch(self, Part::Else, *b);
                quote!(if #condition #then else #otherwise)
            }
            Kind::Fold { body, .. } => {
                let body = *body;
                self.looped(e, |this| this.assembling(body))
            }
            other => panic!("bug in iheartmesh: no blocks in {other:?}"),
        }
    }

    /// The entries of a sparse sum of blocks, not yet sorted.
    fn block_of(&mut self, e: ExprId) -> TokenStream {
        let steps = self.assembling(e);
        quote!({
            let (rows, columns) = rt::Accumulate::sizes(&all);
            let mut all = rt::Triplets::new(rows, columns);
            #steps
            all
        })
    }

    fn add_block(&mut self, e: ExprId, block: &Block) -> TokenStream {
        let value = self.reference(block.value);
        let site = self.context.site(e);
        let rows = self.places(&block.rows);
        match block.columns.is_empty() {
            true => quote!(rt::add_entries(&mut all, [#(#rows),*], #value, #site)?;),
            false => {
                let columns = self.places(&block.columns);
                quote!(rt::add_block(&mut all, [#(#rows),*], [#(#columns),*], #value, #site)?;)
            }
        }
    }

    /// Places from 0.
    pub(super) fn places(&mut self, places: &[ExprId]) -> Vec<TokenStream> {
        places
            .iter()
            .map(|place| {
                let value = self.owned(*place);
                match self.ty(*place).is_element() {
                    true => quote!(#value as usize),
                    false => quote!((#value).wrapping_sub(1) as usize),
                }
            })
            .collect()
    }
}

/// What replaces an eigenvalue.
fn replacing(op: Unary) -> TokenStream {
    match op {
        Unary::PositivePart => quote!(|value| value.max(0.0)),
        _ => quote!(f64::abs),
    }
}
