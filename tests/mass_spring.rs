//! The example of masses and springs, against another implementation, and against what is known without it.

#[path = "../examples/common/springs.rs"]
mod springs;
#[allow(dead_code)]
mod support;

use std::path::Path;

use iheartmesh::glam::DVec3;
use iheartmesh::{CellMesh, Vertex, io};

use springs::wobble;
use support::json::Json;

both_ways! {
    MassSpring, PlainMassSpring = "examples/mass_spring.hlang";
}

/// The rows of a table: the number of the vertex and the values of all columns by name.
fn table(file: &Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = std::fs::read_to_string(file).unwrap();
    let mut lines = text.lines();
    let header = lines.next().unwrap().split(',').map(str::to_owned);
    let row = |line: &str| line.split(',').map(|x| x.parse().unwrap()).collect();
    (header.collect(), lines.map(row).collect())
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, f64::max)
}

macro_rules! compare {
    ($module:ident, $set:expr, $name:expr) => {{
        let (set, name) = ($set, $name);
        let file = io::read(set.join(format!("meshes/{name}.mesh"))).unwrap();
        let directory = set.join("ref").join(name).join("mass_spring");
        let json = Json::parse(&std::fs::read_to_string(directory.join("params.json")).unwrap());
        let number = |name: &str| json.get(name).unwrap().number();
        let mesh = file.cell_mesh().unwrap();
        let rest = &file.positions;
        let (x, v) = wobble(rest);
        let mut module = $module::new(
            &mesh,
            rest,
            x,
            v,
            number("mass"),
            number("stiffness"),
            number("damping_A"),
            number("floor"),
            number("dt"),
        )
        .unwrap();
        let (header, rows) = table(&directory.join("states.csv"));
        let check = |what: &str, found: &[DVec3], tolerance: f64| {
            let place = |axis| {
                header
                    .iter()
                    .position(|h| *h == format!("{what}{axis}"))
                    .unwrap()
            };
            let places = ["x", "y", "z"].map(place);
            let expected: Vec<DVec3> = rows
                .iter()
                .map(|row| DVec3::from(places.map(|place| row[place])))
                .collect();
            let scale = largest(expected.iter().map(|p| p.abs().max_element()));
            let off = largest(
                rows.iter()
                    .zip(&expected)
                    .map(|(row, p)| (found[row[0] as usize] - *p).abs().max_element()),
            );
            assert!(
                !rows.is_empty() && off <= tolerance * scale,
                "{name} {what}: {off}"
            );
        };
        check("fA_", &module.f_all(), 1e-10);
        for step in 1..=50 {
            let (x, v) = (module.position_all(), module.velocity_all());
            if [1, 10, 50].contains(&step) {
                let tolerance = if step == 1 { 1e-10 } else { 1e-8 };
                check(&format!("A{step}_"), &x, tolerance);
                check(&format!("A{step}_v"), &v, tolerance);
            }
            module.set_x(x).unwrap();
            module.set_v(v).unwrap();
        }
    }};
}

#[test]
fn steps_of_the_reference_set() {
    let Some(set) = support::reference_set() else {
        return;
    };
    compare!(MassSpring, &set, "kuhn_cube3");
    compare!(PlainMassSpring, &set, "kuhn_cube3");
    compare!(MassSpring, &set, "tet_bunny");
}

/// Without floor and damping, energy is lost and won only by the length of the steps, and the forces of springs cancel.
#[test]
fn energy_is_kept() {
    let file = io::read(support::workspace().join("meshes/kuhn_cube3.mesh")).unwrap();
    let mesh = file.cell_mesh().unwrap();
    let drift = |dt: f64| {
        let (x, v) = wobble(&file.positions);
        let mut module =
            MassSpring::new(&mesh, &file.positions, x, v, 0.5, 2000.0, 0.0, -1e9, dt).unwrap();
        let energy = |m: &MassSpring| m.kinetic() + m.potential() + m.elastic();
        let before = energy(&module);
        let mut drift: f64 = 0.0;
        for _ in 0..(0.05 / dt) as usize {
            let weight = DVec3::new(0.0, -9.8 * 0.5 * 64.0, 0.0);
            let total: DVec3 = module.f_all().into_iter().sum();
            assert!((total - weight).length() < 1e-9, "{total}");
            let (x, v) = (module.position_all(), module.velocity_all());
            module.set_x(x).unwrap();
            module.set_v(v).unwrap();
            drift = drift.max((energy(&module) - before).abs() / before.abs());
        }
        drift
    };
    let [coarse, fine] = [4e-4, 1e-4].map(drift);
    assert!(
        fine < 0.02 && coarse > 2.0 * fine && coarse < 8.0 * fine,
        "{coarse} {fine}"
    );
}

/// One tetrahedron at rest falls as a stone, and its lowest vertex is thrown back by the floor.
#[test]
fn a_tetrahedron_falls() {
    let mesh = CellMesh::from_tetrahedra(4, &[[0, 1, 2, 3]]).unwrap();
    let rest = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].map(|p| p + DVec3::Y);
    let (v, dt) = ([DVec3::NEG_Y; 4], 0.01);
    let module = MassSpring::new(&mesh, rest, rest, v, 2.0, 50.0, 0.0, 0.0, dt).unwrap();
    let fallen = DVec3::new(0.0, -1.0 - 9.8 * dt, 0.0);
    for i in mesh.vertices() {
        assert!((module.velocity(i) - fallen).length() < 1e-12);
        assert!((module.position(i) - rest[i.index()] - dt * fallen).length() < 1e-12);
    }
    let module = MassSpring::new(&mesh, rest, rest, v, 2.0, 50.0, 0.0, 1.5, dt).unwrap();
    let low = Vertex::new(0);
    assert!((module.velocity(low) + fallen).length() < 1e-12);
    assert!((module.position(low) - DVec3::new(0.0, 1.5, 0.0) + dt * fallen).length() < 1e-12);
    assert!((module.velocity(Vertex::new(2)) - fallen).length() < 1e-12);
    assert_eq!((module.elastic(), module.kinetic()), (0.0, 4.0));
    assert!((module.potential() - 9.8 * 2.0 * 5.0).abs() < 1e-12);
}
