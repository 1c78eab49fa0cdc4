//! Finds how blocks whose eigenvalues are replaced are put together, in sums with planned places, see [`super::slots`]: at
//! places that the program fixes, a small matrix of fixed size, see [`super::slot_units`]; all others where the plan says, see
//! [`super::slot_locals`].

use super::slot_finder::{Finder, parts};
use super::slots::{Added, Step, Unit};
use crate::ir::{Binary, ExprId, Kind, Unary, VariableId};
use crate::types::Shape;

impl Finder<'_> {
    /// The product of a block whose eigenvalues are replaced, and a vector or a dense matrix that has a name.
    pub(super) fn product(
        &mut self,
        block: ExprId,
        factor: ExprId,
        bound: &[VariableId],
    ) -> Option<Vec<Step>> {
        let Kind::Unary(Unary::PositivePart | Unary::AbsolutePart, a) = *self.kind(block) else {
            return None;
        };
        let arena = &self.context.program().arena;
        let is_named = matches!(self.kind(factor), Kind::Global(_) | Kind::Input(_));
        if !is_named || self.local.is_some() {
            return None;
        }
        let array = self.array;
        let Some(Unit { places, height, .. }) = self.unit(block, a, bound, true) else {
            let added = match (arena.ty(factor).shape()?, &self.sum.arrays[array].sizes[..]) {
                (Shape::Vector(_), [_]) => Added::Vector,
                (Shape::Matrix(..), [_, columns]) => Added::Columns(*columns),
                _ => return None,
            };
            return self.local(a, bound, added);
        };
        match (arena.ty(factor).shape()?, &self.sum.arrays[array].sizes[..]) {
            (Shape::Vector(_), [_]) => Some(vec![Step::Block {
                array,
                rows: places,
                columns: Vec::new(),
                height,
                width: 1,
            }]),
            (Shape::Matrix(..), [_, columns]) => Some(vec![Step::Columns {
                array,
                rows: places,
                columns: *columns,
                height,
            }]),
            _ => None,
        }
    }

    /// A block whose eigenvalues are replaced: all its places, each with each.
    pub(super) fn unit(
        &mut self,
        e: ExprId,
        a: ExprId,
        bound: &[VariableId],
        is_multiplied: bool,
    ) -> Option<Unit> {
        let mut unit = Unit {
            places: Vec::new(),
            height: 0,
            is_multiplied,
        };
        let before = self.choices;
        self.parts_of(a, bound, &mut unit)?;
        // places are named beside the block, and must be known there: outside of branches
        let is_known = |e: &ExprId| matches!(self.kind(*e), Kind::Column(..) | Kind::Variable(_));
        let branches = self.choices > before;
        if unit.places.is_empty() || branches && !unit.places.iter().all(is_known) {
            return None;
        }
        self.sum.units.insert(e, unit.clone());
        Some(unit)
    }

    fn parts_of(&mut self, e: ExprId, bound: &[VariableId], unit: &mut Unit) -> Option<()> {
        match self.kind(e).clone() {
            Kind::Assemble { sizes, blocks } => {
                if !unit.is_multiplied {
                    self.sizes(&sizes)?;
                }
                for block in &blocks {
                    let (rows, columns) = self.context.fixed_shape(block.value)?;
                    if let Some(core) = block.core {
                        self.context.fixed_shape(core)?;
                    }
                    for (size, places) in [(rows, &block.rows), (columns, &block.columns)] {
                        let height = parts(size, places.len())?;
                        if unit.height != 0 && unit.height != height {
                            return None;
                        }
                        unit.height = height;
                        for place in places {
                            self.steady(*place, bound)?;
                            if !unit.places.contains(place) {
                                unit.places.push(*place);
                            }
                        }
                    }
                }
                Some(())
            }
            Kind::Binary(Binary::Add, a, b) | Kind::If(_, a, b) => {
                self.choices += usize::from(matches!(self.kind(e), Kind::If(..)));
                self.parts_of(a, bound, unit)?;
                self.parts_of(b, bound, unit)
            }
            Kind::Binary(Binary::Multiply, _, a) => self.parts_of(a, bound, unit),
            _ => None,
        }
    }

    /// A block whose eigenvalues are replaced and whose number of rows the mesh decides: around it what all of its parts
    /// give.
    pub(super) fn local(
        &mut self,
        a: ExprId,
        bound: &[VariableId],
        added: Added,
    ) -> Option<Vec<Step>> {
        self.local = Some(added != Added::Block);
        let steps = self.steps(a, &mut bound.to_vec());
        self.local = None;
        let steps = steps?;
        Some(vec![Step::Local {
            array: self.array,
            height: Step::largest_of(&steps).max(1),
            steps,
            added,
        }])
    }
}
