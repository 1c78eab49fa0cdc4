//! Numbers, vectors and matrices.

use super::{Generator, Kind, Member, Size, Ty};

const THREE: Size = Size::Known(3);

impl Generator {
    pub fn real(&mut self, depth: usize) -> String {
        if depth == 0 {
            return match self.random.usize(0..4) {
                0 => self.literal(),
                1 => self.exact(0),
                _ => self.leaf(Ty::Real),
            };
        }
        let d = depth - 1;
        match self.random.usize(0..if self.has_mesh { 38 } else { 32 }) {
            0..=2 => {
                let sign = self.pick(&["+", "-"]);
                format!("({} {sign} {})", self.real(d), self.real(d))
            }
            3..=5 => {
                let sign = self.pick(&["⋅", ""]);
                format!("({} {sign} ({}))", self.real(d), self.real(d))
            }
            6 => format!("({} / {})", self.real(d), self.real(d)),
            7 => format!("({} / (1 + {}²))", self.real(d), self.real(d)),
            8 => format!("(-{})", self.real(d)),
            9 => format!("|({})|", self.real(d)),
            10 => format!("√|({})|", self.real(d)),
            11 => {
                let power = self.pick(&["²", "³", "⁻¹", "^2", "^0"]);
                format!("({}{power})", self.real(d))
            }
            12 => {
                let function = self.pick(&["sin", "cos", "arctan", "tanh"]);
                format!("{function}({})", self.real(d))
            }
            13 => {
                let function = self.pick(&["min", "max"]);
                format!("{function}({}, {})", self.real(d), self.real(d))
            }
            14 => format!("exp(-|({})|)", self.real(d)),
            15 => format!("atan2({}, {})", self.real(d), self.real(d)),
            16 => {
                let n = self.size();
                let (u, v) = (self.vector(n, d), self.vector(n, d));
                match self.random.usize(0..3) {
                    0 => format!("({u} ⋅ {v})"),
                    1 => format!("({u}ᵀ {v})"),
                    _ => format!("<{u}, {v}>"),
                }
            }
            17 | 18 => {
                let n = self.size();
                let u = self.vector(n, d);
                let norm = self.pick(&["‖", "‖_1", "‖_∞", "‖_3", "‖²"]);
                format!("‖{u}{norm}")
            }
            19 => {
                let n = self.size();
                let u = self.leaf(Ty::Vector(n));
                match n {
                    Size::Known(n) => format!("{u}_{}", self.random.usize(1..=n)),
                    _ => format!("{u}_({})", self.integer(d.min(1))),
                }
            }
            20 => {
                let (n, m) = (self.outer_size(), self.outer_size());
                let a = self.leaf(Ty::Matrix(n, m));
                let (i, j) = (self.index(n), self.index(m));
                format!("{a}_{i},{j}")
            }
            21 => {
                let n = self.size();
                let a = self.matrix(n, n, d);
                let what = self.pick(&["tr", "det"]);
                format!("{what}({a})")
            }
            22 => {
                let (n, m) = (self.size(), self.size());
                let (a, b) = (self.matrix(n, m, d), self.matrix(n, m, d));
                match self.random.usize(0..2) {
                    0 => format!("({a} : {b})"),
                    _ => format!("‖{a}‖_F"),
                }
            }
            23 => {
                let sign = self.pick(&["+", "-", "⋅"]);
                format!("({} {sign} {})", self.integer(d), self.real(d))
            }
            24 | 25 => self.sum(Ty::Real, d),
            26 => {
                let letter = self.letter();
                let k = self.integer(0);
                let body = self.with(&letter, Ty::Integer, |g| g.real(d));
                format!("(∏_({letter} = 1)^({k}) {body})")
            }
            27 | 28 if self.is_differentiable => self.leaf(Ty::Real),
            27 => format!("{}({})", self.input(Ty::Function), self.real(d)),
            28 => {
                let what = self.pick(&["min", "max"]);
                format!("{what}({})", self.set(Member::Real, d))
            }
            29 => {
                let n = self.size();
                let what = self.pick(&["min", "max"]);
                format!("{what}({})", self.vector(n, d))
            }
            30 => {
                let (w, k) = (self.leaf(Ty::Weights), self.integer(d.min(1)));
                format!("{w}_({k})")
            }
            31 => {
                let n = self.size();
                let (u, p) = (self.vector(n, d), self.matrix(n, n, 0));
                format!("({u}ᵀ {p} {u})")
            }
            _ => {
                let kind = self.kind();
                let element = self.element(kind, d);
                match self.random.usize(0..3) {
                    0 => {
                        let other = self.element(Kind::Vertex, d);
                        let x = self.input(Ty::FieldOfPoints);
                        let v = self.element(Kind::Vertex, d);
                        format!("‖{x}_({v}) - {x}_({other})‖")
                    }
                    1 => self.sum(Ty::Real, d),
                    _ => format!("{}_({element})", self.input(Ty::Field(kind))),
                }
            }
        }
    }

    pub fn integer(&mut self, depth: usize) -> String {
        if depth == 0 {
            return match self.random.usize(0..4) {
                0 => self.random.u32(0..=4).to_string(),
                1 => self.input(Ty::Integer),
                _ => self.leaf(Ty::Integer),
            };
        }
        let d = depth - 1;
        match self.random.usize(0..if self.has_mesh { 17 } else { 14 }) {
            0..=2 => {
                let sign = self.pick(&["+", "-"]);
                format!("({} {sign} {})", self.integer(d), self.integer(d))
            }
            3 => format!("({} ⋅ {})", self.integer(d), self.integer(d)),
            4 => format!("(-{})", self.integer(d)),
            5 => format!("|({})|", self.integer(d)),
            6 => {
                let what = self.pick(&["min", "max"]);
                format!("{what}({}, {})", self.integer(d), self.integer(d))
            }
            7 => format!("|{}|", self.set(Member::Integer, d)),
            8 => format!("|{}|", self.set(Member::Pair, d)),
            9 => match self.random.usize(0..3) {
                0 => format!("|{}|", self.leaf(Ty::Points)),
                1 => format!("#{}", self.leaf(Ty::Weights)),
                _ => {
                    let n = self.size();
                    format!("#{}", self.leaf(Ty::Vector(n)))
                }
            },
            10 => self.sum(Ty::Integer, d),
            11 => {
                let what = self.pick(&["min", "max"]);
                format!("{what}({})", self.set(Member::Integer, d))
            }
            12 => {
                let k = self.integer(0);
                format!("{}_({k})", self.input(Ty::Integers))
            }
            13 => {
                let letter = self.letter();
                let k = self.integer(0);
                let body = self.with(&letter, Ty::Integer, |g| g.integer(d));
                format!("(∏_({letter} = 1)^({k}) {body})")
            }
            14 => {
                let (v, e, f) = (
                    self.leaf(Ty::Element(Kind::Vertex)),
                    self.leaf(Ty::Element(Kind::Edge)),
                    self.leaf(Ty::Element(Kind::Face)),
                );
                match self.random.bool() {
                    true => format!("`∂⁰`_{v},{e}"),
                    false => format!("`∂¹`_{e},{f}"),
                }
            }
            _ => {
                let kind = self.kind();
                format!("|{}|", self.set(Member::Element(kind), d))
            }
        }
    }

    /// A sum of terms of a type: over a range, a set, or subscripts.
    pub fn sum(&mut self, ty: Ty, depth: usize) -> String {
        let letter = self.letter();
        let top = if self.has_mesh { 6 } else { 4 };
        let d = depth;
        match self.random.usize(0..top) {
            0 => {
                let (from, to) = (self.random.i32(0..=2), self.integer(0));
                let body = self.with(&letter, Ty::Integer, |g| g.expression(ty, d));
                format!("(∑_({letter} = {from})^({to}) {body})")
            }
            1 => {
                let set = self.set(Member::Integer, d);
                let body = self.with(&letter, Ty::Integer, |g| g.expression(ty, d));
                format!("(∑_({letter} ∈ {set}) {body})")
            }
            2 | 3 if ty != Ty::Integer => {
                let size = self.size();
                let filter = match self.random.usize(0..3) {
                    0 => {
                        let condition = self.with(&letter, Ty::Integer, |g| g.condition(d.min(1)));
                        format!("({letter} for {condition})")
                    }
                    _ => letter.clone(),
                };
                let (factor, body) = self.with_index(&letter, |g| {
                    let factor = match g.random.usize(0..4) {
                        0 => format!("{}_{letter}", g.leaf(Ty::Weights)),
                        _ => g.indexed(&letter, size),
                    };
                    (factor, g.expression(ty, d))
                });
                format!("(∑_{filter} {factor} ({body}))")
            }
            2 | 3 => {
                let body = self.with_index(&letter, |g| g.expression(ty, d));
                let t = self.input(Ty::Integers);
                format!("(∑_{letter} {t}_{letter} ({body}))")
            }
            _ => {
                let kind = self.kind();
                let set = self.set(Member::Element(kind), d);
                let body = self.with(&letter, Ty::Element(kind), |g| g.expression(ty, d));
                format!("(∑_({letter} ∈ {set}) {body})")
            }
        }
    }

    pub fn vector(&mut self, n: Size, depth: usize) -> String {
        if depth == 0 {
            return self.leaf(Ty::Vector(n));
        }
        let d = depth - 1;
        match self.random.usize(0..20) {
            0..=2 => {
                let sign = self.pick(&["+", "-"]);
                format!("({} {sign} {})", self.vector(n, d), self.vector(n, d))
            }
            3 => format!("({} ({}))", self.real(d), self.vector(n, d)),
            4 => format!("({} / {})", self.vector(n, d), self.real(d)),
            5 => format!("(-{})", self.vector(n, d)),
            6 | 7 => {
                let m = self.size();
                format!("({} ({}))", self.matrix(n, m, d), self.vector(m, d))
            }
            8 if n == THREE => format!("({} × {})", self.vector(n, d), self.vector(n, d)),
            8 | 9 => match n {
                Size::Known(k) => {
                    let items: Vec<String> = (0..k).map(|_| self.real(d.min(1))).collect();
                    format!("({})", items.join(", "))
                }
                _ => format!("(1_{} ({}))", n.text(), self.real(d)),
            },
            10 => format!("({} ∘ {})", self.vector(n, d), self.vector(n, d)),
            11 if n != Size::Own => {
                let m = self.outer_size();
                let a = self.leaf(Ty::Matrix(n, m));
                format!("{a}_*,{}", self.index(m))
            }
            12 if n != Size::Own => {
                let m = self.outer_size();
                let a = self.leaf(Ty::Matrix(m, n));
                format!("{a}_{},*", self.index(m))
            }
            13 => {
                let a = self.matrix(n, n, 0);
                match self.random.usize(0..3) {
                    0 => format!("({a} \\ {})", self.vector(n, d)),
                    1 => format!("(({a} + {a}ᵀ + 20 I_{})⁻¹ {})", n.text(), self.vector(n, d)),
                    _ => format!("({a}⁻¹ {})", self.vector(n, d)),
                }
            }
            14 => format!("diag({})", self.matrix(n, n, d)),
            15 | 16 => self.sum(Ty::Vector(n), d),
            17 if n == THREE => {
                let (x, k) = (self.leaf(Ty::Points), self.integer(0));
                format!("{x}_({k})")
            }
            17 => format!("sin({})", self.vector(n, d)),
            _ if n == THREE && self.has_mesh => {
                let v = self.element(Kind::Vertex, d);
                format!("{}_({v})", self.input(Ty::FieldOfPoints))
            }
            18 if n == Size::N => format!("({} ({}))", self.input(Ty::Sparse), self.vector(n, d)),
            _ => {
                let m = self.size();
                format!("({}ᵀ ({}))", self.matrix(m, n, d), self.vector(m, d))
            }
        }
    }

    /// A size that parameters of the program have.
    fn outer_size(&mut self) -> Size {
        match self.size() {
            Size::Own => Size::M,
            size => size,
        }
    }

    /// A number of a row or column that is there, mostly.
    fn index(&mut self, size: Size) -> String {
        match size {
            Size::Known(n) => self.random.usize(1..=n).to_string(),
            _ => match self.random.bool() {
                true => "1".to_owned(),
                false => self.input(Ty::Integer),
            },
        }
    }

    pub fn matrix(&mut self, n: Size, m: Size, depth: usize) -> String {
        if depth == 0 {
            return self.leaf(Ty::Matrix(n, m));
        }
        let d = depth - 1;
        match self.random.usize(0..15) {
            0 | 1 => {
                let sign = self.pick(&["+", "-"]);
                format!("({} {sign} {})", self.matrix(n, m, d), self.matrix(n, m, d))
            }
            2 => format!("({} ({}))", self.real(d), self.matrix(n, m, d)),
            3 | 4 => {
                let k = self.size();
                format!("({} ({}))", self.matrix(n, k, d), self.matrix(k, m, d))
            }
            5 => format!("({}ᵀ)", self.matrix(m, n, d)),
            6 => format!("({} ({})ᵀ)", self.vector(n, d), self.vector(m, d)),
            7 => format!("({} ∘ {})", self.matrix(n, m, d), self.matrix(n, m, d)),
            8 if n == m => format!("I_{}", n.text()),
            8 => {
                let one = self.pick(&["0", "1"]);
                format!("{one}_({},{})", n.text(), m.text())
            }
            9 if n == m && !self.is_differentiable && self.random.bool() => {
                let other = self.outer_size();
                let kernel = format!("null({})", self.leaf(Ty::Matrix(other, n)));
                format!("({kernel} {kernel}ᵀ)")
            }
            9 if n == m && !self.is_differentiable && self.chance(3) => {
                let a = self.leaf(Ty::Matrix(n, n));
                format!("psd({a} + {a}ᵀ)")
            }
            9 if n == m => format!("({}²)", self.matrix(n, m, d)),
            9 => format!("(-{})", self.matrix(n, m, d)),
            10 => match (n, m) {
                (Size::Known(2), Size::Known(2)) => {
                    let cells: Vec<String> = (0..4).map(|_| self.real(d)).collect();
                    format!("[{} {}; {} {}]", cells[0], cells[1], cells[2], cells[3])
                }
                (_, Size::Known(2)) => format!("[{} {}]", self.vector(n, d), self.vector(n, d)),
                (Size::Known(3), _) => format!(
                    "[{}ᵀ; {}ᵀ; {}ᵀ]",
                    self.vector(m, d),
                    self.vector(m, d),
                    self.vector(m, d)
                ),
                (Size::Known(5), Size::Known(5)) => format!(
                    "[{} {}; {} {}]",
                    self.matrix(Size::Known(2), Size::Known(3), d),
                    self.matrix(Size::Known(2), Size::Known(2), 0),
                    self.matrix(Size::Known(3), Size::Known(3), 0),
                    self.pick(&["0", "1"]),
                ),
                _ => self.leaf(Ty::Matrix(n, m)),
            },
            11 if n == m => format!("diag({})", self.vector(n, d)),
            11 => format!("({} / {})", self.matrix(n, m, d), self.real(d)),
            12 | 13 => self.sum(Ty::Matrix(n, m), d),
            _ if n == m => format!("(({} + 20 I_{})⁻¹)", self.leaf(Ty::Matrix(n, m)), n.text()),
            _ if (n, m) == (Size::N, Size::M) => {
                format!("({} ({}))", self.input(Ty::Sparse), self.matrix(n, m, d))
            }
            _ => self.leaf(Ty::Matrix(n, m)),
        }
    }
}
