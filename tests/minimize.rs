//! Energies written in the language, minimised by the host: against minima that other libraries found.

#[path = "../examples/common/disk.rs"]
mod disk;
#[allow(dead_code)]
mod support;

use std::path::Path;

use disk::{around_a_circle, cut, flipped, subdivided};
use iheartmesh::glam::{DVec2, DVec3};
use iheartmesh::solve::{Newton, Stop};
use iheartmesh::{
    FaceMesh, Functions, TwiceDifferentiable, Vertex, check_derivatives, check_gradient,
    inverse_vec, io, vec,
};

use support::reference_mesh::ReferenceMesh;

both_ways! {
    Tutte, PlainTutte = "examples/parameterization/tutte.hlang";
    Dirichlet, PlainDirichlet = "examples/parameterization/symmetric_dirichlet.hlang";
    Shell, PlainShell = "examples/discrete_shell.hlang";
}

/// The numbers of a table, without its first column and line.
fn table<const N: usize>(file: &Path) -> Vec<[f64; N]> {
    let text = std::fs::read_to_string(file).unwrap();
    let row = |line: &str| {
        let cells: Vec<f64> = line
            .split(',')
            .skip(1)
            .map(|x| x.parse().unwrap())
            .collect();
        <[f64; N]>::try_from(cells).unwrap()
    };
    text.lines().skip(1).map(row).collect()
}

fn dirichlet<'a>(
    mesh: &'a FaceMesh,
    surface: &'a [DVec3],
    start: &[DVec2],
) -> impl TwiceDifferentiable {
    Functions {
        state: Dirichlet::new(mesh, surface, start.to_vec()).unwrap(),
        set: |m: &mut Dirichlet<'a>, x: &[f64]| Ok(m.set_x(inverse_vec::<DVec2>(x)?)?),
        energy: |m: &mut Dirichlet<'a>| Ok(m.try_e()?),
        gradient: |m: &mut Dirichlet<'a>| Ok(m.try_G()?),
        hessian: |m: &mut Dirichlet<'a>| Ok(m.try_H()?),
    }
}

/// For energies that a movement of the whole does not change.
fn newton() -> Newton {
    Newton {
        damping: 1e-9,
        ..Newton::default()
    }
}

fn lengths(mesh: &FaceMesh, x: &[DVec2]) -> Vec<f64> {
    mesh.edges()
        .map(|e| {
            let [i, j] = mesh.edge_vertices(e).map(|v| x[v.index()]);
            i.distance(j)
        })
        .collect()
}

/// Half of a sphere.
fn disk() -> (FaceMesh, Vec<DVec3>) {
    let sphere = io::read(support::workspace().join("meshes/sphere_small.ply")).unwrap();
    let mesh = sphere.face_mesh().unwrap();
    let whole = mesh.triangles().unwrap();
    let (x, kept) = cut(&sphere.positions, whole, DVec3::new(0.3, 0.7, -0.5));
    (FaceMesh::from_triangles(x.len(), &kept).unwrap(), x)
}

#[test]
fn a_disk_is_laid_out_without_flips() {
    let (mesh, surface) = disk();
    let triangles = mesh.triangles().unwrap();
    let angles = around_a_circle(&mesh, &surface).unwrap();
    let start = Tutte::new(&mesh, angles.clone()).unwrap().x();
    let plain = PlainTutte::new(&mesh, angles).unwrap().x();
    for (a, b) in start.iter().zip(&plain) {
        assert!(a.distance(*b) < 1e-10);
    }
    assert_eq!(flipped(&start, triangles), 0);
    // each vertex inside is the mean of its neighbours, each other one on the circle
    let at_boundary = mesh.boundary_vertices();
    for v in mesh.vertices() {
        let x = start[v.index()];
        if at_boundary.contains(&v) {
            assert!((x.length() - 1.0).abs() < 1e-12);
            continue;
        }
        let edges = mesh.vertex_edges(v);
        let sum: DVec2 = edges
            .iter()
            .flat_map(|e| mesh.edge_vertices(e))
            .filter(|w| *w != v)
            .map(|w| start[w.index()])
            .sum();
        assert!((sum / edges.len() as f64).distance(x) < 1e-12);
    }

    let mut objective = dirichlet(&mesh, &surface, &start);
    let found = newton()
        .minimize(&mut objective, vec(&start).as_slice())
        .unwrap();
    assert_eq!(found.stop, Stop::Decrement);
    let end: Vec<DVec2> = inverse_vec(&found.x).unwrap();
    assert_eq!(flipped(&end, triangles), 0);
    let area: f64 = triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|v| surface[v as usize]);
            0.5 * (b - a).cross(c - a).length()
        })
        .sum();
    assert!(found.energy > 4.0 * area && found.energy < 8.0 * area);
    let report = check_gradient(&mut objective, vec(&start).as_slice()).unwrap();
    assert!(report.is_within(1e-6), "{report}");
    let plain = PlainDirichlet::new(&mesh, &surface, &end).unwrap();
    assert!((plain.e() - found.energy).abs() < 1e-9 * found.energy);
}

#[test]
fn a_flat_disk_stays_as_it_is() {
    // the least energy of all is that of lengths that are kept
    let (_, x) = disk();
    let (flat, triangles) = subdivided(&x[..3], &[[0, 1, 2]]);
    let small = FaceMesh::from_triangles(flat.len(), &triangles).unwrap();
    // in a frame of the triangle
    let (p, q) = (flat[1] - flat[0], flat[2] - flat[0]);
    let u = p.normalize();
    let w = (q - q.dot(u) * u).normalize();
    let kept: Vec<DVec2> = flat
        .iter()
        .map(|x| DVec2::new((*x - flat[0]).dot(u), (*x - flat[0]).dot(w)))
        .collect();
    let area = 0.5 * p.cross(q).length();
    let mut objective = dirichlet(&small, &flat, &kept);
    let moved: Vec<DVec2> = kept
        .iter()
        .map(|x| DVec2::new(1.7 * x.x + 0.3 * x.y, x.y))
        .collect();
    let found = newton()
        .minimize(&mut objective, vec(&moved).as_slice())
        .unwrap();
    assert!((found.energy - 4.0 * area).abs() < 1e-9 * area, "{found:?}");
    let end: Vec<DVec2> = inverse_vec(&found.x).unwrap();
    for (a, b) in lengths(&small, &end).iter().zip(lengths(&small, &kept)) {
        assert!((a - b).abs() < 1e-6 * b);
    }
}

#[test]
fn what_is_no_disk_is_refused() {
    let spot = io::read(support::workspace().join("meshes/spot.ply")).unwrap();
    let closed = spot.face_mesh().unwrap();
    let error = around_a_circle(&closed, &spot.positions).unwrap_err();
    assert_eq!(
        error,
        "the surface is not a disk: 1 components, Euler characteristic 2"
    );
    let x = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    let twisted = FaceMesh::from_triangles(4, &[[0, 1, 2], [0, 1, 3]]).unwrap();
    let error = around_a_circle(&twisted, &x).unwrap_err();
    assert_eq!(
        error,
        "the surface is not manifold, or not oriented alike everywhere"
    );
}

#[test]
fn parameterizations_of_the_reference_set() {
    let Some(set) = support::reference_set() else {
        return;
    };
    for name in ["cat_head", "cowhead"] {
        let surface = ReferenceMesh::read(&set, &format!("{name}.obj"));
        let (mesh, x) = (&surface.mesh, &surface.positions);
        let folder = set.join(format!("ref/{name}/param"));
        let json = surface.json("param/symmetric_dirichlet.json").unwrap();
        // the start
        let angles = around_a_circle(mesh, x).unwrap();
        let start = Tutte::new(mesh, angles).unwrap().x();
        let expected: Vec<DVec2> = table(&folder.join("x0_tutte.csv"))
            .into_iter()
            .map(DVec2::from_array)
            .collect();
        for (a, b) in start.iter().zip(&expected) {
            assert!(a.distance(*b) < 1e-11, "{name}: {a} {b}");
        }
        let energy = json.get("energy").unwrap().number();
        let mut objective = dirichlet(mesh, x, &start);
        let found = Dirichlet::new(mesh, x, &start).unwrap().e();
        assert!((found - energy).abs() < 1e-9 * energy);
        if cfg!(debug_assertions) && mesh.n_faces() > 1000 {
            // too slow without the optimisations of rustc
            continue;
        }
        let found = newton()
            .minimize(&mut objective, vec(&start).as_slice())
            .unwrap();
        let end: Vec<DVec2> = inverse_vec(&found.x).unwrap();
        assert_eq!(flipped(&end, mesh.triangles().unwrap()), 0);
        let least = json
            .get("final_energy")
            .unwrap()
            .get("TinyAD")
            .unwrap()
            .number();
        assert!(
            found.converged() && (found.energy - least).abs() < 1e-6 * least,
            "{name}: {} {least}",
            found.energy
        );
        // but for a movement of the whole
        let expected: Vec<DVec2> = table(&folder.join("x_final_TinyAD.csv"))
            .into_iter()
            .map(DVec2::from_array)
            .collect();
        for (a, b) in lengths(mesh, &end).iter().zip(lengths(mesh, &expected)) {
            assert!((a - b).abs() < 1e-3 * b, "{name}: {a} {b}");
        }
    }
}

/// Two triangles with a common side of length 2, one of them turned around it.
fn hinge(angle: f64) -> [DVec3; 4] {
    let (sin, cos) = angle.sin_cos();
    [
        DVec3::ZERO,
        DVec3::new(2.0, 0.0, 0.0),
        DVec3::new(0.5, 1.0, 0.0),
        DVec3::new(1.0, -3.0 * cos, 3.0 * sin),
    ]
}

#[test]
fn a_hinge_bends_as_it_should() {
    let mesh = FaceMesh::from_triangles(4, &[[0, 1, 2], [1, 0, 3]]).unwrap();
    let none: [Vertex; 0] = [];
    let (flat, angle, beta) = (hinge(0.0), 0.7, 0.3);
    let bent = hinge(angle);
    // lengths and areas are kept; the areas are 1 and 3
    let expected = 3.0 * beta * angle * angle * 4.0 / 4.0;
    let shell = Shell::new(&mesh, flat, bent, none, 5.0, beta, 0.0).unwrap();
    let plain = PlainShell::new(&mesh, flat, bent, none, 5.0, beta, 0.0).unwrap();
    for found in [shell.e(), plain.e()] {
        assert!((found - expected).abs() < 1e-12, "{found} {expected}");
    }
    // the weight of 4 at the mean heights of the triangles
    let heavy = Shell::new(&mesh, flat, bent, none, 5.0, beta, 2.0).unwrap();
    let weight = 2.0 * (1.0 / 3.0 - 3.0 * angle.cos());
    assert!((heavy.e() - expected - weight).abs() < 1e-12);

    let held = [0, 1, 2].map(Vertex::new);
    let mut energy = Functions {
        state: Shell::new(&mesh, flat, bent, held, 5.0, beta, 0.0).unwrap(),
        set: |m: &mut Shell<'_>, x: &[f64]| Ok(m.set_x(inverse_vec::<DVec3>(x)?)?),
        energy: |m: &mut Shell<'_>| Ok(m.try_e()?),
        gradient: |m: &mut Shell<'_>| Ok(m.try_G()?),
        hessian: |m: &mut Shell<'_>| Ok(m.try_H()?),
    };
    let report = check_derivatives(&mut energy, vec(&bent).as_slice()).unwrap();
    assert!(report.is_within(1e-8), "{report}");
    assert_eq!(report.hessian.unwrap().entries, 144);
    // it opens again
    let mut energy = Functions {
        state: energy.state,
        set: energy.set,
        energy: energy.energy,
        gradient: energy.gradient,
        hessian: |m: &mut Shell<'_>| Ok(m.try_P()?),
    };
    let found = newton()
        .minimize(&mut energy, vec(&bent).as_slice())
        .unwrap();
    assert!(found.converged() && found.energy < 1e-8, "{found:?}");
}
