//! Expressions of a type.

use super::{Generator, Kind, Member, Signature, Size, Ty};

impl Generator {
    pub fn pick<'t>(&mut self, list: &[&'t str]) -> &'t str {
        list[self.random.usize(0..list.len())]
    }

    pub fn chance(&mut self, one_in: usize) -> bool {
        self.random.usize(0..one_in) == 0
    }

    /// A letter that nothing around has.
    pub fn letter(&self) -> String {
        let letters = "ijklpqstabcdhouvwyz".chars().map(String::from);
        let free = letters.filter(|l| self.scope.iter().all(|(name, _)| name != l));
        free.into_iter().next().unwrap_or_else(|| "ι".to_owned())
    }

    /// What `f` makes with a name in scope.
    pub fn with<T>(&mut self, name: &str, ty: Ty, f: impl FnOnce(&mut Self) -> T) -> T {
        self.scope.push((name.to_owned(), ty));
        let made = f(self);
        self.scope.pop();
        made
    }

    /// What `f` makes with an index in scope whose range follows from what it indexes: elsewhere it does not stand alone.
    pub fn with_index<T>(&mut self, letter: &str, f: impl FnOnce(&mut Self) -> T) -> T {
        self.with(letter, Ty::Index, |g| {
            g.with(&format!("({letter} + 0)"), Ty::Integer, f)
        })
    }

    /// The name of a parameter of this type, an old one or a new one.
    pub fn input(&mut self, ty: Ty) -> String {
        let known: Vec<String> = self
            .inputs
            .iter()
            .filter(|(_, t)| **t == ty)
            .map(|(name, _)| name.clone())
            .collect();
        let most = match ty {
            Ty::Real | Ty::Integer | Ty::Vector(_) => 2,
            _ => 1,
        };
        if known.len() >= most || (!known.is_empty() && self.random.bool()) {
            return known[self.random.usize(0..known.len())].clone();
        }
        let size = |size: Size| match size {
            Size::Known(n) => n.to_string(),
            Size::N => "n".to_owned(),
            Size::M => "m".to_owned(),
            Size::Own => panic!("no parameter of the program has the size of a function"),
        };
        let stem = match ty {
            Ty::Real => "r".to_owned(),
            Ty::Integer => "k".to_owned(),
            Ty::Vector(n) => format!("u{}x", size(n)),
            Ty::Matrix(n, m) => format!("A{}x{}x", size(n), size(m)),
            Ty::Sparse => "P".to_owned(),
            Ty::Integers => "t".to_owned(),
            Ty::Points => "x".to_owned(),
            Ty::Weights => "w".to_owned(),
            Ty::SetOf(Member::Integer) => "SZ".to_owned(),
            Ty::SetOf(Member::Real) => "SR".to_owned(),
            Ty::SetOf(Member::Pair) => "SP".to_owned(),
            Ty::SetOf(Member::Element(kind)) => format!("S{}", kind.set()),
            Ty::Element(kind) => format!("o{}", kind.set()),
            Ty::FieldOfPoints => "X".to_owned(),
            Ty::Field(kind) => format!("m{}", kind.set()),
            Ty::Function => "fun".to_owned(),
            Ty::Index => panic!("an index is no parameter"),
        };
        let name = format!("{stem}{}", known.len());
        self.inputs.insert(name.clone(), ty);
        name
    }

    /// A name of this type in scope.
    pub fn named(&mut self, ty: Ty) -> Option<String> {
        let names: Vec<String> = self
            .scope
            .iter()
            .filter(|(_, t)| *t == ty)
            .map(|(name, _)| name.clone())
            .collect();
        match names.is_empty() {
            true => None,
            // later ones are closer
            false => Some(
                names[self
                    .random
                    .usize(0..names.len())
                    .max(self.random.usize(0..names.len()))]
                .clone(),
            ),
        }
    }

    /// A name, or a parameter.
    pub fn leaf(&mut self, ty: Ty) -> String {
        let own = ty != ty.with(Size::N);
        match (self.named(ty), ty) {
            (Some(name), _) if own || !self.chance(4) => name,
            (None, Ty::Matrix(n, m)) if own => {
                let (u, v) = (self.leaf(Ty::Vector(n)), self.leaf(Ty::Vector(m)));
                format!("({u} ({v})ᵀ)")
            }
            _ => self.input(ty),
        }
    }

    /// A call of a function with this result.
    pub fn call(&mut self, ty: Ty, depth: usize) -> Option<String> {
        // the size that a function of any size is called with
        let own = match ty {
            Ty::Vector(n) | Ty::Matrix(n, _) => n,
            _ => self.size(),
        };
        let functions: Vec<Signature> = self
            .functions
            .iter()
            .filter(|f| f.result.with(own) == ty)
            .cloned()
            .collect();
        if functions.is_empty() {
            return None;
        }
        let function = functions[self.random.usize(0..functions.len())].clone();
        let arguments: Vec<String> = function
            .parameters
            .iter()
            .map(|ty| self.expression(ty.with(own), depth.saturating_sub(1)))
            .collect();
        Some(format!("{}({})", function.name, arguments.join(", ")))
    }

    /// An expression of a type, closed: it can stand as an operand anywhere.
    pub fn expression(&mut self, ty: Ty, depth: usize) -> String {
        if depth > 0
            && self.chance(6)
            && let Some(call) = self.call(ty, depth)
        {
            return call;
        }
        match ty {
            Ty::Real => self.real(depth),
            Ty::Integer => self.integer(depth),
            Ty::Vector(n) => self.vector(n, depth),
            Ty::Matrix(n, m) => self.matrix(n, m, depth),
            Ty::SetOf(member) => self.set(member, depth),
            Ty::Element(kind) => self.element(kind, depth),
            other => self.leaf(other),
        }
    }

    /// A condition that rounding does not change.
    pub fn condition(&mut self, depth: usize) -> String {
        let d = depth.saturating_sub(1);
        match self.random.usize(0..if depth == 0 { 4 } else { 8 }) {
            0 | 1 => {
                let sign = self.pick(&["<", "≤", ">", "≥", "=", "≠"]);
                let (a, b) = (self.integer(d.min(1)), self.integer(d.min(1)));
                format!("{a} {sign} {b}")
            }
            2 => {
                let sign = self.pick(&["<", "≤", ">", "≥", "≠"]);
                let (a, b) = (self.exact(d.min(2)), self.exact(1));
                format!("{a} {sign} {b}")
            }
            3 => {
                let sign = self.pick(&["∈", "∉"]);
                match self.random.usize(0..3) {
                    0 => {
                        let (a, b) = (self.integer(0), self.integer(0));
                        let set = self.set(Member::Pair, d.min(1));
                        format!("({a}, {b}) {sign} {set}")
                    }
                    1 if self.has_mesh => {
                        let kind = self.kind();
                        let item = self.leaf(Ty::Element(kind));
                        let set = self.set(Member::Element(kind), d.min(1));
                        format!("{item} {sign} {set}")
                    }
                    _ => {
                        let item = self.integer(d.min(1));
                        let set = self.set(Member::Integer, d.min(1));
                        format!("{item} {sign} {set}")
                    }
                }
            }
            4 if self.has_mesh => {
                let kind = self.kind();
                let sign = self.pick(&["=", "≠"]);
                let (a, b) = (self.leaf(Ty::Element(kind)), self.leaf(Ty::Element(kind)));
                format!("{a} {sign} {b}")
            }
            4 => {
                let sign = self.pick(&["=", "≠"]);
                let (a, b) = (
                    self.set(Member::Integer, d.min(1)),
                    self.set(Member::Integer, d.min(1)),
                );
                format!("{a} {sign} {b}")
            }
            _ => {
                let word = self.pick(&["and", "or"]);
                let (a, b) = (self.condition(d), self.condition(d));
                format!("{a} {word} {b}")
            }
        }
    }

    pub fn kind(&mut self) -> Kind {
        Kind::ALL[self.random.usize(0..3)]
    }

    /// A real number without rounding: sums and products of few short ones.
    pub fn exact(&mut self, depth: usize) -> String {
        if depth > 0 && self.random.bool() {
            let sign = self.pick(&["+", "-", "⋅"]);
            let (a, b) = (self.exact(depth - 1), self.exact(depth - 1));
            return format!("({a} {sign} {b})");
        }
        match self.random.usize(0..if self.has_mesh { 5 } else { 4 }) {
            0 => self.literal(),
            1 => self.input(Ty::Real),
            2 => {
                let (u, k) = (
                    self.input(Ty::Vector(Size::Known(3))),
                    self.random.usize(1..=3),
                );
                format!("{u}_{k}")
            }
            3 => format!("({} + {})", self.input(Ty::Real), self.integer(0)),
            _ => {
                let kind = self.kind();
                let (field, item) = (self.input(Ty::Field(kind)), self.leaf(Ty::Element(kind)));
                format!("{field}_({item})")
            }
        }
    }

    pub fn literal(&mut self) -> String {
        let k = self.random.u32(0..=16);
        format!("{}", f64::from(k) / 4.0)
            .split_once('.')
            .map_or(format!("{}.0", k / 4), |(a, b)| format!("{a}.{b}"))
    }

    /// A size, and an expression that a letter indexes with that size.
    pub fn indexed(&mut self, letter: &str, size: Size) -> String {
        match self.random.usize(0..3) {
            0 => {
                let other = self.size();
                let other = if other == Size::Own { Size::N } else { other };
                if size == Size::Own {
                    return format!("{}_{letter}", self.leaf(Ty::Vector(size)));
                }
                let a = self.leaf(Ty::Matrix(size, other));
                let row = self.random.usize(1..=2);
                format!("{a}_{letter},{row}")
            }
            _ => {
                let u = self.leaf(Ty::Vector(size));
                format!("{u}_{letter}")
            }
        }
    }

    pub fn size(&mut self) -> Size {
        if self.has_own_size && self.random.bool() {
            return Size::Own;
        }
        Size::ALL[self.random.usize(0..Size::ALL.len())]
    }
}
