//! Vectors and matrices: what is written with operators is in `expr`, the rest is here.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::block::{Body, is_copy};
use super::expr::elementary;
use super::types::is_glam;
use crate::ir::{Axis, Binary, ExprId, Kind, Unary};
use crate::types::Type;

impl Body<'_> {
    /// Whether [`Body::array`] knows an expression.
    pub(super) fn is_array(&self, e: ExprId) -> bool {
        matches!(
            self.kind(e),
            Kind::Vector(_)
                | Kind::Component(..)
                | Kind::Extent(..)
                | Kind::Size(_)
                | Kind::At(..)
                | Kind::RowOf(..)
                | Kind::ColumnOf(..)
                | Kind::Blocks(_)
                | Kind::Filled(..)
                | Kind::Identity(_)
                | Kind::Sequence(_)
                | Kind::SequenceOf(_)
                | Kind::HostCall(..)
                | Kind::Agree(..)
        )
    }

    /// Vectors and matrices by their entries and blocks, their entries and sizes.
    pub(super) fn array(&mut self, e: ExprId) -> TokenStream {
        let inner = || self.context.inner_type(self.ty(e));
        match self.kind(e) {
            Kind::Vector(items) => {
                let ty = inner();
                let glam = is_glam(self.ty(e));
                let n = items.len();
                let items: Vec<TokenStream> = items.iter().map(|i| self.owned(*i)).collect();
                match glam {
                    true => quote!(#ty::new(#(#items),*)),
                    false => {
                        let n = Literal::usize_unsuffixed(n);
                        quote!({
                            let entries = [#(#items),*];
                            <#ty as rt::Build>::build(#n, 1, |i, _| entries[i])
                        })
                    }
                }
            }
            Kind::Component(vector, index) => {
                let glam = is_glam(self.ty(*vector));
                let fixed = self.ty(*vector).fixed_vector().is_some();
                let a = self.reference(*vector);
                match self.kind(*index) {
                    Kind::Integer(k) if fixed => {
                        let k = Literal::i64_unsuffixed(*k - 1);
                        match glam {
                            true => {
                                let a = self.owned(*vector);
                                quote!((#a)[#k])
                            }
                            false => quote!((#a)[#k]),
                        }
                    }
                    _ => {
                        let index = self.owned(*index);
                        let site = self.context.site(e);
                        quote!(rt::entry_at(#a, #index, 1, #site)?)
                    }
                }
            }
            Kind::Extent(a, axis) => {
                let sequence = matches!(self.ty(*a), Type::Sequence { .. });
                let a = match self.kind(*a) {
                    Kind::Input(id) if sequence => {
                        let field = self.context.input_field(*id);
                        quote!(#field)
                    }
                    _ => self.reference(*a),
                };
                match (sequence, axis) {
                    (true, _) => quote!(((#a).len() as i64)),
                    (false, 0) => quote!((rt::Array::rows(#a) as i64)),
                    (false, _) => quote!((rt::Array::columns(#a) as i64)),
                }
            }
            Kind::Size(size) => self.context.size(size),
            Kind::At(a, i, j) if crate::optimize::is_within(&self.context.program().arena, e) => {
                let a = self.reference(*a);
                let places = [i, j].map(|k| match self.kind(*k) {
                    Kind::Integer(k) => Literal::i64_unsuffixed(*k - 1),
                    _ => Literal::i64_unsuffixed(0),
                });
                let [i, j] = places;
                quote!(rt::Array::entry(#a, #i, #j))
            }
            Kind::At(a, i, j) => {
                let site = self.context.site(e);
                let (a, i, j) = (self.reference(*a), self.owned(*i), self.owned(*j));
                quote!(rt::entry_at(#a, #i, #j, #site)?)
            }
            Kind::RowOf(a, i) => {
                let (site, ty) = (self.context.site(e), inner());
                let (a, i) = (self.reference(*a), self.owned(*i));
                quote!(rt::row::<#ty>(#a, #i, #site)?)
            }
            Kind::ColumnOf(a, i) => {
                let (site, ty) = (self.context.site(e), inner());
                let (a, i) = (self.reference(*a), self.owned(*i));
                quote!(rt::column::<#ty>(#a, #i, #site)?)
            }
            Kind::Blocks(rows) => self.blocks(e, rows),
            Kind::Filled(_, sizes) if self.ty(e).is_sparse() => {
                let sizes = sizes.iter().map(|s| self.owned(*s));
                quote!(rt::sparse_zeros(#(rt::size(#sizes)),*))
            }
            Kind::Filled(value, sizes) => {
                let ty = inner();
                let value = self.owned(*value);
                let sizes: Vec<TokenStream> = sizes.iter().map(|s| self.owned(*s)).collect();
                let columns = sizes.get(1).cloned().unwrap_or(quote!(1i64));
                let (rows, site) = (&sizes[0], self.context.site(e));
                if !self.may_fail(e) {
                    return quote!(<#ty as rt::Build>::build(rt::size(#rows), rt::size(#columns), |_, _| #value));
                }
                quote!(rt::filled::<#ty>(#rows, #columns, #value, #site)?)
            }
            Kind::Identity(n) if self.ty(e).is_sparse() => {
                let n = self.owned(*n);
                quote!(rt::sparse_identity(rt::size(#n)))
            }
            Kind::Identity(n) => {
                let (ty, site) = (inner(), self.context.site(e));
                let n = self.owned(*n);
                if !self.may_fail(e) {
                    return quote!(rt::identity::<#ty>(rt::size(#n)));
                }
                quote!(rt::identity_of::<#ty>(#n, #site)?)
            }
            Kind::Sequence(items) => {
                let items: Vec<TokenStream> = items.iter().map(|i| self.owned(*i)).collect();
                quote!(::std::vec![#(#items),*])
            }
            Kind::SequenceOf(set) => match self.ty(*set).element_of_set().is_some() {
                true => {
                    let set = self.ids(*set);
                    quote!((#set).to_vec())
                }
                false => {
                    let set = self.reference(*set);
                    quote!((#set).iter().cloned().collect::<::std::vec::Vec<_>>())
                }
            },
            Kind::HostCall(function, arguments) => {
                let function = self.host_function(*function);
                let arguments: Vec<TokenStream> = arguments
                    .iter()
                    .map(|a| {
                        let value = self.owned(*a);
                        self.context.to_outer(value, self.ty(*a))
                    })
                    .collect();
                let call = quote!((#function)(#(#arguments),*));
                self.context.given_by_host(call, self.ty(e))
            }
            Kind::Agree(a, b, value) => {
                let site = self.context.site(e);
                let (a, b, value) = (self.owned(*a), self.owned(*b), self.owned(*value));
                quote!({ rt::agree(#a, #b, #site)?; #value })
            }
            other => panic!("bug in iheartmesh: no Rust for {other:?}"),
        }
    }

    /// A function that the host handed in, to be called.
    pub(super) fn host_function(&mut self, e: ExprId) -> TokenStream {
        match self.kind(e) {
            Kind::Input(id) => {
                let field = self.context.input_field(*id);
                quote!(s.#field)
            }
            Kind::Variable(variable) => self.variable_name(*variable),
            Kind::Item(functions, index) => {
                let found = self.item_place(e, *functions, *index);
                quote!(#found)
            }
            other => panic!("bug in iheartmesh: no function {other:?}"),
        }
    }

    fn dynamic_matrix(&self) -> TokenStream {
        let krate = self.context.krate;
        quote!(#krate::nalgebra::DMatrix<f64>)
    }

    fn blocks(&mut self, e: ExprId, rows: &[Vec<ExprId>]) -> TokenStream {
        if let [columns] = rows
            && super::types::is_glam(self.ty(e))
            && columns.iter().all(|c| super::types::is_glam(self.ty(*c)))
            && columns.iter().all(|c| self.ty(*c).fixed_vector().is_some())
        {
            let ty = self.context.inner_type(self.ty(e));
            let columns = columns.iter().map(|c| self.value(*c)).collect::<Vec<_>>();
            return quote!(#ty::from_cols(#(#columns),*));
        }
        let is_number = |e: &ExprId| self.ty(*e).is_scalar();
        if !self.ty(e).is_sparse() && rows.iter().flatten().all(is_number) {
            let ty = self.context.inner_type(self.ty(e));
            let [n, m] = [rows.len(), rows[0].len()].map(Literal::usize_unsuffixed);
            let rows: Vec<TokenStream> = rows
                .iter()
                .map(|row| {
                    let row = row.iter().map(|entry| self.owned(*entry));
                    quote!([#(#row),*])
                })
                .collect();
            return quote!({
                let entries = [#(#rows),*];
                <#ty as rt::Build>::build(#n, #m, |i, j| entries[i][j])
            });
        }
        let (start, put, finish) = match self.ty(e).is_sparse() {
            true => (
                quote!(rt::sparse_blocks),
                quote!(rt::put_sparse),
                quote!(all.to_csc()),
            ),
            false => {
                let ty = self.context.inner_type(self.ty(e));
                (
                    quote!(<#ty as rt::Build>::zeros),
                    quote!(rt::put),
                    quote!(all),
                )
            }
        };
        // each block has a name, so that sizes are known before any is put in place
        let mut lets = TokenStream::new();
        let mut at_hand = Vec::new();
        let mut names: Vec<Vec<proc_macro2::Ident>> = Vec::new();
        for (r, row) in rows.iter().enumerate() {
            let mut list = Vec::new();
            for (k, block) in row.iter().enumerate() {
                let name = quote::format_ident!("block{}_{}", r, k);
                let value = self.reference(*block);
                lets.extend(quote!(let #name = #value;));
                at_hand.push((*block, quote!(#name)));
                list.push(name);
            }
            names.push(list);
        }
        let pairs = crate::ir::unproven(&self.context.program().arena, e);
        lets.extend(agreements(&pairs, &at_hand, &self.context.site(e)));
        let heights = names
            .iter()
            .filter_map(|row| row.first())
            .map(|b| quote!(rt::Array::rows(#b)));
        let widths = names
            .first()
            .into_iter()
            .flatten()
            .map(|b| quote!(rt::Array::columns(#b)));
        let mut puts = TokenStream::new();
        for row in &names {
            puts.extend(quote!(let mut column = 0usize;));
            for name in row {
                puts.extend(quote! {
                    #put(&mut all, row, column, #name);
                    column += rt::Array::columns(#name);
                });
            }
            if let Some(first) = row.first() {
                puts.extend(quote!(row += rt::Array::rows(#first);));
            }
        }
        quote!({
            #lets
            let mut all = #start(0usize #(+ #heights)*, 0usize #(+ #widths)*);
            let mut row = 0usize;
            #puts
            #finish
        })
    }

    /// Operations of linear algebra with one operand.
    pub(super) fn array_unary(&mut self, e: ExprId, op: Unary, a: ExprId) -> TokenStream {
        let ty = self.context.inner_type(self.ty(e));
        let site = self.context.site(e);
        let (glam, sparse) = (is_glam(self.ty(a)), self.ty(a).is_sparse());
        let sequence = matches!(self.ty(a), Type::Sequence { .. });
        let vector = matches!(self.ty(a), Type::Vector { .. });
        match op {
            Unary::Negate if glam => {
                let a = self.owned(a);
                return quote!((-#a));
            }
            Unary::Norm if glam && vector => {
                let a = self.owned(a);
                return quote!((#a).length());
            }
            // the value of a boundary matrix is a matrix of numbers already
            Unary::ToReal if matches!(self.kind(a), Kind::Boundary(_)) => return self.owned(a),
            _ => {}
        }
        let a = self.reference(a);
        match op {
            Unary::Negate if sparse => quote!((#a).map(|x| -x)),
            Unary::Negate => quote!(rt::map::<#ty>(#a, |x| -x)),
            Unary::ToReal => quote!(rt::reals::<#ty>(#a)),
            Unary::Apply(function) => {
                let applied = elementary(function, quote!(x));
                quote!(rt::map::<#ty>(#a, |x| #applied))
            }
            Unary::Norm => quote!(rt::norm(#a)),
            Unary::NormOne => quote!(rt::norm_one(#a)),
            Unary::NormMax => quote!(rt::norm_max(#a)),
            Unary::NormZero => quote!(rt::norm_zero(#a)),
            Unary::NormNuclear => quote!(rt::norm_nuclear(#a)),
            Unary::Transpose if sparse => quote!(rt::sparse_transpose(#a)),
            Unary::Transpose => quote!(rt::transpose::<#ty>(#a)),
            Unary::Inverse if self.ty(e).is_sparse() => {
                let dense = self.dynamic_matrix();
                quote!(rt::sparse(&rt::inverse::<#dense>(#a, #site)?))
            }
            Unary::Inverse => quote!(rt::inverse::<#ty>(#a, #site)?),
            Unary::PseudoInverse => quote!(rt::pseudo_inverse::<#ty>(#a)),
            Unary::Determinant => quote!(rt::determinant(#a)),
            Unary::Trace => quote!(rt::trace(#a)),
            Unary::Rank => quote!(rt::rank(#a, #site)?),
            Unary::Diagonal if vector => quote!(rt::diagonal::<#ty>(#a)),
            Unary::Diagonal => quote!(rt::diagonal_of::<#ty>(#a)),
            Unary::Stack if sequence => quote!(rt::stack_items::<#ty, _>(&(#a)[..])),
            Unary::Stack => quote!(rt::stack::<#ty>(#a)),
            Unary::NullSpace => quote!(rt::null_space(#a, #site)?),
            Unary::OrthogonalBasis => quote!(rt::orthogonal_basis(#a, #site)?),
            Unary::SingularValues => {
                let Type::Tuple(items) = self.ty(e) else {
                    panic!("bug in iheartmesh: singular values are a tuple");
                };
                let items = items.iter().map(|t| self.context.inner_type(t));
                quote!(rt::singular_values::<#(#items),*>(#a))
            }
            Unary::Least if sequence => {
                quote!(rt::least_item(&(#a)[..], #site)?)
            }
            Unary::Greatest if sequence => {
                quote!(rt::greatest_item(&(#a)[..], #site)?)
            }
            Unary::Least => quote!(rt::least(#a, #site)?),
            Unary::Greatest => quote!(rt::greatest(#a, #site)?),
            Unary::PositivePart if sparse => {
                quote!(rt::sparse_with_eigenvalues(#a, |value| value.max(0.0)))
            }
            Unary::AbsolutePart if sparse => quote!(rt::sparse_with_eigenvalues(#a, f64::abs)),
            Unary::PositivePart => quote!(rt::with_eigenvalues::<#ty>(#a, |value| value.max(0.0))),
            Unary::AbsolutePart => quote!(rt::with_eigenvalues::<#ty>(#a, f64::abs)),
            Unary::Reshape if self.ty(e).is_sparse() => quote!(rt::sparse(#a)),
            Unary::Reshape => quote!(rt::reshape::<#ty>(#a)),
            Unary::ByRows => quote!((#a).to_csr()),
            Unary::ByColumns => quote!((#a).to_csc()),
            Unary::FromHost => quote!(rt::HostCounted::counted(#a)),
            Unary::Absolute | Unary::SquareRoot | Unary::ToInteger | Unary::ToElement => {
                panic!("bug in iheartmesh: {op:?} of an array")
            }
        }
    }

    /// Operations of linear algebra with two operands.
    pub(super) fn array_binary(
        &mut self,
        e: ExprId,
        op: Binary,
        a: ExprId,
        b: ExprId,
    ) -> TokenStream {
        let ty = self.context.inner_type(self.ty(e));
        let site = self.context.site(e);
        let (sparse_a, sparse_b) = (self.ty(a).is_sparse(), self.ty(b).is_sparse());
        let glam = is_glam(self.ty(a))
            && is_glam(self.ty(b))
            && (self.ty(e).is_scalar() || is_glam(self.ty(e)));
        let (left, right) = (a, b);
        if glam && op == Binary::Product && matches!(self.ty(a), Type::Matrix { .. }) {
            let (a, b) = (self.owned(a), self.owned(b));
            return quote!((#a * #b));
        }
        if matches!(op, Binary::Multiply) {
            let sparse = sparse_b;
            let (k, b) = (self.owned(a), self.reference(b));
            return match sparse {
                true => quote!({ let k = #k; (#b).map(|x| k * x) }),
                false => quote!({ let k = #k; rt::map::<#ty>(#b, |x| k * x) }),
            };
        }
        if matches!(op, Binary::Divide) {
            let sparse = sparse_a;
            let (a, k) = (self.reference(a), self.owned(b));
            return match sparse {
                true => quote!({ let k = #k; (#a).map(|x| x / k) }),
                false => quote!({ let k = #k; rt::map::<#ty>(#a, |x| x / k) }),
            };
        }
        if matches!(op, Binary::MatrixPower | Binary::NormPower) {
            let (a, p) = (self.reference(a), self.owned(b));
            return match op {
                Binary::MatrixPower => quote!(rt::power::<#ty>(#a, #p, #site)?),
                _ => quote!(rt::norm_power(#a, #p)),
            };
        }
        if op == Binary::Append {
            let (a, b) = (self.owned(a), self.owned(b));
            return quote!({ let mut items = #a; items.push(#b); items });
        }
        let pairs = crate::ir::unproven(&self.context.program().arena, e);
        let names = [(a, quote!(left)), (b, quote!(right))];
        let (a, b) = (self.reference(a), self.reference(b));
        if !pairs.is_empty() {
            let checks = agreements(&pairs, &names, &site);
            let value = self.array_operation(e, op, (left, right), (quote!(left), quote!(right)));
            return quote!({ let (left, right) = (#a, #b); #checks #value });
        }
        self.array_operation(e, op, (left, right), (a, b))
    }

    /// An operation with two operands at hand, at least one of them an array.
    fn array_operation(
        &mut self,
        e: ExprId,
        op: Binary,
        (left, right): (ExprId, ExprId),
        (a, b): (TokenStream, TokenStream),
    ) -> TokenStream {
        let ty = self.context.inner_type(self.ty(e));
        let site = self.context.site(e);
        let (sparse_a, sparse_b) = (self.ty(left).is_sparse(), self.ty(right).is_sparse());
        let all_dynamic = ![left, right, e].iter().any(|e| is_copy(self.ty(*e)));
        let sequence = matches!(self.ty(left), Type::Sequence { .. });
        match op {
            Binary::Add if sparse_a && sparse_b => quote!((#a + #b)),
            Binary::Subtract if sparse_a && sparse_b => quote!((#a - #b)),
            Binary::Add => quote!(rt::zip::<#ty>(#a, #b, |x, y| x + y)),
            Binary::Subtract => quote!(rt::zip::<#ty>(#a, #b, |x, y| x - y)),
            Binary::Product if sparse_a && sparse_b => quote!((#a * #b)),
            Binary::Product if sparse_a => quote!(rt::sparse_product::<#ty>(#a, #b)),
            Binary::Product if all_dynamic && !sparse_b => quote!((#a * #b)),
            Binary::Product if sparse_b => quote!(rt::product_sparse::<#ty>(#a, #b)),
            Binary::Product => quote!(rt::product::<#ty>(#a, #b)),
            Binary::Hadamard if self.ty(e).is_sparse() && sparse_a => {
                quote!(rt::sparse_hadamard(#a, #b))
            }
            Binary::Hadamard if self.ty(e).is_sparse() => quote!(rt::sparse_hadamard(#b, #a)),
            Binary::Hadamard => quote!(rt::zip::<#ty>(#a, #b, |x, y| x * y)),
            Binary::Dot | Binary::Frobenius => quote!(rt::inner(#a, #b)),
            Binary::Kronecker if self.ty(e).is_sparse() => quote!(rt::sparse_kronecker(#a, #b)),
            Binary::Kronecker => quote!(rt::kronecker::<#ty>(#a, #b)),
            Binary::Solve if self.ty(e).is_sparse() => {
                let dense = self.dynamic_matrix();
                quote!(rt::sparse(&rt::solve::<#dense>(#a, #b, #site)?))
            }
            Binary::Solve => quote!(rt::solve::<#ty>(#a, #b, #site)?),
            Binary::NormWeighted => quote!(rt::norm_weighted(#a, #b)),
            // the type is named, since what is done with the items need not tell it
            Binary::Unstack if sequence => {
                quote!({ let items: #ty = rt::unstack_items(&(#a)[..], #b, #site)?; items })
            }
            Binary::Unstack => quote!(rt::unstack::<#ty>(#a, #b, #site)?),
            other => panic!("bug in iheartmesh: no Rust for {other:?} of arrays"),
        }
    }
}

/// Checks that sizes of operands agree, which are at hand by reference under these names.
fn agreements(
    pairs: &[(Axis, Axis)],
    names: &[(ExprId, TokenStream)],
    site: &TokenStream,
) -> TokenStream {
    let size = |(operand, axis): &Axis| {
        let name = names
            .iter()
            .find(|(e, _)| e == operand)
            .map(|(_, name)| name);
        match axis {
            0 => quote!(rt::Array::rows(#name) as i64),
            _ => quote!(rt::Array::columns(#name) as i64),
        }
    };
    let checks = pairs.iter().map(|(a, b)| {
        let (a, b) = (size(a), size(b));
        quote!(rt::agree(#a, #b, #site)?;)
    });
    quote!(#(#checks)*)
}
