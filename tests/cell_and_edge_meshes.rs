//! Programs on cell meshes and edge meshes, and with boundary matrices as matrices of numbers.
use iheartmesh::glam::DVec3;
use iheartmesh::nalgebra::{DMatrix, DVector};
use iheartmesh::sprs::CsMat;
use iheartmesh::{Cell, CellMesh, EdgeMesh, Element, FaceMesh, Set, SetItem, Vertex};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

fn ids<E: Element + SetItem>(set: Set<E>) -> Vec<u32> {
    set.iter().map(|element| element.id()).collect()
}

programs! {
    Volumes, PlainVolumes = r#"
        ElementSets from MeshConnectivity
        OrientedVertices from TetrahderonNeighborhoods(M)
        M : CellMesh
        V, E, F, C = ElementSets(M)
        x_i ∈ ℝ^3
        vol(c) = |[x_b-x_a x_d-x_a x_k-x_a]|/6 where c ∈ C, a, b, d, k = OrientedVertices(c)
        total = ∑_(c ∈ C) vol(c)
    "#;
    Exterior, PlainExterior = r#"
        ElementSets, BoundaryMatrices from MeshConnectivity
        vec from linearalgebra
        M : CellMesh
        V, E, F, C = ElementSets(M)
        `∂⁰`, `∂¹`, `∂²` = BoundaryMatrices(M)
        u : V → ℝ
        s ∈ ℝ^(#V)
        d = `∂⁰`ᵀ vec(u)
        L = `∂⁰` `∂⁰`ᵀ
        Z = `∂⁰` `∂¹`
        Y = `∂¹` `∂²`
        y = L s
        t = sᵀ L s + (2 `∂⁰`ᵀ s)⋅d
    "#;
    Numbers, PlainNumbers = r#"
        ElementSets, BoundaryMatrices, UnsignedBoundaryMatrices from MeshConnectivity
        NonZeros, ValueSet, IndicatorVector from MeshConnectivity
        VertexOneRing from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        `∂⁰`, `∂¹` = BoundaryMatrices(M)
        `B⁰`, `B¹` = UnsignedBoundaryMatrices(M)
        u : V → ℝ
        w : E → ℝ
        S ⊂ V
        heads = ½(`∂⁰` + `B⁰`)
        tails = -`∂⁰` ∘ heads + heads - `∂⁰`
        square = ‖`∂¹`‖² + `B¹` : `∂¹`
        wide = [`∂⁰` `B⁰`]
        column(e) = `∂⁰`_*,e where e ∈ E
        row(v) = `∂⁰`_v,* where v ∈ V
        sizes = #`∂¹`
        inside = IndicatorVector(S)ᵀ u + ‖IndicatorVector(S)‖ + 2 IndicatorVector(S) ⋅ u
        masked = u ∘ IndicatorVector(S) - `B⁰` w
        around(v) = (`∂⁰`ᵀ IndicatorVector({v}))ᵀ w where v ∈ V
        member(v) = IndicatorVector(VertexOneRing(v))_v + IndicatorVector(S)_v where v ∈ V
        positive = NonZeros(u)
        half = ValueSet(u, ½)
        flat = NonZeros(`∂⁰`ᵀ u)
        untouched = ValueSet(`B⁰`ᵀ IndicatorVector(S), 0)
        few(k) = ValueSet(`B⁰` IndicatorVector(E), k) where k ∈ ℤ
        free(f) = NonZeros(`B⁰` `B¹` IndicatorVector({f})) where f ∈ F
        bound(f) = NonZeros(`B⁰` (`B¹` IndicatorVector({f}))) where f ∈ F
        nothing(f) = NonZeros(`∂⁰` `∂¹` IndicatorVector({f})) where f ∈ F
        signed = { `∂⁰` if |S| > 2
                   `B⁰` otherwise
        total = signed IndicatorVector(E)
    "#;
    Means, PlainMeans = r#"
        ElementSets from MeshConnectivity
        VertexOneRing from PointCloudNeighborhoods(M)
        M : EdgeMesh
        V, E = ElementSets(M)
        x_i ∈ ℝ^3
        m(v) = 1/|VertexOneRing(v)| ∑_(w ∈ VertexOneRing(v)) x_w where v ∈ V
    "#;
}

for_both! {
    #[test]
    fn volumes() {
        let mesh = CellMesh::from_tetrahedra(5, &[[0, 1, 2, 3], [1, 2, 3, 4], [3, 2, 1, 4]]).unwrap();
        let x = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::ONE];
        let module = Volumes::new(&mesh, x).unwrap();
        let expected = [1.0 / 6.0, 1.0 / 3.0, -1.0 / 3.0];
        for (cell, expected) in mesh.cells().zip(expected) {
            assert!((module.vol(cell) - expected).abs() < 1e-15, "{cell:?}");
        }
        assert!((module.total() - 1.0 / 6.0).abs() < 1e-15);
        assert_eq!(module.vol_all().len(), 3);
        let _ = Cell::new(0);
    }

    #[test]
    fn boundary_matrices_are_matrices() {
        let mesh = CellMesh::from_tetrahedra(5, &[[0, 1, 2, 3], [1, 2, 3, 4]]).unwrap();
        let u = [1.0, -2.0, 0.5, 3.0, 7.0];
        let module = Exterior::new(&mesh, u, DVector::from_row_slice(&u)).unwrap();
        let differences: Vec<f64> = mesh
            .edges()
            .map(|edge| {
                let [tail, head] = mesh.edge_vertices(edge);
                u[head.index()] - u[tail.index()]
            })
            .collect();
        assert_eq!(module.d().as_slice(), differences);
        let degree = |v: usize| mesh.vertex_edges(Vertex::new(v as u32)).len() as f64;
        for v in 0..5 {
            assert_eq!(module.L().get(v, v), Some(&degree(v)));
            let around = mesh.edges().map(|edge| mesh.edge_vertices(edge).map(|v| v.index()));
            let expected: f64 = around
                .filter(|ends| ends.contains(&v))
                .map(|[i, j]| u[v] - u[if i == v { j } else { i }])
                .sum();
            assert!((module.y()[v] - expected).abs() < 1e-14);
        }
        // the boundary of a boundary is nothing
        for product in [module.Z(), module.Y()] {
            assert!(product.data().iter().all(|entry| *entry == 0.0));
        }
        assert_eq!((module.Z().rows(), module.Z().cols()), (5, 7));
        let squares: f64 = differences.iter().map(|d| d * d).sum();
        assert!((module.t() - 3.0 * squares).abs() < 1e-12);
    }

    #[test]
    fn boundary_matrices_and_indicators_are_numbers() {
        let faces: [[u32; 3]; 3] = [[0, 1, 2], [2, 1, 3], [4, 2, 3]];
        let mesh = FaceMesh::from_triangles(6, &faces).unwrap();
        let edges = [[0, 1], [0, 2], [1, 2], [1, 3], [2, 3], [2, 4], [3, 4]];
        let mut d = DMatrix::<f64>::zeros(6, 7);
        for (e, [tail, head]) in edges.into_iter().enumerate() {
            (d[(tail, e)], d[(head, e)]) = (-1.0, 1.0);
        }
        let b = d.map(f64::abs);
        let u = DVector::from_row_slice(&[1.0, 0.5, 0.0, -2.0, 0.5, 0.0]);
        let w = DVector::from_row_slice(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.5]);
        let chosen = [1, 2, 4].map(Vertex::new);
        let set: Set<Vertex> = chosen.into_iter().collect();
        let delta = DVector::from_row_slice(&[0.0, 1.0, 1.0, 0.0, 1.0, 0.0]);
        let module = Numbers::new(&mesh, u.as_slice(), w.as_slice(), &set).unwrap();
        let dense = |matrix: CsMat<f64>| {
            let mut all = DMatrix::zeros(matrix.rows(), matrix.cols());
            matrix.iter().for_each(|(entry, (i, j))| all[(i, j)] += *entry);
            all
        };
        let heads = d.map(|x| x.max(0.0));
        assert_eq!(dense(module.heads()), heads);
        assert_eq!(dense(module.tails()), -d.component_mul(&heads) + &heads - &d);
        // ∂¹ has three entries in each column: ±1
        let signs: f64 = faces
            .iter()
            .flat_map(|[i, j, k]| [(i, j), (j, k), (k, i)])
            .map(|(a, b)| if a < b { 1.0 } else { -1.0 })
            .sum();
        assert!((module.square() - (9.0 + signs)).abs() < 1e-12);
        let wide = dense(module.wide());
        assert_eq!((wide.columns(0, 7).into_owned(), wide.columns(7, 7).into_owned()), (d.clone(), b.clone()));
        assert_eq!(module.sizes(), (7, 3));
        for (e, edge) in mesh.edges().enumerate() {
            assert_eq!(module.column(edge), d.column(e));
        }
        let inside = delta.dot(&u) + delta.norm() + 2.0 * delta.dot(&u);
        assert!((module.inside() - inside).abs() < 1e-14);
        assert!((module.masked() - (u.component_mul(&delta) - &b * &w)).norm() < 1e-12);
        for (i, v) in mesh.vertices().enumerate() {
            assert_eq!(module.row(v), d.row(i).transpose());
            assert!((module.around(v) - (d.row(i) * &w)[0]).abs() < 1e-12);
            assert_eq!(module.member(v), delta[i], "no vertex is in its own ring");
        }
        let where_ = |all: &[f64], is: &dyn Fn(f64) -> bool| -> Vec<u32> {
            (0..all.len() as u32).filter(|&i| is(all[i as usize])).collect()
        };
        assert_eq!(ids(module.positive()), where_(u.as_slice(), &|x| x != 0.0));
        assert_eq!(ids(module.half()), where_(u.as_slice(), &|x| x == 0.5));
        let differences = d.tr_mul(&u);
        assert_eq!(ids(module.flat()), where_(differences.as_slice(), &|x| x != 0.0));
        let touched = b.tr_mul(&delta);
        assert_eq!(ids(module.untouched()), where_(touched.as_slice(), &|x| x == 0.0));
        let degrees = b.column_sum();
        for k in [0, 2, 3, 9] {
            assert_eq!(ids(module.few(k)), where_(degrees.as_slice(), &|x| x == k as f64));
        }
        for (corners, f) in faces.into_iter().zip(mesh.faces()) {
            let mut corners = corners.to_vec();
            corners.sort_unstable();
            assert_eq!(ids(module.free(f)), corners);
            assert_eq!(ids(module.bound(f)), corners);
            assert!(module.nothing(f).is_empty(), "the boundary of a boundary");
        }
        assert_eq!(module.total(), d.column_sum());
    }

    #[test]
    fn means() {
        let mesh = EdgeMesh::from_edges(4, &[[0, 1], [2, 0], [3, 0]]).unwrap();
        let x = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let module = Means::new(&mesh, x).unwrap();
        assert!((module.m(Vertex::new(0)) - DVec3::splat(1.0 / 3.0)).length() < 1e-15);
        assert_eq!(module.m(Vertex::new(1)), DVec3::ZERO);
    }
}
