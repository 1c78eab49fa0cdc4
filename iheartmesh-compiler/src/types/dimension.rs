//! Sizes as polynomials with rational coefficients over symbols, so that `n + n` and `2n` are one size.

use std::collections::BTreeMap;
use std::fmt;

use super::{Element, ElementKind};

/// An unknown number in a size.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Atom {
    /// A symbol such as the `n` of `ℝ^n`.
    Symbol(String),
    /// The common length of the sequences declared with one subscript letter.
    Length(String),
    /// The number of vertices, edges, faces or cells of a mesh.
    Count(Element),
    /// A size that is known only at run time; each is different from every other.
    Dynamic(u32),
    /// A size that differs from item to item of a sequence, as the `n_i` of `x_i ∈ ℝ^(n_i)`: a symbol or what is
    /// known only at run time, of each item, or of the item at a place.
    Item(Box<Atom>, Option<Place>),
}

/// Which item of a sequence is meant: an expression.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// Its number; equal numbers stand for equal values.
    pub expression: u32,
    /// As it is shown in messages.
    pub shown: String,
}

/// A size: a polynomial in [`Atom`]s over a number.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Dimension {
    /// Coefficient of each product of atoms (sorted); zero coefficients are left out.
    terms: BTreeMap<Vec<Atom>, i64>,
    /// What all of them are divided by: positive, and without a common factor with all coefficients.
    denominator: i64,
}

impl Dimension {
    /// A number.
    pub fn known(value: i64) -> Self {
        let mut terms = BTreeMap::new();
        if value != 0 {
            terms.insert(Vec::new(), value);
        }
        Self {
            terms,
            denominator: 1,
        }
    }

    /// A single unknown.
    pub fn atom(atom: Atom) -> Self {
        Self {
            terms: BTreeMap::from([(vec![atom], 1)]),
            denominator: 1,
        }
    }

    /// The number it is, if it is an integer.
    pub fn value(&self) -> Option<i64> {
        if self.denominator != 1 {
            return None;
        }
        match self.terms.len() {
            0 => Some(0),
            1 => self.terms.get(&Vec::new()).copied(),
            _ => None,
        }
    }

    /// The single unknown it is, if it is one.
    pub fn as_atom(&self) -> Option<&Atom> {
        match self.terms.iter().next() {
            Some((atoms, 1))
                if self.terms.len() == 1 && atoms.len() == 1 && self.denominator == 1 =>
            {
                atoms.first()
            }
            _ => None,
        }
    }

    /// Sum of two sizes; `None` when a coefficient overflows.
    pub fn add(&self, other: &Self) -> Option<Self> {
        let mut terms = BTreeMap::new();
        for (from, factor) in [(self, other.denominator), (other, self.denominator)] {
            for (atoms, coefficient) in &from.terms {
                let sum: &mut i64 = terms.entry(atoms.clone()).or_insert(0);
                *sum = sum.checked_add(coefficient.checked_mul(factor)?)?;
            }
        }
        Self::reduced(terms, self.denominator.checked_mul(other.denominator)?)
    }

    /// Product of two sizes; `None` when a coefficient overflows.
    pub fn multiply(&self, other: &Self) -> Option<Self> {
        let mut terms = BTreeMap::new();
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                let mut atoms = a.clone();
                atoms.extend(b.iter().cloned());
                atoms.sort();
                let sum: &mut i64 = terms.entry(atoms).or_insert(0);
                *sum = sum.checked_add(x.checked_mul(*y)?)?;
            }
        }
        Self::reduced(terms, self.denominator.checked_mul(other.denominator)?)
    }

    /// A size divided by a number; `None` for 0, and when a coefficient overflows.
    pub fn divide(&self, by: i64) -> Option<Self> {
        let sign = (by != 0).then(|| by.signum())?;
        let mut terms = self.terms.clone();
        for coefficient in terms.values_mut() {
            *coefficient = coefficient.checked_mul(sign)?;
        }
        Self::reduced(terms, self.denominator.checked_mul(by.checked_abs()?)?)
    }

    /// Without what has no effect: zero coefficients, and what all coefficients and the denominator have in common.
    fn reduced(mut terms: BTreeMap<Vec<Atom>, i64>, denominator: i64) -> Option<Self> {
        if denominator <= 0 {
            return None;
        }
        terms.retain(|_, coefficient| *coefficient != 0);
        let common = terms.values().fold(denominator.unsigned_abs(), |a, b| {
            greatest_common_divisor(a, b.unsigned_abs())
        });
        let common = i64::try_from(common).ok()?;
        for coefficient in terms.values_mut() {
            *coefficient /= common;
        }
        let denominator = denominator / common;
        Some(Self { terms, denominator })
    }

    /// The negated size.
    pub fn negate(&self) -> Option<Self> {
        self.multiply(&Self::known(-1))
    }

    /// Whether two sizes are known to be different: their difference is a number other than 0, or a symbol is
    /// compared with another symbol or with a number.
    pub fn differs(&self, other: &Self) -> bool {
        self != other && !self.is_dynamic() && !other.is_dynamic()
    }

    /// What the sum of its [`terms`](Self::terms) is divided by.
    pub fn denominator(&self) -> i64 {
        self.denominator
    }

    /// The sum of products that it is, over its [`denominator`](Self::denominator): coefficients with their atoms.
    pub fn terms(&self) -> impl Iterator<Item = (i64, &[Atom])> {
        self.terms.iter().map(|(atoms, k)| (*k, atoms.as_slice()))
    }

    /// Whether it depends on nothing but numbers of mesh elements.
    pub fn is_of_meshes(&self) -> bool {
        self.terms
            .keys()
            .flatten()
            .all(|atom| matches!(atom, Atom::Count(_)))
    }

    /// The size with symbols replaced.
    pub fn substitute(&self, replace: &dyn Fn(&Atom) -> Option<Dimension>) -> Dimension {
        let mut sum = Self::known(0);
        for (atoms, k) in &self.terms {
            let mut product = Some(Self::known(*k));
            for atom in atoms {
                let factor = replace(atom).unwrap_or_else(|| Self::atom(atom.clone()));
                product = product.and_then(|p| p.multiply(&factor));
            }
            sum = product.and_then(|p| sum.add(&p)).unwrap_or(sum);
        }
        sum.divide(self.denominator).unwrap_or(sum)
    }

    /// All unknowns in it.
    pub fn atoms(&self) -> impl Iterator<Item = &Atom> {
        self.terms.keys().flatten()
    }

    /// Whether it differs from item to item of a sequence.
    pub fn is_ragged(&self) -> bool {
        self.atoms().any(|atom| matches!(atom, Atom::Item(_, None)))
    }

    /// Whether something in it is known only at run time.
    pub fn is_dynamic(&self) -> bool {
        self.atoms()
            .any(|atom| matches!(atom, Atom::Dynamic(_) | Atom::Item(..)))
    }
}

fn greatest_common_divisor(a: u64, b: u64) -> u64 {
    match b {
        0 => a,
        _ => greatest_common_divisor(b, a % b),
    }
}

impl fmt::Display for Atom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Atom::Symbol(name) => write!(f, "{name}"),
            Atom::Length(letter) => write!(f, "|{letter}|"),
            Atom::Count(element) => {
                let letter = match element.kind {
                    ElementKind::Vertex => "V",
                    ElementKind::Edge => "E",
                    ElementKind::Face => "F",
                    ElementKind::Cell => "C",
                };
                write!(f, "|{letter}|")
            }
            Atom::Dynamic(_) => write!(f, "?"),
            Atom::Item(of, _) if matches!(**of, Atom::Dynamic(_)) => write!(f, "?"),
            Atom::Item(of, None) => write!(f, "{of}_i"),
            Atom::Item(of, Some(place)) => write!(f, "{of}_{}", place.shown),
        }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.terms.is_empty() {
            return write!(f, "0");
        }
        if self.denominator != 1 {
            let above = Self {
                denominator: 1,
                ..self.clone()
            };
            return match self.terms.len() {
                1 => write!(f, "{above}/{}", self.denominator),
                _ => write!(f, "({above})/{}", self.denominator),
            };
        }
        // the constant comes last, as one writes it
        let (constant, others): (Vec<_>, Vec<_>) =
            self.terms.iter().partition(|(atoms, _)| atoms.is_empty());
        for (k, (atoms, coefficient)) in others.into_iter().chain(constant).enumerate() {
            match (k, *coefficient < 0) {
                (0, true) => write!(f, "-")?,
                (0, false) => {}
                (_, true) => write!(f, "-")?,
                (_, false) => write!(f, "+")?,
            }
            let size = coefficient.unsigned_abs();
            if size != 1 || atoms.is_empty() {
                write!(f, "{size}")?;
            }
            for atom in atoms {
                write!(f, "{atom}")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn symbol(name: &str) -> Dimension {
        Dimension::atom(Atom::Symbol(name.into()))
    }

    #[test]
    fn twice_is_the_sum_with_itself() {
        let n = symbol("n");
        assert_eq!(n.add(&n), n.multiply(&Dimension::known(2)));
    }

    #[test]
    fn products_are_expanded() {
        let (p, k, one) = (symbol("p"), symbol("k"), Dimension::known(1));
        let product = p.add(&one).unwrap().multiply(&k).unwrap();
        assert_eq!(product, k.add(&p.multiply(&k).unwrap()).unwrap());
        assert_eq!(p.add(&one).unwrap().to_string(), "p+1");
    }

    #[test]
    fn different_symbols_differ_and_dynamic_sizes_do_not() {
        assert!(symbol("n").differs(&symbol("m")));
        assert!(symbol("n").differs(&Dimension::known(3)));
        assert!(!symbol("n").differs(&Dimension::atom(Atom::Dynamic(0))));
    }

    #[test]
    fn quotients_are_reduced() {
        let (n, one) = (symbol("n"), Dimension::known(1));
        let half = n.divide(2).unwrap();
        assert_eq!(half.add(&half), Some(n.clone()));
        assert_eq!(half.to_string(), "n/2");
        let more = n.add(&one).unwrap().divide(2).unwrap();
        assert_eq!(more.to_string(), "(n+1)/2");
        assert_eq!(
            more.multiply(&Dimension::known(4)).unwrap().to_string(),
            "2n+2"
        );
        assert_eq!(n.divide(-2).unwrap().to_string(), "-n/2");
        assert_eq!(Dimension::known(3).divide(2).unwrap().value(), None);
        assert_eq!(n.divide(0), None);
    }

    #[test]
    fn sizes_of_items_may_agree() {
        let n = Box::new(Atom::Symbol("n".into()));
        let at = |k: u32| Place {
            expression: k,
            shown: k.to_string(),
        };
        let first = Dimension::atom(Atom::Item(n.clone(), Some(at(1))));
        let second = Dimension::atom(Atom::Item(n.clone(), Some(at(2))));
        assert!(first != second && !first.differs(&second));
        assert_eq!(first.to_string(), "n_1");
        assert!(Dimension::atom(Atom::Item(n, None)).is_ragged());
    }

    #[test]
    fn overflow_is_not_a_size() {
        assert_eq!(Dimension::known(i64::MAX).add(&Dimension::known(1)), None);
    }
}
