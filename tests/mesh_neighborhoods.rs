//! The neighbourhoods of cell meshes and of edge meshes, and those of face meshes that rest on cellular sets, against
//! brute force on lists of elements: as Rust methods, and through programs, with all optimisations and with none.

#[allow(dead_code)]
mod support;

use iheartmesh::neighborhoods::{
    Neighborhoods, PointCloudNeighborhoods, PolygonNeighborhoods, TetrahderonNeighborhoods,
    TetrahedronNeighborhoods,
};
use iheartmesh::{Cell, CellMesh, Edge, EdgeMesh, Face, FaceMesh, Vertex};

use support::cellular::{boundary, cells, cellular, edges, faces, numbers, selections, vertices};
use support::random::Random;
use support::solids::{self, Parts, Solid, without};
use support::soups::{self, Ids};

both_ways! {
    Cells, PlainCells = "tests/programs/cell_neighborhoods.hlang";
    Points, PlainPoints = "tests/programs/point_neighborhoods.hlang";
    Faces, PlainFaces = "tests/programs/face_neighborhoods.hlang";
}

/// The functions of all three modules on one mesh.
struct Ways<'a, R, P, Q> {
    soup: &'a Solid,
    rust: R,
    program: P,
    plain: Q,
}

/// What every module has, on elements of dimension 0 and 1.
macro_rules! check_graph {
    ($ways:expr) => {{
        let (ways, solid) = (&$ways, $ways.soup);
        for v in 0..solid.n {
            let (handle, around) = (Vertex::new(v), solid.touching(0, &[v], 1));
            check!(ways, try_Vertices, try_vv(handle), Some(vec![v]));
            check!(ways, try_Edges, try_ev(handle), Some(around));
            let ring = solid.ring(0, &[v], 1);
            check!(ways, try_VertexOneRing, try_rv(handle), Some(ring));
        }
        for e in 0..solid.edges.len() as u32 {
            let (handle, ends) = (Edge::new(e), solid.edges[e as usize].to_vec());
            check!(ways, try_Vertices, try_ve(handle), Some(ends));
            check!(ways, try_Edges, try_ee(handle), Some(vec![e]));
        }
        for i in 0..solid.n {
            for j in 0..solid.n {
                let (v, w) = (Vertex::new(i), Vertex::new(j));
                let edge = solid.containing(1, &[i, j]);
                check!(ways, try_EdgeIndex, try_ei(v, w), edge.map(|e| vec![e]));
            }
        }
        for parts in selections(solid) {
            let (v, e) = (&vertices(&parts[0]), &edges(&parts[1]));
            let touching = |from: usize, to| Some(solid.touching(from, &parts[from], to));
            check!(ways, try_Vertices, try_vS(v), touching(0, 0));
            check!(ways, try_Vertices, try_vH(e), touching(1, 0));
            check!(ways, try_Edges, try_eS(v), touching(0, 1));
            check!(ways, try_Edges, try_eH(e), touching(1, 1));
            let ring = solid.ring(0, &parts[0], 1);
            check!(ways, try_VertexOneRing, try_rS(v), Some(ring));
            let all = &cellular(&parts);
            check!(ways, try_Vertices, try_vD(all), Some(parts[0].clone()));
            check!(ways, try_Edges, try_eD(all), Some(parts[1].clone()));
        }
    }};
}

/// What every module has beyond neighbourhoods of dimension 0 and 1; the dimension of the mesh is `$kind`.
macro_rules! check_sets {
    ($ways:expr, $kind:expr) => {{
        let (ways, solid, kind) = (&$ways, $ways.soup, $kind);
        for k in [-1, 0, 1, 2, 5] {
            for v in 0..solid.n {
                let (handle, ring) = (Vertex::new(v), solid.k_ring(&[v], k));
                check!(ways, try_VertexKRing, try_kv(handle, k), Some(ring));
            }
        }
        for e in 0..solid.edges.len() as u32 {
            let (handle, ends) = (Edge::new(e), solid.edges[e as usize].to_vec());
            check!(ways, try_OrientedVertices, try_oe(handle), Some(ends));
        }
        for parts in selections(solid) {
            let all = &cellular(&parts);
            let expected = numbers(&solid.closure(&parts));
            check!(ways, try_Closure, try_closure(all), Some(expected));
            check!(
                ways,
                try_Star,
                try_star(all),
                Some(numbers(&solid.star(&parts)))
            );
            check!(
                ways,
                try_Link,
                try_link(all),
                Some(numbers(&solid.link(&parts)))
            );
            let expected = numbers(&boundary(solid, kind, &parts[kind]));
            check!(ways, try_Boundary, try_boundary(all), Some(expected));
            let v = &vertices(&parts[0]);
            for k in [0, 1, 3] {
                let ring = solid.k_ring(&parts[0], k);
                check!(ways, try_VertexKRing, try_kS(v, k), Some(ring));
            }
        }
    }};
}

fn check_points(solid: &Solid) {
    let mesh = EdgeMesh::from_edges(solid.n as usize, &solid.edges).unwrap();
    let ways = Ways {
        soup: solid,
        rust: PointCloudNeighborhoods::new(&mesh).unwrap(),
        program: Points::new(&mesh).unwrap(),
        plain: PlainPoints::new(&mesh).unwrap(),
    };
    check_graph!(ways);
    check_sets!(ways, 1);
    let all: Vec<u32> = (0..solid.edges.len() as u32).collect();
    let [ends, ..] = boundary(solid, 1, &all);
    assert_eq!(ways.rust.BoundaryVertices().ids(), ends, "{}", solid.name);
    assert_eq!(ways.program.boundary_vertices().ids(), ends);
    assert_eq!(ways.plain.boundary_vertices().ids(), ends);
}

/// The edge before and after one in a face.
fn edges_around(solid: &Solid, f: u32, e: u32) -> Option<[u32; 2]> {
    let face: Vec<(u32, u32)> = solids::steps(&solid.faces[f as usize]).collect();
    let number = |(a, b): (u32, u32)| solid.containing(1, &[a, b]).unwrap();
    let place = face.iter().position(|&step| number(step) == e)?;
    let n = face.len();
    Some([(place + n - 1) % n, (place + 1) % n].map(|k| number(face[k])))
}

fn check_faces(soup: &soups::Soup) {
    let solid = &Solid {
        name: soup.name.clone(),
        n: soup.n,
        cells: Vec::new(),
        faces: soup.faces.clone(),
        edges: soup.edges.clone(),
    };
    let mesh: FaceMesh = soup.mesh();
    let rust: PolygonNeighborhoods = Neighborhoods::new(&mesh).unwrap();
    let ways = Ways {
        soup: solid,
        rust,
        program: Faces::new(&mesh).unwrap(),
        plain: PlainFaces::new(&mesh).unwrap(),
    };
    check_sets!(ways, 2);
    for f in 0..solid.faces.len() as u32 {
        let face = Face::new(f);
        let ring = solid.ring(2, &[f], 1);
        check!(ways, try_FaceOneRing, try_rf(face), Some(ring));
        for e in 0..solid.edges.len() as u32 {
            let edge = Edge::new(e);
            let [previous, next] = match edges_around(solid, f, e) {
                Some(around) => around.map(|e| Some(vec![e])),
                None => [None, None],
            };
            check!(ways, try_NextEdgeAroundFace, try_next(face, edge), next);
            check!(
                ways,
                try_PreviousEdgeAroundFace,
                try_previous(face, edge),
                previous
            );
            let others = without(solid.touching(1, &[e], 2), &[f]);
            let across = others.first().map(|&f| vec![f]);
            check!(ways, try_OppositeFace, try_across(face, edge), across);
        }
    }
    for parts in selections(solid) {
        let ring = solid.ring(2, &parts[2], 1);
        let set = &faces(&parts[2]);
        check!(ways, try_FaceOneRing, try_rG(set), Some(ring));
    }
}

type CellWays<'a> = Ways<'a, TetrahedronNeighborhoods<'a>, Cells<'a>, PlainCells<'a>>;

impl<'a> CellWays<'a> {
    fn new(soup: &'a Solid, mesh: &'a CellMesh) -> CellWays<'a> {
        let rust: TetrahderonNeighborhoods = TetrahedronNeighborhoods::new(mesh).unwrap();
        Ways {
            soup,
            rust,
            program: Cells::new(mesh).unwrap(),
            plain: PlainCells::new(mesh).unwrap(),
        }
    }

    fn touching(&self) {
        let solid = self.soup;
        let of = |from, element, to| Some(solid.touching(from, &[element], to));
        for v in 0..solid.n {
            let handle = Vertex::new(v);
            check!(self, try_Faces, try_fv(handle), of(0, v, 2));
            check!(self, try_Cells, try_cv(handle), of(0, v, 3));
        }
        for e in 0..solid.edges.len() as u32 {
            let handle = Edge::new(e);
            check!(self, try_Faces, try_fe(handle), of(1, e, 2));
            check!(self, try_Cells, try_ce(handle), of(1, e, 3));
        }
        for f in 0..solid.faces.len() as u32 {
            let handle = Face::new(f);
            check!(self, try_Vertices, try_vf(handle), of(2, f, 0));
            check!(self, try_Edges, try_ef(handle), of(2, f, 1));
            check!(self, try_Faces, try_ff(handle), of(2, f, 2));
            check!(self, try_Cells, try_cf(handle), of(2, f, 3));
        }
        for c in 0..solid.cells.len() as u32 {
            let handle = Cell::new(c);
            check!(self, try_Vertices, try_vc(handle), of(3, c, 0));
            check!(self, try_Edges, try_ec(handle), of(3, c, 1));
            check!(self, try_Faces, try_fc(handle), of(3, c, 2));
            check!(self, try_Cells, try_cc(handle), of(3, c, 3));
            check!(
                self,
                try_CellOneRing,
                try_rc(handle),
                Some(solid.ring(3, &[c], 2))
            );
        }
        for parts in selections(solid) {
            let (v, e) = (&vertices(&parts[0]), &edges(&parts[1]));
            let (f, c) = (&faces(&parts[2]), &cells(&parts[3]));
            let of = |from: usize, to| Some(solid.touching(from, &parts[from], to));
            check!(self, try_Vertices, try_vG(f), of(2, 0));
            check!(self, try_Vertices, try_vJ(c), of(3, 0));
            check!(self, try_Edges, try_eG(f), of(2, 1));
            check!(self, try_Edges, try_eJ(c), of(3, 1));
            check!(self, try_Faces, try_fS(v), of(0, 2));
            check!(self, try_Faces, try_fH(e), of(1, 2));
            check!(self, try_Faces, try_fG(f), of(2, 2));
            check!(self, try_Faces, try_fJ(c), of(3, 2));
            check!(self, try_Cells, try_cS(v), of(0, 3));
            check!(self, try_Cells, try_cH(e), of(1, 3));
            check!(self, try_Cells, try_cG(f), of(2, 3));
            check!(self, try_Cells, try_cJ(c), of(3, 3));
            check!(
                self,
                try_CellOneRing,
                try_rJ(c),
                Some(solid.ring(3, &parts[3], 2))
            );
            let all = &cellular(&parts);
            check!(self, try_Faces, try_fD(all), Some(parts[2].clone()));
            check!(self, try_Cells, try_cD(all), Some(parts[3].clone()));
        }
    }

    fn face(&self, f: u32) {
        let (solid, face) = (self.soup, Face::new(f));
        check!(
            self,
            try_OrientedVertices,
            try_of(face),
            Some(solid.oriented_face(f).into())
        );
        let mut diamond: Parts = [0, 1, 2, 3].map(|to| solid.touching(2, &[f], to));
        diamond[2] = vec![f];
        check!(
            self,
            try_Diamond,
            try_diamond(face),
            Some(numbers(&diamond))
        );
        let opposite = solid.cell_at(f, 1).zip(solid.cell_at(f, -1));
        let pair = opposite.map(|(c, d)| vec![c, d]);
        check!(self, try_OppositeCells, try_opposite(face), pair);
        let tip = |c| {
            without(solid.parts(3, c, 0), &solid.faces[f as usize])
                .first()
                .copied()
        };
        let tips = opposite.and_then(|(c, d)| Some(vec![tip(c)?, tip(d)?]));
        check!(self, try_OppositeVertices, try_tips(face), tips);
        for v in 0..solid.n {
            let vertex = Vertex::new(v);
            let around = solid.around(f, v);
            let [next, previous] = [0, 1].map(|k| around.map(|around| vec![around[k]]));
            check!(
                self,
                try_NextVertexAroundFace,
                try_next(face, vertex),
                next.clone()
            );
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
            let names = [
                self.rust
                    .try_NextVertexInFace(face, vertex)
                    .map(|x| x.ids()),
                self.rust
                    .try_NextVerticeInFace(face, vertex)
                    .map(|x| x.ids()),
                self.program.try_around(face, vertex).map(|x| x.1.ids()),
            ];
            support::ways::check("NextVertexInFace", next, names);
        }
    }

    fn cell(&self, c: u32) {
        let (solid, cell) = (self.soup, Cell::new(c));
        let oriented = solid.oriented_cell(c).map(Vec::from);
        check!(self, try_OrientedVertices, try_oc(cell), oriented);
        for v in 0..solid.n {
            let sides = solid.parts(3, c, 2).into_iter();
            let mut sides = sides.filter(|f| !solid.faces[*f as usize].contains(&v));
            let across = sides.next().map(|f| vec![f]);
            check!(
                self,
                try_OppositeFace,
                try_across(cell, Vertex::new(v)),
                across
            );
        }
        for e in 0..solid.edges.len() as u32 {
            let ends = solid.edges[e as usize];
            let mut sides = solid.parts(3, c, 1).into_iter();
            let apart = sides.find(|d| !solid.edges[*d as usize].iter().any(|v| ends.contains(v)));
            check!(
                self,
                try_OppositeEdge,
                try_apart(cell, Edge::new(e)),
                apart.map(|e| vec![e])
            );
        }
    }

    /// From a face to its edges, across them to faces of the same cell, and across faces to cells.
    fn walks(&self) {
        let solid = self.soup;
        for e in 0..solid.edges.len() as u32 {
            let mut sheaf: Parts = [0, 1, 2, 3].map(|to| solid.touching(1, &[e], to));
            sheaf[1] = vec![e];
            let edge = Edge::new(e);
            check!(self, try_Diamond, try_sheaf(edge), Some(numbers(&sheaf)));
            for f in 0..solid.faces.len() as u32 {
                let face = Face::new(f);
                let [before, after] = match edges_around(solid, f, e) {
                    Some(around) => around.map(|e| Some(vec![e])),
                    None => [None, None],
                };
                check!(self, try_NextEdgeAroundFace, try_after(face, edge), after);
                check!(
                    self,
                    try_PreviousEdgeAroundFace,
                    try_before(face, edge),
                    before
                );
            }
        }
        for c in 0..solid.cells.len() as u32 {
            let (cell, own) = (Cell::new(c), solid.parts(3, c, 2));
            for f in 0..solid.faces.len() as u32 {
                let face = Face::new(f);
                let others = without(solid.touching(2, &[f], 3), &[c]);
                let behind = others.first().filter(|_| own.contains(&f));
                let behind = behind.map(|&d| vec![d]);
                check!(self, try_OppositeCell, try_behind(cell, face), behind);
                for e in 0..solid.edges.len() as u32 {
                    let is_side = own.contains(&f) && solid.parts(2, f, 1).contains(&e);
                    let at_edge = |g: &&u32| **g != f && solid.parts(2, **g, 1).contains(&e);
                    let beside = own.iter().find(at_edge).filter(|_| is_side);
                    let beside = beside.map(|&g| vec![g]);
                    let edge = Edge::new(e);
                    check!(
                        self,
                        try_NeighborFaceInCell,
                        try_beside(cell, face, edge),
                        beside
                    );
                }
            }
        }
    }

    fn indices(&self, v: [u32; 4]) {
        let solid = self.soup;
        let [a, b, c, d] = v.map(Vertex::new);
        let face = solid.containing(2, &v[..3]);
        check!(self, try_FaceIndex, try_fi(a, b, c), face.map(|f| vec![f]));
        let around = face.and_then(|f| solid.around(f, v[0]));
        check!(
            self,
            try_OrientedVertices((a, b, c)),
            try_pair(a, b, c),
            around.map(Vec::from)
        );
        let cell = solid.containing(3, &v);
        check!(
            self,
            try_CellIndex,
            try_ci(a, b, c, d),
            cell.map(|c| vec![c])
        );
    }

    fn boundary(&self) {
        let all: Vec<u32> = (0..self.soup.cells.len() as u32).collect();
        let [v, e, f, _] = boundary(self.soup, 3, &all);
        assert_eq!(self.rust.BoundaryFaces().ids(), f, "{}", self.soup.name);
        assert_eq!(self.rust.BoundaryEdges().ids(), e, "{}", self.soup.name);
        assert_eq!(self.rust.BoundaryVertices().ids(), v, "{}", self.soup.name);
        assert_eq!(self.program.boundary_faces().ids(), f);
        assert_eq!(self.program.boundary_edges().ids(), e);
        assert_eq!(self.program.boundary_vertices().ids(), v);
        assert_eq!(self.plain.boundary_faces().ids(), f);
        assert_eq!(self.plain.boundary_edges().ids(), e);
        assert_eq!(self.plain.boundary_vertices().ids(), v);
    }
}

fn check_cells(solid: &Solid) {
    let mesh = CellMesh::from_polyhedra(solid.n as usize, &solid.cells).unwrap();
    let ways = CellWays::new(solid, &mesh);
    check_graph!(ways);
    check_sets!(ways, 3);
    ways.touching();
    ways.walks();
    ways.boundary();
    (0..solid.faces.len() as u32).for_each(|f| ways.face(f));
    let mut random = Random(solid.n.into());
    for c in 0..solid.cells.len() as u32 {
        ways.cell(c);
        let mut corners = solid.parts(3, c, 0);
        corners.rotate_left(random.below(4) as usize);
        ways.indices(corners[..4].try_into().unwrap());
    }
    for face in &solid.faces {
        ways.indices([face[2], face[0], face[1], random.below(solid.n)]);
    }
    for _ in 0..20 {
        ways.indices([0; 4].map(|_| random.below(solid.n)));
    }
}

#[test]
fn cells_by_property() {
    solids::by_property().iter().for_each(check_cells);
}

#[test]
fn random_polyhedra() {
    (0..12).for_each(|seed| check_cells(&solids::random_polyhedra(seed)));
}

#[test]
fn random_tetrahedra() {
    for seed in 0..25 {
        let (n, cells) = solids::random_tetrahedra(seed);
        check_cells(&Solid::of_tetrahedra(
            &format!("tetrahedra {seed}"),
            n,
            &cells,
        ));
    }
}

#[test]
fn faces_by_property() {
    soups::by_property().iter().for_each(check_faces);
}

#[test]
fn random_faces() {
    (0..30).for_each(|seed| check_faces(&soups::random(seed)));
}

#[test]
fn random_points() {
    for seed in 0..30 {
        let mut random = Random(seed);
        let n = 2 + random.below(9);
        let mut edges: Vec<[u32; 2]> = (0..random.below(14))
            .map(|_| random.distinct(n, 2))
            .map(|pair| [pair[0].min(pair[1]), pair[0].max(pair[1])])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        check_points(&Solid {
            name: format!("edges {seed}"),
            n,
            cells: Vec::new(),
            faces: Vec::new(),
            edges,
        });
    }
}
