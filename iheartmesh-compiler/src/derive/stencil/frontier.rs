//! What a formula is differentiated by: numbers that are linear in the entries of the variable, where they are fewer than
//! those.

use std::collections::{BTreeSet, HashMap};

use super::formula::Formulas;
use crate::ir::{Binary, ExprId, Kind, Unary};

/// Numbers that are linear in the variable.
#[derive(Debug, Default)]
struct Linear {
    known: HashMap<ExprId, bool>,
}

impl Formulas<'_, '_> {
    /// The numbers through which a formula depends on the variable: all of them linear, as few as are found.
    pub(super) fn frontier(&mut self, e: ExprId, entries: &[ExprId]) -> Vec<ExprId> {
        let mut linear = Linear::default();
        let mut found = BTreeSet::new();
        let mut seen = BTreeSet::new();
        let mut open = vec![e];
        while let Some(e) = open.pop() {
            if !self.is_active(e) || !seen.insert(e) {
                continue;
            }
            match self.is_linear(e, entries, &mut linear) {
                true => {
                    let base = self.base(e, entries);
                    found.insert(base);
                }
                false => open.extend(self.operands(e)),
            }
        }
        // what is made of others is not needed beside them
        for e in found.iter().rev().copied().collect::<Vec<_>>() {
            if entries.contains(&e) {
                continue;
            }
            let mut parts = Vec::new();
            for part in self.operands(e) {
                if self.is_active(part) {
                    parts.push(self.base(part, entries));
                }
            }
            if parts.iter().all(|part| found.contains(part)) {
                found.remove(&e);
            }
        }
        found.into_iter().collect()
    }

    fn operands(&self, e: ExprId) -> Vec<ExprId> {
        if let Some(determinant) = self.reciprocals.get(&e) {
            return vec![*determinant];
        }
        let mut all = Vec::new();
        self.normal.program.arena.kind(e).operands(|a| all.push(a));
        all
    }

    fn is_linear(&mut self, e: ExprId, entries: &[ExprId], linear: &mut Linear) -> bool {
        if !self.is_active(e) || entries.contains(&e) {
            return true;
        }
        if let Some(known) = linear.known.get(&e) {
            return *known;
        }
        let is_linear = match self.normal.kind(e) {
            Kind::Unary(Unary::Negate, a) => self.is_linear(a, entries, linear),
            Kind::Binary(Binary::Add | Binary::Subtract, a, b) => {
                self.is_linear(a, entries, linear) && self.is_linear(b, entries, linear)
            }
            Kind::Binary(Binary::Multiply, a, b) => {
                (!self.is_active(a) || !self.is_active(b))
                    && self.is_linear(a, entries, linear)
                    && self.is_linear(b, entries, linear)
            }
            _ => false,
        };
        linear.known.insert(e, is_linear);
        is_linear
    }

    /// A linear number without its factor, its sign and what is added to it.
    fn base(&mut self, e: ExprId, entries: &[ExprId]) -> ExprId {
        if entries.contains(&e) {
            return e;
        }
        let mut parts = Vec::new();
        for part in self.operands(e) {
            if self.is_active(part) {
                parts.push(part);
            }
        }
        match parts.as_slice() {
            [single] => self.base(*single, entries),
            _ => e,
        }
    }
}
