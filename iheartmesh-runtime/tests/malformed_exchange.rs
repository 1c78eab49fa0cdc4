//! STL, Gmsh and VTK files that are wrong: a clear error with the place.
#![cfg(feature = "io")]

use iheartmesh_runtime::io;

fn check(name: &str, contents: &[u8], expected: &str) {
    let error = io::from_bytes(name, contents).expect_err(expected);
    assert_eq!(error.to_string(), format!("{name}:{expected}"));
}

#[test]
fn stl() {
    let form = "a text file repeats the lines `facet normal 0 0 1`, `outer loop`, three times `vertex 0 0 0`, \
                `endloop`, `endfacet` between `solid` and `endsolid`";
    let text = |contents: &str, expected: &str| {
        check("a.stl", contents.as_bytes(), &format!("{expected}; {form}"));
    };
    text("", "1: `` is no beginning of a solid");
    text("\n\nv 0 0 0\n", "3: `v 0 0 0` is no beginning of a solid");
    text("solid a\n", "1: the file ends within a solid");
    let facet = "solid a\nfacet normal 0 0 1\n\nouter loop\nvertex 0 0 0\n";
    text(facet, "5: the file ends within a solid");
    text(
        &format!("{facet}vertex 0 zero 0\n"),
        "6: the line `vertex 0 zero 0` cannot be read",
    );
    text(
        &format!("{facet}vertex 0 nan 0\n"),
        "6: the line `vertex 0 nan 0` cannot be read",
    );
    text(
        &format!("{facet}vertex 0 0\nendloop"),
        "6: the line `vertex 0 0` cannot be read",
    );
    text(
        &format!("{facet}endloop\n"),
        "6: the line `endloop` cannot be read",
    );
    text(
        "solid\nendsolid\nsolid\nfacet\n",
        "4: the line `facet` cannot be read",
    );
    text(
        "solid\nendsolid\n\nmore\n",
        "4: `more` is no beginning of a solid",
    );

    let mut binary = vec![0; 84 + 50];
    let damaged = "the file is truncated or damaged, or of another format";
    check(
        "a.stl",
        &binary,
        &format!(
            "byte 80: the header promises 0 triangles of 50 bytes each, but 50 bytes follow; {damaged}"
        ),
    );
    binary[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    check(
        "a.stl",
        &binary,
        &format!(
            "byte 80: the header promises 4294967295 triangles of 50 bytes each, but 50 bytes follow; {damaged}"
        ),
    );
    binary[80..84].copy_from_slice(&1_u32.to_le_bytes());
    assert_eq!(io::from_bytes("a.stl", &binary).unwrap().polygons.len(), 1);
    binary[96..100].copy_from_slice(&f32::NAN.to_le_bytes());
    check(
        "a.stl",
        &binary,
        &format!("byte 84: a corner of triangle 0 is not finite; {damaged}"),
    );
}

#[test]
fn gmsh() {
    let head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    let new = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    let nodes = "{head}$Nodes\n2\n1 0 0 0\n5 1 0 0\n$EndNodes\n";
    let truncated = "it may be truncated";
    let damaged = "the file is truncated or damaged";
    for (contents, expected) in [
        ("", format!("1: the file ends before `$MeshFormat`; {truncated}")),
        ("$Nodes\n", "1: the file begins with `$Nodes`; a Gmsh file begins with `$MeshFormat`".to_owned()),
        (
            "$MeshFormat\n4 0 8\n",
            "2: version `4` of Gmsh files cannot be read; save it as version 2.2 or 4.1".to_owned(),
        ),
        ("$MeshFormat\n4.1 2 8\n", "2: the kind of file is 2; 0 is text, 1 is binary".to_owned()),
        (
            "$MeshFormat\n4.1 1 8\n\u{2}\0\0\0",
            format!("byte 20: 2 stands where the number 1 tells the byte order; {damaged}"),
        ),
        ("$MeshFormat\n4.1 1 8\n\u{1}\0", format!("byte 20: the file ends before the number 1; {truncated}")),
        ("{head}$Nodes\n-1\n", "5: the number of nodes is -1; it cannot be negative".to_owned()),
        (
            "{head}$Nodes\n4294967296\n1 0 0 0\n",
            format!("5: the number of nodes is 4294967296, more than the file can hold; {truncated}"),
        ),
        ("{head}$Nodes\nmany\n", "5: the number of nodes `many` is no whole number; write it as 17".to_owned()),
        (
            "{head}$Nodes\n1\n1 0 nan 0\n$EndNodes\n",
            "6: the position is not finite; positions are real numbers".to_owned(),
        ),
        ("{head}$Nodes\n2\n1 0 0 0\n1 0 0 0\n", "7: there are two nodes 1; each node has a tag of its own".to_owned()),
        ("{head}$Nodes\n1\n1 0 0 0\n2 0 0 0", "7: `2` stands where `$EndNodes` must; check the number of entries".to_owned()),
        ("{head}$Nodes\n2\n1 0 0 0\n", format!("6: the file ends before the tag of a node; {truncated}")),
        (
            "{nodes}$Elements\n1\n1 1 0 1 2\n",
            "11: an element names node 2, which is not there; nodes are named by their tags, and stand before the elements".to_owned(),
        ),
        (
            "{nodes}$Elements\n1\n1 9 0 1 5\n",
            "11: elements of type 9 are neither edges, triangles, quadrilaterals, tetrahedra nor hexahedra of first order; \
             save the mesh with such elements".to_owned(),
        ),
        (
            "{nodes}$Elements\n1\n1 1 -1 1 5\n",
            "11: the number of tags is -1; it cannot be negative".to_owned(),
        ),
        (
            "{nodes}$Elements\n2\n1 1 0 1 5\n1 1 0 5 1\n",
            "12: there are two elements 1; each element has a tag of its own".to_owned(),
        ),
        (
            "{nodes}$NodeData\n1\n\"a\"\n0\n3\n0\n1\n1\n4 0.5\n",
            "17: a value belongs to node 4, which is not there; values stand after the elements".to_owned(),
        ),
        (
            "{nodes}$NodeData\n1\n\"a\"\n0\n3\n0\n77\n1\n1 0.5\n",
            "16: the values of `a` have 77 components; 1, 3 or 9 are known".to_owned(),
        ),
        ("{nodes}$Periodic\n1\n", format!("9: the file ends before `$EndPeriodic`; {truncated}")),
        (
            "{nodes}17\n",
            "9: `17` stands where a section must begin; sections begin with `$`: check the number of entries before".to_owned(),
        ),
        (
            "{new}$Nodes\n1 2 1 2\n2 1 0 1\n1\n0 0 0\n$EndNodes\n",
            format!("8: there are to be 2 nodes, but the blocks have 1; {damaged}"),
        ),
        (
            "{new}$Nodes\n1 1 1 1\n2 1 0 18446744073709551615\n1\n0 0 0\n$EndNodes\n",
            "6: the number of nodes `18446744073709551615` is no whole number; write it as 17".to_owned(),
        ),
        (
            "{new}$Elements\n1 9999999999 1 1\n",
            format!("5: the number of elements is 9999999999, more than the file can hold; {truncated}"),
        ),
    ] {
        let contents = contents.replace("{nodes}", nodes).replace("{head}", head).replace("{new}", new);
        check("a.msh", contents.as_bytes(), &expected);
    }
}

#[test]
fn vtk() {
    let head = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET {kind}\n";
    let points = "{head}POINTS 3 double\n0 0 0\n1 0 0\n0 1 0\n";
    let cells = "{points}CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";
    let truncated = "it may be truncated";
    let damaged = "the file is truncated or damaged";
    for (contents, expected) in [
        (
            "<VTKFile>\n",
            "1: the first line is `<VTKFile>`; a legacy VTK file begins with `# vtk DataFile Version 3.0`; \
             a file in XML cannot be read".to_owned(),
        ),
        (
            "# vtk DataFile Version 3.0\ntitle\nUTF8\n",
            "3: `UTF8` is no encoding; the third line is `ASCII` or `BINARY`".to_owned(),
        ),
        (
            "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET STRUCTURED_POINTS\n",
            "4: the data set is `STRUCTURED_POINTS`; UNSTRUCTURED_GRID and POLYDATA can be read: save it as one of these".to_owned(),
        ),
        ("{head}POINTS -3 double\n", "5: the number of points is -3; it cannot be negative".to_owned()),
        (
            "{head}POINTS 4294967296 double\n0 0 0\n",
            format!("5: the number of points is 4294967296, more than the file can hold; {truncated}"),
        ),
        (
            "{head}POINTS 1 real\n",
            "5: there is no type `real` of numbers; types are `double`, `float`, `int`, `unsigned_char`, …".to_owned(),
        ),
        ("{head}POINTS 1 float\n0 0 inf\n", "6: the position is not finite; positions are real numbers".to_owned()),
        ("{head}POINTS 2 float\n0 0 0 1 x\n", "6: a coordinate `x` is no number; write it as 1.5e-3".to_owned()),
        ("{head}POINTS 2 float\n0 0 0 1 2\n", format!("6: the file ends before a coordinate; {truncated}")),
        (
            "{points}CELLS 1 4\n3 0 1 3\n",
            "10: a cell names vertex 3, but the file has 3 vertices; vertices are numbered from 0".to_owned(),
        ),
        (
            "{points}CELLS 1 4\n3 0 1 -1\n",
            "10: a cell names vertex -1, but the file has 3 vertices; vertices are numbered from 0".to_owned(),
        ),
        (
            "{points}CELLS 1 4\n4 0 1 2\n",
            format!("10: a cell is to have 4 corners, but 3 numbers are left of the 4 of the list; {damaged}"),
        ),
        (
            "{points}CELLS 1 5\n3 0 1 2 0\n",
            format!("10: the list of 1 cells has 1 numbers too many; {damaged}"),
        ),
        ("{points}CELLS 1 4\n3 0 1 2\n", format!("10: there are 1 cells, but types of 0; {damaged}")),
        (
            "{points}CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n",
            "12: cell 0 of type 10 has 3 corners; remove it, or save it as other cells".to_owned(),
        ),
        (
            "{points}CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n13\n",
            "12: cell 0 is of type 13, which is neither an edge, a polygon, a tetrahedron nor a hexahedron; \
             remove it, or save it as other cells".to_owned(),
        ),
        (
            "{points}CELLS 2 3\nOFFSETS vtktypeint64\n0 4\n",
            format!("11: offset 1 is 4 after 0; {damaged}"),
        ),
        (
            "{points}CELLS 2 3\nOFFSETS vtktypeint64\n0 2\n",
            format!("11: the last offset is 2, but there are 3 corners; {damaged}"),
        ),
        ("{cells}CELL_DATA 2\n", format!("13: there are values of 2 cells, but 1 cells; {damaged}")),
        (
            "{cells}SCALARS a double 1\n",
            "13: the values `a` belong to nothing; `POINT_DATA` or `CELL_DATA` stands before values".to_owned(),
        ),
        (
            "{cells}CELL_DATA 1\nSCALARS a double\nVECTORS b double\n",
            format!("15: `VECTORS` stands where `LOOKUP_TABLE` must; {damaged}"),
        ),
        (
            "{cells}CELL_DATA 1\nFIELD f 1\na 1 -1 double\n",
            "15: the number of values is -1; it cannot be negative".to_owned(),
        ),
        (
            "{cells}CELL_DATA 1\nFIELD f 1\na 4294967296 4294967296 double\n",
            format!("15: the number of values is 9223372036854775807, more than the file can hold; {truncated}"),
        ),
        (
            "{cells}CELL_DATA 1\nFIELD f 1\na -2 1 double\n",
            format!("15: the values have -2 components; {damaged}"),
        ),
        (
            "{cells}CELL_DATA 1\nVECTORS b double\n0 0\n",
            format!("15: the file ends before a value; {truncated}"),
        ),
        (
            "{cells}1 2 3\n",
            "13: unknown section `1`; remove it, or check the number of entries before".to_owned(),
        ),
    ] {
        let contents = contents.replace("{cells}", cells).replace("{points}", points);
        let contents = contents.replace("{head}", head).replace("{kind}", "UNSTRUCTURED_GRID");
        check("a.vtk", contents.as_bytes(), &expected);
    }
    // one cell that is many edges, with very many values
    let corners: String = (0..20_000).map(|k| format!(" {}", k % 3)).collect();
    let values: String = (0..20_000).map(|_| "a 1 1 int\n1\n").collect();
    let contents =
        format!("{points}LINES 1 20001\n20000{corners}\nCELL_DATA 1\nFIELD f 20000\n{values}");
    let contents = contents
        .replace("{head}", head)
        .replace("{kind}", "POLYDATA");
    let error = io::from_bytes("a.vtk", contents.as_bytes())
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("the values `a` and those before take far more memory than the file"),
        "{error}"
    );
}
