//! Terms with loops inside whose second derivatives are projected, as in `projection.rs`: of items of several sizes, of some items
//! only, with neighbours that do not exist.

#[allow(dead_code)]
#[path = "support/projected.rs"]
mod projected;
#[macro_use]
#[path = "support/twice.rs"]
mod twice;

use std::collections::BTreeSet;

use iheartmesh::Set;
use iheartmesh::glam::{DMat2, DVec2};
use nalgebra::DMatrix;
use projected::*;

programs! {
    Items, PlainItems = r#"
        ElementSets from MeshConnectivity
        VertexOneRing from Neighborhoods(M)
        psd from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        w ∈ ℝ
        y : V → ℝ
        u : V → ℝ^(2×2)
        X : V → ℝ² : where vertices are held
        m_i ∈ ℤ : which item of `z` is the place of a vertex, 0 where it is held
        z_k ∈ ℝ²
        Q ∈ {ℤ×ℤ}
        n ∈ ℤ
        flat(i) = (∑_(j ∈ VertexOneRing(i)) y_j y_i - w)² where i ∈ V
        many(i) = (|∑_(j ∈ VertexOneRing(i)) u_j| - w)² where i ∈ V
        p(i) = { z_(m_i) if m_i > 0
                 X_i otherwise where i ∈ V
        free(i) = (∑_(j ∈ VertexOneRing(i)) ‖p(j) - p(i)‖² - w)² where i ∈ V
        held(k) = { ∑_((i, j) ∈ Q) ((z_i⋅z_j) ‖z_k‖² - w)² if ‖z_k‖² < w
                    ‖z_1 - z_k‖⁴ otherwise where k ∈ ℤ
        P = ∑_(i ∈ V) psd(∂²flat(i)/∂y²)
        R = ∑_(i ∈ V) psd(∂²many(i)/∂u²)
        S = ∑_(i ∈ V) psd(∂²free(i)/∂z²)
        T = ∑_(k = 2)^n psd(∂²held(k)/∂z²)
        f = ∑_(i ∈ V) flat(i)
        Y = ∑_(k = 1)^n psd(k ∂²f/∂y²)
    "#;

    Opposite, PlainOpposite = r#"
        ElementSets from MeshConnectivity
        VertexOneRing, OppositeVertices, Edges from Neighborhoods(M)
        psd from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x : V → ℝ³
        w ∈ ℝ
        T ⊂ V
        l(k) = ‖x_i - x_j‖² where k ∈ E, i, j = OppositeVertices(k)
        S(i) = { (∑_(k ∈ Edges(i)) l(k) - w)² if w > 0
                 ∑_(j ∈ VertexOneRing(i)) ‖x_j - x_i‖⁴ otherwise where i ∈ V
        R(i) = (∑_(k ∈ Edges(i)) l(k) - w)² where i ∈ V
        P = ∑_(i ∈ V) psd(∂²S(i)/∂x²)
        Q = ∑_(i ∈ T) psd(∂²R(i)/∂x²)
    "#;
}

/// Sums of numbers that are zero.
fn add(all: Dual, term: &Dual) -> Dual {
    all + term
}

for_both! {
    #[test]
    fn items_of_other_sizes() {
        for (number, lists) in meshes().iter().enumerate() {
            let n = lists.n;
            let numbers = |count: usize, seed: u64| -> Vec<f64> {
                points(count.div_ceil(3), seed)
                    .iter()
                    .flat_map(|x| x.to_array())
                    .take(count)
                    .collect()
            };
            let (y, u) = (numbers(n, 3), numbers(4 * n, 4));
            let held = numbers(2 * n, 5);
            // every third vertex is held
            let mut count = 0;
            let places: Vec<i64> = (0..n)
                .map(|i| if i % 3 == 1 { 0 } else { count += 1; count })
                .collect();
            let z = numbers(2 * count as usize, 6);
            let matrices: Vec<DMat2> = u.chunks(4).map(DMat2::from_cols_slice).collect();
            let pairs = |x: &[f64]| -> Vec<DVec2> { x.chunks(2).map(DVec2::from_slice).collect() };
            let mesh = lists.mesh();
            let mut module = Items::new(&mesh, 0.3, &y, &matrices, pairs(&held), &places, pairs(&z), Set::default(), 0).unwrap();
            for (w, members) in [(0.3, vec![]), (0.6, vec![(1, 2)]), (2.0, vec![(1, 2), (2, 2), (2, 1)])] {
                module.set_w(w).unwrap();
                let sum = |all: usize, term: &dyn Fn(usize) -> DMatrix<f64>, size: usize| {
                    (0..all).fold(DMatrix::zeros(size, size), |sum, k| sum + positive(&term(k)))
                };
                let flat = |i: usize| second_of(y.clone(), |y| {
                    let ring = lists.rings[i].iter().map(|j| y[*j].clone() * &y[i]);
                    square(&ring.fold(Dual::from(-w), |all, term| add(all, &term)))
                });
                near("P", &dense(&module.P()), &sum(n, &flat, n));
                let many = |i: usize| second_of(u.clone(), |u| {
                    let [a, b, c, d] = std::array::from_fn(|k| {
                        lists.rings[i].iter().fold(Dual::from(0.0), |all, j| add(all, &u[4 * j + k]))
                    });
                    square(&(a * &d - b * &c - w))
                });
                near("R", &dense(&module.R()), &sum(n, &many, 4 * n));
                let free = |i: usize| second_of(z.clone(), |z| {
                    let at = |i: usize| -> [Dual; 2] {
                        std::array::from_fn(|d| match places[i] as usize {
                            0 => Dual::from(held[2 * i + d]),
                            k => z[2 * (k - 1) + d].clone(),
                        })
                    };
                    let (mut all, own) = (Dual::from(-w), at(i));
                    for j in &lists.rings[i] {
                        for (a, b) in at(*j).iter().zip(&own) {
                            all += square(&(a.clone() - b));
                        }
                    }
                    square(&all)
                });
                near("S", &dense(&module.S()), &sum(n, &free, z.len()));
                // pairs and a range that the host gives
                let last = if members.is_empty() { 0 } else { count };
                if count < 2 && last > 0 {
                    continue;
                }
                module.set_Q(Set::from(members.clone())).unwrap();
                module.set_n(last).unwrap();
                let held = |k: usize| second_of(z.clone(), |z| {
                    let at = |k: i64| -> [Dual; 2] { std::array::from_fn(|d| z[2 * (k as usize - 1) + d].clone()) };
                    let dot = |a: &[Dual; 2], b: &[Dual; 2]| a[0].clone() * &b[0] + a[1].clone() * &b[1];
                    let own = at(k as i64 + 2);
                    if dot(&own, &own).re < w {
                        let terms = members.iter().map(|(i, j)| square(&(dot(&at(*i), &at(*j)) * dot(&own, &own) - w)));
                        return terms.fold(Dual::from(0.0), |all, term| add(all, &term));
                    }
                    let difference: [Dual; 2] = std::array::from_fn(|d| at(1)[d].clone() - &own[d]);
                    square(&dot(&difference, &difference))
                });
                near(&format!("T {number}"), &dense(&module.T()), &sum((last - 1).max(0) as usize, &held, z.len()));
            }
            // an item that there is not
            module.set_Q(Set::from(vec![(1, count + 1)])).unwrap();
            module.set_n(count).unwrap();
            module.set_w(f64::INFINITY).unwrap();
            assert_eq!(module.try_T().is_err(), count > 1);
            module.set_w(0.0).unwrap();
            assert!(module.try_T().is_ok());
        }
    }

    #[test]
    fn neighbors_that_are_missing() {
        let open = Lists::new(7, &[[1, 3, 5], [1, 5, 6]]);
        let closed = meshes().swap_remove(5);
        for lists in [open, closed] {
            let mesh = lists.mesh();
            let x = points(lists.n, 8);
            let all: BTreeSet<usize> = (0..lists.n).collect();
            let mut module = Opposite::new(&mesh, &x, -1.0, vertices(&all)).unwrap();
            let ring = |i: usize| second(&x, |x| {
                let ring = lists.rings[i].iter().map(|j| minus(&x[*j], &x[i]));
                ring.fold(Dual::from(0.0), |all, u| all + square(&dot(&u, &u)))
            });
            let zero = DMatrix::zeros(3 * lists.n, 3 * lists.n);
            let rings = (0..lists.n).fold(zero.clone(), |all, i| all + positive(&ring(i)));
            // what is not needed may be missing
            near("P", &dense(&module.P()), &rings);
            module.set_w(1.0).unwrap();
            if lists.n == 7 {
                let error = module.try_P().unwrap_err().to_string();
                assert!(error.contains("`OppositeVertices` has no value in `OppositeVertices(k)`"), "{error}");
                assert!(module.try_Q().is_err());
                // isolated vertices need no neighbours
                module.set_T(vertices(&BTreeSet::from([0, 2, 4]))).unwrap();
                assert_eq!(dense(&module.Q()), zero);
                continue;
            }
            // opposite vertices of the edges at one of four
            let opposite = |i: usize| second(&x, |x| {
                let others: Vec<usize> = (0..4).filter(|j| *j != i).collect();
                let sides = (0..3).map(|k| minus(&x[others[k]], &x[others[(k + 1) % 3]]));
                square(&sides.fold(Dual::from(-1.0), |all, u| all + dot(&u, &u)))
            });
            let expected = (0..4).fold(zero, |all, i| all + positive(&opposite(i)));
            near("P", &dense(&module.P()), &expected);
            near("Q", &dense(&module.Q()), &expected);
        }
    }
}

#[test]
fn the_first_vertex_without_a_value_is_named() {
    let lists = Lists::new(7, &[[1, 3, 5], [1, 5, 6]]);
    let (mesh, x) = (lists.mesh(), points(lists.n, 8));
    let module = optimized::Opposite::new(&mesh, &x, 1.0, Set::default()).unwrap();
    let error = module.try_P().unwrap_err().to_string();
    assert!(
        error.starts_with("`P` has no value: for vertex 1, `OppositeVertices` has no value"),
        "{error}"
    );
}

/// A block that takes all of a mesh has more entries than can be counted: that is said before memory is asked for.
#[test]
fn a_block_that_is_too_large() {
    let lists = grid(260);
    let mesh = lists.mesh();
    let (y, none) = (vec![1.0; lists.n], vec![0; lists.n]);
    let (u, at) = (vec![DMat2::ZERO; lists.n], vec![DVec2::ZERO; lists.n]);
    let nothing: Vec<DVec2> = Vec::new();
    let module =
        optimized::Items::new(&mesh, 1.0, &y, &u, &at, &none, nothing, Set::default(), 1).unwrap();
    let error = module.try_Y().unwrap_err().to_string();
    assert!(
        error.contains("more entries than can be counted"),
        "{error}"
    );
}
