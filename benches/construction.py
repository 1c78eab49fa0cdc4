"""Time to build the topology of mesh files with libigl and geometry-central, beside `cargo bench --bench construction`.

    pip install libigl==2.6.3 potpourri3d==1.4.0 meshio==5.3.5
    python benches/construction.py FILE…

Triangles: libigl's edge_topology (edges, edges of faces, faces of edges); of geometry-central, which potpourri3d wraps, the
cheapest thing that takes a mesh: a GeodesicTracer, that is a halfedge mesh with its lengths and angles.
Tetrahedra: libigl's numbering of faces (unique_simplices of oriented_facets) and its edges. The best of several runs.
"""

import sys
import time

import igl
import meshio
import numpy
import potpourri3d


def best(compute):
    times = []
    end = time.perf_counter() + 2
    while len(times) < 5 or time.perf_counter() < end:
        start = time.perf_counter()
        result = compute()
        times.append(time.perf_counter() - start)
        del result
    return 1e3 * min(times)


def row(name, elements, what, milliseconds):
    print(f"{name:<24} {what:<40} {milliseconds:10.3f} ms {1e6 * milliseconds / elements:8.0f} ns/element")


for path in sys.argv[1:]:
    mesh = meshio.read(path)
    name = path.replace("\\", "/").split("/")[-1]
    points = numpy.asarray(mesh.points, dtype=numpy.float64, order="C")
    for cells in mesh.cells:
        corners = numpy.asarray(cells.data, dtype=numpy.int64, order="C")
        n = len(corners)
        if cells.type == "triangle":
            row(name, n, "libigl edge_topology", best(lambda: igl.edge_topology(points, corners)))
            row(name, n, "geometry-central GeodesicTracer", best(lambda: potpourri3d.GeodesicTracer(points, corners)))
        elif cells.type == "tetra":

            def number():
                facets = igl.oriented_facets(corners)
                return igl.unique_simplices(facets), igl.edges(corners)

            row(name, n, "libigl unique_simplices, edges", best(number))
