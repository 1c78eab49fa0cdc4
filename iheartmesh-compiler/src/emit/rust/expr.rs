//! Expressions that are not sets.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::block::{Body, is_copy, row_name};
use crate::ir::{Binary, Elementary, ExprId, Kind, Unary};
use crate::syntax::ast::CompareOp;
use crate::types::{Number, Type};

impl Body<'_> {
    /// The value of an expression, owned.
    pub(super) fn owned(&mut self, e: ExprId) -> TokenStream {
        let Some(name) = self.names.get(&e).cloned() else {
            return self.value(e);
        };
        let copy = is_copy(self.ty(e));
        match (self.is_kept_as_failure(e), copy) {
            (true, true) => quote!(#name?),
            (true, false) => quote!(#name.clone()?),
            (false, true) => quote!(#name),
            (false, false) => quote!(#name.clone()),
        }
    }

    /// A reference to the value of an expression.
    pub(super) fn reference(&mut self, e: ExprId) -> TokenStream {
        let Some(name) = self.names.get(&e).cloned() else {
            if let Some(place) = self.place_of(e) {
                return place;
            }
            let value = self.value(e);
            return quote!(&#value);
        };
        match self.is_kept_as_failure(e) {
            true => quote!(#name.as_ref().map_err(|fault| *fault)?),
            false => quote!(&#name),
        }
    }

    /// A reference to a value that is stored somewhere already.
    fn place_of(&mut self, e: ExprId) -> Option<TokenStream> {
        if is_copy(self.ty(e)) {
            return None;
        }
        Some(match self.kind(e) {
            Kind::Variable(v) => self.variable_name(*v),
            Kind::Input(id) => {
                let field = self.context.input_field(*id);
                match self.ty(e) {
                    // a local name, see `prelude`
                    ty @ Type::Sequence { .. } if !self.context.is_same_outside(ty) => {
                        let value = self.context.to_inner(quote!(#field), ty);
                        quote!(&#value)
                    }
                    Type::Sequence { .. } => quote!(#field),
                    ty if !self.context.is_same_outside(ty) => {
                        let value = self.context.to_inner(quote!(s.#field.as_ref()), ty);
                        quote!(&#value)
                    }
                    _ => quote!(s.#field.as_ref()),
                }
            }
            Kind::Global(id) => {
                let name = self.context.global_name(*id);
                match self.context.is_static_global(*id) {
                    true => quote!(t.#name()?),
                    false => quote!(s.#name()?),
                }
            }
            Kind::Agree(a, b, value) => {
                let place = match self.names.contains_key(value) {
                    true => self.reference(*value),
                    false => self.place_of(*value)?,
                };
                let site = self.context.site(e);
                let (a, b) = (self.owned(*a), self.owned(*b));
                quote!({ rt::agree(#a, #b, #site)?; #place })
            }
            Kind::Item(sequence, index)
                if matches!(self.kind(*sequence), Kind::Input(_))
                    && self.context.is_same_outside(self.ty(e))
                    && !self.index_may_fail(*index)
                    && self.ty(*index).is_element() =>
            {
                let base = self.reference(*sequence);
                let element = self.stored_element(*index);
                quote!(&(#base)[#element as usize])
            }
            _ => return None,
        })
    }

    /// The value of an expression that has no name.
    pub(super) fn value(&mut self, e: ExprId) -> TokenStream {
        let kind = self.kind(e);
        if self.is_assembled(e) {
            return self.assemble(e);
        }
        match kind {
            Kind::Integer(v) => {
                let v = Literal::i64_suffixed(*v);
                quote!(#v)
            }
            Kind::Real(bits) => real(f64::from_bits(*bits)),
            Kind::Boolean(v) => quote!(#v),
            Kind::Variable(v) => {
                let name = self.variable_name(*v);
                match self.ty(e) {
                    ty if is_copy(ty) => name,
                    ty if ty.element_of_set().is_some() => quote!(rt::Ids::from_slice(#name)),
                    Type::Sequence { .. } => quote!(#name.to_vec()),
                    _ => quote!(#name.clone()),
                }
            }
            Kind::Input(id) => {
                let field = self.context.input_field(*id);
                match self.ty(e) {
                    Type::Element(_) => quote!(s.#field.id()),
                    ty if is_copy(ty) => quote!(s.#field),
                    ty @ Type::Sequence { .. } if !self.context.is_same_outside(ty) => {
                        self.context.to_inner(quote!(#field), ty)
                    }
                    ty if !self.context.is_same_outside(ty) && super::item::is_converted(ty) => {
                        let value = self.context.to_inner(quote!(s.#field.as_ref()), ty);
                        quote!((#value))
                    }
                    // a local name, see `prelude`
                    Type::Sequence { .. } => quote!(#field.to_vec()),
                    ty if ty.element_of_set().is_some() => {
                        quote!(rt::ids_of_set(s.#field.as_ref()))
                    }
                    _ => quote!(s.#field.as_ref().clone()),
                }
            }
            Kind::Global(id) => {
                let name = self.context.global_name(*id);
                let receiver = match self.context.is_static_global(*id) {
                    true => quote!(t),
                    false => quote!(s),
                };
                match is_copy(self.ty(e)) {
                    true => quote!(*#receiver.#name()?),
                    false => quote!(#receiver.#name()?.clone()),
                }
            }
            Kind::Column(..) => self.column(e),
            Kind::Call(..) | Kind::Entry(..) if self.calls.contains_key(&e) => {
                self.calls[&e].clone()
            }
            Kind::Call(id, arguments) => {
                let name = self.context.function_name(*id);
                let first = match self.context.is_static_function(*id) {
                    true => quote!(t),
                    false => quote!(s),
                };
                let arguments: Vec<_> = arguments.iter().map(|a| self.argument(*a)).collect();
                let because = self.context.because_of_call(e);
                quote!(#name(#first #(, #arguments)*)#because?)
            }
            Kind::Field(id, element) => {
                let field = super::item::field_name(*id);
                let may_fail = self.index_may_fail(*element);
                let index = self.stored_element(*element);
                match may_fail {
                    true => {
                        let site = self.context.site(self.column_value(*element));
                        quote!(*rt::of_element(#field, #index, #site)?)
                    }
                    false => quote!(#field[#index as usize]),
                }
            }
            Kind::Unary(op, a) => self.unary(e, *op, *a),
            Kind::Binary(op, a, b) => self.binary(e, *op, *a, *b),
            Kind::Compare(op, a, b) => self.compare(*op, *a, *b),
            Kind::And(a, b) => self.logical(e, quote!(&&), *a, *b),
            Kind::Or(a, b) => self.logical(e, quote!(||), *a, *b),
            Kind::Not(a) => {
                let a = self.owned(*a);
                quote!((!#a))
            }
            Kind::Vector(_) | Kind::Component(..) => self.array(e),
            Kind::Item(sequence, index) => self.item(e, *sequence, *index),
            Kind::Tuple(items) => {
                let items: Vec<_> = items.iter().map(|i| self.owned(*i)).collect();
                quote!((#(#items,)*))
            }
            Kind::Project(a, k) => {
                let k = Literal::u32_unsuffixed(*k);
                let copy = is_copy(self.ty(e));
                let a = match self.names.contains_key(a) {
                    true => self.reference(*a),
                    false => self.owned(*a),
                };
                match copy {
                    true => quote!((#a).#k),
                    false => quote!((#a).#k.clone()),
                }
            }
            Kind::If(condition, a, b) => self.choice(e, *condition, *a, *b),
            Kind::Fail => {
                let site = self.context.site(e);
                quote!(return ::std::result::Result::Err(#site))
            }
            Kind::Fold { .. } => self.fold(e),
            Kind::Tabulate { .. } => self.tabulate(e),
            Kind::Stored(matrix, _, index) => {
                let site = self.context.site(e);
                let (matrix, index) = (self.reference(*matrix), self.owned(*index));
                quote!(rt::stored(#matrix, #index, #site)?)
            }
            Kind::Scatter { .. } => self.scatter(e),
            Kind::Update(base, entries) => self.update(e, *base, entries),
            Kind::Optimum { .. } => self.optimum(e),
            Kind::Integral { .. } => self.integral(e),
            _ if self.is_array(e) => self.array(e),
            _ => self.set_value(e),
        }
    }

    /// An argument of a call: what is not copied by reference.
    fn argument(&mut self, e: ExprId) -> TokenStream {
        match self.ty(e) {
            ty if ty.element_of_set().is_some() => self.ids(e),
            Type::Function { .. } => {
                let function = self.host_function(e);
                match self.kind(e) {
                    Kind::Variable(_) => function,
                    _ => quote!(&*#function),
                }
            }
            ty if is_copy(ty) => self.owned(e),
            _ => self.reference(e),
        }
    }

    /// A column of the current row.
    fn column(&mut self, e: ExprId) -> TokenStream {
        let Kind::Column(variable, k) = self.kind(e) else {
            panic!("bug in iheartmesh: no column");
        };
        let row = row_name(*variable);
        let index = Literal::u32_unsuffixed(*k);
        let may_fail = Self::column_may_fail(self.plan, self.kind(e));
        let site = || self.context.site(self.column_value(e));
        match (self.ty(e), may_fail) {
            (Type::Element(_), false) => quote!(#row[#index]),
            (Type::Element(_), true) => {
                let site = site();
                quote!(rt::element(#row[#index], #site)?)
            }
            (Type::Boolean, false) => quote!((#row[#index] != 0)),
            (Type::Boolean, true) => {
                let site = site();
                quote!((rt::integer(#row[#index], #site)? != 0))
            }
            (_, false) => quote!((#row[#index] as i32 as i64)),
            (_, true) => {
                let site = site();
                quote!(rt::integer(#row[#index], #site)?)
            }
        }
    }

    /// What a column stores.
    pub(super) fn column_value(&self, e: ExprId) -> ExprId {
        match self.kind(e) {
            Kind::Column(variable, k) => self
                .plan
                .space(*variable)
                .and_then(|s| s.columns.get(*k as usize))
                .map_or(e, |c| c.value),
            _ => e,
        }
    }

    /// An element, not checked where it is a column in which it may be missing.
    fn stored_element(&mut self, index: ExprId) -> TokenStream {
        if let Kind::Column(variable, k) = self.kind(index)
            && !self.names.contains_key(&index)
        {
            let row = row_name(*variable);
            let k = Literal::u32_unsuffixed(*k);
            return quote!(#row[#k]);
        }
        self.owned(index)
    }

    fn index_may_fail(&self, index: ExprId) -> bool {
        Self::column_may_fail(self.plan, self.kind(index)) && !self.names.contains_key(&index)
    }

    fn item(&mut self, e: ExprId, sequence: ExprId, index: ExprId) -> TokenStream {
        let copy = is_copy(self.ty(e));
        let found = self.item_place(e, sequence, index);
        match (self.kind(sequence), copy) {
            // the host's items
            (Kind::Input(_), _) if !self.context.is_same_outside(self.ty(e)) => match self.ty(e) {
                Type::Element(_) => quote!((#found).id()),
                ty => {
                    let value = self.context.to_inner(quote!(item), ty);
                    quote!({ let item = &(#found); #value })
                }
            },
            (_, true) => found,
            (_, false) => quote!((#found).clone()),
        }
    }

    /// An item of a sequence where it stands.
    pub(super) fn item_place(&mut self, e: ExprId, sequence: ExprId, index: ExprId) -> TokenStream {
        let base = match self.kind(sequence) {
            // a local name, see `prelude`
            Kind::Input(id) => {
                let field = self.context.input_field(*id);
                quote!(#field)
            }
            Kind::Variable(_) => self.reference(sequence),
            _ => {
                let reference = self.reference(sequence);
                quote!((#reference))
            }
        };
        if self.ty(index).is_element() {
            let may_fail = self.index_may_fail(index);
            let element = self.stored_element(index);
            let is_input = matches!(self.kind(sequence), Kind::Input(_));
            match (may_fail, is_input) {
                (true, _) => {
                    let site = self.context.site(self.column_value(index));
                    quote!(*rt::of_element(&#base[..], #element, #site)?)
                }
                (false, true) => quote!(#base[#element as usize]),
                (false, false) => {
                    let site = self.context.site(e);
                    quote!(*rt::at(&#base[..], #element as usize, #site)?)
                }
            }
        } else {
            let place = self.owned(index);
            let site = self.context.site(e);
            quote!(*rt::entry(&#base[..], #place, #site)?)
        }
    }

    fn unary(&mut self, e: ExprId, op: Unary, a: ExprId) -> TokenStream {
        if matches!(self.ty(a), Type::Vector { space: Some(_), .. }) {
            let n = self.context.count(self.space_of(a));
            let a = self.reference(a);
            return quote!(rt::chain_as_vector(#a, #n));
        }
        if op == Unary::FromHost || !self.ty(a).is_scalar() && !self.ty(a).is_element() {
            return self.array_unary(e, op, a);
        }
        let overflows = crate::optimize::may_overflow(&self.context.program().arena, e);
        let site = self.context.site(e);
        let integer = *self.ty(e) == Type::INTEGER;
        let value = self.owned(a);
        match op {
            Unary::Negate if overflows => quote!(rt::integers((#value).checked_neg(), #site)?),
            Unary::Absolute if overflows => quote!(rt::integers((#value).checked_abs(), #site)?),
            Unary::Negate => quote!((-#value)),
            Unary::Absolute if integer => quote!((#value).wrapping_abs()),
            Unary::Absolute => quote!((#value).abs()),
            Unary::SquareRoot => quote!((#value).sqrt()),
            Unary::ToReal => quote!((#value as f64)),
            Unary::ToInteger => quote!((#value as i64 + 1)),
            Unary::ToElement => quote!(((#value - 1) as u32)),
            Unary::Apply(function) => elementary(function, quote!((#value))),
            _ => self.array_unary(e, op, a),
        }
    }

    fn binary(&mut self, e: ExprId, op: Binary, a: ExprId, b: ExprId) -> TokenStream {
        let simple = |ty: &Type| ty.is_scalar() || super::types::is_glam(ty);
        let same_product = !matches!(
            op,
            Binary::Product | Binary::Hadamard | Binary::Frobenius | Binary::Kronecker
        );
        if !simple(self.ty(a)) || !simple(self.ty(b)) || !same_product || op > Binary::Max {
            return self.array_binary(e, op, a, b);
        }
        let integer = *self.ty(e) == Type::Scalar(Number::Integer);
        let exponent = match self.kind(b) {
            Kind::Real(bits) => Some(f64::from_bits(*bits)),
            _ => None,
        };
        let overflows = crate::optimize::may_overflow(&self.context.program().arena, e);
        let site = self.context.site(e);
        let (a, b) = (self.owned(a), self.owned(b));
        match op {
            Binary::Add if integer && overflows => {
                quote!(rt::integers((#a).checked_add(#b), #site)?)
            }
            Binary::Add if integer => quote!((#a + #b)),
            Binary::Subtract if integer && overflows => {
                quote!(rt::integers((#a).checked_sub(#b), #site)?)
            }
            Binary::Subtract if integer => quote!((#a - #b)),
            Binary::Multiply if integer && overflows => {
                quote!(rt::integers((#a).checked_mul(#b), #site)?)
            }
            Binary::Multiply if integer => quote!((#a * #b)),
            Binary::Add => quote!((#a + #b)),
            Binary::Subtract => quote!((#a - #b)),
            Binary::Multiply => quote!((#a * #b)),
            Binary::Divide => quote!((#a / #b)),
            Binary::Power => match exponent {
                Some(p) if p.fract() == 0.0 && p.abs() <= 64.0 => {
                    let p = Literal::i32_suffixed(p as i32);
                    quote!((#a).powi(#p))
                }
                Some(0.5) => quote!((#a).sqrt()),
                _ => quote!((#a).powf(#b)),
            },
            Binary::Dot => quote!((#a).dot(#b)),
            Binary::Cross => quote!((#a).cross(#b)),
            Binary::Atan2 => quote!((#a).atan2(#b)),
            Binary::Min => quote!((#a).min(#b)),
            Binary::Max => quote!((#a).max(#b)),
            other => panic!("bug in iheartmesh: no Rust for {other:?}"),
        }
    }

    fn compare(&mut self, op: CompareOp, a: ExprId, b: ExprId) -> TokenStream {
        let sign = match op {
            CompareOp::Equal => quote!(==),
            CompareOp::NotEqual => quote!(!=),
            CompareOp::Less => quote!(<),
            CompareOp::LessOrEqual => quote!(<=),
            CompareOp::Greater => quote!(>),
            CompareOp::GreaterOrEqual => quote!(>=),
        };
        let (a, b) = match is_copy(self.ty(a)) {
            true => (self.owned(a), self.owned(b)),
            false => (self.reference(a), self.reference(b)),
        };
        quote!((#a #sign #b))
    }
}

/// A real number as Rust writes it.
fn real(value: f64) -> TokenStream {
    if value.is_nan() {
        return quote!(f64::NAN);
    }
    if value.is_infinite() {
        return match value > 0.0 {
            true => quote!(f64::INFINITY),
            false => quote!(f64::NEG_INFINITY),
        };
    }
    if value == std::f64::consts::PI {
        return quote!(::std::f64::consts::PI);
    }
    if value == std::f64::consts::TAU {
        return quote!(::std::f64::consts::TAU);
    }
    if value == std::f64::consts::E {
        return quote!(::std::f64::consts::E);
    }
    let literal = Literal::f64_suffixed(value.abs());
    match value.is_sign_negative() {
        true => quote!((-#literal)),
        false => quote!(#literal),
    }
}

pub(super) fn elementary(function: Elementary, x: TokenStream) -> TokenStream {
    match function {
        Elementary::Sin => quote!(#x.sin()),
        Elementary::Cos => quote!(#x.cos()),
        Elementary::Tan => quote!(#x.tan()),
        Elementary::Cot => quote!((1.0 / #x.tan())),
        Elementary::Sec => quote!((1.0 / #x.cos())),
        Elementary::Csc => quote!((1.0 / #x.sin())),
        Elementary::Asin => quote!(#x.asin()),
        Elementary::Acos => quote!(#x.acos()),
        Elementary::Atan => quote!(#x.atan()),
        Elementary::Sinh => quote!(#x.sinh()),
        Elementary::Cosh => quote!(#x.cosh()),
        Elementary::Tanh => quote!(#x.tanh()),
        Elementary::Asinh => quote!(#x.asinh()),
        Elementary::Acosh => quote!(#x.acosh()),
        Elementary::Atanh => quote!(#x.atanh()),
        Elementary::Exp => quote!(#x.exp()),
        Elementary::Ln => quote!(#x.ln()),
        Elementary::Log2 => quote!(#x.log2()),
        Elementary::Log10 => quote!(#x.log10()),
    }
}
