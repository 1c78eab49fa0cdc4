//! Valid files of every format, cut off and changed at random: whatever comes of it, no panic, and what is read can be
//! trusted, made a mesh of, and written again.
#![cfg(feature = "io")]

use iheartmesh_runtime::glam::DVec3;
use iheartmesh_runtime::io::{self, Attributes, IoError, MeshFile, Place};

/// A small generator of random numbers, the same each time.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % n.max(1) as u64) as usize
    }

    fn choose<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.below(all.len())]
    }
}

/// A surface with values of all kinds.
fn surface() -> MeshFile {
    let positions = [
        [0.0, 0.0, 0.5],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [1.5, -2.25, 0.125],
    ];
    let mut file = MeshFile::of_positions(positions.map(DVec3::from));
    file.polygons.push(&[0, 1, 2]);
    file.polygons.push(&[3, 2, 1]);
    file
}

fn volume() -> MeshFile {
    let corner = |k: u32| DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2));
    let mut file = MeshFile::of_positions((0..8).map(corner).collect::<Vec<_>>());
    file.edges.push([0, 7]);
    file.polygons.push(&[0, 1, 3]);
    file.polygons.push(&[0, 1, 3, 2]);
    file.tetrahedra.push([0, 1, 2, 4]);
    file.hexahedra.push([0, 1, 3, 2, 4, 5, 7, 6]);
    file.polyhedra.push_prism([0, 1, 2, 4, 5, 6]);
    file.polyhedra.push_pyramid([0, 1, 3, 2, 4]);
    file
}

/// The same, with an octahedron too.
fn polyhedra() -> MeshFile {
    let mut file = volume();
    file.polyhedra.push([
        [0, 1, 2],
        [1, 3, 2],
        [3, 4, 2],
        [4, 0, 2],
        [1, 0, 5],
        [3, 1, 5],
        [4, 3, 5],
        [0, 4, 5],
    ]);
    file
}

fn with(mut file: MeshFile, attributes: Attributes) -> MeshFile {
    file.attributes = attributes;
    file
}

/// Files of each format, as they are written here and by others.
fn samples() -> Vec<(&'static str, Vec<u8>)> {
    let none = Attributes::new();
    let colors = none.clone().vertex_colors([[1, 2, 3]; 4]);
    let values = colors
        .clone()
        .vertex_scalar("K", [1.0, 2.0, 3.0, 4.0])
        .vertex_vector("normal", [DVec3::Z; 4]);
    let faces = values.clone().face_vector("flow", [DVec3::X; 2]);
    let cells = none
        .clone()
        .vertex_scalar("K", [0.25; 8])
        .edge_scalar("length", [1.0])
        .cell_scalar("volume", [1.0, 6.0, 2.0, 3.0]);
    let mut polygons = surface();
    polygons.polygons.push(&[0, 1, 3, 2]);
    let mut samples = vec![
        ("a.obj", with(polygons.clone(), colors.clone())),
        ("a.off", with(polygons.clone(), colors)),
        ("a.ply", with(surface(), faces.clone())),
        ("a.mesh", volume()),
        ("a.msh", with(volume(), cells.clone())),
        ("a.vtk", with(volume(), cells)),
        ("a.vtk", polyhedra()),
        ("a.vtk", with(surface(), faces)),
        ("a.stl", surface()),
    ];
    if cfg!(feature = "gltf") {
        samples.push(("a.gltf", with(surface(), values.clone())));
        samples.push(("a.glb", with(surface(), values)));
    }
    let written = |(name, file): (&'static str, MeshFile)| {
        (
            name,
            io::file_to_bytes(name, &file).unwrap_or_else(|error| panic!("{error}")),
        )
    };
    let mut samples: Vec<_> = samples.into_iter().map(written).collect();
    let mut text = |name, text: &str| samples.push((name, text.as_bytes().to_vec()));
    text(
        "a.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1/2/3 -2//1 \\\n -3/4\nf 1 2 3\n",
    );
    text(
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
         element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
    );
    text(
        "a.stl",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n",
    );
    text("a.msh", include_str!("../../meshes/two_tets_fig3_v41.msh"));
    text(
        "a.vtk",
        include_str!("../../meshes/cells/cells_51_text.vtk"),
    );
    text(
        "a.vtk",
        "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n\
         METADATA\nINFORMATION 0\n\nLINES 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n\
         TRIANGLE_STRIPS 1 5\n4 0 1 2 3\nCELL_DATA 2\nFIELD FieldData 1\nkind 1 2 int\n7 8\n\
         POINT_DATA 4\nSCALARS s double 2\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8\n",
    );
    // binary
    samples.push((
        "a.vtk",
        include_bytes!("../../meshes/cells/cells_42_binary.vtk").to_vec(),
    ));
    samples.push((
        "a.msh",
        include_bytes!("../../meshes/cells/cells_22_binary.msh").to_vec(),
    ));
    let ints = |all: &[i32]| -> Vec<u8> { all.iter().flat_map(|x| x.to_be_bytes()).collect() };
    let doubles: Vec<u8> = [0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.5_f64]
        .iter()
        .flat_map(|x| x.to_be_bytes())
        .collect();
    samples.push((
        "a.vtk",
        [
            b"# vtk DataFile Version 3.0\nvtk output\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n",
            &doubles[..],
            b"\nCELLS 2 7\n",
            &ints(&[3, 0, 1, 2, 2, 0, 1]),
            b"\nCELL_TYPES 2\n",
            &ints(&[5, 3]),
            b"\nCELL_DATA 2\nSCALARS s int 1\nLOOKUP_TABLE default\n",
            &ints(&[5, 3]),
            b"\n",
        ]
        .concat(),
    ));
    let little = |all: &[u8]| -> Vec<u8> {
        all.chunks(4)
            .flat_map(|part| part.iter().rev().copied())
            .collect()
    };
    let node = |tag: i32| [little(&ints(&[tag])), vec![0; 24]].concat();
    samples.push((
        "a.msh",
        [
            &b"$MeshFormat\n2.2 1 8\n"[..],
            &little(&ints(&[1])),
            b"\n$EndMeshFormat\n$Nodes\n3\n",
            &[node(1), node(2), node(3)].concat(),
            b"\n$EndNodes\n$Elements\n2\n",
            &little(&ints(&[2, 2, 1, 1, 0, 1, 2, 3, 2, 0, 3, 2, 1])),
            b"\n$EndElements\n",
        ]
        .concat(),
    ));
    samples
}

fn damage(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut damaged = bytes.to_vec();
    for _ in 0..1 + random.below(4) {
        if damaged.is_empty() {
            break;
        }
        let place = random.below(damaged.len());
        match random.below(8) {
            0 => damaged[place] ^= 1 << random.below(8),
            1 => damaged[place] = *random.choose(b"0123456789-+.e/# \n\\\xff{}[]\","),
            2 => drop(damaged.remove(place)),
            3 => damaged.insert(place, *random.choose(b"9-. \n\0{")),
            4 => {
                let end = (place + 4).min(damaged.len());
                damaged[place..end].fill(*random.choose(&[0, 0x7f, 0x80, 0xff]));
            }
            5 => damaged.truncate(place),
            6 => {
                // some bytes once more
                let end = (place + random.below(40)).min(damaged.len());
                let part = damaged[place..end].to_vec();
                damaged.splice(place..place, part);
            }
            _ => {
                // a word becomes another
                let is_blank = |byte: &u8| byte.is_ascii_whitespace() || b",:[]".contains(byte);
                let end = damaged[place..].iter().position(is_blank);
                let start = damaged[..place].iter().rposition(is_blank);
                let (start, end) = (
                    start.map_or(0, |k| k + 1),
                    end.map_or(damaged.len(), |k| place + k),
                );
                let words: [&[u8]; 11] = [
                    b"-1",
                    b"0",
                    b"nan",
                    b"-inf",
                    b"1e999",
                    b"4294967295",
                    b"4294967296",
                    b"9223372036854775807",
                    b"-9223372036854775808",
                    b"99999999999999999999",
                    "θ".as_bytes(),
                ];
                damaged.splice(start..end, random.choose(&words).iter().copied());
            }
        }
    }
    damaged
}

/// What is read can be trusted; what is not is an error whose place is in the file.
fn check(name: &str, bytes: &[u8]) {
    let file = match io::from_bytes(name, bytes) {
        Ok(file) => file,
        Err(IoError::Malformed { place, .. }) => {
            match place {
                Place::Byte(byte) => assert!(byte <= bytes.len(), "{name}: byte {byte}"),
                Place::Line(line) => {
                    // or after the last line, where something is missing
                    let n_lines = 1 + bytes.iter().filter(|&&byte| byte == b'\n').count();
                    assert!(
                        (1..=n_lines + 1).contains(&line),
                        "{name}: line {line} of {n_lines}"
                    );
                }
                Place::Entry(..) => {}
            }
            return;
        }
        Err(error) => panic!("{name}: {error}"),
    };
    let n = file.positions.len();
    assert!(
        file.positions.iter().all(|position| position.is_finite()),
        "{name}"
    );
    let corners = file.polygons.corners().iter();
    let corners = corners.chain(file.edges.iter().flatten());
    let mut corners = corners
        .chain(file.tetrahedra.iter().flatten())
        .chain(file.hexahedra.iter().flatten())
        .chain(file.polyhedra.faces().corners());
    assert!(corners.all(|&corner| (corner as usize) < n), "{name}");
    let _ = (file.face_mesh(), file.edge_mesh());
    if let Ok(mesh) = file.cell_mesh() {
        let again = MeshFile::of_cells(file.positions.clone(), &mesh).cell_mesh();
        let again = again.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(again.boundary(3), mesh.boundary(3), "{name}");
    }
    let mut merged = file.clone();
    merged.merge_equal_positions();
    // also checks that there are as many values as elements
    match io::file_to_bytes("again.vtk", &file) {
        Ok(written) => {
            let again =
                io::from_bytes("again.vtk", &written).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(again.positions, file.positions);
            assert_eq!(
                (again.tetrahedra, again.hexahedra, again.polyhedra),
                (file.tetrahedra, file.hexahedra, file.polyhedra)
            );
        }
        Err(error) => {
            let error = error.to_string();
            assert!(error.contains("cannot be the name"), "{error}");
        }
    }
}

#[test]
fn damaged_files_are_read_or_refused() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for (name, bytes) in samples() {
        io::from_bytes(name, &bytes).unwrap_or_else(|error| panic!("{error}"));
        check(name, &bytes);
        (0..bytes.len()).for_each(|end| check(name, &bytes[..end]));
        for _ in 0..3000 {
            check(name, &damage(&bytes, &mut random));
        }
        // as a file of another kind
        for (other, _) in samples() {
            check(other, &bytes);
        }
    }
}
