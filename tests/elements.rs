//! Elements of a mesh as numbers and in recursion, against loops written out, with and without optimisations.

use iheartmesh::{FaceMesh, Set, Vertex};

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

for_both! {
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
