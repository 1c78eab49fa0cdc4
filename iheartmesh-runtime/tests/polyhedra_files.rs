//! Files with prisms, pyramids and polyhedra: what other programs write is understood, what is written is read again, and what is
//! malformed is an error with its place.
#![cfg(feature = "io")]

#[path = "../../tests/support/random.rs"]
#[allow(dead_code)]
mod random;
#[path = "../../tests/support/solids.rs"]
#[allow(dead_code)]
mod solids;

use std::path::Path;

use iheartmesh_runtime::glam::DVec3;
use iheartmesh_runtime::io::{self, Attributes, MeshFile, Polyhedra};
use iheartmesh_runtime::{CellMesh, ElementKind, Vertex};
use random::Random;

fn read(name: &str, contents: impl AsRef<[u8]>) -> MeshFile {
    io::from_bytes(name, contents.as_ref()).unwrap_or_else(|error| panic!("{error}"))
}

fn fixture(name: &str) -> MeshFile {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../meshes/cells");
    io::read(folder.join(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// The volume of each cell by the divergence theorem: of the pyramids from the origin to its faces, outwards.
fn volumes(file: &MeshFile) -> Vec<f64> {
    let mesh = file.cell_mesh().unwrap_or_else(|error| panic!("{error}"));
    let x = |v: Vertex| file.positions[v.index()];
    let cells = mesh.cells().map(|cell| {
        let (faces, signs) = mesh.cell_boundary(cell);
        let faces = faces.iter().zip(signs).map(|(face, &sign)| {
            let corners: Vec<DVec3> = mesh.face_vertices(face).iter().map(x).collect();
            let fan = corners[1..].windows(2);
            let fan = fan.map(|pair| corners[0].dot(pair[0].cross(pair[1])) / 6.0);
            f64::from(sign) * fan.sum::<f64>()
        });
        faces.sum()
    });
    cells.collect()
}

fn assert_close(found: &[f64], expected: &[f64], name: &str) {
    assert_eq!(found.len(), expected.len(), "{name}");
    for (found, expected) in found.iter().zip(expected) {
        assert!(
            (found - expected).abs() < 1e-12,
            "{name}: {found} is not {expected}"
        );
    }
}

/// A pyramid on a cube with a prism and a tetrahedron beside them, and below a cube whose corner is cut off.
const PYRAMID: [u32; 5] = [4, 5, 6, 7, 8];
const PRISM: [u32; 6] = [1, 5, 9, 2, 6, 10];
const CUT: [&[u32]; 7] = [
    &[0, 1, 2, 3],
    &[12, 14, 16, 17, 13],
    &[12, 13, 1, 0],
    &[0, 3, 14, 12],
    &[1, 13, 17, 15, 2],
    &[3, 2, 15, 16, 14],
    &[15, 17, 16],
];

fn assert_cells(file: &MeshFile) {
    assert_eq!(file.tetrahedra, [[4, 5, 8, 11]]);
    assert_eq!(file.hexahedra, [[0, 1, 2, 3, 4, 5, 6, 7]]);
    assert_eq!(file.polyhedra.pyramid(0), Some(PYRAMID));
    assert_eq!(file.polyhedra.prism(file.polyhedra.len() - 1), Some(PRISM));
}

#[test]
fn files_of_vtk() {
    let mut expected = Polyhedra::new();
    expected.push_pyramid(PYRAMID);
    expected.push(CUT);
    expected.push_prism(PRISM);
    for name in ["42_text", "42_binary", "51_text", "51_binary"] {
        let file = fixture(&format!("cells_{name}.vtk"));
        assert_cells(&file);
        assert_eq!(file.polyhedra, expected, "{name}");
        assert_eq!(file.polygons, [[0, 3, 2, 1]].iter().collect(), "{name}");
        assert_eq!(file.edges, [[0, 8]], "{name}");
        // cell k of the file has the value 10 k
        let values = |kind| file.attributes.scalar(kind, "id").unwrap().to_vec();
        assert_eq!(
            values(ElementKind::Cell),
            [50.0, 10.0, 0.0, 30.0, 40.0],
            "{name}"
        );
        assert_eq!(values(ElementKind::Face), [20.0], "{name}");
        assert_eq!(values(ElementKind::Edge), [60.0], "{name}");
        let heights: Vec<f64> = file.positions.iter().map(|x| x.z).collect();
        let attribute = file.attributes.scalar(ElementKind::Vertex, "height");
        assert_eq!(attribute, Some(&heights[..]), "{name}");

        let mesh = file.cell_mesh().unwrap();
        let sizes = (
            mesh.n_vertices(),
            mesh.n_edges(),
            mesh.n_faces(),
            mesh.n_cells(),
        );
        assert_eq!(sizes, (18, 35, 27 - 4, 5), "{name}");
        assert!(mesh.is_consistently_oriented(), "{name}");
        let expected = [5.0 / 24.0, 1.0, 1.0 / 3.0, 47.0 / 48.0, 0.5];
        assert_close(&volumes(&file), &expected, name);
    }
}

#[test]
fn files_of_meshio() {
    for name in [
        "cells.mesh",
        "cells_22_binary.msh",
        "cells_41_binary.msh",
        "cells_meshio.vtk",
    ] {
        let file = fixture(name);
        assert_cells(&file);
        let expected = [5.0 / 24.0, 1.0, 1.0 / 3.0, 0.5];
        assert_close(&volumes(&file), &expected, name);
        if name != "cells.mesh" {
            let ids = file.attributes.scalar(ElementKind::Cell, "id");
            assert_eq!(ids, Some(&[30.0, 10.0, 0.0, 20.0][..]), "{name}");
        }
    }
}

/// Each kind on its own, in the order of corners that its format documents.
#[test]
fn cells_of_each_kind_have_positive_volumes() {
    let ring = |n: u32, z: f64| {
        (0..n).map(move |k| {
            let angle = f64::from(k) / f64::from(n) * std::f64::consts::TAU;
            (angle.cos(), angle.sin(), z)
        })
    };
    let area = |n: u32| 0.5 * f64::from(n) * (std::f64::consts::TAU / f64::from(n)).sin();
    let vtk = |points: Vec<(f64, f64, f64)>, kind: u8| {
        let n = points.len();
        let points: String = points
            .iter()
            .map(|(x, y, z)| format!("{x} {y} {z}\n"))
            .collect();
        let corners: String = (0..n).map(|k| format!(" {k}")).collect();
        read(
            "a.vtk",
            format!(
                "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {n} double\n{points}CELLS 1 {}\n\
                 {n}{corners}\nCELL_TYPES 1\n{kind}\n",
                n + 1
            ),
        )
    };
    for (n, kind) in [(3, 13), (4, 12), (5, 15), (6, 16)] {
        let prism = vtk(ring(n, 0.0).chain(ring(n, 2.0)).collect(), kind);
        assert_close(&volumes(&prism), &[2.0 * area(n)], "prism");
        let bytes = io::file_to_bytes("b.vtk", &prism).unwrap();
        assert!(String::from_utf8_lossy(&bytes).contains(&format!("CELL_TYPES 1\n{kind}\n")));
        assert_eq!(read("b.vtk", bytes), prism);
    }
    let pyramid = vtk(ring(4, 0.0).chain([(0.0, 0.0, 1.5)]).collect(), 14);
    assert_close(&volumes(&pyramid), &[1.0], "pyramid");
}

/// VTK has two orders for wedges: files of both are read, those that are inverted among others stay so.
#[test]
fn wedges_of_both_orders() {
    let positions: Vec<DVec3> = (0..2)
        .flat_map(|z| [DVec3::ZERO, DVec3::X, DVec3::Y].map(|x| x + f64::from(z) * DVec3::Z))
        .collect();
    let (today, before) = ([0, 1, 2, 3, 4, 5], [0, 2, 1, 3, 5, 4]);
    let text = |wedges: &[[u32; 6]]| {
        let points: String = positions
            .iter()
            .map(|x| format!("{} {} {}\n", x.x, x.y, x.z))
            .collect();
        let cells: String = wedges
            .iter()
            .map(|w| format!("6 {w:?}\n").replace(['[', ']', ','], ""))
            .collect();
        let n = wedges.len();
        format!(
            "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n{points}CELLS {n} {}\n{cells}\
             CELL_TYPES {n}\n{}",
            7 * n,
            "13\n".repeat(n)
        )
    };
    let signs = |wedges: &[[u32; 6]]| -> Vec<f64> {
        volumes(&read("a.vtk", text(wedges)))
            .iter()
            .map(|x| x.signum())
            .collect()
    };
    assert_eq!(signs(&[today, today, before]), [1.0, 1.0, -1.0]);
    assert_eq!(signs(&[before, today, before]), [1.0, -1.0, 1.0]);
    assert_eq!(signs(&[before, today]), [-1.0, 1.0]);

    // what is inverted is written so that it is read again as it is
    let mut file = MeshFile::of_positions(positions.clone());
    file.polyhedra.push_prism(today);
    file.polyhedra.push_prism(before);
    let bytes = io::file_to_bytes("a.vtk", &file).unwrap();
    assert!(String::from_utf8_lossy(&bytes).ends_with("CELL_TYPES 2\n13\n13\n"));
    assert_eq!(read("a.vtk", bytes), file);
    file.polyhedra.push_prism(before);
    let bytes = io::file_to_bytes("a.vtk", &file).unwrap();
    assert!(String::from_utf8_lossy(&bytes).ends_with("CELL_TYPES 3\n42\n42\n42\n"));
    assert_eq!(read("a.vtk", bytes), file);
}

/// A cell of random faces that a format without polyhedra may not hold, or a prism or pyramid.
fn push_random(polyhedra: &mut Polyhedra, random: &mut Random, n: u32, is_simple: bool) {
    let v = random.distinct(n, 8);
    match random.below(if is_simple { 2 } else { 5 }) {
        0 => polyhedra.push_prism(v[..6].try_into().unwrap()),
        1 => polyhedra.push_pyramid(v[..5].try_into().unwrap()),
        2 => polyhedra.push(solids::prism(&v[..4], &v[4..])),
        3 => polyhedra.push(solids::pyramid(&v[..5], v[5])),
        _ => {
            // faces that do not close
            let n_faces = 4 + random.below(4);
            let faces: Vec<Vec<u32>> = (0..n_faces)
                .map(|_| {
                    let corners = 3 + random.below(4);
                    (0..corners).map(|_| random.below(n)).collect()
                })
                .collect();
            polyhedra.push(faces);
        }
    }
}

fn random_file(seed: u64, is_simple: bool) -> MeshFile {
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let n = 8 + random.below(6);
    let mut number = || f64::from(random.below(1 << 20)) / 7.0 - 7e4;
    let positions: Vec<DVec3> = (0..n)
        .map(|_| DVec3::new(number(), number(), number()))
        .collect();
    let mut file = MeshFile::of_positions(positions);
    for _ in 0..random.below(3) {
        let v = random.distinct(n, 8);
        file.tetrahedra.push(v[..4].try_into().unwrap());
        file.polygons.push(&v[..3 + random.below(2) as usize]);
        file.edges.push([v[0], v[1]]);
    }
    for _ in 0..random.below(3) {
        file.hexahedra
            .push(random.distinct(n, 8).try_into().unwrap());
    }
    for _ in 0..random.below(6) {
        push_random(&mut file.polyhedra, &mut random, n, is_simple);
    }
    let n_cells = file.n_cells();
    let mut number = || f64::from(random.below(1 << 30)) / 3.0;
    let scalars: Vec<f64> = (0..n_cells).map(|_| number()).collect();
    let vectors: Vec<DVec3> = (0..n_cells).map(|_| DVec3::splat(number())).collect();
    if n_cells > 0 {
        file.attributes = Attributes::new()
            .cell_scalar("pressure", scalars)
            .cell_vector("flow", vectors);
    }
    file
}

#[test]
fn random_files_are_read_as_they_were_written() {
    let mut n_polyhedra = 0;
    for seed in 0..500 {
        let file = random_file(seed, false);
        let bytes = io::file_to_bytes("a.vtk", &file).unwrap();
        assert_eq!(read("a.vtk", bytes), file, "{seed}");

        let mut file = random_file(seed, true);
        n_polyhedra += file.polyhedra.len();
        let bytes = io::file_to_bytes("a.msh", &file).unwrap();
        assert_eq!(read("a.msh", bytes), file, "{seed}");
        // one list for each kind: prisms before pyramids
        file.attributes = Attributes::new();
        let mut sorted = MeshFile::of_positions(file.positions.clone());
        sorted.edges = file.edges.clone();
        let faces = file.polygons.iter();
        sorted.polygons = faces
            .clone()
            .filter(|f| f.len() == 3)
            .chain(faces.filter(|f| f.len() == 4))
            .collect();
        sorted.tetrahedra = file.tetrahedra.clone();
        sorted.hexahedra = file.hexahedra.clone();
        let polyhedra = file.polyhedra.iter();
        let (prisms, pyramids): (Vec<_>, Vec<_>) =
            polyhedra.partition(|faces| faces.clone().next().is_some_and(|face| face.len() == 3));
        sorted.polyhedra = prisms.into_iter().chain(pyramids).collect();
        let bytes = io::file_to_bytes("a.mesh", &file).unwrap();
        assert_eq!(read("a.mesh", bytes), sorted, "{seed}");
    }
    assert!(n_polyhedra > 500);
}

/// A prism or pyramid is known in whatever order its faces stand, and nothing else is taken for one.
#[test]
fn prisms_and_pyramids_are_known() {
    let mut random = Random(7);
    for _ in 0..300 {
        let v = random.distinct(20, 8);
        let mut found = Polyhedra::new();
        let mut expected = MeshFile::of_positions(vec![DVec3::ZERO; 20]);
        let mut shuffled = |mut faces: Vec<Vec<u32>>, random: &mut Random| {
            for face in &mut faces {
                let k = random.below(face.len() as u32);
                face.rotate_left(k as usize);
            }
            for k in (1..faces.len()).rev() {
                faces.swap(k, random.below(k as u32 + 1) as usize);
            }
            found.push(faces);
        };
        shuffled(solids::prism(&v[..3], &v[3..6]), &mut random);
        shuffled(solids::pyramid(&v[..4], v[4]), &mut random);
        shuffled(
            solids::inverted(solids::prism(&v[..3], &v[3..6])),
            &mut random,
        );
        shuffled(solids::hexahedron(v[..8].try_into().unwrap()), &mut random);
        shuffled(solids::tetrahedron(v[..4].try_into().unwrap()), &mut random);
        // with a quadrilateral the other way round
        let mut twisted = solids::prism(&v[..3], &v[3..6]);
        for side in twisted.iter_mut().filter(|side| side.len() == 4).take(1) {
            side.reverse();
        }
        shuffled(twisted, &mut random);
        let mut simple = Polyhedra::new();
        simple.push_prism(found.prism(0).unwrap());
        simple.push_pyramid(found.pyramid(1).unwrap());
        simple.push_prism(found.prism(2).unwrap());
        for index in 0..6 {
            assert_eq!(found.prism(index).is_some(), [0, 2].contains(&index));
            assert_eq!(found.pyramid(index).is_some(), index == 1);
        }
        // and they are the same cells
        let mesh = |all: &Polyhedra| {
            let cells = all.iter().take(3).map(|faces| faces.collect::<Vec<_>>());
            CellMesh::from_polyhedra(20, cells).unwrap()
        };
        assert_eq!(mesh(&found).boundary(3), mesh(&simple).boundary(3));
        expected.polyhedra = found;
        let error = io::file_to_bytes("a.msh", &expected)
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("cannot hold polyhedron 3, which is a hexahedron"),
            "{error}"
        );
    }
}

/// Cell k of a mesh is cell k of the file that it is written to, and of the mesh that is read from there.
#[test]
fn meshes_of_cells_are_written() {
    let solids = (0..300).map(solids::random_polyhedra);
    for solid in solids.chain(solids::by_property()) {
        let mesh = CellMesh::from_polyhedra(solid.n as usize, &solid.cells).unwrap();
        let positions: Vec<DVec3> = (0..solid.n)
            .map(|k| DVec3::new(f64::from(k), f64::from(k * k), f64::from(k % 3)))
            .collect();
        let file = MeshFile::of_cells(positions, &mesh);
        assert_eq!(file.n_cells(), mesh.n_cells(), "{}", solid.name);
        let bytes = io::file_to_bytes("a.vtk", &file).unwrap();
        let again = read("a.vtk", bytes);
        assert_eq!(again, file, "{}", solid.name);
        let again = again.cell_mesh().unwrap();
        for k in 1..=3 {
            assert_eq!(again.boundary(k), mesh.boundary(k), "{} {k}", solid.name);
        }
    }
    // in the order that they were given in
    let hexahedra = [[7, 6, 5, 4, 3, 2, 1, 0], [8, 9, 10, 11, 0, 1, 2, 3]];
    let mesh = CellMesh::from_hexahedra(12, &hexahedra).unwrap();
    let file = MeshFile::of_cells(vec![DVec3::ZERO; 12], &mesh);
    assert_eq!((&file.hexahedra[..], file.n_cells()), (&hexahedra[..], 2));
    let tetrahedra = [[3, 1, 2, 0], [4, 1, 2, 3]];
    let mesh = CellMesh::from_tetrahedra(5, &tetrahedra).unwrap();
    assert_eq!(
        MeshFile::of_cells(vec![DVec3::ZERO; 5], &mesh).tetrahedra,
        tetrahedra
    );
    // prisms and pyramids go into the formats that hold no others
    let mesh = CellMesh::from_polyhedra(
        9,
        [
            solids::prism(&[0, 1, 2], &[3, 4, 5]),
            solids::pyramid(&[0, 1, 4, 3], 8),
        ],
    );
    let file = MeshFile::of_cells(vec![DVec3::ZERO; 9], &mesh.unwrap());
    for name in ["a.msh", "a.mesh"] {
        let again = read(name, io::file_to_bytes(name, &file).unwrap());
        assert_eq!(again.polyhedra, file.polyhedra, "{name}");
    }
}

#[test]
fn equal_positions_of_polyhedra_are_merged() {
    let mut file =
        MeshFile::of_positions([0, 0, 1, 2, 3, 3, 4, 5].map(|k| DVec3::splat(f64::from(k))));
    file.polyhedra.push_prism([1, 2, 3, 5, 6, 7]);
    file.merge_equal_positions();
    assert_eq!(file.positions.len(), 6);
    assert_eq!(file.polyhedra.prism(0), Some([0, 1, 2, 3, 4, 5]));
}

#[test]
fn what_a_format_cannot_hold_is_not_written() {
    let message =
        |path: &str, file: &MeshFile| io::file_to_bytes(path, file).unwrap_err().to_string();
    let mut file = MeshFile::of_positions(vec![DVec3::ZERO; 18]);
    file.polyhedra.push_prism(PRISM);
    for path in ["a.ply", "a.obj", "a.off", "a.stl"] {
        let expected = format!(
            "{path}: this format holds neither edges nor cells; write a .mesh, .msh or .vtk file"
        );
        assert_eq!(message(path, &file), expected);
    }
    #[cfg(feature = "gltf")]
    assert_eq!(
        message("a.glb", &file),
        "a.glb: a glTF file cannot hold cells; write a .mesh, .msh or .vtk file"
    );
    file.polyhedra.push(CUT);
    assert_eq!(
        message("a.msh", &file),
        "a.msh: a Gmsh file cannot hold polyhedron 1, which is neither a prism over a triangle nor a pyramid over a \
         quadrilateral; write a .vtk file"
    );
    assert_eq!(
        message("a.mesh", &file),
        "a.mesh: a MEDIT file cannot hold polyhedron 1, which is neither a prism over a triangle nor a pyramid over a \
         quadrilateral; write a .vtk file"
    );
    // kinds with lists of their own, in meshes where they come too late
    let hexahedron = solids::hexahedron([0, 1, 2, 3, 4, 5, 6, 7]);
    let tetrahedron = solids::tetrahedron([1, 2, 6, 8]);
    let pyramid = solids::pyramid(&[4, 5, 6, 7], 8);
    for (cells, index, kind) in [
        ([&hexahedron, &tetrahedron], 0, "tetrahedron"),
        ([&pyramid, &hexahedron], 1, "hexahedron"),
    ] {
        let mesh = CellMesh::from_polyhedra(9, cells).unwrap();
        let late = MeshFile::of_cells(vec![DVec3::ZERO; 9], &mesh);
        assert_eq!(
            message("a.msh", &late),
            format!(
                "a.msh: a Gmsh file cannot hold polyhedron {index}, which is a {kind} but not in the list of these; make the \
                 mesh with tetrahedra first, then hexahedra, then all others, or write a .vtk file"
            )
        );
        let bytes = io::file_to_bytes("a.vtk", &late).unwrap();
        assert_eq!(io::from_bytes("a.vtk", &bytes).unwrap(), late);
    }
    file.tetrahedra.push([0, 1, 2, 3]);
    file.polyhedra.push_pyramid([0, 1, 2, 3, 18]);
    assert_eq!(
        message("a.vtk", &file),
        "a.vtk: cell 3 names vertex 18, but there are 18 positions; vertices are numbered from 0"
    );
    for (faces, problem) in [
        (
            vec![vec![0, 1, 2], vec![2, 1, 0]],
            "polyhedron 0 has 2 faces",
        ),
        (
            vec![vec![0, 1, 2], vec![0, 1], vec![2, 1, 0], vec![1, 2, 3]],
            "polyhedron 0 has a face 1 with 2 corners",
        ),
    ] {
        let mut file = MeshFile::of_positions(vec![DVec3::ZERO; 4]);
        file.polyhedra.push(faces);
        let expected = format!(
            "a.vtk: {problem}; a polyhedron has at least four faces, and a face at least three corners"
        );
        assert_eq!(message("a.vtk", &file), expected);
    }
}
