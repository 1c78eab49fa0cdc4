//! Sizes as polynomials with integer coefficients over symbols, so that `n + n` and `2n` are one size.

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
}

/// A size: a polynomial in [`Atom`]s.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Dimension {
    /// Coefficient of each product of atoms (sorted); zero coefficients are left out.
    terms: BTreeMap<Vec<Atom>, i64>,
}

impl Dimension {
    /// A number.
    pub fn known(value: i64) -> Self {
        let mut terms = BTreeMap::new();
        if value != 0 {
            terms.insert(Vec::new(), value);
        }
        Self { terms }
    }

    /// A single unknown.
    pub fn atom(atom: Atom) -> Self {
        Self {
            terms: BTreeMap::from([(vec![atom], 1)]),
        }
    }

    /// The number it is, if it is one.
    pub fn value(&self) -> Option<i64> {
        match self.terms.len() {
            0 => Some(0),
            1 => self.terms.get(&Vec::new()).copied(),
            _ => None,
        }
    }

    /// The single unknown it is, if it is one.
    pub fn as_atom(&self) -> Option<&Atom> {
        match self.terms.iter().next() {
            Some((atoms, 1)) if self.terms.len() == 1 && atoms.len() == 1 => atoms.first(),
            _ => None,
        }
    }

    /// Sum of two sizes; `None` when a coefficient overflows.
    pub fn add(&self, other: &Self) -> Option<Self> {
        let mut terms = self.terms.clone();
        for (atoms, coefficient) in &other.terms {
            let sum = terms.entry(atoms.clone()).or_insert(0);
            *sum = sum.checked_add(*coefficient)?;
        }
        terms.retain(|_, coefficient| *coefficient != 0);
        Some(Self { terms })
    }

    /// Product of two sizes; `None` when a coefficient overflows.
    pub fn multiply(&self, other: &Self) -> Option<Self> {
        let mut product = Self::known(0);
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                let mut atoms = a.clone();
                atoms.extend(b.iter().cloned());
                atoms.sort();
                product = product.add(&Self {
                    terms: BTreeMap::from([(atoms, x.checked_mul(*y)?)]),
                })?;
            }
        }
        Some(product)
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

    /// The sum of products that it is: coefficients with their atoms.
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
        sum
    }

    fn is_dynamic(&self) -> bool {
        self.terms
            .keys()
            .flatten()
            .any(|atom| matches!(atom, Atom::Dynamic(_)))
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
        }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.terms.is_empty() {
            return write!(f, "0");
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
    fn overflow_is_not_a_size() {
        assert_eq!(Dimension::known(i64::MAX).add(&Dimension::known(1)), None);
    }
}
