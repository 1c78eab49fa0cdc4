//! Sizes of values: as values, as they differ from item to item of a sequence, and compared at run time where they
//! are not known when the program is compiled.

use super::Checker;
use super::scope::Found;
use crate::ir::{Binary, ExprId, Kind, Layout, VariableId};
use crate::resolve::ModuleId;
use crate::span::Span;
use crate::syntax::ast::{BinaryOp, Expr, ExprKind, UnaryOp};
use crate::types::{Atom, Dimension, Place, Type};

impl Checker<'_> {
    /// A size of a value: the number of its items or rows (0), of its columns (1).
    pub(super) fn extent(&mut self, e: ExprId, axis: u8) -> ExprId {
        let dimension = match (self.ty(e), axis) {
            (Type::Vector { length, .. } | Type::Sequence { length, .. }, _) => {
                Some(length.clone())
            }
            (Type::Matrix { rows, .. }, 0) => Some(rows.clone()),
            (Type::Matrix { columns, .. }, _) => Some(columns.clone()),
            _ => None,
        };
        // the length of a parameter that is a sequence is its own, whatever its letter
        let own = matches!(
            (self.ty(e), self.program.arena.kind(e)),
            (Type::Sequence { .. }, Kind::Variable(_))
        );
        match dimension.filter(|_| !own).and_then(|d| self.size(&d)) {
            Some(size) => size,
            None => self.add(Kind::Extent(e, axis), Type::INTEGER),
        }
    }

    /// A size as a value; `None` when it is known only from the value that has it.
    pub(super) fn size(&mut self, dimension: &Dimension) -> Option<ExprId> {
        if let Some(n) = dimension.value() {
            return Some(self.program.arena.integer(n));
        }
        let atoms: Vec<Atom> = dimension.atoms().cloned().collect();
        if atoms.iter().any(|atom| matches!(atom, Atom::Dynamic(_))) {
            return None;
        }
        let is_stored = |checker: &Self, atom: &Atom| match atom {
            Atom::Symbol(name) => !checker.templates.contains_key(name),
            Atom::Length(_) | Atom::Count(_) => true,
            Atom::Dynamic(_) | Atom::Item(..) => false,
        };
        if atoms.iter().all(|atom| is_stored(self, atom)) {
            return Some(self.add(Kind::Size(dimension.clone()), Type::INTEGER));
        }
        // others are computed from the values that give them
        if dimension.denominator() != 1 {
            return None;
        }
        let terms: Vec<(i64, Vec<Atom>)> =
            dimension.terms().map(|(k, a)| (k, a.to_vec())).collect();
        let mut sum = None;
        for (k, atoms) in terms {
            let mut product = self.program.arena.integer(k);
            for atom in atoms {
                let factor = self.atom(&atom)?;
                product = match self.program.arena.kind(product) {
                    Kind::Integer(1) => factor,
                    _ => self.add(
                        Kind::Binary(Binary::Multiply, product, factor),
                        Type::INTEGER,
                    ),
                };
            }
            sum = Some(match sum {
                None => product,
                Some(sum) => self.add(Kind::Binary(Binary::Add, sum, product), Type::INTEGER),
            });
        }
        sum
    }

    fn atom(&mut self, atom: &Atom) -> Option<ExprId> {
        match atom {
            Atom::Symbol(name) => {
                if let Some(size) = self.templates.get(name) {
                    return Some(*size);
                }
            }
            Atom::Item(of, Some(place)) => {
                let Atom::Symbol(name) = &**of else {
                    return None;
                };
                let sizes = match self.templates.get(name) {
                    Some(sizes) => *sizes,
                    None => self.ragged_sizes(name)?,
                };
                return Some(self.item_size(sizes, ExprId(place.expression)));
            }
            Atom::Item(_, None) | Atom::Dynamic(_) => return None,
            Atom::Length(_) | Atom::Count(_) => {}
        }
        Some(self.add(Kind::Size(Dimension::atom(atom.clone())), Type::INTEGER))
    }

    /// The parameter `n ∈ ℤ` of the compiled module.
    fn parameter_size(&self, name: &str) -> Option<ExprId> {
        let position = self
            .program
            .inputs
            .iter()
            .position(|input| input.name == name && input.ty == Type::INTEGER)?;
        let kind = Kind::Input(crate::ir::InputId(position as u32));
        self.program.arena.find(&kind, &Type::INTEGER)
    }

    /// A symbol that stands for a size, or for the sizes of the items of a sequence.
    pub(super) fn size_symbol(&mut self, name: &str) -> ExprId {
        if let Some(sizes) = self.ragged_sizes(name) {
            return sizes;
        }
        match self.size(&Dimension::atom(Atom::Symbol(name.to_owned()))) {
            Some(size) => size,
            None => self.error(),
        }
    }

    /// The sizes `n` of the items of the sequence `x_i ∈ ℝ^(n_i)` that is a parameter of the module.
    fn ragged_sizes(&mut self, name: &str) -> Option<ExprId> {
        let (place, axis) = *self.ragged.get(name)?;
        let symbol = self.resolved.module(ModuleId(0)).symbols.get(name)?;
        if symbol.meanings != [crate::resolve::Meaning::Dimension] {
            return match self.in_module(ModuleId(0), |c| c.find_in_module(ModuleId(0), name)) {
                Found::Value(value) => Some(value),
                _ => None,
            };
        }
        let sequence = self.input(place)?;
        Some(self.sizes_of_items(sequence, axis))
    }

    /// `#x` of a sequence: the number of its items, and behind it the sizes of each where it has some.
    pub(super) fn sizes_of_sequence(&mut self, sequence: ExprId) -> ExprId {
        let length = self.extent(sequence, 0);
        let Type::Sequence { item, .. } = self.ty(sequence).clone() else {
            return length;
        };
        let sizes = match &*item {
            Type::Vector { length, .. } => vec![length],
            Type::Matrix { rows, columns, .. } => vec![rows, columns],
            _ => return length,
        };
        let mut items = vec![length];
        for (axis, size) in sizes.into_iter().enumerate() {
            let axis = axis as u8;
            items.push(match size.is_ragged() {
                true => self.sizes_of_items(sequence, axis),
                false => self.size(size).unwrap_or_else(|| {
                    let one = self.program.arena.integer(1);
                    let first = self.add(Kind::Item(sequence, one), (*item).clone());
                    self.size_of_first(length, first, axis)
                }),
            });
        }
        let types = items.iter().map(|item| self.ty(*item).clone()).collect();
        self.add(Kind::Tuple(items), Type::Tuple(types))
    }

    /// The sizes of the items of a sequence, as a sequence.
    pub(super) fn sizes_of_items(&mut self, sequence: ExprId, axis: u8) -> ExprId {
        if let Some((sizes, _)) = self
            .item_sizes
            .iter()
            .find(|(_, of)| **of == (sequence, axis))
        {
            return *sizes;
        }
        let Type::Sequence { item, length, .. } = self.ty(sequence).clone() else {
            return self.error();
        };
        let variable = self.program.arena.new_variable("k", Type::INTEGER);
        let k = self.program.arena.variable(variable);
        let item = self.add(Kind::Item(sequence, k), *item);
        let body = self.add(Kind::Extent(item, axis), Type::INTEGER);
        let size = self.extent(sequence, 0);
        let sizes = self.add(
            Kind::Tabulate {
                layout: Layout::Sequence,
                variables: vec![variable],
                sizes: vec![size],
                body,
            },
            Type::Sequence {
                item: Box::new(Type::INTEGER),
                length,
                index: None,
            },
        );
        self.item_sizes.insert(sizes, (sequence, axis));
        sizes
    }

    /// One of the sizes of items.
    pub(super) fn item_size(&mut self, sizes: ExprId, index: ExprId) -> ExprId {
        let Some(&(sequence, axis)) = self.item_sizes.get(&sizes) else {
            return self.add(Kind::Item(sizes, index), Type::INTEGER);
        };
        let Type::Sequence { item, .. } = self.ty(sequence).clone() else {
            return self.error();
        };
        let ty = self.item_type(&item, index);
        let item = self.add(Kind::Item(sequence, index), ty);
        self.add(Kind::Extent(item, axis), Type::INTEGER)
    }

    /// The type of one item: sizes that differ from item to item are those of this one.
    pub(super) fn item_type(&mut self, item: &Type, index: ExprId) -> Type {
        let shown = match self.program.arena.kind(index) {
            Kind::Integer(k) if *k >= 0 => k.to_string(),
            Kind::Variable(v) => self.program.arena.variable_name(*v).to_owned(),
            _ => "(…)".to_owned(),
        };
        let place = Place {
            expression: index.0,
            shown,
        };
        item.with_atoms(&|atom| match atom {
            Atom::Item(of, None) => Some(Atom::Item(of.clone(), Some(place.clone()))),
            _ => None,
        })
    }

    /// The type of the values of a body for all values of a variable, as the items of a sequence or the members of a
    /// set: sizes that depend on the variable differ from item to item.
    pub(super) fn type_of_all(&mut self, ty: &Type, variable: VariableId, counts: bool) -> Type {
        let value = self.program.arena.variable(variable);
        let arena = &self.program.arena;
        let fresh = std::cell::Cell::new(self.n_dynamic);
        let ty = ty.with_atoms(&|atom| match atom {
            Atom::Dynamic(_) => Some(Atom::Item(Box::new(atom.clone()), None)),
            Atom::Item(of, Some(place)) if counts && place.expression == value.0 => {
                Some(Atom::Item(of.clone(), None))
            }
            Atom::Item(_, Some(place)) if arena.depends_on(ExprId(place.expression), variable) => {
                fresh.set(fresh.get() + 1);
                Some(Atom::Item(Box::new(Atom::Dynamic(fresh.get())), None))
            }
            _ => None,
        });
        self.n_dynamic = fresh.get();
        ty
    }

    /// A type whose sizes do not depend on something that is not known here: sizes of items that are not of a sequence
    /// as a whole, and where `all` also other sizes that are known only at run time, become new ones.
    pub(super) fn with_new_sizes(
        &mut self,
        ty: &Type,
        is_unknown: &dyn Fn(&crate::ir::Arena, ExprId) -> bool,
        all: bool,
    ) -> Type {
        let arena = &self.program.arena;
        let fresh = std::cell::RefCell::new((self.n_dynamic, Vec::<(Atom, Atom)>::new()));
        let ty = ty.with_atoms(&|atom| {
            let replaced = match atom {
                Atom::Dynamic(_) => all,
                Atom::Item(_, Some(place)) => is_unknown(arena, ExprId(place.expression)),
                _ => false,
            };
            if !replaced {
                return None;
            }
            let mut fresh = fresh.borrow_mut();
            if let Some((_, new)) = fresh.1.iter().find(|(old, _)| old == atom) {
                return Some(new.clone());
            }
            fresh.0 += 1;
            let new = Atom::Dynamic(fresh.0);
            fresh.1.push((atom.clone(), new.clone()));
            Some(new)
        });
        self.n_dynamic = fresh.into_inner().0;
        ty
    }

    /// A size that is known only at run time.
    pub(super) fn new_dimension(&mut self) -> Dimension {
        self.n_dynamic += 1;
        Dimension::atom(Atom::Dynamic(self.n_dynamic))
    }

    /// A value whose size along an axis must be this one: compared at run time where it is not known before.
    pub(super) fn sized(
        &mut self,
        span: Span,
        value: ExprId,
        axis: u8,
        wanted: (&Dimension, ExprId),
    ) -> ExprId {
        let own = match (self.ty(value), axis) {
            (Type::Vector { length, .. }, 0) => length.clone(),
            (Type::Matrix { rows, .. }, 0) => rows.clone(),
            (Type::Matrix { columns, .. }, 1) => columns.clone(),
            _ => Dimension::known(1),
        };
        if own == *wanted.0 {
            return value;
        }
        let found = self.extent(value, axis);
        if found == wanted.1 {
            return value;
        }
        let ty = self.ty(value).clone();
        self.add_at(span, Kind::Agree(wanted.1, found, value), ty)
    }

    /// A matrix that must be square.
    pub(super) fn squared(&mut self, span: Span, matrix: ExprId) -> ExprId {
        let Type::Matrix { columns, .. } = self.ty(matrix).clone() else {
            return matrix;
        };
        let size = self.extent(matrix, 1);
        self.sized(span, matrix, 0, (&columns, size))
    }

    /// All rows of blocks must have as many columns: compared at run time where this is not known before. Blocks that stand
    /// below each other are compared one by one where the matrix is put together.
    pub(super) fn agreeing_rows(
        &mut self,
        rows: &[Vec<Expr>],
        widths: &[Vec<Dimension>],
        blocks: &mut [Vec<ExprId>],
    ) {
        let total = |widths: &[Dimension]| {
            let zero = Dimension::known(0);
            widths.iter().try_fold(zero, |sum, width| sum.add(width))
        };
        for r in 1..blocks.len() {
            if total(&widths[r]) == total(&widths[0]) || blocks[r].len() == blocks[0].len() {
                continue;
            }
            let (Some(first), Some(own)) = (self.columns(&blocks[0]), self.columns(&blocks[r]))
            else {
                continue;
            };
            let block = blocks[r][0];
            let ty = self.ty(block).clone();
            blocks[r][0] = self.add_at(rows[r][0].span, Kind::Agree(first, own, block), ty);
        }
    }

    /// The number of columns of blocks side by side.
    fn columns(&mut self, blocks: &[ExprId]) -> Option<ExprId> {
        let mut sum = None;
        for block in blocks {
            let columns = match self.ty(*block) {
                Type::Matrix { .. } => self.extent(*block, 1),
                _ => self.program.arena.integer(1),
            };
            sum = Some(match sum {
                None => columns,
                Some(sum) => self.add(Kind::Binary(Binary::Add, sum, columns), Type::INTEGER),
            });
        }
        sum
    }

    /// A size that is written as arithmetic over sizes.
    pub(super) fn symbolic(&mut self, e: &Expr) -> Option<Dimension> {
        match &e.kind {
            ExprKind::Integer(value) => Some(Dimension::known(*value)),
            ExprKind::Name(name) => {
                let Found::Value(value) = self.find(name) else {
                    let symbols = &self.resolved.module(self.module).symbols;
                    let meanings = &symbols.get(&name.text)?.meanings;
                    let is_size = *meanings == [crate::resolve::Meaning::Dimension]
                        && !self.ragged.contains_key(&name.text);
                    return is_size.then(|| Dimension::atom(Atom::Symbol(name.text.clone())));
                };
                let is_symbol = self.parameter_size(&name.text) == Some(value)
                    || self.templates.get(&name.text) == Some(&value)
                        && *self.ty(value) == Type::INTEGER;
                match self.program.arena.kind(value) {
                    Kind::Integer(n) => Some(Dimension::known(*n)),
                    Kind::Size(size) => Some(size.clone()),
                    _ => is_symbol.then(|| Dimension::atom(Atom::Symbol(name.text.clone()))),
                }
            }
            ExprKind::Binary {
                op, left, right, ..
            } => {
                let (left, right) = (self.symbolic(left)?, self.symbolic(right)?);
                arithmetic(left, *op, &right)
            }
            ExprKind::Unary {
                op: UnaryOp::Negate,
                operand,
            } => self.symbolic(operand)?.negate(),
            ExprKind::Unary {
                op: UnaryOp::Size,
                operand,
            }
            | ExprKind::Norm {
                double: false,
                operand,
                subscript: None,
            } => {
                let ExprKind::Name(name) = &operand.kind else {
                    return None;
                };
                let Found::Value(value) = self.find(name) else {
                    return None;
                };
                match (self.ty(value), self.program.arena.kind(value)) {
                    (Type::Sequence { length, .. }, Kind::Input(_)) => Some(length.clone()),
                    (Type::Set(_), Kind::AllElements(element)) => {
                        Some(Dimension::atom(Atom::Count(*element)))
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }
}

/// Arithmetic with sizes.
pub(super) fn arithmetic(a: Dimension, op: BinaryOp, b: &Dimension) -> Option<Dimension> {
    match op {
        BinaryOp::Add => a.add(b),
        BinaryOp::Subtract => b.negate().and_then(|b| a.add(&b)),
        BinaryOp::Juxtapose | BinaryOp::Dot => a.multiply(b),
        BinaryOp::Divide => a.divide(b.value()?),
        _ => None,
    }
}
