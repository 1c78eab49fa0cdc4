//! Elements of a mesh: boundary matrices and sets as programs use them themselves, elements as numbers, functions that call
//! each other; against loops written out, with and without optimisations.

use std::collections::BTreeMap;

use iheartmesh::{Edge, Face, FaceMesh, Set, Vertex};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Members, PlainMembers = r#"
        ElementSets from MeshConnectivity
        M : FaceMesh
        V, E, F = ElementSets(M)
        S ∈ {ℤ}
        T ∈ {ℤ} index
        P = { v for v ∈ V if v ∈ S }
        Q = { v for v ∈ V if v ∉ T }
        n = ∑_(f ∈ F) k where k = |{ i for i ∈ S if f ∈ S }|
    "#;

    Connectivity, PlainConnectivity = r#"
        * from MeshConnectivity
        M : FaceMesh
        V, E, F = ElementSets(M)
        `∂⁰`, `∂¹` = BoundaryMatrices(M)
        `B⁰`, `B¹` = UnsignedBoundaryMatrices(M)
        `∂¹ᵀ` = `∂¹`ᵀ
        corners(f) = vertexset(NonZeros(`B⁰`(`B¹` IndicatorVector({f})))) where f ∈ F
        cancelled(f) = vertexset(NonZeros(`∂⁰`(`∂¹` IndicatorVector({f})))) where f ∈ F
        border = edgeset(NonZeros(`∂¹` IndicatorVector(F)))
        twice = ValueSet(`B¹` IndicatorVector(F), 2)
        along(e) = faceset(ValueSet(`∂¹ᵀ` IndicatorVector({e}), 1)) where e ∈ E
        against(e) = faceset(ValueSet(`∂¹ᵀ` IndicatorVector({e}), -1)) where e ∈ E
        ends(e) = ValueSet(`∂⁰` IndicatorVector({e}), 1) where e ∈ E
        entry(v, e) = `∂⁰`_v,e where v ∈ V, e ∈ E
    "#;

    Cellular, PlainCellular = r#"
        ElementSets from MeshConnectivity
        Vertices, Edges, Faces from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        closure(f) = CellularSet(Vertices(f), Edges(f), {f}) where f ∈ F
        sizes(f) = tuple(|Vertices(S)|, |Edges(S)|, |Faces(S)|) where f ∈ F, S = closure(f)
        star(S) = ∪_(v ∈ S) Faces(v) where S ⊂ V
        around(v) = star(Vertices(closed)) where v ∈ V, closed = CellularSet({v})
        link(v) = (∪_(f ∈ Faces(v)) Edges(f)) ∩ Edges(star({v})) - Edges(v) where v ∈ V
    "#;

    Alternating, PlainAlternating = r#"
        ElementSets from MeshConnectivity
        VertexOneRing, Vertices, Faces from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ
        grow(S, k) = { S if k = 0
                       shrink(Vertices(Faces(S)), k - 1) otherwise
            where S ⊂ V, k ∈ ℤ
        shrink(S, k) = { S if k = 0
                         grow({ v for v ∈ S if x_v > 0 }, k - 1) otherwise
            where S ⊂ V, k ∈ ℤ
        around(v) = grow({v}, 4) where v ∈ V
    "#;
}

/// The triangles of a strip of squares, `n` squares long and two wide.
fn strip(n: u32) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    for i in 0..n {
        for j in 0..2 {
            let a = 3 * i + j;
            triangles.extend([[a, a + 3, a + 4], [a, a + 4, a + 1]]);
        }
    }
    triangles
}

fn vertices(list: impl IntoIterator<Item = u32>) -> Set<Vertex> {
    list.into_iter().map(Vertex::new).collect()
}

/// The edges of a triangle, each from the lesser vertex to the greater one, and whether the triangle runs along it.
fn sides(t: [u32; 3]) -> [((u32, u32), bool); 3] {
    [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])].map(|(a, b)| ((a.min(b), a.max(b)), a < b))
}

/// The edges of triangles in the order of the mesh, with the triangles beside each and whether these run along it.
fn edges(triangles: &[[u32; 3]]) -> BTreeMap<(u32, u32), Vec<(u32, bool)>> {
    let mut edges: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for (f, t) in (0..).zip(triangles) {
        for (edge, is_along) in sides(*t) {
            edges.entry(edge).or_default().push((f, is_along));
        }
    }
    edges
}

for_both! {
    #[test]
    fn products_of_boundary_matrices_and_chains() {
        let triangles = strip(3);
        let mesh = FaceMesh::from_triangles(12, &triangles).unwrap();
        let module = Connectivity::new(&mesh).unwrap();
        let edges = edges(&triangles);
        for (f, t) in (0..).zip(&triangles) {
            let f = Face::new(f);
            assert_eq!(module.corners(f), vertices(*t));
            // the boundary of a boundary is empty, although entries of the product cancel only
            assert_eq!(module.cancelled(f), vertices([]));
        }
        let with = |n: usize| -> Set<Edge> {
            let numbered = (0..).zip(edges.values());
            let some = numbered.filter(|(_, faces)| faces.len() == n);
            some.map(|(e, _)| Edge::new(e)).collect()
        };
        assert_eq!(module.border(), with(1));
        assert_eq!(module.twice(), with(2));
        for (e, ((a, b), faces)) in (0..).zip(&edges) {
            let e = Edge::new(e);
            let beside = |is_along: bool| -> Set<Face> {
                let some = faces.iter().filter(|(_, along)| *along == is_along);
                some.map(|(f, _)| Face::new(*f)).collect()
            };
            assert_eq!(module.along(e), beside(true));
            assert_eq!(module.against(e), beside(false));
            assert_eq!(module.ends(e), vertices([*b]));
            for v in 0..12 {
                let entry = i64::from(v == *b) - i64::from(v == *a);
                assert_eq!(module.entry(Vertex::new(v), e), entry);
            }
        }
    }

    #[test]
    fn cellular_sets_and_unions() {
        let triangles = strip(3);
        let mesh = FaceMesh::from_triangles(12, &triangles).unwrap();
        let module = Cellular::new(&mesh).unwrap();
        let edges = edges(&triangles);
        for f in 0..12 {
            assert_eq!(module.sizes(Face::new(f)), (3, 3, 1));
            let closure = module.closure(Face::new(f));
            assert_eq!(closure.vertices, vertices(triangles[f as usize]));
        }
        for v in 0..12 {
            let star: Set<Face> = (0..)
                .zip(&triangles)
                .filter(|(_, t)| t.contains(&v))
                .map(|(f, _)| Face::new(f))
                .collect();
            assert_eq!(module.around(Vertex::new(v)), star);
            let link: Set<Edge> = (0..)
                .zip(&edges)
                .filter(|(_, ((a, b), faces))| {
                    let is_beside = |(f, _): &(u32, bool)| triangles[*f as usize].contains(&v);
                    *a != v && *b != v && faces.iter().any(is_beside)
                })
                .map(|(e, _)| Edge::new(e))
                .collect();
            assert_eq!(module.link(Vertex::new(v)), link, "{v}");
        }
    }

    #[test]
    fn elements_are_members_by_their_number() {
        let mesh = FaceMesh::from_triangles(9, &strip(2)).unwrap();
        // formulas count from 1, the host counts `index` from 0
        let members = Members::new(
            &mesh,
            Set::from_iter([1_i64, 3, 9, 40]),
            Set::from_iter([0_i64, 2, 8, 40]),
        )
        .unwrap();
        assert_eq!(members.P(), vertices([0, 2, 8]));
        assert_eq!(members.Q(), vertices([1, 3, 4, 5, 6, 7]));
        // of the eight faces the first and the third, each with four numbers
        assert_eq!(members.n(), 8);
    }

    #[test]
    fn functions_that_call_each_other() {
        let triangles = strip(5);
        let mesh = FaceMesh::from_triangles(18, &triangles).unwrap();
        let x: Vec<f64> = (0..18).map(|v| f64::from(v % 4) - 0.5).collect();
        let module = Alternating::new(&mesh, x.clone()).unwrap();
        for v in 0..18 {
            let mut set = vec![v];
            for _ in 0..2 {
                let mut grown: Vec<u32> = triangles
                    .iter()
                    .filter(|t| t.iter().any(|w| set.contains(w)))
                    .flatten()
                    .copied()
                    .collect();
                grown.retain(|w| x[*w as usize] > 0.0);
                set = grown;
            }
            assert_eq!(module.around(Vertex::new(v)), vertices(set), "around {v}");
        }
    }
}
