//! The energies of the example of deformed tetrahedra, minimised: against minima that other libraries found.

#[path = "../examples/common/bar.rs"]
mod bar;
#[allow(dead_code)]
mod support;

use std::path::Path;

use bar::{bar, ends, twisted, volumes};
use iheartmesh::glam::DVec3;
use iheartmesh::solve::Newton;
use iheartmesh::{CellMesh, Functions, Vertex, check_gradient, inverse_vec, io, vec};

use support::json::Json;

iheartmesh::iheartmesh! {
    /// What the energies share.
    pub struct Deformation = include "examples/tetrahedral_deformation/deformation.hlang";

    /// The symmetric Dirichlet energy.
    pub struct Dirichlet = include "examples/tetrahedral_deformation/symmetric_dirichlet.hlang";

    /// The exponential symmetric Dirichlet energy.
    pub struct Exponential =
        include "examples/tetrahedral_deformation/exponential_symmetric_dirichlet.hlang";

    /// The AMIPS energy.
    pub struct Amips = include "examples/tetrahedral_deformation/amips.hlang";

    /// The conformal AMIPS energy.
    pub struct Conformal = include "examples/tetrahedral_deformation/conformal_amips.hlang";

    /// One without optimisations, which shows that the others import what they should.
    #[without(all)]
    pub struct PlainConformal = include "examples/tetrahedral_deformation/conformal_amips.hlang";
}

/// A generated module as closures.
macro_rules! functions {
    ($module:ident, $made:expr) => {
        Functions {
            state: $made,
            set: |m: &mut $module<'_>, x: &[f64]| Ok(m.set_x(inverse_vec::<DVec3>(x)?)?),
            energy: |m: &mut $module<'_>| Ok(m.try_e()?),
            gradient: |m: &mut $module<'_>| Ok(m.try_G()?),
            hessian: |m: &mut $module<'_>| Ok(m.try_H()?),
        }
    };
}

/// The first column of a table as vertices, the others as positions.
fn table(file: &Path) -> (Vec<Vertex>, Vec<DVec3>) {
    let text = std::fs::read_to_string(file).unwrap();
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |k: usize| cells[k].parse::<f64>().unwrap();
        (
            Vertex::new(cells[0].parse().unwrap()),
            DVec3::new(number(1), number(2), number(3)),
        )
    };
    text.lines().skip(1).map(row).unzip()
}

#[test]
fn a_twisted_bar_finds_its_shape() {
    let (rest, tetrahedra) = bar(1, 4);
    assert_eq!((rest.len(), tetrahedra.len()), (20, 24));
    assert!(
        volumes(&rest, &tetrahedra)
            .iter()
            .all(|v| (v - 1.0).abs() < 1e-15)
    );
    let mesh = CellMesh::from_tetrahedra(rest.len(), &tetrahedra).unwrap();
    assert!(mesh.is_consistently_oriented());
    let start = twisted(&rest, 0.5, 1.1);
    let held = ends(&rest);
    assert_eq!(held.len(), 8);
    let places: Vec<DVec3> = held.iter().map(|v| start[*v as usize]).collect();
    let held: Vec<Vertex> = held.into_iter().map(Vertex::new).collect();
    let mut least = Vec::new();
    macro_rules! minimize {
        ($($module:ident)*) => {$({
            let made = $module::new(&mesh, &rest, &start, &held, &places, 100.0).unwrap();
            let before = made.e();
            let mut energy = functions!($module, made);
            let report = check_gradient(&mut energy, vec(&start).as_slice()).unwrap();
            assert!(report.is_within(1e-7), "{report}");
            let found = Newton::default()
                .minimize(&mut energy, vec(&start).as_slice())
                .unwrap();
            assert!(found.converged() && found.energy < before && found.gradient < 1e-3);
            let x: Vec<DVec3> = inverse_vec(&found.x).unwrap();
            assert!(volumes(&x, &tetrahedra).iter().all(|v| *v > 0.0));
            least.push((found.energy, x));
        })*};
    }
    minimize! { Dirichlet Exponential Amips Conformal }
    let plain = PlainConformal::new(&mesh, &rest, &least[3].1, &held, &places, 100.0).unwrap();
    assert!((plain.e() - least[3].0).abs() < 1e-10 * least[3].0);
}

#[test]
fn deformations_of_the_reference_set() {
    let Some(set) = support::reference_set() else {
        return;
    };
    let file = io::read(set.join("meshes/kuhn_cube3.mesh")).unwrap();
    let (mesh, rest) = (file.cell_mesh().unwrap(), &file.positions);
    let folder = set.join("ref/kuhn_cube3/energy");
    let (held, places) = table(&folder.join("handles.csv"));
    let deformed = table(&folder.join("x_deformed.csv")).1;
    macro_rules! compare {
        ($($name:literal $module:ident)*) => {$({
            let json = std::fs::read_to_string(folder.join(concat!($name, ".json"))).unwrap();
            let json = Json::parse(&json);
            let number = |json: &Json, name: &str| json.get(name).unwrap().number();
            let problem = json.get("handle_problem").unwrap();
            let w = number(problem, "w");
            let close = |found: f64, expected: f64, tolerance: f64| {
                let error = (found - expected).abs() / expected;
                assert!(error < tolerance, "{}: {found} is not {expected}", $name);
            };
            let mut made = $module::new(&mesh, rest, &deformed, &held, &places, 0.0).unwrap();
            close(made.e(), number(&json, "energy"), 1e-8);
            made.set_w(w).unwrap();
            made.set_x(rest).unwrap();
            close(made.e(), number(problem, "energy_at_rest_positions"), 1e-9);
            let mut energy = functions!($module, made);
            let found = Newton::default()
                .minimize(&mut energy, vec(rest).as_slice())
                .unwrap();
            assert!(found.converged());
            close(found.energy, number(problem.get("final_energy").unwrap(), "TinyAD"), 1e-6);
        })*};
    }
    compare! { "SD" Dirichlet "EXP_SD" Exponential "AMIPS" Amips "CONF_AMIPS" Conformal }
}
