//! Meshes of polyhedra as lists of sides, and what their neighbourhoods are by slow and obvious definitions. Nothing here
//! knows the library.

use super::random::Random;

/// Which elements: vertices, edges, faces, cells, each ascending.
pub type Parts = [Vec<u32>; 4];

/// The cells of a mesh, and its faces and edges by the numbering that cell meshes have.
pub struct Solid {
    /// What the mesh is.
    pub name: String,
    /// Number of vertices.
    pub n: u32,
    /// The sides of each cell, counter-clockwise seen from outside.
    pub cells: Vec<Vec<Vec<u32>>>,
    /// The vertices of each face in its order.
    pub faces: Vec<Vec<u32>>,
    /// The vertices of each edge, the smaller one first.
    pub edges: Vec<[u32; 2]>,
}

/// All the ways to write a cycle of vertices from one of its vertices, in either direction, the smallest first.
fn forms(side: &[u32]) -> Vec<Vec<u32>> {
    let mut forms = Vec::new();
    for start in 0..side.len() {
        let mut turned = side.to_vec();
        turned.rotate_left(start);
        forms.push(turned.clone());
        turned.reverse();
        forms.push(turned);
    }
    forms.sort();
    forms
}

fn sorted<T: Ord>(mut items: Vec<T>) -> Vec<T> {
    items.sort_unstable();
    items.dedup();
    items
}

/// The sides of a tetrahedron: the terms of the boundary of a simplex, those with a minus turned around.
pub fn tetrahedron([a, b, c, d]: [u32; 4]) -> Vec<Vec<u32>> {
    [[b, c, d], [a, d, c], [a, b, d], [a, c, b]]
        .map(Vec::from)
        .into()
}

/// The sides of a hexahedron whose vertices run around the bottom, then around the top: by the coordinates of a cube.
pub fn hexahedron(corners: [u32; 8]) -> Vec<Vec<u32>> {
    const CUBE: [[i32; 3]; 8] = [
        [-1, -1, -1],
        [1, -1, -1],
        [1, 1, -1],
        [-1, 1, -1],
        [-1, -1, 1],
        [1, -1, 1],
        [1, 1, 1],
        [-1, 1, 1],
    ];
    let mut sides = Vec::new();
    for (axis, u, v) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        for outward in [-1, 1] {
            let mut side: Vec<usize> = (0..8).filter(|&k| CUBE[k][axis] == outward).collect();
            let angle =
                |k: &usize| (f64::from(CUBE[*k][v] * outward)).atan2(f64::from(CUBE[*k][u]));
            side.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
            sides.push(side.into_iter().map(|k| corners[k]).collect());
        }
    }
    sides
}

/// The sides of a polygon with an apex above it.
pub fn pyramid(bottom: &[u32], apex: u32) -> Vec<Vec<u32>> {
    let mut sides: Vec<Vec<u32>> = (0..bottom.len())
        .map(|k| vec![bottom[k], bottom[(k + 1) % bottom.len()], apex])
        .collect();
    sides.push(bottom.iter().rev().copied().collect());
    sides
}

/// The sides of a prism by its bottom and its top.
pub fn prism(bottom: &[u32], top: &[u32]) -> Vec<Vec<u32>> {
    let n = bottom.len();
    let mut sides: Vec<Vec<u32>> = (0..n)
        .map(|k| vec![bottom[k], bottom[(k + 1) % n], top[(k + 1) % n], top[k]])
        .collect();
    sides.push(bottom.iter().rev().copied().collect());
    sides.push(top.to_vec());
    sides
}

/// The same cell inside out.
pub fn inverted(sides: Vec<Vec<u32>>) -> Vec<Vec<u32>> {
    sides
        .into_iter()
        .map(|side| side.into_iter().rev().collect())
        .collect()
}

impl Solid {
    /// A mesh by its cells.
    pub fn new(name: &str, n: u32, cells: Vec<Vec<Vec<u32>>>) -> Solid {
        let sides = || cells.iter().flatten();
        let mut faces: Vec<Vec<u32>> = sides().map(|side| forms(side)[0].clone()).collect();
        faces.sort_by_key(|face| (sorted(face.clone()), face.clone()));
        faces.dedup();
        let edges = sorted(
            sides()
                .flat_map(|side| steps(side))
                .map(|(a, b)| [a.min(b), a.max(b)])
                .collect(),
        );
        Solid {
            name: name.to_owned(),
            n,
            cells,
            faces,
            edges,
        }
    }

    /// A mesh of tetrahedra.
    pub fn of_tetrahedra(name: &str, n: u32, tetrahedra: &[[u32; 4]]) -> Solid {
        Solid::new(
            name,
            n,
            tetrahedra.iter().copied().map(tetrahedron).collect(),
        )
    }

    /// How many elements of each kind there are.
    pub fn sizes(&self) -> [u32; 4] {
        let [edges, faces, cells] = [self.edges.len(), self.faces.len(), self.cells.len()];
        [self.n, edges as u32, faces as u32, cells as u32]
    }

    /// The number of the face with a side's vertices in its cyclic order or in the opposite one, and 1 or -1 for which.
    pub fn face_of(&self, side: &[u32]) -> (u32, i8) {
        let form = &forms(side)[0];
        let face = self.faces.iter().position(|face| face == form).unwrap();
        let forward = steps(form).all(|step| steps(side).any(|other| other == step));
        (face as u32, if forward { 1 } else { -1 })
    }

    /// 1 where a face runs along an edge, -1 where against it, 0 where the edge is not one of its sides.
    pub fn edge_sign(&self, e: u32, f: u32) -> i8 {
        let [a, b] = self.edges[e as usize];
        steps(&self.faces[f as usize])
            .map(|step| i8::from(step == (a, b)) - i8::from(step == (b, a)))
            .sum()
    }

    /// 1 where a face runs counter-clockwise seen from outside of a cell, -1 where clockwise, 0 where it is no side.
    pub fn face_sign(&self, f: u32, c: u32) -> i8 {
        self.cells[c as usize]
            .iter()
            .map(|side| self.face_of(side))
            .filter(|&(face, _)| face == f)
            .map(|(_, sign)| sign)
            .sum()
    }

    /// The elements of dimension `low` that an element of dimension `high` is made of.
    pub fn parts(&self, high: usize, element: u32, low: usize) -> Vec<u32> {
        let k = element as usize;
        let edges = |side: &[u32]| -> Vec<u32> {
            let runs = |e: &[u32; 2]| steps(side).any(|(a, b)| *e == [a.min(b), a.max(b)]);
            numbers(&self.edges, runs)
        };
        match (high, low) {
            _ if high == low => vec![element],
            (1, 0) => self.edges[k].to_vec(),
            (2, 0) => sorted(self.faces[k].clone()),
            (2, 1) => edges(&self.faces[k]),
            (3, 0) => sorted(self.cells[k].concat()),
            (3, 1) => sorted(self.cells[k].iter().flat_map(|side| edges(side)).collect()),
            (3, 2) => sorted(
                self.cells[k]
                    .iter()
                    .map(|side| self.face_of(side).0)
                    .collect(),
            ),
            _ => panic!("no elements of dimension {low} in those of dimension {high}"),
        }
    }

    /// The elements of dimension `to` that are part of one of the given ones of dimension `from`, or that one of these is
    /// part of.
    pub fn touching(&self, from: usize, elements: &[u32], to: usize) -> Vec<u32> {
        let of = |&element: &u32| match to <= from {
            true => self.parts(from, element, to),
            false => (0..self.sizes()[to])
                .filter(|&other| self.parts(to, other, from).contains(&element))
                .collect(),
        };
        sorted(elements.iter().flat_map(of).collect())
    }

    /// The elements of a kind that have a part of dimension `via` in common with one of the given ones, without these.
    pub fn ring(&self, kind: usize, elements: &[u32], via: usize) -> Vec<u32> {
        without(
            self.touching(via, &self.touching(kind, elements, via), kind),
            elements,
        )
    }

    /// The vertices at most `k` edges away from one of the given ones.
    pub fn k_ring(&self, vertices: &[u32], k: i64) -> Vec<u32> {
        let mut reached = vertices.to_vec();
        for _ in 0..k.max(0) {
            let next = self.touching(1, &self.touching(0, &reached, 1), 0);
            reached = sorted([reached, next].concat());
        }
        reached
    }

    /// The first element of a kind that contains all these vertices.
    pub fn containing(&self, kind: usize, vertices: &[u32]) -> Option<u32> {
        (0..self.sizes()[kind]).find(|&element| {
            let parts = self.parts(kind, element, 0);
            vertices.iter().all(|v| parts.contains(v))
        })
    }

    /// The vertices after and before a vertex of a face.
    pub fn around(&self, f: u32, v: u32) -> Option<[u32; 2]> {
        let face = &self.faces[f as usize];
        let place = face.iter().position(|other| *other == v)?;
        let n = face.len();
        Some([face[(place + 1) % n], face[(place + n - 1) % n]])
    }

    /// The smallest vertex of a face with those after and before it.
    pub fn oriented_face(&self, f: u32) -> [u32; 3] {
        let smallest = *self.faces[f as usize].iter().min().unwrap();
        let [next, previous] = self.around(f, smallest).unwrap();
        [smallest, next, previous]
    }

    /// A vertex of a cell that is not on its first face that runs counter-clockwise, and three vertices of that face.
    pub fn oriented_cell(&self, c: u32) -> Option<[u32; 4]> {
        let f = (0..self.sizes()[2]).find(|&f| self.face_sign(f, c) == 1)?;
        let across = without(self.parts(3, c, 0), &self.faces[f as usize]);
        let [i, j, k] = self.oriented_face(f);
        Some([*across.first()?, i, j, k])
    }

    /// The first cell of which a face is a side with a sign.
    pub fn cell_at(&self, f: u32, sign: i8) -> Option<u32> {
        (0..self.sizes()[3]).find(|&c| self.face_sign(f, c) == sign)
    }

    /// The faces of exactly one of these cells.
    pub fn boundary_faces(&self, cells: &[u32]) -> Vec<u32> {
        let is_boundary = |&f: &u32| {
            let around = cells.iter().filter(|&&c| self.face_sign(f, c) != 0);
            around.count() == 1
        };
        (0..self.sizes()[2]).filter(is_boundary).collect()
    }

    /// All that is part of one of these elements.
    pub fn closure(&self, parts: &Parts) -> Parts {
        [0, 1, 2, 3].map(|low| {
            let of = |high: usize| self.touching(high, &parts[high], low);
            sorted((low..4).flat_map(of).collect())
        })
    }

    /// All that one of these elements is part of.
    pub fn star(&self, parts: &Parts) -> Parts {
        [0, 1, 2, 3].map(|high| {
            let of = |low: usize| self.touching(low, &parts[low], high);
            sorted((0..=high).flat_map(of).collect())
        })
    }

    /// The closure of the star without the star of the closure.
    pub fn link(&self, parts: &Parts) -> Parts {
        let outer = self.closure(&self.star(parts));
        let inner = self.star(&self.closure(parts));
        [0, 1, 2, 3].map(|kind| without(outer[kind].clone(), &inner[kind]))
    }
}

fn numbers<T>(items: &[T], property: impl Fn(&T) -> bool) -> Vec<u32> {
    let numbered = (0..).zip(items);
    numbered
        .filter_map(|(k, item)| property(item).then_some(k))
        .collect()
}

/// The directed steps around a polygon.
pub fn steps(side: &[u32]) -> impl Iterator<Item = (u32, u32)> + '_ {
    (0..side.len()).map(|k| (side[k], side[(k + 1) % side.len()]))
}

/// Those that are not among others.
pub fn without(ids: Vec<u32>, others: &[u32]) -> Vec<u32> {
    ids.into_iter().filter(|v| !others.contains(v)).collect()
}

/// Small meshes, each with something special.
pub fn by_property() -> Vec<Solid> {
    let tetrahedra = Solid::of_tetrahedra;
    vec![
        Solid::new("no cells", 3, vec![]),
        tetrahedra("one tetrahedron", 4, &[[0, 1, 2, 3]]),
        tetrahedra("one that is inverted", 4, &[[3, 1, 0, 2], [0, 1, 3, 2]]),
        tetrahedra("two at a face", 5, &[[0, 1, 2, 3], [1, 2, 3, 4]]),
        tetrahedra(
            "two at a face, seen from one side",
            5,
            &[[0, 1, 2, 3], [2, 1, 3, 4]],
        ),
        tetrahedra("two at an edge", 6, &[[0, 1, 2, 3], [1, 0, 4, 5]]),
        tetrahedra("two at a vertex", 7, &[[3, 1, 2, 0], [3, 6, 5, 4]]),
        tetrahedra(
            "two apart, isolated vertices",
            11,
            &[[9, 1, 2, 0], [3, 6, 5, 7]],
        ),
        tetrahedra(
            "three at a face",
            6,
            &[[0, 1, 2, 3], [1, 2, 3, 4], [5, 3, 2, 1]],
        ),
        tetrahedra("the same twice", 4, &[[0, 1, 2, 3], [1, 2, 0, 3]]),
        tetrahedra(
            "all faces inside",
            5,
            &[
                [1, 2, 3, 4],
                [0, 2, 4, 3],
                [0, 1, 3, 4],
                [0, 1, 4, 2],
                [0, 1, 2, 3],
            ],
        ),
        Solid::new("hexahedron", 8, vec![hexahedron([0, 1, 2, 3, 4, 5, 6, 7])]),
        Solid::new(
            "pyramid on a hexahedron",
            9,
            vec![
                hexahedron([0, 1, 2, 3, 4, 5, 6, 7]),
                pyramid(&[4, 5, 6, 7], 8),
            ],
        ),
        Solid::new(
            "prism, tetrahedron, pyramid",
            8,
            vec![
                prism(&[0, 1, 2], &[3, 4, 5]),
                pyramid(&[3, 4, 5], 6),
                pyramid(&[1, 0, 3, 4], 7),
            ],
        ),
        Solid::new(
            "one face on two cycles",
            6,
            vec![pyramid(&[0, 1, 2, 3], 4), pyramid(&[0, 2, 1, 3], 5)],
        ),
        Solid::new(
            "sixfold prism, inside out",
            12,
            vec![inverted(prism(&[0, 1, 2, 3, 4, 5], &[6, 7, 8, 9, 10, 11]))],
        ),
    ]
}

/// Random tetrahedra on a few vertices.
pub fn random_tetrahedra(seed: u64) -> (u32, Vec<[u32; 4]>) {
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let n = 4 + random.below(6);
    let cells = (0..1 + random.below(9)).map(|_| random.distinct(n, 4).try_into().unwrap());
    (n, cells.collect())
}

/// Random hexahedra on a few vertices.
pub fn random_hexahedra(seed: u64) -> (u32, Vec<[u32; 8]>) {
    let mut random = Random(seed.wrapping_mul(0xd134_2543_de82_ef95));
    let n = 8 + random.below(4);
    let cells = (0..1 + random.below(4)).map(|_| random.distinct(n, 8).try_into().unwrap());
    (n, cells.collect())
}

/// Random tetrahedra, pyramids, prisms and hexahedra on a few vertices, some inside out.
pub fn random_polyhedra(seed: u64) -> Solid {
    let mut random = Random(seed.wrapping_mul(0xa076_1d64_78bd_642f));
    let n = 8 + random.below(4);
    let mut cells = Vec::new();
    for _ in 0..1 + random.below(5) {
        let v = random.distinct(n, 8);
        let cell = match random.below(5) {
            0 => tetrahedron([v[0], v[1], v[2], v[3]]),
            1 => pyramid(&v[..4], v[4]),
            2 => prism(&v[..3], &v[3..6]),
            3 => pyramid(&v[..5], v[5]),
            _ => hexahedron(v.try_into().unwrap()),
        };
        cells.push(match random.below(3) {
            0 => inverted(cell),
            _ => cell,
        });
    }
    Solid::new(&format!("random polyhedra {seed}"), n, cells)
}
