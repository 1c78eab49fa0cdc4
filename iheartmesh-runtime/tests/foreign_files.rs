//! Gmsh and VTK files as other programs write them, in text and binary.
#![cfg(feature = "io")]

#[path = "support/bytes.rs"]
mod bytes;

use bytes::Bytes;
use iheartmesh_runtime::ElementKind::{Cell, Edge, Face, Vertex};
use iheartmesh_runtime::glam::DVec3;
use iheartmesh_runtime::io::{self, MeshFile};

fn read(name: &str, contents: impl AsRef<[u8]>) -> MeshFile {
    io::from_bytes(name, contents.as_ref()).unwrap_or_else(|error| panic!("{error}"))
}

/// A triangle, an edge and a point between nodes 7, 3 and 10, with a value at two of them.
fn assert_triangle(file: &MeshFile) {
    assert_eq!(
        file.positions,
        [DVec3::ZERO, DVec3::X, DVec3::new(0.0, 0.1, 1e-300)]
    );
    assert_eq!(file.polygons.as_triangles(), Some(&[[1, 0, 2]][..]));
    assert_eq!(file.edges, [[2, 1]]);
    let heat = file.attributes.scalar(Vertex, "heat map").unwrap();
    assert!(heat[0] == 0.25 && heat[1].is_nan() && heat[2] == -1.0);
    assert_eq!(
        file.attributes.vector(Face, "flow"),
        Some(&[DVec3::new(1.0, 2.0, 3.0)][..])
    );
    assert_eq!(file.attributes.vector(Edge, "flow"), None);
}

#[test]
fn gmsh_files_with_everything() {
    let sections = "$PhysicalNames\n1\n2 1 \"red $Nodes\"\n$EndPhysicalNames\n";
    let nodes = "$Nodes\n3\n7 0 0 0\n3 1 0 0\n10 0 .1 1e-300\n$EndNodes\n";
    let elements = "$Elements\n3\n4 15 2 0 1 7\n2 2 3 0 1 99 3 7 10\n9 1 0 10 3\n$EndElements\n";
    let values = "$NodeData\n1\n\"heat map\"\n1\n0.0\n3\n0\n1\n2\n7 0.25\n10 -1\n$EndNodeData\n\
        $ElementData\n2\n\"flow\"\n\"scheme\"\n0\n4\n0\n3\n1\n0\n2 1 2 3\n$EndElementData\n";
    let head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    assert_triangle(&read(
        "a.msh",
        format!("{head}{sections}{nodes}{elements}{values}"),
    ));
    assert_triangle(&read(
        "a.msh",
        format!("{head}{nodes}{elements}{values}").replace('\n', "\r\n"),
    ));

    // nodes of a surface with their parameters
    let nodes = "$Entities\n0 0 0 0\n$EndEntities\n$Nodes\n2 3 3 10\n2 1 1 2\n7\n3\n0 0 0 0.5 0.5\n1 0 0 .5 .5\n0 4 0 1\n10\n0 .1 1e-300\n$EndNodes\n";
    let elements =
        "$Elements\n3 3 2 9\n0 1 15 1\n4 7\n2 1 2 1\n2 3 7 10\n1 1 1 1\n9 10 3\n$EndElements\n";
    let head = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    assert_triangle(&read("a.msh", format!("{head}{nodes}{elements}{values}")));

    for is_big in [false, true] {
        let mut file = Bytes {
            all: Vec::new(),
            is_big,
        };
        let values = |file: &mut Bytes| {
            file.text("$NodeData\n1\n\"heat map\"\n1\n0.0\n3\n0\n1\n2\n");
            for (tag, value) in [(7, 0.25), (10, -1.0)] {
                file.ints(&[tag]);
                file.doubles(&[value]);
            }
            file.text("\n$EndNodeData\n$ElementData\n1\n\"flow\"\n1\n0\n3\n0\n3\n1\n");
            file.ints(&[2]);
            file.doubles(&[1.0, 2.0, 3.0]);
            file.text("\n$EndElementData\n");
        };
        file.text("$MeshFormat\n2.2 1 8\n");
        file.ints(&[1]);
        file.text("\n$EndMeshFormat\n$Nodes\n3\n");
        for (tag, position) in [
            (7, [0.0; 3]),
            (3, [1.0, 0.0, 0.0]),
            (10, [0.0, 0.1, 1e-300]),
        ] {
            file.ints(&[tag]);
            file.doubles(&position);
        }
        file.text("\n$EndNodes\n$Elements\n3\n");
        file.ints(&[15, 1, 2, 4, 0, 1, 7]);
        file.ints(&[2, 1, 1, 2, 0, 3, 7, 10]);
        file.ints(&[1, 1, 0, 9, 10, 3]);
        file.text("\n$EndElements\n");
        values(&mut file);
        assert_triangle(&read("a.msh", &file.all));

        file.all.clear();
        file.text("$MeshFormat\n4.1 1 8\n");
        file.ints(&[1]);
        file.text("\n$EndMeshFormat\n$Nodes\n");
        file.sizes(&[2, 3, 3, 10]);
        file.ints(&[2, 1, 1]);
        file.sizes(&[2, 7, 3]);
        file.doubles(&[0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 0.0, 0.0, 0.5, 0.5]);
        file.ints(&[0, 4, 0]);
        file.sizes(&[1, 10]);
        file.doubles(&[0.0, 0.1, 1e-300]);
        file.text("\n$EndNodes\n$Elements\n");
        file.sizes(&[3, 3, 2, 9]);
        file.ints(&[0, 1, 15]);
        file.sizes(&[1, 4, 7]);
        file.ints(&[2, 1, 2]);
        file.sizes(&[1, 2, 3, 7, 10]);
        file.ints(&[1, 1, 1]);
        file.sizes(&[1, 9, 10, 3]);
        file.text("\n$EndElements\n");
        values(&mut file);
        assert_triangle(&read("a.msh", &file.all));
    }
}

#[test]
fn vtk_files_of_other_programs() {
    // every kind of cell, in the legacy form
    let points: String = (0..8)
        .map(|k| format!("{} {} {}\n", k & 1, k >> 1 & 1, k >> 2))
        .collect();
    let text = format!(
        "# vtk DataFile Version 2.0\na title\nascii\ndataset unstructured_grid\nFIELD FieldData 1\nTIME 1 1 double\n0.5\n\
         POINTS 8 float\n{points}CELLS 9 47\n1 0\n2 0 1\n3 0 1 3\n4 0 1 2 3\n5 0 1 2 3 5\n3 4 5 6\n\
         4 0 1 2 4\n8 0 1 2 3 4 5 6 7\n8 0 1 3 2 4 5 7 6\n\nCELL_TYPES 9\n1 3 4 8 6\n5 10 11 12\n\
         CELL_DATA 9\nSCALARS region%20of int 1\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7 8\n\
         LOOKUP_TABLE mine 1\n0 0.5 1 1\nVECTORS v double\n{}\nPOINT_DATA 8\nFIELD more 2\npair 2 8 double\n{}\n\
         METADATA\nINFORMATION 0\n\nother 1 3 int\n1 2 3\n",
        "0 0 1 ".repeat(9),
        "1 2 ".repeat(8)
    );
    for text in [text.clone(), text.replace('\n', "\r\n")] {
        let file = read("a.vtk", text);
        assert_eq!(file.edges, [[0, 1], [0, 1], [1, 3]]);
        let faces: Vec<&[u32]> = vec![
            &[0, 1, 3, 2],
            &[0, 1, 2],
            &[2, 1, 3],
            &[2, 3, 5],
            &[4, 5, 6],
        ];
        assert_eq!(file.polygons, faces.into_iter().collect());
        assert_eq!(file.tetrahedra, [[0, 1, 2, 4]]);
        assert_eq!(file.hexahedra, [[0, 1, 3, 2, 4, 5, 7, 6]; 2]);
        let values = |kind| file.attributes.scalar(kind, "region of").unwrap().to_vec();
        assert_eq!(values(Edge), [1.0, 2.0, 2.0]);
        assert_eq!(values(Face), [3.0, 4.0, 4.0, 4.0, 5.0]);
        assert_eq!(values(Cell), [6.0, 7.0, 8.0]);
        assert_eq!(file.attributes.vector(Cell, "v"), Some(&[DVec3::Z; 3][..]));
        assert_eq!(
            file.attributes.scalar(Vertex, "pair_1"),
            Some(&[2.0; 8][..])
        );
        assert!(file.attributes.get(Vertex, "other").is_none());
    }

    // polygonal data in binary, in both forms of connectivity
    for is_new in [false, true] {
        let mut file = Bytes {
            all: Vec::new(),
            is_big: true,
        };
        file.text(
            "# vtk DataFile Version 5.1\nvtk output\nBINARY\nDATASET POLYDATA\nPOINTS 4 double\n",
        );
        for position in [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 0.1, 0.0],
            [7.0, 7.0, 1e-300],
        ] {
            file.doubles(&position);
        }
        match is_new {
            true => {
                file.text("\nPOLYGONS 3 7\nOFFSETS vtktypeint64\n");
                file.sizes(&[0, 3, 7]);
                file.text("\nCONNECTIVITY vtktypeint64\n");
                file.sizes(&[0, 1, 2, 0, 1, 2, 3]);
                file.text("\nLINES 2 2\nOFFSETS vtktypeint64\n");
                file.sizes(&[0, 2]);
                file.text("\nCONNECTIVITY vtktypeint64\n");
                file.sizes(&[3, 0]);
            }
            false => {
                file.text("\nPOLYGONS 2 9\n");
                file.ints(&[3, 0, 1, 2, 4, 0, 1, 2, 3]);
                file.text("\nLINES 1 3\n");
                file.ints(&[2, 3, 0]);
            }
        }
        file.text("\nMETADATA\nINFORMATION 0\n\nCELL_DATA 3\nSCALARS tint unsigned_char 3\nLOOKUP_TABLE default\n");
        file.all.extend([1, 2, 3, 4, 5, 6, 7, 8, 9]);
        file.text("\nPOINT_DATA 4\nNORMALS normal float\n");
        (0..12).for_each(|k| file.put(&(k as f32).to_le_bytes()));
        file.text("\nSCALARS id vtkIdType\nLOOKUP_TABLE default\n");
        file.ints(&[5, 6, 7, -8]);
        let file = read("a.vtk", &file.all);
        assert_eq!(file.positions[3], DVec3::new(7.0, 7.0, 1e-300));
        let faces: Vec<&[u32]> = vec![&[0, 1, 2], &[0, 1, 2, 3]];
        assert_eq!(file.polygons, faces.into_iter().collect());
        assert_eq!(file.edges, [[3, 0]]);
        assert_eq!(
            file.attributes.colors(Face),
            Some(&[[1, 2, 3], [4, 5, 6]][..])
        );
        assert_eq!(file.attributes.colors(Edge), Some(&[[7, 8, 9]][..]));
        assert_eq!(
            file.attributes.vector(Vertex, "normal").unwrap()[3],
            DVec3::new(9.0, 10.0, 11.0)
        );
        assert_eq!(
            file.attributes.scalar(Vertex, "id"),
            Some(&[5.0, 6.0, 7.0, -8.0][..])
        );
    }
}

/// Found by fuzzing: what is called a colour may have one or two parts.
#[test]
fn colours_of_two_parts_are_scalars() {
    let text = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\nPOINT_DATA 1\n\
                COLOR_SCALARS a 2\n0.5 0.25\nCOLOR_SCALARS b 4\n0.2 0.4 1 1\n";
    let file = read("a.vtk", text);
    assert_eq!(file.attributes.scalar(Vertex, "a_1"), Some(&[0.25][..]));
    assert_eq!(file.attributes.colors(Vertex), Some(&[[51, 102, 255]][..]));
}
