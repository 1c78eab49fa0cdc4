//! Files that are wrong: a clear error with the place, and neither a panic nor memory that the file cannot fill.
#![cfg(feature = "io")]

use iheartmesh_runtime::io;

fn check(name: &str, contents: &str, expected: &str) {
    let error = io::from_bytes(name, contents.as_bytes())
        .expect_err(contents)
        .to_string();
    assert_eq!(error, expected, "{contents:?}");
}

#[test]
fn obj() {
    let bad = |contents: &str, expected: &str| check("bad.obj", contents, expected);
    let empty =
        "bad.obj:1: the file is empty; an OBJ file has lines such as `v 0 0 1` and `f 1 2 3`";
    bad("", empty);
    bad(" \r\n\n", empty);
    bad(
        "v 0 0 0\nv 1 zero 0\n",
        "bad.obj:2: coordinate y `zero` is no number; write it as 1.5e-3",
    );
    bad(
        "v 0 0\n",
        "bad.obj:1: coordinate z is missing; the line ends too early",
    );
    bad(
        "v 0 nan 0\n",
        "bad.obj:1: the position is not finite; positions are real numbers",
    );
    bad(
        "v 0 1e999 0\n",
        "bad.obj:1: the position is not finite; positions are real numbers",
    );
    let index = "indices count from 1, or from −1 for the last vertex before the face";
    bad(
        "v 0 0 0\nf 0 1 1\n",
        &format!("bad.obj:2: there is no vertex with the index 0; {index}"),
    );
    bad(
        "v 0 0 0\nf 1 1 -2\n",
        &format!("bad.obj:2: there is no vertex with the index -2; {index}"),
    );
    bad(
        "f 1 99999999999 1\n",
        &format!("bad.obj:1: there is no vertex with the index 99999999999; {index}"),
    );
    bad(
        "f -9223372036854775808 1 1\n",
        &format!("bad.obj:1: there is no vertex with the index -9223372036854775808; {index}"),
    );
    bad(
        "v 0 0 0\n\nf 1 1 2\nf 1 1 4\nf 1 1 3",
        "bad.obj:4: the face names vertex 4, but the file has 1 vertex; indices count from 1; the file may be truncated",
    );
    let form = "write it as 7, 7/1, 7//1 or 7/1/1";
    bad(
        "f a b c\n",
        &format!("bad.obj:1: corner `a` is no index; {form}"),
    );
    bad(
        "f 1/2/3/4 1 1\n",
        &format!("bad.obj:1: corner `1/2/3/4` is no index; {form}"),
    );
    bad(
        "f 1.5 1 1\n",
        &format!("bad.obj:1: corner `1.5` is no index; {form}"),
    );
    let lines = "an OBJ file has lines such as `v 0 0 1` and `f 1 2 3`";
    bad(
        "v 0 0 0\n<html>\n",
        &format!("bad.obj:2: unknown statement `<html>`; {lines}"),
    );
    let long = "x".repeat(1000);
    bad(
        &long,
        &format!("bad.obj:1: unknown statement `{}…`; {lines}", &long[..24]),
    );
}

#[test]
fn off() {
    let bad = |contents: &str, expected: &str| check("bad.off", contents, expected);
    let kinds = "an OFF file begins with the word OFF, COFF, NOFF, CNOFF or one of these after ST";
    bad(
        "",
        "bad.off:1: the file ends before the word OFF; it may be truncated",
    );
    bad(
        "3 1 0\n",
        &format!("bad.off:1: `3` is no OFF file that can be read; {kinds}"),
    );
    bad(
        "4OFF\n",
        &format!("bad.off:1: `4OFF` is no OFF file that can be read; {kinds}"),
    );
    bad(
        "OFF BINARY\n",
        "bad.off:1: the OFF file is not plain text; save it as text",
    );
    bad(
        "OFF\n# nothing\n",
        "bad.off:2: the file ends before the numbers of vertices and faces; it may be truncated",
    );
    bad(
        "OFF\n-1 0 0\n",
        "bad.off:2: the number of vertices is -1; it cannot be negative",
    );
    bad(
        "OFF\n1.5 0 0\n",
        "bad.off:2: number of vertices `1.5` is no whole number; write it as 17",
    );
    bad(
        "OFF\n0 4294967296 0\n",
        "bad.off:2: the number of faces is 4294967296, more than the file can hold; it may be truncated",
    );
    bad(
        "OFF\n3 0 0\n0 0 0\n1 1 1\n",
        "bad.off:4: the file ends before vertex 2 of 3; it may be truncated",
    );
    bad(
        "OFF\n1 0 0\n0 0 inf\n",
        "bad.off:3: the position is not finite; positions are real numbers",
    );
    bad(
        "OFF\n1 2 0\n0 0 0\n3 0 0 0\n",
        "bad.off:4: the file ends before face 1 of 2; it may be truncated",
    );
    let corners = "write the number of corners, then each of them";
    bad(
        "OFF\n1 1 0\n0 0 0\n4 0 0 0\n",
        &format!("bad.off:4: the face is to have 4 corners, but 3 follow; {corners}"),
    );
    bad(
        "OFF\n1 1 0\n0 0 0\n-3 0 0 0\n",
        &format!("bad.off:4: the face is to have -3 corners, but 3 follow; {corners}"),
    );
    for index in ["1", "-1", "4294967296"] {
        bad(
            &format!("OFF\n1 1 0\n0 0 0\n3 0 {index} 0\n"),
            &format!(
                "bad.off:4: the face names vertex {index}, but the file has 1 vertex; vertices are numbered from 0"
            ),
        );
    }
}

/// A PLY file with three vertices (if so declared) and a face.
fn ply(format: &str, n_vertices: &str, rest: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\nelement vertex {n_vertices}\nproperty float x\nproperty float y\nproperty float z\n\
         element face 1\nproperty list uchar int vertex_indices\nend_header\n{rest}"
    )
}

#[test]
fn text_ply() {
    let bad = |n_vertices: &str, rest: &str, expected: &str| {
        check("bad.ply", &ply("ascii", n_vertices, rest), expected)
    };
    let truncated = "the file is truncated or its header wrong";
    bad(
        "4294967296",
        "0 0 0\n",
        &format!(
            "bad.ply:10: the header promises 4294967296 `vertex`, more than the 6 bytes after it can hold; {truncated}"
        ),
    );
    bad(
        "2",
        "0 0 0\n1 1 1\n",
        &format!(
            "bad.ply:12: the header promises 1 `face`, more than the 0 bytes after it can hold; {truncated}"
        ),
    );
    bad(
        "2",
        "0 0 0          \n",
        &format!("bad.ply:11: the file ends before element 1 of 2 `vertex`; {truncated}"),
    );
    bad(
        "1",
        "0 0\n3 0 0 0\n",
        "bad.ply:10: z is missing; the line ends too early",
    );
    bad(
        "1",
        "0 0 zero\n3 0 0 0\n",
        "bad.ply:10: z `zero` is no number; write it as 1.5e-3",
    );
    let list = "write the length of the list, then each item";
    bad(
        "1",
        "0 0 0\n4 0 0 0\n",
        &format!("bad.ply:11: the list is to have 4 items, but 3 follow; {list}"),
    );
    bad(
        "1",
        "0 0 0\n-1\n",
        &format!("bad.ply:11: the list is to have -1 items, but 0 follow; {list}"),
    );
    bad(
        "1",
        "0 0 0\n3 0 0 1\n",
        "bad.ply:11: the face names vertex 1, but the file has 1 vertex; vertices are numbered from 0",
    );
    bad(
        "1",
        "0 0 0\n3 0 0 -1\n",
        "bad.ply:11: the face names vertex -1; vertices are numbered from 0",
    );
    bad(
        "1",
        "0 inf 0\n3 0 0 0\n",
        "bad.ply:11: the position of vertex 0 of 1 is not finite; positions are real numbers",
    );
}

#[test]
fn ply_headers() {
    let help = "a PLY file begins with the lines `ply` and `format …` and a header that ends with `end_header`";
    let bad = |contents: &str, line, problem: &str| {
        check(
            "bad.ply",
            contents,
            &format!("bad.ply:{line}: {problem}; {help}"),
        )
    };
    bad("", 1, "the header is not complete");
    bad("solid\nend_header\n", 1, "the header is not complete");
    bad("ply\nformat ascii 1.0\n", 2, "the header is not complete");
    bad(
        "ply\nformat ascii 1.0\nelement vertex -1\nend_header\n",
        3,
        "the header line `element vertex -1` cannot be read",
    );
    bad(
        "ply\nformat cuneiform 1.0\nend_header\n",
        2,
        "the header line `format cuneiform 1.0` cannot be read",
    );
    let huge = "ply\nformat ascii 1.0\nelement vertex 99999999999999999999999\nend_header\n";
    bad(
        huge,
        3,
        "the header line `element vertex 999999999…` cannot be read",
    );
    let twice =
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float x\nend_header\n";
    bad(
        twice,
        6,
        "the header declares an element or a property twice",
    );
    check(
        "bad.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n",
        "bad.ply:7: the vertices have no coordinates; each needs the properties x, y and z",
    );
    check(
        "bad.ply",
        "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n1 0\n",
        "bad.ply:10: the faces are given as triangle strips; save the file with plain faces",
    );
}

#[test]
fn binary_ply() {
    let header = ply("binary_little_endian", "1", "");
    let start = header.len();
    let file = |face: &[u8]| {
        let mut bytes = header.clone().into_bytes();
        bytes.extend([0; 12]);
        bytes.extend(face);
        io::from_bytes("bad.ply", &bytes)
            .map(|file| file.polygons.len())
            .map_err(|error| error.to_string())
    };
    assert_eq!(file(&[3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]), Ok(1));
    let at = start + 12;
    assert_eq!(
        file(&[3, 0, 0, 0, 0]),
        Err(format!(
            "bad.ply:byte {at}: the file ends before element 0 of 1 `face`; the file is truncated or its header wrong"
        ))
    );
    assert_eq!(
        file(&[1, 255, 255, 255, 255]),
        Err(format!(
            "bad.ply:byte {at}: the face names vertex -1; vertices are numbered from 0"
        ))
    );
    assert_eq!(
        file(&[1, 1, 0, 0, 0]),
        Err(format!(
            "bad.ply:byte {at}: the face names vertex 1, but the file has 1 vertex; vertices are numbered from 0"
        ))
    );
    for n_vertices in ["4294967296", "18446744073709551615"] {
        let error = io::from_bytes(
            "bad.ply",
            ply("binary_big_endian", n_vertices, "0").as_bytes(),
        )
        .unwrap_err()
        .to_string();
        assert!(
            error.contains(&format!(
                "promises {n_vertices} `vertex`, more than the 1 bytes"
            )),
            "{error}"
        );
    }
    // Elements without properties take no space, however many there are.
    let empty =
        "ply\nformat binary_little_endian 1.0\nelement nothing 18446744073709551615\nend_header\n";
    check(
        "bad.ply",
        empty,
        "bad.ply:4: the header declares no element `vertex`; a mesh without vertices has `element vertex 0`",
    );
    let vertices =
        "element vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header";
    let empty = empty.replace("end_header", vertices);
    assert!(
        io::from_bytes("empty.ply", empty.as_bytes())
            .unwrap()
            .positions
            .is_empty()
    );
    // A list that is to have 2³¹ − 1 items.
    let list = "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list int double vertex_indices\nend_header\n".replace("end_header", vertices);
    let bytes = [list.as_bytes(), &i32::MAX.to_le_bytes(), &[0; 64]].concat();
    assert!(
        io::from_bytes("bad.ply", &bytes)
            .unwrap_err()
            .to_string()
            .contains("ends before element 0")
    );
    let bytes = [list.as_bytes(), &(-1_i32).to_le_bytes()].concat();
    assert!(
        io::from_bytes("bad.ply", &bytes)
            .unwrap_err()
            .to_string()
            .contains("a list of element 0 of `face` has no valid length")
    );
}
