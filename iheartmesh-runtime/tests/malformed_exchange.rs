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
            "11: elements of type 9 are neither edges, triangles, quadrilaterals, tetrahedra, hexahedra, prisms nor pyramids \
             of first order; make the mesh of first order, with vertices at the corners of elements only, and save it again"
                .to_owned(),
        ),
        (
            "{nodes}$Elements\n1\n1 6 0 1 5 1 5 1\n",
            format!("11: the file ends before a node; {truncated}"),
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
            "{points}CELLS 1 4\n3 0 1 3\nCELL_TYPES 1\n5\n",
            "10: cell 0 names vertex 3, but the file has 3 vertices; vertices are numbered from 0".to_owned(),
        ),
        (
            "{points}CELLS 1 4\n3 0 1 -1\nCELL_TYPES 1\n5\n",
            "10: cell 0 names vertex -1, but the file has 3 vertices; vertices are numbered from 0".to_owned(),
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
            "10: cell 0 of type 10 has 3 corners; remove it, or save it as other cells".to_owned(),
        ),
        (
            "{points}CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n13\n",
            "10: cell 0 of type 13 has 3 corners; remove it, or save it as other cells".to_owned(),
        ),
        (
            "{points}CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n99\n",
            "10: cell 0 is of type 99, which is neither an edge, a polygon nor a polyhedron; \
             remove it, or save it as other cells".to_owned(),
        ),
        (
            "{points}CELLS 2 5\n0\n3 0 1 2\nCELL_TYPES 2\n2 22\n",
            "11: cell 1 is of type 22, which is not of first order; \
             make the mesh of first order, with vertices at the corners of elements only, and save it again".to_owned(),
        ),
        (
            "{points}CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n41\n",
            "10: cell 0 is of type 41, a convex point set, which does not say what its faces are; \
             save it as a polyhedron, of type 42".to_owned(),
        ),
        (
            "{points}CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n266\n",
            format!("12: there is no type 266 of cells; {damaged}"),
        ),
        ("{points}POINTS 0 double\n", "9: there are two lists of points; keep one".to_owned()),
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
            "{cells}CELL_DATA 1\nSCALARS a double x\nLOOKUP_TABLE default\n1\n",
            "14: the number of components `x` is no whole number; write it as 3".to_owned(),
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
    polyhedra(points, head);
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

/// Polyhedra between three points: the numbers of one cell after another.
fn polyhedra(points: &str, head: &str) {
    let form = "a polyhedron is the number of its faces, then for each face the number of its corners and the corners";
    let least = "a polyhedron has at least four faces, and a face at least three corners";
    let large =
        "face 0 of cell 1 is to have 4294967299 corners, but 3 numbers of the cell are left";
    for (numbers, expected) in [
        (
            "",
            format!("cell 1 is a polyhedron without a number of faces; {form}"),
        ),
        (
            "0",
            format!("cell 1 is a polyhedron that has 0 faces; {least}"),
        ),
        (
            "3 3 0 1 2 3 0 1 2 3 0 1 2",
            format!("cell 1 is a polyhedron that has 3 faces; {least}"),
        ),
        (
            "4 3 0 1 2 3 0 1 2 3 0 1 2 2 0 1",
            format!("cell 1 is a polyhedron that has a face 3 with 2 corners; {least}"),
        ),
        (
            "5 3 0 1 2 3 0 1 2 3 0 1 2 3 0 1 2",
            format!(
                "cell 1 is to be a polyhedron with 5 faces, but its numbers are those of 4; {form}"
            ),
        ),
        (
            "-1 3 0 1 2",
            format!(
                "cell 1 is to be a polyhedron with -1 faces, but its numbers are those of 1; {form}"
            ),
        ),
        (
            "9223372036854775807 3 0 1 2",
            format!(
                "cell 1 is to be a polyhedron with 9223372036854775807 faces, but its numbers are those of 1; {form}"
            ),
        ),
        (
            "4 3 0 1 2 4 0 1 2",
            format!(
                "face 1 of cell 1 is to have 4 corners, but 3 numbers of the cell are left; {form}"
            ),
        ),
        ("4 4294967299 0 1 2", format!("{large}; {form}")),
        (
            "4 -3 0 1 2",
            format!(
                "face 0 of cell 1 is to have -3 corners, but 3 numbers of the cell are left; {form}"
            ),
        ),
        (
            "4 3 0 1 3",
            "cell 1 names vertex 3, but the file has 3 vertices; vertices are numbered from 0"
                .to_owned(),
        ),
        (
            "4 3 0 -1 2",
            "cell 1 names vertex -1, but the file has 3 vertices; vertices are numbered from 0"
                .to_owned(),
        ),
    ] {
        let n = numbers.split_whitespace().count();
        let points = points
            .replace("{head}", head)
            .replace("{kind}", "UNSTRUCTURED_GRID");
        // the third cell has no numbers, but a place
        let types = "CELL_TYPES 3\n1 42 2\n";
        let text = format!("{points}CELLS 3 {}\n1 0\n{n} {numbers}\n0\n{types}", n + 4);
        check("a.vtk", text.as_bytes(), &format!("11: {expected}"));
        // in the form of version 5, where cells have no lines of their own
        let end = n + 1;
        let text = format!(
            "{points}CELLS 4 {end}\nOFFSETS vtktypeint64\n0 1 {end} {end}\nCONNECTIVITY vtktypeint64\n0\n{numbers}\n{types}"
        );
        // a cell without numbers begins where the next one does, or where the list ends
        let line = if n == 0 { 13 } else { 14 };
        check("a.vtk", text.as_bytes(), &format!("{line}: {expected}"));
        // in binary, at the byte where the number of numbers stands
        let numbers: Vec<i64> = numbers
            .split_whitespace()
            .map(|x| x.parse().unwrap())
            .collect();
        if numbers.iter().any(|&x| i32::try_from(x).is_err()) {
            continue;
        }
        let ints = |all: &[i32]| -> Vec<u8> { all.iter().flat_map(|x| x.to_be_bytes()).collect() };
        let mut bytes =
            b"# vtk DataFile Version 3.0\n\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n"
                .to_vec();
        bytes.extend([0; 72]);
        bytes.extend(format!("\nCELLS 3 {}\n", n + 4).as_bytes());
        let place = bytes.len() + 8;
        bytes.extend(ints(&[1, 0, n as i32]));
        bytes.extend(ints(&numbers.iter().map(|&x| x as i32).collect::<Vec<_>>()));
        bytes.extend(ints(&[0]));
        bytes.extend(b"\nCELL_TYPES 3\n");
        bytes.extend(ints(&[1, 42, 2]));
        check("a.vtk", &bytes, &format!("byte {place}: {expected}"));
    }
}
