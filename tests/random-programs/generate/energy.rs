//! Programs with a number and its derivatives.

use super::{Generated, Generator, Kind, Member, Size, Ty};

/// A number `e` of a program, with derivatives.
pub struct Energy {
    /// `e` and all else.
    pub generated: Generated,
    /// What it is differentiated by: number `k` of these gives `∂e/∂x` as `gk` and `∂²e/∂x²` as `Hk`.
    pub variables: Vec<String>,
    /// Whether there are also mixed second derivatives by the first two, as `B`.
    pub is_mixed: bool,
}

const POINT: Ty = Ty::Vector(Size::Known(3));

/// The program of a seed. Three of four have a mesh, and most of these sum over elements.
pub fn energy(seed: u64) -> Energy {
    let mut generator = Generator::new(seed);
    generator.is_differentiable = true;
    generator.has_mesh = !seed.is_multiple_of(4);
    generator.energy()
}

impl Generator {
    fn energy(&mut self) -> Energy {
        let mut lines = Vec::new();
        for k in 0..self.random.usize(0..=1) {
            let (line, signature) = self.function(&format!("f{k}"), 2);
            lines.push(line);
            self.functions.push(signature);
        }
        // a sum over elements, with the set and the variable for its projected blocks
        let mut sum = None;
        if self.has_mesh && !self.chance(5) {
            let (line, kind) = self.term();
            lines.push(line);
            let set = match self.random.usize(0..3) {
                0 => self.set(Member::Element(kind), 1),
                _ => kind.set().to_owned(),
            };
            let factor = match self.random.usize(0..3) {
                0 => self.with("t", Ty::Element(kind), |g| g.real(0)),
                _ => String::new(),
            };
            let all = format!("(∑_(t ∈ {set}) {factor} S(t))");
            // functions of sums have dense second derivatives, which the interpreter is slow with
            let first = if kind == Kind::Vertex { 2 } else { 0 };
            let e = match self.random.usize(first..10) {
                0 => format!("{all}²"),
                1 => format!("√(1 + {all}²)"),
                2 => format!("({all} + {})", self.real(1)),
                3 => format!("({all} ({}))", self.real(1)),
                _ => all,
            };
            lines.push(format!("e = {e}"));
            sum = Some(set);
        } else {
            let depth = 2 + self.random.usize(0..2);
            let e = self.expression(Ty::Real, depth);
            lines.push(format!("e = {e}"));
        }
        let mut variables = self.differentiable();
        self.random.shuffle(&mut variables);
        // the points of a sum over elements are always among them
        variables.sort_by_key(|(_, ty)| sum.is_some() && *ty != Ty::FieldOfPoints);
        variables.truncate(3);
        let mut definitions = vec!["e".to_owned()];
        for (k, (x, ty)) in variables.iter().enumerate() {
            let (gradient, hessian) = (format!("g{k}"), format!("H{k}"));
            lines.push(format!("{gradient} = ∂e/∂{x}"));
            lines.push(format!("{hessian} = ∂²e/∂{x}²"));
            definitions.extend([gradient, hessian]);
            if *ty != Ty::Real && self.random.bool() {
                lines.push(format!("v{k} = H{k} g{k}"));
                definitions.push(format!("v{k}"));
            }
        }
        let is_mixed = variables.len() > 1 && self.random.bool();
        if is_mixed {
            let (a, b) = (&variables[0].0, &variables[1].0);
            lines.push(format!("B = ∂²e/∂{a}∂{b}"));
            definitions.push("B".to_owned());
        }
        if let (Some(set), Some((x, Ty::FieldOfPoints))) = (sum, variables.first()) {
            let replace = self.pick(&["psd", "psd_abs"]);
            lines.push(format!("P = ∑_(t ∈ {set}) {replace}(∂²S(t)/∂{x}²)"));
            definitions.push("P".to_owned());
            if self.random.bool() {
                lines.push("Pg = P g0".to_owned());
                definitions.push("Pg".to_owned());
            }
            match self.random.usize(0..3) {
                0 => {
                    lines.push("W = H0 - 2 P / 3".to_owned());
                    definitions.push("W".to_owned());
                }
                1 => {
                    lines.push("W = (H0 - P)ᵀ [g0 (2 g0)]".to_owned());
                    definitions.push("W".to_owned());
                }
                _ => {}
            }
        }
        let variables = variables.into_iter().map(|(name, _)| name).collect();
        Energy {
            generated: self.assemble(lines, definitions, Vec::new()),
            variables,
            is_mixed,
        }
    }

    /// The parameters so far that derivatives by exist.
    fn differentiable(&self) -> Vec<(String, Ty)> {
        let all = self.inputs.iter().map(|(name, ty)| (name.clone(), *ty));
        let is_real = |ty: &Ty| {
            matches!(
                ty,
                Ty::Real
                    | Ty::Vector(_)
                    | Ty::Matrix(..)
                    | Ty::Points
                    | Ty::Weights
                    | Ty::FieldOfPoints
                    | Ty::Field(_)
            )
        };
        all.filter(|(_, ty)| is_real(ty)).collect()
    }

    /// A function `S` of the points around an element.
    fn term(&mut self) -> (String, Kind) {
        let before = self.scope.len();
        let x = self.input(Ty::FieldOfPoints);
        let kind = self.kind();
        let mut known = |names: &[&str], ty: Ty| {
            let names = names.iter().map(|name| ((*name).to_owned(), ty));
            self.scope.extend(names);
        };
        known(&["o"], Ty::Element(kind));
        let (locals, ring) = match kind {
            Kind::Vertex => {
                known(&["b"], Ty::Element(Kind::Vertex));
                known(&[&format!("({x}_b - {x}_o)")], POINT);
                known(&[&format!("‖{x}_b - {x}_o‖²")], Ty::Real);
                (String::new(), true)
            }
            Kind::Edge => {
                known(&["b", "c"], Ty::Element(Kind::Vertex));
                known(&["p"], POINT);
                known(&["l"], Ty::Real);
                let locals = format!(", b, c = Vertices(o), p = {x}_c - {x}_b, l = ‖p‖");
                (locals, false)
            }
            Kind::Face => {
                known(&["a", "b", "c"], Ty::Element(Kind::Vertex));
                known(&["p", "q"], POINT);
                known(&["l", &format!("‖{x}_c - {x}_b‖²")], Ty::Real);
                let locals = format!(
                    ", a, b, c = OrientedVertices(o), p = {x}_b - {x}_a, q = {x}_c - {x}_a, l = ½ ‖p × q‖"
                );
                (locals, false)
            }
        };
        let mut body = self.real(2);
        if ring {
            body = match self.random.usize(0..3) {
                0 => format!("‖∑_(b ∈ VertexOneRing(o)) ({body}) ({x}_b - {x}_o)‖²"),
                1 => format!("(∑_(b ∈ VertexOneRing(o)) {body})²"),
                _ => format!("∑_(b ∈ VertexOneRing(o)) {body}"),
            };
        }
        self.scope.truncate(before);
        let set = kind.set();
        (format!("S(o) = {body}\n    where o ∈ {set}{locals}"), kind)
    }
}
