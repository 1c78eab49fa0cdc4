//! Terms with loops inside whose second derivatives are projected, as sums around a vertex: the mesh decides how large the
//! block of each is. Against dual numbers and nalgebra's eigenvalues.

#[allow(dead_code)]
#[path = "support/projected.rs"]
mod projected;
#[macro_use]
#[path = "support/twice.rs"]
mod twice;

use std::collections::BTreeSet;

use iheartmesh::glam::DVec3;
use iheartmesh::{FaceMesh, Set, Vertex};
use nalgebra::{DMatrix, DVector};
use num_dual::DualNum;
use projected::*;

programs! {
    #[together(e, B, p)]
    #[together(L, A)]
    #[together(r, s, U)]
    Rings, PlainRings = r#"
        ElementSets from MeshConnectivity
        VertexOneRing, NeighborVerticesInFace, Vertices, Edges, Faces from Neighborhoods(M)
        arccos from trigonometry
        psd, psd_abs from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x : V → ℝ³
        w ∈ ℝ
        W ⊂ V
        v ∈ ℝ^(3#V)
        Z ∈ ℝ^(3#V×m)
        l(p, q) = { (‖p - q‖² - w)² if ‖p - q‖² > w
                    0 otherwise where p, q ∈ ℝ³
        o(f, i) = { ‖∑_(j ∈ Vertices(f)) x_j‖⁴ if ‖x_i‖² > w
                    w ‖x_i‖² otherwise where f ∈ F, i ∈ V
        mean(i) = ‖∑_(j ∈ VertexOneRing(i)) (x_j - x_i)‖⁴ where i ∈ V
        stretch(i) = (∑_(j ∈ VertexOneRing(i)) ‖x_j - x_i‖² - w)² where i ∈ V
        hinge(i) = ∑_(j ∈ VertexOneRing(i)) l(x_i, x_j) where i ∈ V
        near(i) = ∑_(j for ‖x_j - x_i‖² < w) (x_j⋅x_i)² + x_i⋅x_i where i ∈ V
        own(i) = { (x_i ⋅ ∑_(j ∈ VertexOneRing(i) ∩ W) x_j - w)² if |Edges(i)| > 3
                   ∑_(j ∈ VertexOneRing(i)) (w - x_i⋅x_j)² otherwise where i ∈ V
        nested(i) = (∑_(j ∈ VertexOneRing(i)) ∑_(k ∈ VertexOneRing(j)) x_i⋅x_k - w)² where i ∈ V
        both(i) = ∑_(f ∈ Faces(i)) o(f, i) - w (∑_(j ∈ VertexOneRing(i)) x_j⋅x_j)² where i ∈ V
        angle(f, i) = arccos((u⋅t)/(‖u‖ ‖t‖))
            where f ∈ F, i ∈ V, j, k = NeighborVerticesInFace(f, i), u = x_j - x_i, t = x_k - x_i
        curved(i) = (2π - ∑_(f ∈ Faces(i)) angle(f, i))² where i ∈ V
        e = ∑_(i ∈ V) stretch(i)
        A = ∑_(i ∈ V) psd(∂²mean(i)/∂x²)
        B = ∑_(i ∈ V) psd_abs(∂²stretch(i)/∂x²)
        C = ∑_(i ∈ V) psd(∂²hinge(i)/∂x²)
        D = ∑_(i ∈ V) psd(∂²near(i)/∂x²)
        G = ∑_(i ∈ W) psd(∂²own(i)/∂x²)
        H = ∑_(i ∈ V) psd(∂²nested(i)/∂x²)
        J = ∑_(i ∈ V) psd_abs(∂²both(i)/∂x²)
        K = ∑_(i ∈ V) psd(∂²curved(i)/∂x²)
        L = 2 ∑_(i ∈ V) psd(∂²stretch(i)/∂x²) + ∑_(i ∈ V) psd(w ∂²mean(i)/∂x²) - w A / 2 + ∑_(i ∈ V) (psd(∂²both(i)/∂x²) - psd_abs(∂²both(i)/∂x²)/w - 2 psd_abs(∂²straight(i)/∂x²))
        straight(i) = (‖x_i‖² - w)² where i ∈ V
        cases(i) = { (∑_(j ∈ VertexOneRing(i)) ‖x_j - x_i‖² - w)² if ‖x_i‖² > w
                     ∑_(j ∈ VertexOneRing(i)) l(x_i, x_j) otherwise where i ∈ V
        r = ∑_(i ∈ V) cases(i)
        s = ∂r/∂x
        U = ∑_(i ∈ V) psd(∂²cases(i)/∂x²)
        N = ∑_(k = 1)^2 psd((k - w) ∂²e/∂x²)
        p = L v
        q = B Z
    "#;
}

type Energy = dyn Fn(&Energies<'_>, usize, &[Point]) -> Dual;

/// The energies of one vertex.
struct Energies<'a> {
    lists: &'a Lists,
    w: f64,
    set: &'a BTreeSet<usize>,
}

impl Energies<'_> {
    fn ring<'b>(&self, i: usize, x: &'b [Point]) -> impl Iterator<Item = &'b Point> {
        let ring = self.lists.rings[i].clone();
        ring.into_iter().map(|j| &x[j])
    }

    fn mean(&self, i: usize, x: &[Point]) -> Dual {
        let ring: Vec<Point> = self.ring(i, x).map(|p| minus(p, &x[i])).collect();
        let all = sum(ring.iter());
        square(&dot(&all, &all))
    }

    fn stretch(&self, i: usize, x: &[Point]) -> Dual {
        let ring = self.ring(i, x).map(|p| minus(p, &x[i]));
        square(&(ring.fold(Dual::from(-self.w), |all, u| all + dot(&u, &u))))
    }

    fn hinge(&self, i: usize, x: &[Point]) -> Dual {
        let ring = self.ring(i, x).map(|p| minus(p, &x[i]));
        let terms = ring.map(|u| dot(&u, &u) - self.w).filter(|l| l.re > 0.0);
        terms.fold(Dual::from(0.0), |all, l| all + square(&l))
    }

    fn near(&self, i: usize, x: &[Point]) -> Dual {
        let near = x.iter().filter(|p| {
            let u = minus(p, &x[i]);
            dot(&u, &u).re < self.w
        });
        near.fold(dot(&x[i], &x[i]), |all, p| all + square(&dot(p, &x[i])))
    }

    fn own(&self, i: usize, x: &[Point]) -> Dual {
        if self.lists.rings[i].len() > 3 {
            let ring = self.lists.rings[i].intersection(self.set);
            let all = sum(ring.map(|j| &x[*j]));
            return square(&(dot(&x[i], &all) - self.w));
        }
        let terms = self.ring(i, x).map(|p| square(&(dot(&x[i], p) - self.w)));
        terms.fold(Dual::from(0.0), |all, term| all + term)
    }

    fn straight(&self, i: usize, x: &[Point]) -> Dual {
        square(&(dot(&x[i], &x[i]) - self.w))
    }

    fn cases(&self, i: usize, x: &[Point]) -> Dual {
        match dot(&x[i], &x[i]).re > self.w {
            true => self.stretch(i, x),
            false => self.hinge(i, x),
        }
    }

    fn nested(&self, i: usize, x: &[Point]) -> Dual {
        let rings = self.lists.rings[i].iter().flat_map(|j| self.ring(*j, x));
        square(&(dot(&x[i], &sum(rings)) - self.w))
    }

    fn both(&self, i: usize, x: &[Point]) -> Dual {
        let mut all = Dual::from(0.0);
        for face in self.lists.faces(i) {
            let center = sum(face.iter().map(|j| &x[*j]));
            let length = dot(&x[i], &x[i]);
            all += match length.re > self.w {
                true => square(&dot(&center, &center)),
                false => length * self.w,
            };
        }
        let ring = self.ring(i, x);
        let ring = ring.fold(Dual::from(0.0), |all, p| all + dot(p, p));
        all - square(&ring) * self.w
    }

    fn curved(&self, i: usize, x: &[Point]) -> Dual {
        let angles = self.lists.faces(i).map(|[_, j, k]| {
            let (u, t) = (minus(&x[j], &x[i]), minus(&x[k], &x[i]));
            (dot(&u, &t) / (dot(&u, &u).sqrt() * dot(&t, &t).sqrt())).acos()
        });
        square(&angles.fold(Dual::from(std::f64::consts::TAU), |all, angle| all - angle))
    }
}

for_both! {
    #[test]
    fn sums_around_vertices() {
        for (number, lists) in meshes().iter().enumerate() {
            let n = lists.n;
            let x = points(n, number as u64);
            let v = DVector::from_fn(3 * n, |k, _| (k as f64).sin());
            let z = DMatrix::from_fn(3 * n, 2, |k, j| ((k + 7 * j) as f64).cos());
            let mesh = lists.mesh();
            let mut module = Rings::new(&mesh, &x, 1.0, vertices(&BTreeSet::new()), &v, &z).unwrap();
            // dual numbers of many numbers take their time
            let all = [(0.7, 1), (3.0, 2)];
            let chosen = if n > 5 { &all[number % 2..][..1] } else { &all };
            for &(w, some) in chosen {
                let set: BTreeSet<usize> = (0..n).filter(|k| k % some == 0).collect();
                module.set_w(w).unwrap();
                module.set_W(vertices(&set)).unwrap();
                let energies = Energies { lists, w, set: &set };
                let some = |members: &[usize], energy: &Energy, part: &dyn Fn(DMatrix<f64>) -> DMatrix<f64>| {
                    let zero = DMatrix::zeros(3 * n, 3 * n);
                    members.iter().fold(zero, |all, i| all + part(second(&x, |x| energy(&energies, *i, x))))
                };
                let all: Vec<usize> = (0..n).collect();
                let total = |energy: &Energy, part: &dyn Fn(DMatrix<f64>) -> DMatrix<f64>| some(&all, energy, part);
                let psd = |a: DMatrix<f64>| positive(&a);
                let absolute = |a: DMatrix<f64>| replaced(&a, f64::abs);
                let a = total(&|e, i, x| e.mean(i, x), &psd);
                let b = total(&|e, i, x| e.stretch(i, x), &absolute);
                near("A", &dense(&module.A()), &a);
                near("B", &dense(&module.B()), &b);
                near("C", &dense(&module.C()), &total(&|e, i, x| e.hinge(i, x), &psd));
                near("D", &dense(&module.D()), &total(&|e, i, x| e.near(i, x), &psd));
                near("G", &dense(&module.G()), &some(&Vec::from_iter(set.clone()), &|e, i, x| e.own(i, x), &psd));
                near("H", &dense(&module.H()), &total(&|e, i, x| e.nested(i, x), &psd));
                near("J", &dense(&module.J()), &total(&|e, i, x| e.both(i, x), &absolute));
                near("K", &dense(&module.K()), &total(&|e, i, x| e.curved(i, x), &psd));
                let l = 2.0 * total(&|e, i, x| e.stretch(i, x), &psd)
                    + 0.5 * w * &a
                    + total(&|e, i, x| e.both(i, x), &|a| positive(&a) - absolute(a) / w)
                    - 2.0 * total(&|e, i, x| e.straight(i, x), &absolute);
                near("L", &dense(&module.L()), &l);
                let u = total(&|e, i, x| e.cases(i, x), &psd);
                near("U", &dense(&module.U()), &u);
                let h = total(&|e, i, x| e.stretch(i, x), &|a| a);
                near("N", &dense(&module.N()), &(positive(&((1.0 - w) * &h)) + positive(&((2.0 - w) * &h))));
                let as_matrix = |v: DVector<f64>| DMatrix::from_vec(v.len(), 1, v.as_slice().to_vec());
                near("p", &as_matrix(module.p()), &(&l * as_matrix(v.clone())));
                near("q", &module.q(), &(&b * &z));
                // asked together
                let mut again = Rings::new(&mesh, &x, w, vertices(&set), &v, &z).unwrap();
                let (e, b, p) = again.e_B_p();
                assert!((e - module.e()).abs() <= 1e-12 * e.abs());
                near("B", &dense(&b), &dense(&module.B()));
                near("p", &as_matrix(p), &as_matrix(module.p()));
                let (r, slope, together) = again.r_s_U();
                near("U", &dense(&together), &u);
                assert!((r - module.r()).abs() <= 1e-12 * r.abs());
                near("s", &as_matrix(slope), &as_matrix(module.s()));
                again.set_w(w).unwrap();
                let (l, a) = again.L_A();
                near("L", &dense(&l), &dense(&module.L()));
                near("A", &dense(&a), &dense(&module.A()));
            }
        }
    }
}

fn large() -> (FaceMesh, Vec<DVec3>) {
    let lists = grid(16);
    (lists.mesh(), points(lists.n, 1))
}

#[test]
fn every_number_of_threads_gives_the_same_bits() {
    let (mesh, x) = large();
    let v = DVector::from_fn(3 * x.len(), |k, _| (k as f64).sin());
    let z = DMatrix::zeros(3 * x.len(), 0);
    let values = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| {
            let all: Set<Vertex> = mesh.vertices().collect();
            let module = optimized::Rings::new(&mesh, &x, 2.0, all, &v, &z).unwrap();
            let bits = |x: &[f64]| x.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            [
                bits(module.B().data()),
                bits(module.L().data()),
                bits(module.J().data()),
                bits(module.p().as_slice()),
            ]
        })
    };
    let one = values(1);
    for threads in [2, 3, 8] {
        assert!(values(threads) == one);
    }
}

#[test]
fn memory_and_patterns_are_used_again() {
    let lists = grid(6);
    let (mesh, x) = (lists.mesh(), points(lists.n, 2));
    let all: Set<Vertex> = mesh.vertices().collect();
    let v = DVector::zeros(3 * x.len());
    let z = DMatrix::zeros(3 * x.len(), 0);
    let mut module = optimized::Rings::new(&mesh, &x, 0.5, all, &v, &z).unwrap();
    let mut matrices = [module.B(), module.J(), module.C()];
    let places = matrices
        .each_ref()
        .map(|a| (a.data().as_ptr(), a.indices().as_ptr()));
    let patterns = matrices.clone();
    for factor in [0.0, 0.5, 4.0] {
        let moved: Vec<DVec3> = x.iter().map(|x| *x * factor).collect();
        module.set_x(moved).unwrap();
        let [b, j, c] = &mut matrices;
        module.B_into(b);
        module.J_into(j);
        module.C_into(c);
        for (matrix, fresh) in matrices.iter().zip([module.B(), module.J(), module.C()]) {
            assert_eq!(*matrix, fresh);
        }
        for (matrix, pattern) in matrices.iter().zip(&patterns) {
            assert_eq!(matrix.indices(), pattern.indices());
            assert_eq!(matrix.proper_indptr(), pattern.proper_indptr());
        }
        let now = matrices
            .each_ref()
            .map(|a| (a.data().as_ptr(), a.indices().as_ptr()));
        assert_eq!(now, places);
    }
    // of one vertex all pairs of its ring are stored, and no others
    let set = vertices(&BTreeSet::from([7]));
    module.set_W(set).unwrap();
    let g = module.G();
    let ring = 1 + lists.rings[7].len();
    assert!(g.nnz() <= 9 * ring * ring && g.nnz() > 0);
}

/// One term that takes all items: 150 rows at once.
#[test]
fn a_term_of_everything() {
    let lists = Lists::new(50, &grid(7).triangles);
    let (mesh, x) = (lists.mesh(), points(50, 2));
    let v = DVector::zeros(150);
    let z = DMatrix::zeros(150, 0);
    let module = optimized::Rings::new(&mesh, &x, 1.5, Set::default(), &v, &z).unwrap();
    let plain = plain::Rings::new(&mesh, &x, 1.5, Set::default(), &v, &z).unwrap();
    let n = dense(&module.N());
    near("N", &n, &dense(&plain.N()));
    let eigenvalues = n.clone().symmetric_eigenvalues();
    assert!(eigenvalues.min() > -1e-12 * eigenvalues.max());
    near("D", &dense(&module.D()), &dense(&plain.D()));
}
