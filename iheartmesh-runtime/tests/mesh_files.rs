//! Mesh files: round trips, the variants of each format, and what other programs write.
#![cfg(feature = "io")]

use glam::DVec3;
use iheartmesh_runtime::ElementKind::{Face, Vertex};
use iheartmesh_runtime::FaceMesh;
use iheartmesh_runtime::io::{self, AttributeValues, Attributes, MeshFile, Polygons};

fn read(name: &str, text: &str) -> MeshFile {
    io::from_bytes(name, text.as_bytes()).unwrap_or_else(|error| panic!("{error}"))
}

fn polygons(list: &[&[u32]]) -> Polygons {
    list.iter().collect()
}

/// Numbers that do not survive any rounding.
fn positions() -> Vec<DVec3> {
    vec![
        DVec3::new(0.1, -1.0 / 3.0, 1e-300),
        DVec3::new(f64::MAX, f64::MIN_POSITIVE, -0.0),
        DVec3::new(std::f64::consts::PI, 5e-324, 1.0),
        DVec3::new(1e22, 123456789.12345679, -7.0),
        DVec3::splat(2.0),
        DVec3::ZERO,
    ]
}

fn faces() -> Polygons {
    polygons(&[&[0, 1, 2, 3], &[4, 2, 1], &[0, 4, 3, 2, 1]])
}

#[test]
fn every_format_gives_back_what_was_written() {
    let vertex_colors = vec![
        [0, 128, 255],
        [1, 2, 3],
        [254, 255, 0],
        [9, 9, 9],
        [0, 0, 0],
        [77, 66, 55],
    ];
    let plain = Attributes::new();
    let colors = plain.clone().vertex_colors(vertex_colors.clone());
    let off = plain
        .clone()
        .vertex_vector("normal", positions())
        .vertex_colors(vertex_colors)
        .face_colors([[1, 2, 3], [4, 5, 6], [7, 8, 9]]);
    let ply = off
        .clone()
        .vertex_scalar("K", [f64::NAN, f64::INFINITY, -0.0, 1.5, 1e-310, 2.0])
        .vertex_vector("gradient", positions())
        .face_scalar("area", [0.5, 1.0, 2.0])
        .face_vector("normal", [DVec3::X, DVec3::Y, DVec3::Z]);
    for (name, attributes) in [
        ("a.obj", &plain),
        ("a.OFF", &plain),
        ("a.ply", &plain),
        ("a.obj", &colors),
        ("a.off", &off),
        ("a.Ply", &ply),
    ] {
        let bytes = io::to_bytes(name, &positions(), &faces(), attributes).unwrap();
        let file = io::from_bytes(name, &bytes).unwrap();
        for (read, written) in file.positions.iter().zip(positions()) {
            assert_eq!(
                read.to_array().map(f64::to_bits),
                written.to_array().map(f64::to_bits),
                "{name}"
            );
        }
        assert_eq!(file.positions.len(), 6);
        assert_eq!(file.polygons, faces());
        assert_eq!(
            file.attributes.iter().count(),
            attributes.iter().count(),
            "{name}"
        );
        for attribute in attributes {
            // NaN is written, but not equal to itself.
            let read = file.attributes.get(attribute.element(), attribute.name());
            assert_eq!(
                format!("{read:?}"),
                format!("{:?}", Some(attribute.values())),
                "{name}"
            );
        }
    }
}

#[test]
fn files_on_disk() {
    let directory = std::env::temp_dir().join(format!("iheartmesh-{}", std::process::id()));
    std::fs::create_dir_all(&directory).unwrap();
    let mesh = FaceMesh::from_polygons(6, &faces()).unwrap();
    for name in ["mesh.obj", "mesh.off", "mesh.ply"] {
        let path = directory.join(name);
        io::write(&path, &positions(), &mesh, &Attributes::new()).unwrap();
        assert_eq!(
            io::read(&path).unwrap().face_mesh().unwrap().boundary(2),
            mesh.boundary(2)
        );
    }
    let error = io::read(directory.join("missing.ply")).unwrap_err();
    assert!(
        matches!(error, io::IoError::File { .. }) && std::error::Error::source(&error).is_some()
    );
    assert!(
        io::write(
            directory.join("no/such/directory.ply"),
            &[],
            &Polygons::new(),
            &Attributes::new()
        )
        .is_err()
    );
    std::fs::remove_dir_all(directory).unwrap();
}

#[test]
fn faces_may_come_as_triangles_and_not_at_all() {
    let triangles = vec![[0, 1, 2], [2, 1, 3]];
    let all = [&positions()[..], &positions()[..0]];
    let bytes = io::to_bytes("a.ply", all[0], &triangles, &Attributes::new()).unwrap();
    let file = io::from_bytes("a.ply", &bytes).unwrap();
    assert_eq!(file.polygons.triangles(), Some(triangles.clone()));
    assert_eq!(
        bytes,
        io::to_bytes("a.ply", all[0], &triangles[..], &Attributes::new()).unwrap()
    );
    for (name, positions) in ["a.obj", "a.off", "a.ply"]
        .into_iter()
        .flat_map(|name| all.map(|list| (name, list)))
    {
        let bytes = io::to_bytes(name, positions, &Polygons::new(), &Attributes::new()).unwrap();
        let file = io::from_bytes(name, &bytes).unwrap();
        assert_eq!(
            (file.positions.len(), file.polygons.len()),
            (positions.len(), 0)
        );
        assert_eq!(file.face_mesh().unwrap().n_vertices(), positions.len());
    }
}

#[test]
fn long_polygons() {
    let ring: Vec<u32> = (0..300).collect();
    let positions: Vec<DVec3> = ring.iter().map(|&i| DVec3::splat(f64::from(i))).collect();
    for name in ["a.obj", "a.off", "a.ply"] {
        let bytes = io::to_bytes(
            name,
            &positions,
            &polygons(&[&ring, &[2, 1, 0]]),
            &Attributes::new(),
        )
        .unwrap();
        assert_eq!(
            io::from_bytes(name, &bytes).unwrap().polygons,
            polygons(&[&ring, &[2, 1, 0]])
        );
    }
}

#[test]
fn obj_as_other_programs_write_it() {
    let file = read(
        "scene.obj",
        "# comment\r\nmtllib scene.mtl\r\no first\r\nv 0 0 0\r\nv 1 0 0 # at the end\r\nv 0 1 0 1.0\r\nvt 0 0\r\nvn 0 0 1\r\n\
         f 1/1/1 2/1/1 3/1/1\r\no second\r\ng left right\r\nusemtl red\r\ns off\r\nv 9 9 9\r\nv 0 0 1\r\n\
         f -5//1 2//-1 \\\r\n 5//1\r\nf 1/1 2/ 6 3\r\nl 1 2\r\np 1\r\n\tv\t5e-1 .5 5.\r\n",
    );
    // Forward references, unreferenced vertices and all objects in one numbering.
    assert_eq!(file.positions.len(), 6);
    assert_eq!(file.positions[5], DVec3::new(0.5, 0.5, 5.0));
    assert_eq!(
        file.polygons,
        polygons(&[&[0, 1, 2], &[0, 1, 4], &[0, 1, 5, 2]])
    );
    assert_eq!(file.face_mesh().unwrap().isolated_vertices().len(), 1);
    assert_eq!(file.attributes, Attributes::new());

    let file = read("colors.obj", "v 0 0 0 1 0 0.5\nv 1 0 0 0 1 0.2");
    assert_eq!(
        file.attributes.colors(Vertex),
        Some(&[[255, 0, 128], [0, 255, 51]][..])
    );
}

#[test]
fn off_variants() {
    let expected = polygons(&[&[0, 1, 2]]);
    let plain = read("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    assert_eq!(plain.polygons, expected);
    for text in [
        "OFF 3 1 3 # counts\n\n# a comment\n0 0 0\n1 0 0\n0 1 0 # two\n3  0 1 2\n",
        "OFF\r\n3 1\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2",
        "STOFF\n3 1 0\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2 7\n",
    ] {
        assert_eq!(read("a.off", text), plain);
    }

    let file = read(
        "a.off",
        "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 1 2 3 4\n3 0 1 2 0.5 0.0 1.0\n",
    );
    assert_eq!(
        file.attributes.colors(Vertex),
        Some(&[[255, 0, 0], [0, 255, 0], [1, 2, 3]][..])
    );
    assert_eq!(file.attributes.colors(Face), Some(&[[128, 0, 255]][..]));
    let file = read(
        "a.off",
        "CNOFF\n3 1 0\n0 0 0 0 0 1 9 8 7\n1 0 0 0 1 0 9 8 7\n0 1 0 1 0 0 9 8 7\n3 0 1 2 3 4 5\n",
    );
    assert_eq!(
        file.attributes.vector(Vertex, "normal"),
        Some(&[DVec3::Z, DVec3::Y, DVec3::X][..])
    );
    assert_eq!(file.attributes.colors(Vertex), Some(&[[9, 8, 7]; 3][..]));
    assert_eq!(file.polygons, expected);
}

const TEXT_PLY: &str = "ply\nformat ascii 1.0\ncomment by hand\nobj_info none\nelement camera 1\nproperty float fov\n\
    property list uchar float pose\nelement face 2\nproperty list uchar int vertex_indices\nproperty int flags\n\
    element vertex 4\nproperty float x\nproperty float y\nproperty double z\nproperty uchar red\nproperty uchar green\n\
    property uchar blue\nproperty uchar alpha\nproperty float nx\nproperty float ny\nproperty float nz\n\
    property float quality\nproperty list uchar int others\nend_header\n\
    60. 2 1 .5\n3 0 1 2 7\n4 0 1 2 3 -8\n\n0 0 0 255 0 0 255 0 0 1 nan 1 3\n1 0 0 0 255 0 255 0 0 1 2 0\n\
    1 1 1e-3 0 0 255 255 0 1 0 3 2 0 1\n  0 1 0 1 2 3 255 1 0 0 4 0";

#[test]
fn ply_in_text_with_everything() {
    for text in [TEXT_PLY.to_owned(), TEXT_PLY.replace('\n', "\r\n")] {
        let file = read("a.ply", &text);
        assert_eq!(file.positions[2], DVec3::new(1.0, 1.0, 1e-3));
        assert_eq!(file.polygons, polygons(&[&[0, 1, 2], &[0, 1, 2, 3]]));
        assert_eq!(
            file.attributes.scalar(Face, "flags"),
            Some(&[7.0, -8.0][..])
        );
        assert_eq!(file.attributes.colors(Vertex).unwrap()[3], [1, 2, 3]);
        assert_eq!(
            file.attributes.vector(Vertex, "normal").unwrap()[2],
            DVec3::Y
        );
        assert_eq!(
            file.attributes.scalar(Vertex, "alpha"),
            Some(&[255.0; 4][..])
        );
        let quality = file.attributes.scalar(Vertex, "quality").unwrap();
        assert!(quality[0].is_nan() && quality[1..] == [2.0, 3.0, 4.0]);
        let names: Vec<&str> = file
            .attributes
            .iter()
            .map(|attribute| attribute.name())
            .collect();
        assert_eq!(names, ["flags", "color", "alpha", "normal", "quality"]);
        assert!(matches!(
            file.attributes.iter().next().unwrap().values(),
            AttributeValues::Scalar(_)
        ));
    }
}

#[test]
fn binary_ply_of_both_byte_orders_and_all_types() {
    let header = "element vertex 3\nproperty float x\nproperty double y\nproperty short z\nproperty int8 a\nproperty uint16 b\n\
        property uint c\nelement face 1\nproperty list uint16 uint8 vertex_index\nproperty list int8 double weights\nend_header\n";
    let file = |order: &str, big: bool| {
        let mut bytes =
            format!("ply\nformat {order} 1.0\ncomment caf\u{e9}\n{header}").into_bytes();
        // The comment in Latin-1: no UTF-8.
        let accent = bytes.iter().position(|&byte| byte == 0xc3).unwrap();
        bytes.remove(accent);
        let mut put = |little: &[u8]| {
            bytes.extend(if big {
                little.iter().rev().copied().collect::<Vec<_>>()
            } else {
                little.to_vec()
            });
        };
        for vertex in 0..3_u8 {
            put(&(f32::from(vertex) + 0.5).to_le_bytes());
            put(&(f64::from(vertex) / 3.0).to_le_bytes());
            put(&(-i16::from(vertex)).to_le_bytes());
            put(&(-5_i8).to_le_bytes());
            put(&60000_u16.to_le_bytes());
            put(&4_000_000_000_u32.to_le_bytes());
        }
        put(&3_u16.to_le_bytes());
        [2, 1, 0_u8].iter().for_each(|corner| put(&[*corner]));
        put(&[1]);
        put(&0.25_f64.to_le_bytes());
        io::from_bytes("a.ply", &bytes).unwrap()
    };
    let little = file("binary_little_endian", false);
    assert_eq!(little, file("binary_big_endian", true));
    assert_eq!(little.positions[2], DVec3::new(2.5, 2.0 / 3.0, -2.0));
    assert_eq!(little.polygons, polygons(&[&[2, 1, 0]]));
    assert_eq!(little.attributes.scalar(Vertex, "a"), Some(&[-5.0; 3][..]));
    assert_eq!(little.attributes.scalar(Vertex, "c"), Some(&[4e9; 3][..]));
}

#[test]
fn written_ply_has_the_header_that_other_programs_know() {
    let attributes = Attributes::new()
        .vertex_scalar("quality", [1.0, 2.0, 3.0])
        .vertex_vector("normal", [DVec3::Z; 3])
        .vertex_vector("flow", [DVec3::X; 3])
        .vertex_colors([[1, 2, 3]; 3])
        .face_scalar("area", [1.0]);
    let bytes = io::to_bytes("a.ply", &positions()[..3], &[[0, 1, 2]][..], &attributes).unwrap();
    let text = String::from_utf8_lossy(&bytes);
    let (header, _) = text.split_once("end_header").unwrap();
    assert_eq!(
        header,
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\n\
         property double z\nproperty double quality\nproperty double nx\nproperty double ny\nproperty double nz\n\
         property double flow_x\nproperty double flow_y\nproperty double flow_z\nproperty uchar red\nproperty uchar green\n\
         property uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nproperty double area\n"
    );
}

#[test]
fn what_does_not_fit_is_not_written() {
    let message = |name: &str, faces: &[[u32; 3]], attributes: Attributes| {
        io::to_bytes(name, &positions()[..3], faces, &attributes)
            .unwrap_err()
            .to_string()
    };
    let none = Attributes::new();
    let face = &[[0, 1, 2]][..];
    assert_eq!(
        message("a.blend", face, none.clone()),
        "a.blend: unknown file format; name it .obj, .off, .ply, .stl, .mesh, .msh, .vtk, .gltf or .glb"
    );
    assert_eq!(
        message("a.ply", &[[0, 1, 3]], none.clone()),
        "a.ply: face 0 names vertex 3, but there are 3 positions; vertices are numbered from 0"
    );
    assert_eq!(
        message("a.ply", face, none.clone().face_scalar("area", [1.0, 2.0])),
        "a.ply: the attribute `area` has 2 values for 1 face; give one for each"
    );
    assert_eq!(
        message("a.obj", face, none.clone().vertex_scalar("K", [1.0; 3])),
        "a.obj: an OBJ file cannot hold the vertex attribute `K`; write a .ply file"
    );
    assert!(
        message(
            "a.off",
            face,
            none.clone().face_vector("normal", [DVec3::X])
        )
        .contains("the face attribute `normal`")
    );
    assert!(
        message("a.ply", face, none.clone().vertex_scalar("θ", [1.0; 3]))
            .contains("`θ` cannot be the name")
    );
    assert!(
        message("a.ply", face, none.clone().vertex_scalar("x", [1.0; 3]))
            .contains("two properties `x`")
    );
    assert!(
        message("a.ply", face, none.clone().vertex_scalar("", [1.0; 3]))
            .contains("`` cannot be the name")
    );
    let nan = [DVec3::new(0.0, f64::NAN, 0.0)];
    let error = io::to_bytes("a.off", &nan, &Polygons::new(), &none).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a.off: the position of vertex 0 is not finite; positions are real numbers"
    );
    let mesh = FaceMesh::from_triangles(4, &[[0, 1, 2]]).unwrap();
    let error = io::to_bytes("a.ply", &positions(), &mesh, &none).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a.ply: 6 positions for 4 vertices; give one for each"
    );
}

#[test]
fn texts_may_start_with_the_mark_of_utf_8() {
    for (name, text) in [
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
    ] {
        assert_eq!(read(name, &format!("\u{feff}{text}")), read(name, text));
    }
}
