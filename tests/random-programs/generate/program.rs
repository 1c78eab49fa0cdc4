//! Whole programs.

use std::collections::BTreeMap;
use std::fmt::Write;

use iheartmesh_runtime::FaceMesh;

use super::data::{Sizes, datum};
use super::{Generated, Generator, Kind, Member, Polygons, Signature, Size, Ty};

/// The program of a seed. Every second one has a mesh.
pub fn program(seed: u64) -> Generated {
    Generator::new(seed).program()
}

impl Generator {
    pub fn new(seed: u64) -> Self {
        Self {
            random: fastrand::Rng::with_seed(seed),
            has_mesh: seed % 2 == 1,
            has_own_size: false,
            is_differentiable: false,
            inputs: BTreeMap::new(),
            functions: Vec::new(),
            scope: Vec::new(),
        }
    }

    fn result(&mut self) -> Ty {
        match self.random.usize(0..if self.has_mesh { 14 } else { 11 }) {
            0..=2 => Ty::Real,
            3 => Ty::Integer,
            4 | 5 => Ty::Vector(self.size()),
            6 | 7 => Ty::Matrix(self.size(), self.size()),
            8 => Ty::SetOf(Member::Integer),
            9 => Ty::SetOf(Member::Real),
            10 => Ty::SetOf(Member::Pair),
            11 => Ty::Real,
            12 => Ty::Vector(Size::Known(3)),
            _ => Ty::SetOf(Member::Element(self.kind())),
        }
    }

    fn parameter(&mut self) -> Ty {
        match self.random.usize(0..if self.has_mesh { 8 } else { 5 }) {
            0 | 1 => Ty::Real,
            2 => Ty::Integer,
            3 => Ty::Vector(self.size()),
            4 => Ty::SetOf(Member::Integer),
            5 => Ty::SetOf(Member::Element(self.kind())),
            _ => Ty::Element(self.kind()),
        }
    }

    fn program(&mut self) -> Generated {
        let mut lines = Vec::new();
        let (mut definitions, mut fields) = (Vec::new(), Vec::new());
        let depth = 2 + self.random.usize(0..2);
        for k in 0..self.random.usize(1..=3) {
            let name = format!("f{k}");
            let (line, signature) = self.function(&name, depth);
            lines.push(line);
            if let [Ty::Element(kind)] = signature.parameters[..] {
                fields.push((name, kind));
            }
            self.functions.push(signature);
        }
        for k in 0..self.random.usize(2..=4) {
            let name = format!("d{k}");
            let line = match self.random.usize(0..3) {
                0 => self.entry_by_entry(&name, depth),
                _ => {
                    let ty = self.result();
                    let line = match self.random.usize(0..5) {
                        0 => self.cases(&name, ty, depth),
                        _ => format!("{name} = {}", self.expression(ty, depth)),
                    };
                    self.scope.push((name.clone(), ty));
                    line
                }
            };
            lines.push(line);
            definitions.push(name);
        }
        self.assemble(lines, definitions, fields)
    }

    /// A function, recursive at times, with local definitions.
    pub fn function(&mut self, name: &str, depth: usize) -> (String, Signature) {
        let result = self.result();
        if !self.is_differentiable && self.chance(6) {
            let signature = Signature {
                name: name.to_owned(),
                parameters: vec![Ty::Integer, result],
                result,
            };
            let text = self.with("a", result, |g| {
                g.with("h", Ty::Integer, |g| {
                    let (first, second) = (g.expression(result, 1), g.expression(result, 1));
                    format!(
                        "{name}(h, a) = {{ {first} if h ≤ 0\n    {name}(h - 1, {second}) otherwise\n    where h ∈ ℤ, a {}",
                        result.declared()
                    )
                })
            });
            return (text, signature);
        }
        if self.chance(4) {
            return self.of_any_size(name, depth);
        }
        let one_element = self.has_mesh && self.random.bool();
        let parameters: Vec<Ty> = match one_element {
            true => vec![Ty::Element(self.kind())],
            false => (0..self.random.usize(1..=3))
                .map(|_| self.parameter())
                .collect(),
        };
        let names = ["a", "b", "c"];
        let before = self.scope.len();
        for (name, ty) in names.iter().zip(&parameters) {
            self.scope.push(((*name).to_owned(), *ty));
        }
        let mut locals = Vec::new();
        for local in ["p", "q"] {
            if self.random.bool() {
                let ty = self.result();
                locals.push(format!("{local} = {}", self.expression(ty, depth - 1)));
                self.scope.push((local.to_owned(), ty));
            }
        }
        if self.has_mesh && self.chance(3) {
            match self.named(Ty::Element(Kind::Face)) {
                Some(f) if self.random.bool() => {
                    locals.push(format!("s, t, u = OrientedVertices({f})"));
                    for name in ["s", "t", "u"] {
                        self.scope
                            .push((name.to_owned(), Ty::Element(Kind::Vertex)));
                    }
                }
                _ => {
                    if let Some(e) = self.named(Ty::Element(Kind::Edge)) {
                        locals.push(format!("s, t = Vertices({e})"));
                        for name in ["s", "t"] {
                            self.scope
                                .push((name.to_owned(), Ty::Element(Kind::Vertex)));
                        }
                    }
                }
            }
        }
        let head = format!("{name}({})", names[..parameters.len()].join(", "));
        let body = match self.random.usize(0..3) {
            0 => self.cases(&head, result, depth),
            _ => format!("{head} = {}", self.expression(result, depth)),
        };
        self.scope.truncate(before);
        let declared = names.iter().zip(&parameters);
        let mut behind: Vec<String> = declared
            .map(|(name, ty)| format!("{name} {}", ty.declared()))
            .collect();
        behind.extend(locals);
        let signature = Signature {
            name: name.to_owned(),
            parameters,
            result,
        };
        (
            format!("{body}\n    where {}", behind.join(", ")),
            signature,
        )
    }

    /// A function of vectors of any size.
    fn of_any_size(&mut self, name: &str, depth: usize) -> (String, Signature) {
        let vector = Ty::Vector(Size::Own);
        let result = match self.random.usize(0..4) {
            0 => Ty::Real,
            1 => Ty::Matrix(Size::Own, Size::Own),
            _ => vector,
        };
        self.has_own_size = true;
        let names = ["a", "b", "c"];
        let parameters = vec![vector, vector, Ty::Integer];
        let before = self.scope.len();
        for (name, ty) in names.iter().zip(&parameters) {
            self.scope.push(((*name).to_owned(), *ty));
        }
        let head = format!("{name}(a, b, c)");
        let body = match self.random.usize(0..3) {
            0 => self.cases(&head, result, depth),
            _ => format!("{head} = {}", self.expression(result, depth)),
        };
        self.scope.truncate(before);
        self.has_own_size = false;
        let signature = Signature {
            name: name.to_owned(),
            parameters,
            result,
        };
        (format!("{body}\n    where a, b ∈ ℝ^g, c ∈ ℤ"), signature)
    }

    fn cases(&mut self, head: &str, ty: Ty, depth: usize) -> String {
        let (a, b) = (
            self.expression(ty, depth - 1),
            self.expression(ty, depth - 1),
        );
        let condition = self.condition(depth - 1);
        let last = match self.chance(5) {
            true => format!("if {}", self.condition(1)),
            false => "otherwise".to_owned(),
        };
        format!("{head} = {{ {a} if {condition}\n    {b} {last}")
    }

    /// A definition of a vector, matrix or sequence by its entries.
    fn entry_by_entry(&mut self, name: &str, depth: usize) -> String {
        let (n, m) = (self.size(), self.size());
        let (line, ty) = match self.random.usize(0..6) {
            0 | 1 => self.with_index("i", |g| {
                let (indexed, body) = (g.indexed("i", n), g.real(depth - 1));
                (format!("{name}_i = {indexed} + {body}"), Ty::Vector(n))
            }),
            2 => self.with_index("i", |g| {
                g.with_index("j", |g| {
                    let (first, second) = (g.indexed("i", n), g.indexed("j", m));
                    let body = g.real(depth - 1);
                    (
                        format!("{name}_i,j = {first} {second} + {body}"),
                        Ty::Matrix(n, m),
                    )
                })
            }),
            3 => self.with_index("i", |g| {
                let (indexed, row) = (g.indexed("i", n), g.vector(m, depth - 1));
                (format!("{name}_i,* = {indexed} ({row})"), Ty::Matrix(n, m))
            }),
            4 => self.with_index("i", |g| {
                let (indexed, column) = (g.indexed("i", m), g.vector(n, depth - 1));
                (
                    format!("{name}_*,i = {indexed} ({column})"),
                    Ty::Matrix(n, m),
                )
            }),
            _ => self.with_index("i", |g| {
                let (x, vector) = (g.input(Ty::Points), g.vector(Size::Known(3), depth - 1));
                (format!("{name}_i = {x}_i + {vector}"), Ty::Points)
            }),
        };
        self.scope.push((name.to_owned(), ty));
        line
    }

    /// The text, with the parameters that it uses and values for them.
    pub fn assemble(
        &mut self,
        lines: Vec<String>,
        definitions: Vec<String>,
        fields: Vec<(String, Kind)>,
    ) -> Generated {
        let text = lines.join("\n");
        // sizes by name need a parameter that has them
        let uses = |letter: char| {
            let declared = self
                .inputs
                .values()
                .any(|ty| ty.declared().contains(letter));
            let words: Vec<&str> = text
                .split(|c: char| !c.is_alphanumeric())
                .filter(|w| w.len() == 1)
                .collect();
            declared
                || words.contains(&letter.to_string().as_str())
                || text.contains(&format!("^{letter}"))
        };
        let (needs_n, needs_m) = (uses('n'), uses('m'));
        if needs_n {
            self.input(Ty::Vector(Size::N));
        }
        if needs_m {
            self.input(Ty::Vector(Size::M));
        }
        let mesh = self
            .has_mesh
            .then(|| polygons(&mut self.random, self.is_differentiable));
        let size = |random: &mut fastrand::Rng| match random.usize(0..12) {
            0 => 0,
            _ => random.usize(1..=4),
        };
        let mut sizes = Sizes {
            own: size(&mut self.random),
            n: size(&mut self.random),
            m: size(&mut self.random),
            length: size(&mut self.random),
            elements: mesh.as_ref().map_or([0; 3], |mesh| mesh.counts),
            is_rough: self.is_differentiable,
        };
        let mut source = String::from(
            "sin, cos, arctan, tanh, atan2 from trigonometry\ntr, det, diag, null, psd, psd_abs from linearalgebra\n",
        );
        if mesh.is_some() {
            source.push_str(
                "ElementSets, BoundaryMatrices from MeshConnectivity\nVertices, Edges, Faces, VertexOneRing, NextVertexAroundFace, PreviousVertexAroundFace, EdgeIndex, OrientedVertices from Neighborhoods(M)\nM : FaceMesh\nV, E, F = ElementSets(M)\n`∂⁰`, `∂¹` = BoundaryMatrices(M)\n",
            );
        }
        let mut inputs = Vec::new();
        for (name, ty) in self.inputs.clone() {
            let subscript = match ty {
                Ty::Points | Ty::Weights => "_i",
                _ => "",
            };
            let _ = writeln!(source, "{name}{subscript} {}", ty.declared());
            inputs.push((name, datum(&mut self.random, ty, &sizes)));
        }
        source.push_str(&text);
        source.push('\n');
        let mut calls = Vec::new();
        for function in self.functions.clone() {
            for _ in 0..2 {
                sizes.own = size(&mut self.random);
                let mut arguments = Vec::new();
                for ty in &function.parameters {
                    arguments.push(datum(&mut self.random, *ty, &sizes));
                    // now and then a length that does not fit
                    if self.chance(12) {
                        sizes.own = size(&mut self.random);
                    }
                }
                calls.push((function.name.clone(), arguments));
            }
        }
        Generated {
            source,
            mesh,
            inputs,
            definitions,
            calls,
            fields,
        }
    }
}

/// One of a few meshes: closed or with a boundary, triangles or not, with a vertex in no face or not. Small ones are of
/// triangles.
fn polygons(random: &mut fastrand::Rng, is_small: bool) -> Polygons {
    let (vertices, faces): (usize, &[&[u32]]) = match random.usize(0..6) {
        0 => (4, &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1], &[1, 3, 2]]),
        1 => (4, &[&[0, 1, 2], &[2, 1, 3]]),
        2 if !is_small => (6, &[&[0, 1, 2, 3], &[0, 3, 4]]),
        3 => (5, &[&[4, 0, 1], &[4, 1, 2], &[4, 2, 3], &[4, 3, 0]]),
        4 if !is_small => (7, &[&[0, 1, 2], &[2, 3, 4], &[5, 6, 2]]),
        _ => (3, &[&[0, 1, 2]]),
    };
    let faces: Vec<Vec<u32>> = faces.iter().map(|f| f.to_vec()).collect();
    match FaceMesh::from_polygons(vertices, &faces) {
        Ok(mesh) => Polygons {
            counts: [mesh.n_vertices(), mesh.n_edges(), mesh.n_faces()],
            vertices,
            faces,
        },
        Err(error) => panic!("{error}"),
    }
}
