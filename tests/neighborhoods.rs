//! The standard neighbourhoods against brute force on lists of faces: as Rust methods, and through a program that
//! imports them, with all optimisations and with none.

#[allow(dead_code)]
mod support;

use iheartmesh::neighborhoods::Neighborhoods;
use iheartmesh::{CellularSet, Edge, Error, Face, FaceMesh, Set, Vertex, io};

use support::random::Random;
use support::reference_mesh::ReferenceMesh;
use support::soups::{Ids, Soup, by_property, random};

both_ways! {
    Program, PlainProgram = "tests/programs/neighborhoods.hlang";
}

/// The functions of all three modules on one mesh.
struct Ways<'a> {
    soup: &'a Soup,
    rust: Neighborhoods<'a>,
    program: Program<'a>,
    plain: PlainProgram<'a>,
}

fn vertices(ids: &[u32]) -> Set<Vertex> {
    ids.iter().copied().map(Vertex::new).collect()
}

fn edges(ids: &[u32]) -> Set<Edge> {
    ids.iter().copied().map(Edge::new).collect()
}

fn faces(ids: &[u32]) -> Set<Face> {
    ids.iter().copied().map(Face::new).collect()
}

impl<'a> Ways<'a> {
    fn new(soup: &'a Soup, mesh: &'a FaceMesh) -> Ways<'a> {
        Ways {
            soup,
            rust: Neighborhoods::new(mesh).unwrap(),
            program: Program::new(mesh).unwrap(),
            plain: PlainProgram::new(mesh).unwrap(),
        }
    }

    fn vertex(&self, v: u32) {
        let (soup, handle) = (self.soup, Vertex::new(v));
        check!(self, try_Vertices, try_vv(handle), Some(vec![v]));
        check!(
            self,
            try_Edges,
            try_ev(handle),
            Some(soup.edges_of_vertices(&[v]))
        );
        check!(
            self,
            try_Faces,
            try_fv(handle),
            Some(soup.faces_of_vertices(&[v]))
        );
        check!(
            self,
            try_VertexOneRing,
            try_rv(handle),
            Some(soup.ring(&[v]))
        );
    }

    fn edge(&self, e: u32) {
        let (soup, handle) = (self.soup, Edge::new(e));
        let [i, j] = soup.edges[e as usize];
        let around = soup.faces_of_edges(&[e]);
        check!(self, try_Vertices, try_ve(handle), Some(vec![i, j]));
        check!(self, try_Edges, try_ee(handle), Some(vec![e]));
        check!(self, try_Faces, try_fe(handle), Some(around.clone()));
        let diamond = [vec![2, i, j, 1, e, around.len() as u32], around, vec![0]].concat();
        check!(self, try_Diamond, try_diamond(handle), Some(diamond));
        let opposite = soup.sides_of(i, j);
        check!(
            self,
            try_OppositeFaces,
            try_opposite(handle),
            opposite.map(Vec::from)
        );
        let apexes = soup.apexes(opposite, [i, j]);
        check!(
            self,
            try_OppositeVertices,
            try_apexes(handle),
            apexes.map(Vec::from)
        );
        for (i, j) in [(i, j), (j, i)] {
            self.pair(i, j);
        }
    }

    fn pair(&self, i: u32, j: u32) {
        let (soup, v, w) = (self.soup, Vertex::new(i), Vertex::new(j));
        check!(
            self,
            try_EdgeIndex,
            try_ei(v, w),
            soup.edge(i, j).map(|e| vec![e])
        );
        let sides = soup.sides_of(i, j);
        check!(
            self,
            try_OrientedOppositeFaces,
            try_sides(v, w),
            sides.map(Vec::from)
        );
        let apexes = soup.apexes(sides, [i, j]);
        check!(
            self,
            try_OppositeVertices((v, w)),
            try_tips(v, w),
            apexes.map(Vec::from)
        );
    }

    fn face(&self, f: u32) {
        let (soup, handle) = (self.soup, Face::new(f));
        check!(
            self,
            try_Vertices,
            try_vf(handle),
            Some(soup.vertices_of_faces(&[f]))
        );
        check!(
            self,
            try_Edges,
            try_ef(handle),
            Some(soup.edges_of_faces(&[f]))
        );
        check!(self, try_Faces, try_ff(handle), Some(vec![f]));
        check!(
            self,
            try_OrientedVertices,
            try_oriented(handle),
            Some(soup.oriented(f).into())
        );
        for &v in &soup.faces[f as usize] {
            self.corner(f, v);
        }
    }

    fn corner(&self, f: u32, v: u32) {
        let around = self.soup.around(f, v);
        let (face, vertex) = (Face::new(f), Vertex::new(v));
        let next = around.map(|[next, _]| vec![next]);
        check!(
            self,
            try_NextVertexAroundFace,
            try_next(face, vertex),
            next.clone()
        );
        let previous = around.map(|[_, previous]| vec![previous]);
        check!(
            self,
            try_PreviousVertexAroundFace,
            try_previous(face, vertex),
            previous
        );
        check!(
            self,
            try_NeighborVerticesInFace,
            try_both(face, vertex),
            around.map(Vec::from)
        );
        // other names of the first
        let aliases = |a: &dyn Fn() -> Result<Vertex, Error>| a().map(|x| x.ids());
        let names = [
            aliases(&|| self.rust.try_NextVertexInFace(face, vertex)),
            aliases(&|| self.rust.try_NextVerticeInFace(face, vertex)),
            self.program.try_around(face, vertex).map(|x| x.0.ids()),
        ];
        support::ways::check("NextVertexInFace", next.clone(), names);
        let twice = next.map(|v| [v.clone(), v].concat());
        let pair = |x: Result<(Vertex, Vertex), Error>| x.map(|x| x.ids());
        let (a, b) = (
            self.program.try_around(face, vertex),
            self.plain.try_around(face, vertex),
        );
        support::ways::check("both names", twice, [pair(a.clone()), pair(a), pair(b)]);
    }

    fn triple(&self, [i, j, k]: [u32; 3]) {
        let face = self.soup.face([i, j, k]);
        let (a, b, c) = (Vertex::new(i), Vertex::new(j), Vertex::new(k));
        check!(self, try_FaceIndex, try_fi(a, b, c), face.map(|f| vec![f]));
        let around = face.and_then(|f| self.soup.around(f, i));
        check!(
            self,
            try_OrientedVertices((a, b, c)),
            try_pair(a, b, c),
            around.map(Vec::from)
        );
    }

    fn sets(&self, v: &[u32], e: &[u32], f: &[u32]) {
        let soup = self.soup;
        let (s, h, g) = (&vertices(v), &edges(e), &faces(f));
        check!(self, try_Vertices, try_vS(s), Some(v.to_vec()));
        check!(
            self,
            try_Vertices,
            try_vH(h),
            Some(soup.vertices_of_edges(e))
        );
        check!(
            self,
            try_Vertices,
            try_vG(g),
            Some(soup.vertices_of_faces(f))
        );
        check!(self, try_Edges, try_eS(s), Some(soup.edges_of_vertices(v)));
        check!(self, try_Edges, try_eH(h), Some(e.to_vec()));
        check!(self, try_Edges, try_eG(g), Some(soup.edges_of_faces(f)));
        check!(self, try_Faces, try_fS(s), Some(soup.faces_of_vertices(v)));
        check!(self, try_Faces, try_fH(h), Some(soup.faces_of_edges(e)));
        check!(self, try_Faces, try_fG(g), Some(f.to_vec()));
        check!(self, try_VertexOneRing, try_rS(s), Some(soup.ring(v)));
        let all = &CellularSet {
            vertices: s.clone(),
            edges: h.clone(),
            faces: g.clone(),
            cells: Set::new(),
        };
        check!(self, try_Vertices, try_vD(all), Some(v.to_vec()));
        check!(self, try_Edges, try_eD(all), Some(e.to_vec()));
        check!(self, try_Faces, try_fD(all), Some(f.to_vec()));
    }

    fn boundary(&self) {
        let boundary = self.soup.boundary();
        let around = self.soup.vertices_of_edges(&boundary);
        assert_eq!(
            self.rust.BoundaryEdges().ids(),
            boundary,
            "{}",
            self.soup.name
        );
        assert_eq!(self.program.boundary_edges().ids(), boundary);
        assert_eq!(self.plain.boundary_edges().ids(), boundary);
        assert_eq!(
            self.rust.BoundaryVertices().ids(),
            around,
            "{}",
            self.soup.name
        );
        assert_eq!(self.program.boundary_vertices().ids(), around);
        assert_eq!(self.plain.boundary_vertices().ids(), around);
    }
}

/// Every function on every element, every pair and every triple.
fn check_all(soup: &Soup) {
    let mesh = soup.mesh();
    let ways = Ways::new(soup, &mesh);
    ways.boundary();
    for i in 0..soup.n {
        ways.vertex(i);
        for j in (0..soup.n).filter(|j| *j != i) {
            ways.pair(i, j);
            (0..soup.n).for_each(|k| ways.triple([i, j, k]));
        }
    }
    (0..soup.edges.len() as u32).for_each(|e| ways.edge(e));
    for f in 0..soup.faces.len() as u32 {
        ways.face(f);
        (0..soup.n).for_each(|v| ways.corner(f, v));
    }
    let mut random = Random(soup.n.into());
    for one_of in [1, 2, 2, 3, u32::MAX] {
        let v = random.subset(soup.n, one_of);
        let e = random.subset(soup.edges.len() as u32, one_of);
        let f = random.subset(soup.faces.len() as u32, one_of);
        ways.sets(&v, &e, &f);
    }
}

#[test]
fn meshes_by_property() {
    by_property().iter().for_each(check_all);
}

#[test]
fn random_soups() {
    (0..60).for_each(|seed| check_all(&random(seed)));
}

#[test]
fn meshes_of_the_repository() {
    for name in ["bob_small.ply", "fox.ply", "sphere_small.ply"] {
        let file = io::read(support::workspace().join("meshes").join(name)).unwrap();
        let mesh = file.face_mesh().unwrap();
        let soup = Soup::of_mesh(name, &mesh);
        let ways = Ways::new(&soup, &mesh);
        ways.boundary();
        (0..soup.n).for_each(|v| ways.vertex(v));
        (0..soup.edges.len() as u32)
            .step_by(3)
            .for_each(|e| ways.edge(e));
        let mut random = Random(1);
        for f in 0..soup.faces.len() as u32 {
            ways.face(f);
            ways.corner(f, random.below(soup.n));
            let [i, j, k] = soup.oriented(f);
            [[i, j, k], [k, i, j], [j, i, k]]
                .into_iter()
                .for_each(|t| ways.triple(t));
            ways.pair(i, (i + 1 + random.below(soup.n - 1)) % soup.n);
        }
        let v = random.subset(soup.n, 20);
        let e = random.subset(soup.edges.len() as u32, 20);
        let f = random.subset(soup.faces.len() as u32, 20);
        ways.sets(&v, &e, &f);
    }
}

#[test]
fn neighbourhoods_of_the_reference_set() {
    let Some(set) = support::reference_set() else {
        return;
    };
    for file in [
        "bob_small.obj",
        "cat_head.obj",
        "fan3.obj",
        "mobius_tri.obj",
        "octa.off",
        "platonic_shelf.obj",
        "spot_control.obj",
    ] {
        let reference = ReferenceMesh::read(&set, file);
        let json = reference.json("neighborhoods.json").unwrap();
        let soup = Soup::of_mesh(file, &reference.mesh);
        let ways = Ways::new(&soup, &reference.mesh);
        let number = |text: &str| text.parse::<u32>().unwrap();
        for (v, ring) in json.get("vertex_one_ring").unwrap().object() {
            let v = Vertex::new(number(v));
            check!(ways, try_VertexOneRing, try_rv(v), Some(ring.ids()));
        }
        for (v, faces) in json.get("faces_of_vertex").unwrap().object() {
            let v = Vertex::new(number(v));
            check!(ways, try_Faces, try_fv(v), Some(faces.ids()));
        }
        for (v, edges) in json.get("edges_of_vertex").unwrap().object() {
            let v = Vertex::new(number(v));
            check!(ways, try_Edges, try_ev(v), Some(edges.ids()));
        }
        let edge = |text: &str| {
            let (i, j) = text.split_once('-').unwrap();
            Edge::new(reference.edge(number(i), number(j)) as u32)
        };
        for (e, faces) in json.get("faces_of_edge").unwrap().object() {
            check!(ways, try_Faces, try_fe(edge(e)), Some(faces.ids()));
        }
        for (f, corners) in json.get("face_next_prev").unwrap().object() {
            let f = Face::new(number(f));
            for corner in corners.list() {
                let [v, next, previous] = corner.ids()[..] else {
                    panic!("three vertices");
                };
                let expected = Some(vec![next, previous]);
                check!(
                    ways,
                    try_NeighborVerticesInFace,
                    try_both(f, Vertex::new(v)),
                    expected
                );
            }
        }
    }
}
