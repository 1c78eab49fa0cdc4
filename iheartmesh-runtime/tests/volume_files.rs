//! Files of tetrahedra and hexahedra: what is written is read again, what is malformed is an error with its line, and the
//! meshes of the reference set are what other libraries say of them.
#![cfg(feature = "io")]

#[path = "../../tests/support/reference_set.rs"]
mod locate;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use iheartmesh_runtime::glam::DVec3;
use iheartmesh_runtime::io::{self, Attributes, MeshFile};
use iheartmesh_runtime::{BoundaryMatrix, CellMesh, Vertex};

/// One element of each kind.
fn example() -> MeshFile {
    let mut file = MeshFile::of_positions(
        (0..9)
            .map(|k| DVec3::new(f64::from(k) / 3.0, -1e-7, 1e300))
            .collect::<Vec<_>>(),
    );
    file.edges.push([3, 1]);
    file.polygons.push(&[0, 1, 2]);
    file.polygons.push(&[5, 1, 2, 8]);
    file.tetrahedra.push([0, 3, 2, 1]);
    file.hexahedra.push([0, 1, 2, 3, 4, 5, 6, 7]);
    file.polyhedra.push_prism([0, 1, 2, 3, 4, 8]);
    file.polyhedra.push_pyramid([0, 1, 2, 3, 4]);
    file
}

#[test]
fn medit_files_are_read_as_they_were_written() {
    let file = example();
    let bytes = io::file_to_bytes("a.mesh", &file).unwrap();
    assert_eq!(io::from_bytes("a.mesh", &bytes).unwrap(), file);
    // without line breaks, with comments and lists that are skipped
    let text = "MeshVersionFormatted 1 # old\nDimension\n3 Vertices 4 0 0 0 7 1 0 0 7 0 1 0 7\n# between\n0 0 1 7 \
                Corners 2 1 2 Ridges 0 Normals 1 0 0 1 Tetrahedra 1 1 2 3 4 9";
    let file = io::from_bytes("b.MESH", text.as_bytes()).unwrap();
    assert_eq!(file.positions, [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]);
    assert_eq!(file.tetrahedra, [[0, 1, 2, 3]]);
    assert_eq!(file.cell_mesh().unwrap().n_faces(), 4);
}

#[test]
fn cells_of_two_kinds_are_one_mesh() {
    let mut file = MeshFile::of_positions(vec![DVec3::ZERO; 9]);
    file.hexahedra.push([0, 1, 2, 3, 4, 5, 6, 7]);
    assert_eq!(file.cell_mesh().unwrap().n_faces(), 6);
    file.tetrahedra.push([4, 5, 6, 8]);
    let mesh = file.cell_mesh().unwrap();
    assert_eq!(
        (mesh.n_cells(), mesh.n_faces(), mesh.n_edges()),
        (2, 10, 16)
    );
    file.tetrahedra.push([0, 0, 1, 2]);
    assert!(
        file.cell_mesh()
            .unwrap_err()
            .to_string()
            .starts_with("cell 1 is degenerate")
    );
    assert_eq!(example().edge_mesh().unwrap().n_edges(), 1);
}

#[test]
fn malformed_medit_files() {
    let head = "MeshVersionFormatted 2\nDimension 3\nVertices\n2\n0 0 0 0\n1 0 0 0\n";
    for (text, message) in [
        (
            "",
            "1: the file ends before `MeshVersionFormatted`; it may be truncated",
        ),
        (
            "OFF\n",
            "1: the first word is `OFF`, not `MeshVersionFormatted`; this is no text file of MEDIT",
        ),
        (
            "MeshVersionFormatted 2\nDimension 2",
            "2: the dimension is 2; positions have three coordinates",
        ),
        (
            "MeshVersionFormatted 2\nVertices 4294967296\n0 0 0 0",
            "2: the number of vertices is 4294967296, more than the file can hold; it may be truncated",
        ),
        (
            "MeshVersionFormatted 2\nVertices -1\n",
            "2: the number of vertices is -1; it cannot be negative",
        ),
        (
            "MeshVersionFormatted 2\nVertices 1\n0 nan 0 0",
            "3: the position is not finite; positions are real numbers",
        ),
        (
            "MeshVersionFormatted 2\nVertices 1\n0 x\u{7} 0 0",
            "3: a coordinate `x` is no number; write it as 1.5e-3",
        ),
        (
            "MeshVersionFormatted 2\nVertices 1\n0 0 0",
            "3: the file ends before a reference; it may be truncated",
        ),
        (
            "{head}Vertices 0",
            "7: there are two lists of vertices; keep one",
        ),
        (
            "{head}Tetrahedra 1\n1 2 3 1 0",
            "8: an entry of Tetrahedra names vertex 3, but the file has 2 vertices; vertices are numbered from 1",
        ),
        (
            "{head}Edges 1\n0 1 0",
            "8: an entry of Edges names vertex 0, but the file has 2 vertices; vertices are numbered from 1",
        ),
        (
            "{head}Triangles 1\n-1 1 0 0",
            "8: an entry of Triangles names vertex -1, but the file has 2 vertices; vertices are numbered from 1",
        ),
        (
            "{head}Hexahedra 1\n1.5 1 0 0 1 1 1 1 1 1",
            "8: a vertex `1.5` is no whole number; write it as 17",
        ),
        (
            "{head}Hexahedra 99999999999999999999\n",
            "7: the number of Hexahedra `99999999999999999999` is no whole number; write it as 17",
        ),
        (
            "{head}Corners 9223372036854775807\n",
            "7: the number of Corners is 9223372036854775807, more than the file can hold; it may be truncated",
        ),
        (
            "{head}Polygons 1\n1 2 1 0",
            "7: there is no list `Polygons`; remove it, or check the number of entries before",
        ),
        (
            "{head}Prisms 1\n1 1 1 1 1 0 1",
            "8: an entry of Prisms names vertex 0, but the file has 2 vertices; vertices are numbered from 1",
        ),
        (
            "{head}Pyramids 1\n1 1 1 1 1",
            "8: the file ends before a reference; it may be truncated",
        ),
        (
            "{head}Pyramids 1000000\n1 1 1 1 1",
            "7: the number of Pyramids is 1000000, more than the file can hold; it may be truncated",
        ),
        (
            "{head}TetrahedraP2 1\n",
            "7: `TetrahedraP2` are not of first order; make the mesh of first order, with vertices at the corners of elements only, and save it again",
        ),
    ] {
        let text = text.replace("{head}", head);
        let error = io::from_bytes("a.mesh", text.as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), format!("a.mesh:{message}"));
    }
    // any prefix of a file, and any word replaced: an error or a file, but no panic
    let bytes = io::file_to_bytes("a.mesh", &example()).unwrap();
    for end in 0..bytes.len() {
        let _ = io::from_bytes("a.mesh", &bytes[..end]);
    }
    let text = String::from_utf8(bytes).unwrap();
    let words: Vec<&str> = text.split_whitespace().collect();
    for place in 0..words.len() {
        for word in [
            "-1",
            "4294967297",
            "nan",
            "End",
            "Vertices",
            "1e999",
            "\u{fffd}",
        ] {
            let mut words = words.clone();
            words[place] = word;
            let _ = io::from_bytes("a.mesh", words.join(" ").as_bytes());
        }
    }
}

#[test]
fn what_a_format_cannot_hold_is_not_written() {
    let message =
        |path: &str, file: &MeshFile| io::file_to_bytes(path, file).unwrap_err().to_string();
    let mut file = example();
    assert_eq!(
        message("a.ply", &file),
        "a.ply: this format holds neither edges nor cells; write a .mesh, .msh or .vtk file"
    );
    file.attributes = Attributes::new().cell_scalar("volume", [1.0]);
    assert_eq!(
        message("a.vtk", &file),
        "a.vtk: the attribute `volume` has 1 values for 4 cells; give one for each"
    );
    file.attributes = Attributes::new().cell_scalar("", [1.0, 2.0, 3.0, 4.0]);
    assert_eq!(
        message("a.vtk", &file),
        "a.vtk: values in a VTK file have a name, but that of an attribute is empty; give it one"
    );
    file.attributes = Attributes::new()
        .cell_scalar("a", [1.0, 2.0, 3.0, 4.0])
        .vertex_vector("a", vec![DVec3::X; 9])
        .edge_scalar("a", [5.0]);
    io::file_to_bytes("a.vtk", &file).unwrap();
    for (attributes, at) in [
        (
            file.attributes.clone().face_vector("a", [DVec3::X; 2]),
            "other elements",
        ),
        (
            file.attributes.clone().edge_scalar("a", [6.0]),
            "other elements",
        ),
        (
            file.attributes.clone().vertex_scalar("a", [0.0; 9]),
            "vertices",
        ),
    ] {
        file.attributes = attributes;
        assert_eq!(
            message("a.vtk", &file),
            format!(
                "a.vtk: a VTK file cannot hold several attributes `a` of {at}, unless they are of different kinds of element \
                 and alike; rename all but one of them"
            )
        );
    }
    file.attributes = Attributes::new().cell_scalar("my volume", [1.0, 2.0, 3.0, 4.0]);
    assert_eq!(
        message("a.mesh", &file),
        "a.mesh: a MEDIT file cannot hold the cell attribute `my volume`; write a .vtk file"
    );
    file = example();
    file.polygons.push(&[0, 1, 2, 3, 4]);
    assert_eq!(
        message("a.mesh", &file),
        "a.mesh: a MEDIT file cannot hold a face with 5 corners; write a .ply or .vtk file"
    );
    file.tetrahedra.push([0, 1, 2, 9]);
    assert_eq!(
        message("a.vtk", &file),
        "a.vtk: cell 1 names vertex 9, but there are 9 positions; vertices are numbered from 0"
    );
}

#[test]
fn vtk_files() {
    let mut file = MeshFile::of_positions([DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]);
    file.edges.push([0, 1]);
    file.polygons.push(&[0, 1, 2]);
    file.tetrahedra.push([0, 1, 2, 3]);
    file.attributes = Attributes::new()
        .vertex_scalar("heat", [0.5, 1.0, f64::NAN, -2.0])
        .face_vector("normal", [DVec3::Z])
        .cell_scalar("volume", [0.125])
        .edge_scalar("length", [1.0]);
    let expected = "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n1 0 0\n\
        0 1 0\n0 0 1\nCELLS 3 12\n2 0 1\n3 0 1 2\n4 0 1 2 3\nCELL_TYPES 3\n3\n5\n10\nPOINT_DATA 4\n\
        SCALARS heat double 1\nLOOKUP_TABLE default\n0.5\n1\nnan\n-2\nCELL_DATA 3\nNORMALS normal double\nnan nan nan\n\
        0 0 1\nnan nan nan\nSCALARS volume double 1\nLOOKUP_TABLE default\nnan\nnan\n0.125\n\
        SCALARS length double 1\nLOOKUP_TABLE default\n1\nnan\nnan\n";
    let bytes = io::file_to_bytes("a.vtk", &file).unwrap();
    assert_eq!(String::from_utf8(bytes).unwrap(), expected);
    let again = io::from_bytes("a.vtk", expected.as_bytes()).unwrap();
    let bytes = io::file_to_bytes("a.vtk", &again).unwrap();
    assert_eq!(String::from_utf8(bytes).unwrap(), expected);
}

/// Entries of a Matrix Market file, from 0.
fn matrix_market(path: &Path) -> BTreeMap<(usize, usize), i8> {
    let text = fs::read_to_string(path).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('%')).skip(1);
    lines
        .map(|line| {
            let entry: Vec<i64> = line
                .split_whitespace()
                .map(|x| x.parse().unwrap())
                .collect();
            (
                (entry[0] as usize - 1, entry[1] as usize - 1),
                entry[2] as i8,
            )
        })
        .collect()
}

/// The rank over the field of two elements, by reduction of the columns.
fn rank(matrix: &BoundaryMatrix) -> usize {
    let mut reduced: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    for column in matrix.outer_iterator() {
        let mut rows: BTreeSet<u32> = column.iter().map(|(row, _)| row as u32).collect();
        while let Some(lowest) = rows.last().copied() {
            match reduced.get(&lowest) {
                Some(other) => rows = rows.symmetric_difference(other).copied().collect(),
                None => {
                    reduced.insert(lowest, rows);
                    break;
                }
            }
        }
    }
    reduced.len()
}

fn field(json: &str, name: &str) -> i64 {
    let (_, rest) = json.split_once(&format!("\"{name}\":")).unwrap();
    rest.trim_start()
        .split([',', '\n', '}'])
        .next()
        .unwrap()
        .trim()
        .parse()
        .unwrap()
}

fn check_reference(directory: &Path, name: &str) {
    let file = io::read(directory.join(format!("meshes/{name}.mesh"))).unwrap();
    let mesh: CellMesh = file.cell_mesh().unwrap();
    let reference = directory.join("ref").join(name);
    let json = fs::read_to_string(reference.join("topology.json")).unwrap();
    let sizes = [
        mesh.n_vertices(),
        mesh.n_edges(),
        mesh.n_faces(),
        mesh.n_cells(),
    ];
    for (size, what) in sizes.into_iter().zip(["V", "E", "F", "C"]) {
        assert_eq!(size as i64, field(&json, what), "{name} {what}");
    }
    assert_eq!(mesh.euler_characteristic(), field(&json, "chi"), "{name}");
    let components = mesh
        .vertices()
        .filter(|&v| mesh.vertex_edges(v).is_empty())
        .count();
    assert_eq!(
        (mesh.n_components() - components) as i64,
        field(&json, "components"),
        "{name}"
    );
    let (boundary, faces) = mesh.boundary_mesh().unwrap();
    assert_eq!(faces.len() as i64, field(&json, "boundary_faces"), "{name}");
    assert!(
        boundary.is_closed() && mesh.is_consistently_oriented(),
        "{name}"
    );

    let ranks = [
        0,
        rank(mesh.boundary(1)),
        rank(mesh.boundary(2)),
        rank(mesh.boundary(3)),
        0,
    ];
    let betti: Vec<usize> = (0..4).map(|k| sizes[k] - ranks[k] - ranks[k + 1]).collect();
    let (_, rest) = json.split_once("\"Z2\":").unwrap();
    let list = rest.split(['[', ']']).nth(1).unwrap();
    let expected: Vec<usize> = list.split(',').map(|x| x.trim().parse().unwrap()).collect();
    assert_eq!(betti, expected, "{name}");

    if !reference.join("d3.mtx").exists() {
        return;
    }
    let [edges, triangles] = ["edges.csv", "faces.csv"].map(|file| {
        let text = fs::read_to_string(reference.join(file)).unwrap();
        text.lines().skip(1).map(str::to_owned).collect::<Vec<_>>()
    });
    let found = mesh.edges().map(|e| {
        let [i, j] = mesh.edge_vertices(e).map(Vertex::id);
        format!("{i},{j}")
    });
    assert_eq!(found.collect::<Vec<_>>(), edges, "{name}");
    let found = mesh.faces().map(|f| {
        let ids: Vec<String> = mesh
            .face_vertices(f)
            .ids()
            .iter()
            .map(u32::to_string)
            .collect();
        ids.join(",")
    });
    assert_eq!(found.collect::<Vec<_>>(), triangles, "{name}");
    for k in 1..=3 {
        let entries = mesh.boundary(k).iter();
        let entries: BTreeMap<_, _> = entries
            .map(|(&value, (row, column))| ((row as usize, column as usize), value))
            .collect();
        assert_eq!(
            entries,
            matrix_market(&reference.join(format!("d{k}.mtx"))),
            "{name} {k}"
        );
    }
}

#[test]
fn volumes_of_the_reference_set() {
    let Some(directory) = locate::reference_set(&Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
    else {
        return;
    };
    for name in ["kuhn_cube3", "tet_single", "two_tets_fig3", "tet_bunny"] {
        check_reference(&directory, name);
    }
}

#[test]
fn any_name_stands_in_a_vtk_file() {
    let names = [
        "my volume",
        "50%",
        "%20",
        "%+1",
        "a\"b",
        "ä\u{a0}ö",
        "two\nlines",
    ];
    for name in names {
        let mut file = example();
        file.attributes = Attributes::new()
            .vertex_vector(name, vec![DVec3::X; file.positions.len()])
            .cell_scalar(name, [1.0, 2.0, 3.0, 4.0]);
        let bytes = io::file_to_bytes("a.vtk", &file).unwrap();
        let found = io::from_bytes("a.vtk", &bytes).unwrap();
        assert_eq!(found.attributes, file.attributes, "{name}");
    }
    let mut file = example();
    file.attributes = Attributes::new().cell_scalar("50% of it", [1.0, 2.0, 3.0, 4.0]);
    let text = String::from_utf8(io::file_to_bytes("a.vtk", &file).unwrap()).unwrap();
    assert!(
        text.contains("SCALARS 50%25%20of%20it double 1\n"),
        "{text}"
    );
}
