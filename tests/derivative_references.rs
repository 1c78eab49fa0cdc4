//! Energies and their derivatives on real meshes, against values that other libraries computed.

#[allow(dead_code)]
mod support;

use std::fs;
use std::path::Path;

use iheartmesh::glam::{DVec2, DVec3};
use iheartmesh::{CellMesh, io, sprs};

use support::json::Json;
use support::reference_mesh::ReferenceMesh;

both_ways! {
    Descent, PlainDescent = "examples/gradient_descent.hlang";
    Dirichlet, PlainDirichlet = "tests/programs/symmetric_dirichlet.hlang";
    Tetrahedra, PlainTetrahedra = "tests/programs/tetrahedral_energies.hlang";
}

/// The rows of a table without its first column and line.
fn table(file: &Path) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(file).unwrap();
    let numbers = |line: &str| {
        line.split(',')
            .skip(1)
            .map(|x| x.parse().unwrap())
            .collect()
    };
    text.lines().skip(1).map(numbers).collect()
}

/// The first column of a table.
fn rows(file: &Path) -> Vec<usize> {
    let text = fs::read_to_string(file).unwrap();
    let first = |line: &str| line.split(',').next().unwrap().parse().unwrap();
    text.lines().skip(1).map(first).collect()
}

/// The difference of two lists, as a part of the greatest value of the second.
#[track_caller]
fn check(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let scale = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    for (k, (a, b)) in found.iter().zip(expected).enumerate() {
        assert!((a - b).abs() <= tolerance * scale, "at {k}: {a} is not {b}");
    }
}

#[test]
fn a_step_of_gradient_descent() {
    let Some(set) = support::reference_set() else {
        return;
    };
    let smooth = ReferenceMesh::read(&set, "bob_small.obj");
    let noisy = io::read(set.join("ref/bilateral_bob_small/noisy.obj")).unwrap();
    let expected = table(&set.join("ref/sec431_bob_small/gradient_step.csv"));
    let column = |k: usize| -> Vec<f64> {
        expected
            .iter()
            .flat_map(|row| row[k..k + 3].to_vec())
            .collect()
    };
    let flat = |x: &[DVec3]| -> Vec<f64> { x.iter().flat_map(|x| x.to_array()).collect() };
    let optimized = Descent::new(&smooth.mesh, &noisy.positions, &smooth.positions).unwrap();
    let plain = PlainDescent::new(&smooth.mesh, &noisy.positions, &smooth.positions).unwrap();
    for (g, x) in [
        (optimized.g(), optimized.x1_star()),
        (plain.g(), plain.x1_star()),
    ] {
        check(g.as_slice(), &column(0), 1e-11);
        check(&flat(&x), &column(3), 1e-11);
    }
}

/// The lower triangle of a matrix in a file, with the entries of another at these places.
fn lower(file: &Path, matrix: &sprs::CsMat<f64>) -> (Vec<f64>, Vec<f64>) {
    let text = fs::read_to_string(file).unwrap();
    let mut lines = text.lines().filter(|line| !line.starts_with('%'));
    assert!(lines.next().is_some());
    let mut expected = Vec::new();
    let mut found = Vec::new();
    for line in lines {
        let parts: Vec<&str> = line.split(' ').collect();
        let (i, j) = (
            parts[0].parse::<usize>().unwrap(),
            parts[1].parse::<usize>().unwrap(),
        );
        expected.push(parts[2].parse().unwrap());
        found.push(matrix.get(i - 1, j - 1).copied().unwrap_or(0.0));
    }
    (found, expected)
}

#[test]
fn symmetric_dirichlet_energies() {
    let Some(set) = support::reference_set() else {
        return;
    };
    for name in ["cat_head", "cowhead"] {
        let surface = ReferenceMesh::read(&set, &format!("{name}.obj"));
        let folder = set.join(format!("ref/{name}/param"));
        let plane: Vec<DVec2> = table(&folder.join("x0_tutte.csv"))
            .iter()
            .map(|row| DVec2::new(row[0], row[1]))
            .collect();
        let json = surface.json("param/symmetric_dirichlet.json").unwrap();
        let energy = json.get("energy").unwrap().number();
        let file = folder.join("symmetric_dirichlet_gradient.csv");
        let gradient: Vec<f64> = table(&file).concat();
        // of a large mesh a selection
        let rows = rows(&file);
        let selected = |g: &[f64]| -> Vec<f64> {
            rows.iter().flat_map(|v| [g[2 * v], g[2 * v + 1]]).collect()
        };
        let optimized = Dirichlet::new(&surface.mesh, &surface.positions, &plane).unwrap();
        let plain = PlainDirichlet::new(&surface.mesh, &surface.positions, &plane).unwrap();
        check(&[optimized.e(), plain.e()], &[energy, energy], 1e-9);
        check(&selected(optimized.g().as_slice()), &gradient, 1e-9);
        check(&selected(plain.g().as_slice()), &gradient, 1e-9);
        let matrices = [
            ("", optimized.H(), plain.H(), 1e-9),
            ("_psd", optimized.P(), plain.P(), 1e-7),
        ];
        for (part, a, b, tolerance) in matrices {
            let file = folder.join(format!("symmetric_dirichlet_hessian{part}_lower.mtx"));
            for matrix in [a, b] {
                assert!(matrix.is_csc());
                if file.exists() {
                    let (found, expected) = lower(&file, &matrix);
                    check(&found, &expected, tolerance);
                }
                let error = matrix
                    .iter()
                    .map(|(x, (i, j))| (x - matrix.get(j, i).unwrap()).abs() / (1.0 + x.abs()))
                    .fold(0.0, f64::max);
                assert!(error < 1e-9, "not symmetric: {error}");
            }
        }
    }
}

/// The vertices and tetrahedra of a MEDIT file.
fn tetrahedra(file: &Path) -> (Vec<DVec3>, Vec<[u32; 4]>) {
    let text = fs::read_to_string(file).unwrap();
    let section = |name: &'static str| {
        let mut words = text
            .split_whitespace()
            .skip_while(move |word| *word != name);
        words.next();
        let n: usize = words.next().unwrap().parse().unwrap();
        (n, words)
    };
    let (n, words) = section("Vertices");
    let numbers: Vec<f64> = words.take(4 * n).map(|x| x.parse().unwrap()).collect();
    let positions = numbers
        .chunks(4)
        .map(|p| DVec3::new(p[0], p[1], p[2]))
        .collect();
    let (n, words) = section("Tetrahedra");
    let numbers: Vec<u32> = words.take(5 * n).map(|x| x.parse().unwrap()).collect();
    let cells = numbers
        .chunks(5)
        .map(|c| [c[0] - 1, c[1] - 1, c[2] - 1, c[3] - 1])
        .collect();
    (positions, cells)
}

#[test]
fn energies_of_tetrahedra() {
    let Some(set) = support::reference_set() else {
        return;
    };
    let rest = tetrahedra(&set.join("meshes/kuhn_cube3.mesh"));
    let folder = set.join("ref/kuhn_cube3/energy");
    let x: Vec<DVec3> = table(&folder.join("x_deformed.csv"))
        .iter()
        .map(|row| DVec3::new(row[0], row[1], row[2]))
        .collect();
    let mesh = CellMesh::from_tetrahedra(rest.0.len(), &rest.1).unwrap();
    let m = Tetrahedra::new(&mesh, &rest.0, &x).unwrap();
    let n = PlainTetrahedra::new(&mesh, &rest.0, &x).unwrap();
    for (name, e, g, h, psd, tolerance) in [
        (
            "SD",
            [m.e1(), n.e1()],
            [m.g1(), n.g1()],
            [m.H1(), n.H1()],
            Some([m.P1(), n.P1()]),
            1e-9,
        ),
        (
            "EXP_SD",
            [m.e2(), n.e2()],
            [m.g2(), n.g2()],
            [m.H2(), n.H2()],
            None,
            1e-8,
        ),
        (
            "AMIPS",
            [m.e3(), n.e3()],
            [m.g3(), n.g3()],
            [m.H3(), n.H3()],
            None,
            1e-9,
        ),
        (
            "CONF_AMIPS",
            [m.e4(), n.e4()],
            [m.g4(), n.g4()],
            [m.H4(), n.H4()],
            Some([m.P4(), n.P4()]),
            1e-9,
        ),
    ] {
        let json = fs::read_to_string(folder.join(format!("{name}.json"))).unwrap();
        let energy = Json::parse(&json).get("energy").unwrap().number();
        check(&e, &[energy, energy], tolerance);
        let gradient = table(&folder.join(format!("{name}_gradient.csv"))).concat();
        for g in g {
            check(g.as_slice(), &gradient, tolerance);
        }
        for h in h {
            let (found, expected) = lower(&folder.join(format!("{name}_hessian_lower.mtx")), &h);
            check(&found, &expected, tolerance);
        }
        for psd in psd.into_iter().flatten() {
            let file = folder.join(format!("{name}_hessian_psd_lower.mtx"));
            let (found, expected) = lower(&file, &psd);
            check(&found, &expected, 1e-7);
        }
    }
}
