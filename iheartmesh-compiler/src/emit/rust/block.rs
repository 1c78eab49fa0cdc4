//! Bodies: the statements of each region, loops and branches.

use std::collections::BTreeMap;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::Context;
use super::place::{Part, Placement, RegionId, Roots};
use super::slots::SlotSum;
use crate::ir::{ExprId, Fold, Kind, Parameter, Range, VariableId};
use crate::optimize::Plan;
use crate::types::{Atom, Number, Shape, Type};

/// How a body reaches what it needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    /// Only the topology is at hand, as `t`.
    Static,
    /// The values are at hand as `s`, and the topology as `t`.
    Dynamic,
    /// A plan is being computed: what fails is kept as a failure, since its row may never be used.
    Build,
}

/// The body of one Rust function.
pub(super) struct Body<'a> {
    pub(super) context: &'a Context<'a>,
    pub(super) mode: Mode,
    pub(super) plan: &'a Plan,
    pub(super) placement: Placement,
    /// Expressions that have a name.
    pub(super) names: BTreeMap<ExprId, Ident>,
    /// Calls, and entries of boundary matrices, whose values are at hand.
    pub(super) calls: BTreeMap<ExprId, TokenStream>,
    /// How variables are written, where not by their own name.
    pub(super) variables: BTreeMap<VariableId, TokenStream>,
    /// Sizes that the arguments of the function at hand give.
    pub(super) sizes: BTreeMap<Atom, TokenStream>,
    /// The sum of blocks with planned places that the body is.
    pub(super) slots: Option<&'a SlotSum>,
    /// Which of its arrays blocks are added to.
    pub(super) array: usize,
    /// The variable of a loop that is done in pieces: only the rounds in `range`.
    pub(super) rounds: Option<VariableId>,
}

impl<'a> Body<'a> {
    pub(super) fn new(context: &'a Context<'a>, mode: Mode, plan: &'a Plan, roots: &Roots) -> Self {
        let arena = &context.program().arena;
        let placement = Placement::new(
            arena,
            roots,
            |e| context.may_fail.own(arena, e) || Self::column_may_fail(plan, arena.kind(e)),
            |e| match arena.kind(e) {
                Kind::Call(id, _) => context.program().function(*id).recursive,
                kind => matches!(kind, Kind::HostCall(..) | Kind::Optimum { .. }),
            },
            context.staged.optimizations.share,
        );
        Self {
            context,
            mode,
            plan,
            placement,
            names: BTreeMap::new(),
            calls: BTreeMap::new(),
            variables: BTreeMap::new(),
            sizes: BTreeMap::new(),
            slots: None,
            array: 0,
            rounds: None,
        }
    }

    /// A body with a single result.
    pub(super) fn single(
        context: &'a Context<'a>,
        mode: Mode,
        plan: &'a Plan,
        e: ExprId,
    ) -> TokenStream {
        Self::of_function(context, mode, plan, &[], e)
    }

    /// The body of a function with these parameters.
    pub(super) fn of_function(
        context: &'a Context<'a>,
        mode: Mode,
        plan: &'a Plan,
        parameters: &[Parameter],
        e: ExprId,
    ) -> TokenStream {
        let mut roots = Roots::default();
        let region = roots.region(None, None);
        roots.need(region, e);
        let mut body = Self::new(context, mode, plan, &roots);
        body.sizes = context.sizes_of(parameters);
        let statements = body.statements(RegionId(region), &[e]);
        let result = body.owned(e);
        quote!(#statements ::std::result::Result::Ok(#result))
    }

    pub(super) fn column_may_fail(plan: &Plan, kind: &Kind) -> bool {
        match kind {
            Kind::Column(variable, k) => plan
                .space(*variable)
                .and_then(|space| space.columns.get(*k as usize))
                .is_some_and(|column| column.may_fail),
            _ => false,
        }
    }

    pub(super) fn kind(&self, e: ExprId) -> &'a Kind {
        self.context.program().arena.kind(e)
    }

    pub(super) fn ty(&self, e: ExprId) -> &'a Type {
        self.context.program().arena.ty(e)
    }

    /// Whether an expression, with all that is written inside of it, may fail.
    pub(super) fn may_fail(&self, e: ExprId) -> bool {
        self.context.may_fail.expr(&self.context.program().arena, e)
    }

    /// Whether an expression that has a name is a value or a failure, and fails where it is used: in a plan, and where it may
    /// not be needed.
    pub(super) fn is_kept_as_failure(&self, e: ExprId) -> bool {
        self.mode == Mode::Build && self.may_fail(e) || self.placement.is_uncertain(e)
    }

    /// The statements of a region: a `let` for each expression that is used more than once or further in. Those of
    /// `results` are written by the caller where they are used only there.
    pub(super) fn statements(&mut self, region: RegionId, results: &[ExprId]) -> TokenStream {
        let mut statements = TokenStream::new();
        for e in self.placement.placed(region).to_vec() {
            if self.is_written_inside(e, results) {
                continue;
            }
            let name = format_ident!("t{}", e.0);
            let value = self.value(e);
            let statement = match self.is_kept_as_failure(e) {
                true => {
                    let ty = self.context.inner_type(self.ty(e));
                    quote!(let #name: rt::Fallible<#ty> = (|| ::std::result::Result::Ok(#value))();)
                }
                false => quote!(let #name = #value;),
            };
            statements.extend(statement);
            self.names.insert(e, name);
        }
        statements
    }

    /// Whether an expression is written where it is used, without a name.
    fn is_written_inside(&self, e: ExprId, results: &[ExprId]) -> bool {
        let arena = &self.context.program().arena;
        match arena.kind(e) {
            Kind::Integer(_)
            | Kind::Real(_)
            | Kind::Boolean(_)
            | Kind::Variable(_)
            | Kind::Input(_)
            | Kind::AllElements(_)
            | Kind::Boundary(_)
            | Kind::Column(..)
            | Kind::Fail => true,
            // a reference to what is kept
            Kind::Global(_) if self.mode != Mode::Build && is_kept_array(self.ty(e)) => true,
            // its blocks are added where they stand
            _ if self
                .slots
                .is_some_and(|sum| self.is_assembled(e) || sum.tuples.contains(&e)) =>
            {
                true
            }
            // a function is called where it stands
            _ if matches!(self.ty(e), Type::Function { .. }) => true,
            _ => {
                let result = results.contains(&e) || self.placement.is_result_here(arena, e);
                let uses = self.placement.uses(arena, e, result);
                uses <= 1 && !self.is_kept_as_failure(e)
            }
        }
    }

    /// `{ statements; value }` for the result of a region.
    fn region_value(&mut self, e: ExprId, part: Part, result: ExprId) -> TokenStream {
        let region = self.placement.part(e, part);
        let statements = self.statements(region, &[]);
        let value = self.owned(result);
        quote!({ #statements #value })
    }

    /// A choice.
    pub(super) fn choice(
        &mut self,
        e: ExprId,
        condition: ExprId,
        a: ExprId,
        b: ExprId,
    ) -> TokenStream {
        let condition = self.owned(condition);
        let a = self.region_value(e, Part::Then, a);
        let b = self.region_value(e, Part::Else, b);
        quote!(if #condition #a else #b)
    }

    /// `and`, `or`.
    pub(super) fn logical(
        &mut self,
        e: ExprId,
        sign: TokenStream,
        a: ExprId,
        b: ExprId,
    ) -> TokenStream {
        let a = self.owned(a);
        let b = self.region_value(e, Part::Right, b);
        quote!((#a #sign #b))
    }

    /// A loop.
    pub(super) fn fold(&mut self, e: ExprId) -> TokenStream {
        let Kind::Fold {
            op, variable, body, ..
        } = self.kind(e)
        else {
            panic!("bug in iheartmesh: no loop");
        };
        let (op, body) = (*op, *body);
        let ty = self.ty(e);
        let (start, finish) = self.accumulator(e, op, ty, body == self.variable_expr(*variable));
        let total = self.rounds_of_total(e);
        let named = self.rounds_with_names(e);
        let around = match (&total, &named) {
            (None, None) => self.rounds,
            _ => self.rounds.replace(*variable),
        };
        let looped = self.looped(e, |this| this.step(e, op, ty, body));
        self.rounds = around;
        match (total, named) {
            (Some(rounds), _) => {
                quote!(rt::total(#rounds, |range| { #start #looped ::std::result::Result::Ok(#finish) })?)
            }
            (None, Some(rounds)) => {
                quote!({ #start rt::rounds(#rounds, |range| { #looped ::std::result::Result::Ok(()) })?; #finish })
            }
            (None, None) => quote!({ #start #looped #finish }),
        }
    }

    /// A loop that does something for each value.
    pub(super) fn looped(
        &mut self,
        e: ExprId,
        step: impl FnOnce(&mut Self) -> TokenStream,
    ) -> TokenStream {
        self.looped_or(e, step, TokenStream::new())
    }

    /// A loop that does something for each value; `otherwise` is an `else` for what its condition leaves out.
    pub(super) fn looped_or(
        &mut self,
        e: ExprId,
        step: impl FnOnce(&mut Self) -> TokenStream,
        otherwise: TokenStream,
    ) -> TokenStream {
        let Kind::Fold {
            variable,
            range,
            condition,
            ..
        } = self.kind(e)
        else {
            panic!("bug in iheartmesh: no loop");
        };
        let locals = match range {
            Range::Rows { .. } => self.bind_locals(*variable),
            _ => TokenStream::new(),
        };
        let head = self.loop_head(*variable, range);
        let outside = self.placement.part(e, Part::Loop);
        let before = self.statements(outside, &[]);
        let inside = match condition {
            None => {
                let step = step(self);
                quote!(#before #step)
            }
            Some(condition) => {
                let condition = self.owned(*condition);
                let taken = self.placement.part(e, Part::Taken);
                let statements = self.statements(taken, &[]);
                let step = step(self);
                quote!(#before if #condition { #statements #step } #otherwise)
            }
        };
        quote!(#locals #head { #inside })
    }

    pub(super) fn variable_expr(&self, variable: VariableId) -> ExprId {
        // the expression of a bound variable exists as soon as the variable does
        let arena = &self.context.program().arena;
        let ty = arena.variable_type(variable).clone();
        arena
            .find(&Kind::Variable(variable), &ty)
            .unwrap_or(ExprId(u32::MAX))
    }

    /// How a loop's value is started and finished.
    fn accumulator(
        &self,
        e: ExprId,
        op: Fold,
        ty: &Type,
        keeps_order: bool,
    ) -> (TokenStream, TokenStream) {
        let inner = self.context.inner_type(ty);
        match op {
            Fold::Sum => match self.context.known_zero_of(ty, &self.sizes) {
                Some(zero) => (quote!(let mut sum: #inner = #zero;), quote!(sum)),
                // the first term says how large they are
                None => {
                    let site = self.context.site(e);
                    (
                        quote!(let mut sum: ::std::option::Option<#inner> = ::std::option::Option::None;),
                        quote!(match sum {
                            ::std::option::Option::Some(sum) => sum,
                            ::std::option::Option::None => return ::std::result::Result::Err(#site),
                        }),
                    )
                }
            },
            Fold::Product => match ty {
                Type::Scalar(Number::Integer) => (quote!(let mut product = 1i64;), quote!(product)),
                _ => (quote!(let mut product = 1.0f64;), quote!(product)),
            },
            Fold::Min | Fold::Max | Fold::ArgMin | Fold::ArgMax => {
                let site = self.context.site(e);
                let (kept, pattern) = match op {
                    Fold::Min | Fold::Max => (inner, quote!(best)),
                    _ => (quote!((_, #inner)), quote!((_, best))),
                };
                (
                    quote!(let mut best: ::std::option::Option<#kept> = ::std::option::Option::None;),
                    quote!(match best {
                        ::std::option::Option::Some(#pattern) => best,
                        ::std::option::Option::None => return ::std::result::Result::Err(#site),
                    }),
                )
            }
            Fold::Collect | Fold::Union if ty.element_of_set().is_some() => {
                let finish = match keeps_order && op == Fold::Collect {
                    true => quote!(set),
                    false => quote!(rt::sorted(set)),
                };
                (quote!(let mut set = rt::Ids::new();), finish)
            }
            Fold::Collect | Fold::Union => (
                quote!(let mut set = ::std::vec::Vec::new();),
                quote!(<#inner as ::std::convert::From<::std::vec::Vec<_>>>::from(set)),
            ),
        }
    }

    /// What a loop does with each value.
    fn step(&mut self, e: ExprId, op: Fold, ty: &Type, body: ExprId) -> TokenStream {
        match op {
            Fold::Sum | Fold::Product if ty.is_integer() && ty.is_scalar() => {
                let value = self.owned(body);
                let site = self.context.site(e);
                match op {
                    Fold::Sum => quote!(sum = rt::integers(sum.checked_add(#value), #site)?;),
                    _ => quote!(product = rt::integers(product.checked_mul(#value), #site)?;),
                }
            }
            Fold::Sum if ty.is_scalar() || super::types::is_glam(ty) => {
                let value = self.owned(body);
                quote!(sum += #value;)
            }
            Fold::Sum if self.context.known_zero_of(ty, &self.sizes).is_none() => {
                let value = self.reference(body);
                let site = self.context.site(e);
                quote!(rt::add_to(&mut sum, #value, #site)?;)
            }
            Fold::Sum => {
                let value = self.reference(body);
                if ty.is_sparse() {
                    return quote!(sum = &sum + #value;);
                }
                let inner = self.context.inner_type(ty);
                quote!(sum = rt::zip::<#inner>(&sum, #value, |a, b| a + b);)
            }
            Fold::Product => {
                let value = self.owned(body);
                quote!(product *= #value;)
            }
            Fold::Min | Fold::Max | Fold::ArgMin | Fold::ArgMax => {
                super::optimum::keep_best(op, self.owned(body))
            }
            Fold::Collect => {
                let value = self.owned(body);
                quote!(set.push(#value);)
            }
            Fold::Union if ty.element_of_set().is_some() => {
                let value = self.ids(body);
                quote!(set.extend_from_slice(#value);)
            }
            Fold::Union => {
                let value = self.reference(body);
                quote!(set.extend((#value).iter().cloned());)
            }
        }
    }

    pub(super) fn variable_name(&self, variable: VariableId) -> TokenStream {
        if let Some(written) = self.variables.get(&variable) {
            return written.clone();
        }
        let name = variable_ident(self.context, variable);
        quote!(#name)
    }
}

/// Whether values of a type are copied rather than cloned.
pub(super) fn is_copy(ty: &Type) -> bool {
    match ty {
        Type::Scalar(_) | Type::Boolean | Type::Element(_) | Type::Function { .. } => true,
        Type::Vector { .. } => ty.fixed_vector().is_some(),
        Type::Matrix {
            rows,
            columns,
            sparse: false,
            spaces: None,
            ..
        } => rows.value().is_some() && columns.value().is_some(),
        Type::Tuple(items) => items.iter().all(is_copy),
        _ => false,
    }
}

/// The name of a variable in Rust.
pub(super) fn variable_ident(context: &Context<'_>, variable: VariableId) -> Ident {
    let name = super::names::rust_name(context.program().arena.variable_name(variable));
    format_ident!("v{}_{}", variable.0, name)
}

/// The current row of a space.
pub(super) fn row_name(variable: VariableId) -> Ident {
    format_ident!("row{}", variable.0)
}

/// The number of the current row of a space.
pub(super) fn number_name(variable: VariableId) -> Ident {
    format_ident!("number{}", variable.0)
}

/// Whether a definition of this type is read by a reference: a vector or matrix of a size that is not in the text.
fn is_kept_array(ty: &Type) -> bool {
    matches!(ty.shape(), Some(Shape::Vector(_) | Shape::Matrix(..))) && !ty.is_fixed()
}
