//! glTF: what is written is read again, scenes are placed, and what is malformed is an error with its place.
#![cfg(feature = "gltf")]

use iheartmesh_runtime::ElementKind::Vertex;
use iheartmesh_runtime::FaceMesh;
use iheartmesh_runtime::glam::DVec3;
use iheartmesh_runtime::io::{self, Attributes, MeshFile};

fn square() -> MeshFile {
    let mut file = MeshFile::of_positions([
        DVec3::ZERO,
        DVec3::X,
        DVec3::new(1.0, 0.5, -2.0),
        DVec3::Y,
        // in no face
        DVec3::splat(0.125),
    ]);
    file.polygons.push(&[0, 1, 2]);
    file.polygons.push(&[0, 2, 3]);
    file.edges.push([4, 0]);
    // in the order in which they are read
    file.attributes = Attributes::new()
        .vertex_scalar("K", [0.5, -1.0, 2.0, 0.0, 8.0])
        .vertex_colors([[1, 2, 3], [0, 0, 255], [7; 3], [255; 3], [0; 3]])
        .vertex_vector("flow", [DVec3::Z; 5])
        .vertex_vector("normal", [DVec3::Y; 5]);
    file
}

#[test]
fn what_is_written_is_read_again() {
    let bare = MeshFile::of_positions([DVec3::X, DVec3::Y]);
    for written in [square(), bare, MeshFile::default()] {
        for name in ["a.gltf", "a.glb"] {
            let bytes = io::file_to_bytes(name, &written).unwrap();
            assert_eq!(io::from_bytes(name, &bytes).unwrap(), written, "{name}");
        }
    }
    let mesh = FaceMesh::from_triangles(5, &[[0, 1, 2], [3, 1, 0]]).unwrap();
    let bytes = io::to_bytes("a.glb", &square().positions, &mesh, &Attributes::new()).unwrap();
    let file = io::from_bytes("a.glb", &bytes).unwrap();
    assert_eq!(
        file.polygons.as_triangles(),
        Some(&[[0, 1, 2], [3, 1, 0]][..])
    );
}

#[test]
fn what_the_format_cannot_hold_is_not_written() {
    let message = |file: &MeshFile| io::file_to_bytes("a.glb", file).unwrap_err().to_string();
    let mut file = square();
    file.attributes = Attributes::new().face_scalar("area", [1.0, 2.0]);
    assert_eq!(
        message(&file),
        "a.glb: a glTF file cannot hold the face attribute `area`; write a .ply or .vtk file"
    );
    file.attributes = Attributes::new().vertex_scalar("K", [0.0, 1.0, f64::NAN, 0.0, 0.0]);
    assert_eq!(
        message(&file),
        "a.glb: a value of `K` is not finite in single precision; write a .ply file"
    );
    file = square();
    file.polygons.push(&[0, 1, 2, 3]);
    assert_eq!(
        message(&file),
        "a.glb: a glTF file cannot hold faces that are no triangles; divide them into triangles, or write a .ply file"
    );
    file.tetrahedra.push([0, 1, 2, 3]);
    assert_eq!(
        message(&file),
        "a.glb: a glTF file cannot hold cells; write a .mesh, .msh or .vtk file"
    );
    file = MeshFile::of_positions([DVec3::splat(-1e40)]);
    assert_eq!(
        message(&file),
        "a.glb: the position of vertex 0 is beyond single precision; scale the positions, or write a .ply file"
    );
}

/// Four positions (48 bytes), then the corners 0 1 2 3 in 16 bits, in base 64.
const BUFFER: &str = "data:application/octet-stream;base64,\
    AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAABAAIAAwA=";

/// A file with that buffer; `more` are further fields of the root, `primitives` those of mesh 0.
fn scene(primitives: &str, more: &str) -> String {
    format!(
        r#"{{"asset":{{"version":"2.0"}},
"buffers":[{{"byteLength":56,"uri":"{BUFFER}"}}],
"bufferViews":[{{"buffer":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":8}}],
"accessors":[{{"bufferView":0,"count":4,"componentType":5126,"type":"VEC3","min":[0,0,0],"max":[1,1,1]}},
{{"bufferView":1,"count":4,"componentType":5123,"type":"SCALAR"}},
{{"bufferView":0,"byteOffset":4,"count":3,"componentType":5126,"type":"VEC3"}}],
"meshes":[{{"primitives":[{primitives}]}}]{more}}}"#
    )
}

fn read(primitives: &str, more: &str) -> MeshFile {
    io::from_bytes("a.gltf", scene(primitives, more).as_bytes())
        .unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn primitives_of_every_mode() {
    let attributes = r#"{"attributes":{"POSITION":0},"indices":1,"mode":"#;
    let file = |mode: u32| read(&format!("{attributes}{mode}}}"), "");
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    assert_eq!(file(0).positions, corners);
    assert!(file(0).polygons.is_empty() && file(0).edges.is_empty());
    assert_eq!(file(1).edges, [[0, 1], [2, 3]]);
    assert_eq!(file(2).edges, [[0, 1], [1, 2], [2, 3], [3, 0]]);
    assert_eq!(file(3).edges, [[0, 1], [1, 2], [2, 3]]);
    assert_eq!(
        file(5).polygons.triangles().unwrap(),
        [[0, 1, 2], [2, 1, 3]]
    );
    assert_eq!(
        file(6).polygons.triangles().unwrap(),
        [[0, 1, 2], [0, 2, 3]]
    );
    // without corners, and with the vertices of the primitive before
    let file = read(
        r#"{"attributes":{"POSITION":0},"mode":5},{"attributes":{"POSITION":0},"mode":1}"#,
        "",
    );
    assert_eq!((file.positions.len(), file.polygons.len()), (4, 2));
    assert_eq!(file.edges, [[0, 1], [2, 3]]);
}

/// An accessor whose values are those of a view, or zero, but for some.
fn sparse(view: &str, n_sparse: &str, indices: &str, values: &str) -> String {
    let sparse = format!(
        r#"{view}"sparse":{{"count":{n_sparse},"indices":{{"bufferView":1,"componentType":5123{indices}}},"values":{{"bufferView":0{values}}}}},"count":4,"componentType":5126"#
    );
    scene(r#"{"attributes":{"POSITION":0},"indices":1,"mode":1}"#, "").replacen(
        r#""bufferView":0,"count":4,"componentType":5126"#,
        &sparse,
        1,
    )
}

#[test]
fn sparse_accessors() {
    let read = |text: &str| {
        let file = io::from_bytes("a.gltf", text.as_bytes());
        file.unwrap_or_else(|error| panic!("{error}")).positions
    };
    let all = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    // vertices 1 and 2 get the values x, y of the view from byte 12 on
    let at_one = r#","byteOffset":2"#;
    let from_one = r#","byteOffset":12"#;
    let some = read(&sparse("", "2", at_one, from_one));
    assert_eq!(some, [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ZERO]);
    let view = r#""bufferView":0,"#;
    assert_eq!(read(&sparse(view, "2", at_one, from_one)), all);
    let moved = read(&sparse(view, "2", at_one, r#","byteOffset":24"#));
    assert_eq!(moved, [DVec3::ZERO, DVec3::Y, DVec3::Z, DVec3::Z]);
    assert_eq!(read(&sparse(view, "0", "", "")), all);

    let damaged = "the file is truncated or damaged";
    let bytes = |text: String| text.replace("\"componentType\":5123}", "\"componentType\":5121}");
    for (text, message) in [
        (
            sparse(view, "5", "", ""),
            format!("5 entries of 2 bytes are to be in a view of 8 bytes; {damaged}"),
        ),
        (
            sparse(view, "4", "", from_one),
            format!("4 entries of 12 bytes are to be in a view of 48 bytes; {damaged}"),
        ),
        (
            sparse(view, "18446744073709551615", "", ""),
            format!("18446744073709551615 entries of 2 bytes are to be in a view of 8 bytes; {damaged}"),
        ),
        (
            // the bytes 0 0 1 0 as indices
            bytes(sparse(view, "3", "", "")),
            "a value of the sparse accessor is to stand at 0 of 4 after 1 at least; \
             the indices increase and are less than `count`"
                .to_owned(),
        ),
        (
            sparse(view, "4", "", "").replacen("\"count\":4,\"componentType\":5126", "\"count\":3,\"componentType\":5126", 1),
            "a value of the sparse accessor is to stand at 3 of 3 after 3 at least; \
             the indices increase and are less than `count`"
                .to_owned(),
        ),
        (
            sparse("", "0", "", "").replacen(
                "\"count\":4,\"componentType\":5126",
                "\"count\":4294967296,\"componentType\":5126",
                1,
            ),
            "the scene takes far more memory than the file; \
             the same data is placed too often, or a sparse accessor is far longer than its data"
                .to_owned(),
        ),
        (
            sparse(view, "1", "", "").replace("\"componentType\":5123}", "\"componentType\":5126}"),
            "the type of the indices of the sparse accessor is unknown; components of indices are 5121, 5123 or 5125"
                .to_owned(),
        ),
        (
            sparse(view, "1", "", "").replace("\"indices\":{\"bufferView\":1", "\"indices\":{\"bufferView\":2"),
            "there is no bufferViews[2]: there are 2; entries are numbered from 0".to_owned(),
        ),
    ] {
        let error = io::from_bytes("a.gltf", text.as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), format!("a.gltf:accessors[0]: {message}"));
    }
}

#[test]
fn nodes_place_meshes() {
    // twice: shifted within a node that is twice as large and mirrored, and turned by 90 degrees around z
    let nodes = r#","scene":0,"scenes":[{"nodes":[0,2]}],"nodes":[
{"children":[1],"scale":[2,2,-2]},{"mesh":0,"translation":[10,0,0]},
{"mesh":0,"rotation":[0,0,0.70710678118,0.70710678118]},{"mesh":0}]"#;
    let file = read(
        r#"{"attributes":{"POSITION":0,"_K":1,"_A":0},"indices":1,"mode":5}"#,
        nodes,
    );
    let expected = [
        [20.0, 0.0, 0.0],
        [22.0, 0.0, 0.0],
        [20.0, 2.0, 0.0],
        [20.0, 0.0, -2.0],
        [0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
    ];
    assert_eq!(file.positions.len(), 8);
    for (position, expected) in file.positions.iter().zip(expected) {
        assert!(
            (*position - DVec3::from(expected)).length() < 1e-7,
            "{position}"
        );
    }
    // what is mirrored is turned over
    assert_eq!(
        file.polygons.triangles().unwrap(),
        [[0, 2, 1], [2, 3, 1], [4, 5, 6], [6, 5, 7]]
    );
    let values = [0.0, 1.0, 2.0, 3.0];
    assert_eq!(
        file.attributes.scalar(Vertex, "K"),
        Some(&[values, values].concat()[..])
    );
    assert_eq!(file.attributes.vector(Vertex, "A").unwrap()[5], DVec3::X);
}

#[test]
fn seams_can_be_closed() {
    let file = read(
        r#"{"attributes":{"POSITION":0},"mode":5},{"attributes":{"POSITION":0,"_K":1},"mode":6}"#,
        "",
    );
    let mut closed = file.clone();
    closed.merge_equal_positions();
    assert_eq!((file.positions.len(), closed.positions.len()), (8, 4));
    // the first primitive has no values
    let values = closed.attributes.scalar(Vertex, "K").unwrap();
    assert!(values.len() == 4 && values.iter().all(|value| value.is_nan()));
    assert_eq!(
        closed.polygons.triangles().unwrap(),
        [[0, 1, 2], [2, 1, 3], [0, 1, 2], [0, 2, 3]]
    );
}

#[test]
fn buffers_in_other_files() {
    let folder = std::env::temp_dir().join(format!("iheartmesh-gltf-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let text = scene(r#"{"attributes":{"POSITION":0}}"#, "").replace(BUFFER, "my%20data.bin");
    let text = text.replace(
        r#""count":4,"componentType":5126"#,
        r#""count":3,"componentType":5126"#,
    );
    let path = folder.join("a.gltf");
    std::fs::write(&path, &text).unwrap();
    let missing = io::read(&path).unwrap_err().to_string();
    assert!(
        missing.contains("buffers[0]: the buffer is the file `my data.bin`: "),
        "{missing}"
    );
    let data: Vec<u8> = (0..14).flat_map(|k| (k as f32).to_le_bytes()).collect();
    std::fs::write(folder.join("my data.bin"), data).unwrap();
    let file = io::read(&path).unwrap();
    assert_eq!(file.positions[2], DVec3::new(6.0, 7.0, 8.0));
    std::fs::remove_dir_all(folder).unwrap();

    let message = |text: &str| {
        io::from_bytes("a.gltf", text.as_bytes())
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        message(&text),
        "a.gltf:buffers[0]: the buffer is the file `my data.bin`: other files are not opened for contents in memory; \
         save it as .glb, which is one file"
    );
    for name in [
        "../secret.bin",
        "/etc/passwd",
        "https://example.org/a.bin",
        "a/../../b",
    ] {
        let path =
            std::env::temp_dir().join(format!("iheartmesh-outside-{}.gltf", std::process::id()));
        std::fs::write(&path, text.replace("my%20data.bin", name)).unwrap();
        let message = io::read(&path).unwrap_err().to_string();
        assert!(
            message.contains("it must be in the same folder or below"),
            "{message}"
        );
        std::fs::remove_file(path).unwrap();
    }
}

#[test]
fn malformed_files() {
    let with = |primitives: &str, more: &str| scene(primitives, more);
    let good = with(r#"{"attributes":{"POSITION":0},"indices":1,"mode":1}"#, "");
    let damaged = "the file is truncated or damaged";
    let all = [
        (String::new(), "1: EOF while parsing a value; a glTF file is JSON, alone or after the bytes `glTF` and a header".to_owned()),
        (
            good.replace("\"count\":4,\"componentType\":5126", "\"count\":4294967296,\"componentType\":5126"),
            format!("accessors[0]: 4294967296 entries of 12 bytes are to be in a view of 48 bytes; {damaged}"),
        ),
        (
            good.replace("\"count\":4,\"componentType\":5126", "\"count\":18446744073709551615,\"componentType\":5126"),
            format!("accessors[0]: 18446744073709551615 entries of 12 bytes are to be in a view of 48 bytes; {damaged}"),
        ),
        (
            good.replace("\"byteOffset\":48", "\"byteOffset\":18446744073709551615"),
            format!("bufferViews[1]: 8 bytes from byte 18446744073709551615 are to be in a buffer of 56; {damaged}"),
        ),
        (
            good.replace("\"byteLength\":56", "\"byteLength\":57"),
            format!("buffers[0]: the buffer is to have 57 bytes, but has 56; {damaged}"),
        ),
        (
            good.replace("base64,AA", "base64,*"),
            format!("buffers[0]: the `uri` of the buffer is no data in base 64; {damaged}"),
        ),
        (
            good.replace("\"POSITION\":0", "\"POSITION\":3"),
            "meshes[0]: there is no accessors[3]: there are 3; entries are numbered from 0".to_owned(),
        ),
        (
            good.replace("\"POSITION\"", "\"POSITIONS\""),
            "meshes[0]: a primitive has no `POSITION`; vertices need positions".to_owned(),
        ),
        (
            good.replace("\"POSITION\":0", "\"POSITION\":1"),
            "meshes[0]: positions have 1 coordinates; `POSITION` is of type VEC3".to_owned(),
        ),
        (
            good.replace("\"POSITION\":0", "\"POSITION\":0,\"NORMAL\":2"),
            "accessors[2]: there are 3 values for 4 positions; each vertex has one".to_owned(),
        ),
        (
            good.replace("\"POSITION\":0", "\"POSITION\":2"),
            "accessors[1]: an element names vertex 3 of 3 vertices; vertices are numbered from 0".to_owned(),
        ),
        (
            good.replace("\"indices\":1", "\"indices\":0"),
            "accessors[0]: the vertices of elements are not single whole numbers; \
             they are of type SCALAR with components 5121, 5123 or 5125".to_owned(),
        ),
        (
            good.replace("\"mode\":1", "\"mode\":4"),
            format!("meshes[0]: 4 vertices are no multiple of 3; {damaged}"),
        ),
        (
            good.replace("\"mode\":1", "\"mode\":9"),
            "meshes[0]: the mode of a primitive is unknown; modes are 0 to 6".to_owned(),
        ),
        (
            good.replace("AACAPwAA", "AADAfwAA"),
            "accessors[0]: the position of vertex 1 is not finite; positions are real numbers".to_owned(),
        ),
        (
            good.replace("\"bufferView\":1,", ""),
            "accessors[1]: the accessor has no `bufferView`; save the file without compressed data".to_owned(),
        ),
        (
            good.replace("\"byteLength\":48}", "\"byteLength\":48,\"byteStride\":4}"),
            "bufferViews[0]: `byteStride` is 4, less than the 12 bytes of an entry; the file is damaged".to_owned(),
        ),
        (
            good.replace("\"meshes\"", "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[0]}],\"meshes\""),
            "nodes[0]: the node is reached twice; the nodes of a scene are a tree".to_owned(),
        ),
        (
            good.replace("\"meshes\"", "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":7}],\"meshes\""),
            "nodes[0]: there is no meshes[7]: there are 1; entries are numbered from 0".to_owned(),
        ),
        (
            good.replace("\"meshes\"", "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"meshes\""),
            "1: the file needs the extension `KHR_draco_mesh_compressi…`; save it without compression".to_owned(),
        ),
        (
            good.replace("\"type\":\"SCALAR\"", "\"type\":\"SCALE\""),
            "accessors[1]: the type of the accessor is unknown; types are SCALAR, VEC2, VEC3, …, components 5120 to 5126".to_owned(),
        ),
        (
            format!("{{\"asset\":{{\"version\":\"2.0\"}},\"nodes\":[{}{{}}]}}", "{},".repeat(50_000)),
            "1: there are 50003 objects in 150040 bytes; a glTF file is JSON, alone or after the bytes `glTF` and a header".to_owned(),
        ),
    ];
    assert!(io::from_bytes("a.gltf", good.as_bytes()).is_ok());
    for (text, message) in all {
        assert!(text != good, "{message}");
        let error = io::from_bytes("a.gltf", text.as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), format!("a.gltf:{message}"));
    }
    // the same data placed again and again
    let primitive = r#"{"attributes":{"POSITION":0,"_A":0},"indices":1}"#;
    let nodes: Vec<String> = (0..40_000).map(|k| k.to_string()).collect();
    let nodes = format!(
        r#","scenes":[{{"nodes":[{}]}}],"nodes":[{}{{"mesh":0}}]"#,
        nodes.join(","),
        r#"{"mesh":0,"name":"some name"},"#.repeat(39_999)
    );
    let primitives: Vec<String> = (0..500)
        .map(|k| primitive.replace("_A", &format!("_A{k}")))
        .collect();
    let text = scene(&primitives.join(","), &nodes).replace("\"indices\":1", "\"mode\":0");
    let error = io::from_bytes("a.gltf", text.as_bytes())
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("the scene takes far more memory than the file"),
        "{error}"
    );
}

#[test]
fn malformed_containers() {
    let bytes = io::file_to_bytes("a.glb", &square()).unwrap();
    let message = |bytes: &[u8]| io::from_bytes("a.glb", bytes).unwrap_err().to_string();
    let n = bytes.len();
    assert_eq!(
        message(&bytes[..n - 1]),
        format!(
            "a.glb:byte 8: the length is to be {n} bytes, but is {}; the file is truncated or damaged",
            n - 1
        )
    );
    assert!(message(b"glTF").starts_with("a.glb:byte 4: the length is to be 0 bytes"));
    let mut other = bytes.clone();
    other[4] = 1;
    assert!(
        message(&other).contains("byte 12: unsupported version"),
        "{}",
        message(&other)
    );
    let mut other = bytes.clone();
    other[12..16].fill(255);
    assert!(
        message(&other).contains("chunk length exceeds"),
        "{}",
        message(&other)
    );
    let mut other = bytes;
    other[20] = b'!';
    assert!(
        message(&other).starts_with("a.glb:byte 20: "),
        "{}",
        message(&other)
    );
}
