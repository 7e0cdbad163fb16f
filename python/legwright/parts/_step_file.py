# SPDX-License-Identifier: Apache-2.0
"""Solids as STEP files (ISO 10303-21, AP214) for CAD: flat faces, in millimetres.

Triangles of one plane are one face, so that flat sides can be picked and measured; round ones stay
facets. The same solid gives the same bytes.
"""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from legwright.parts._mesh_files import Mesh

_ONE_WAY = 1e-3  # of normals that are one direction: 2.6 degrees, as thin triangles lean
_ONE_PLANE = 1e-4  # [mm]
_HEAD = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('solid of flat faces, millimetres'),'2;1');
FILE_NAME('{name}','1980-01-01T00:00:00',(''),(''),'legwright parts','legwright','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('automotive design');
#2=APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1);
#3=PRODUCT_CONTEXT('',#1,'mechanical');
#4=PRODUCT('{name}','{name}','',(#3));
#5=PRODUCT_DEFINITION_FORMATION('','',#4);
#6=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#7=PRODUCT_DEFINITION('design','',#5,#6);
#8=PRODUCT_DEFINITION_SHAPE('','',#7);
#9=SHAPE_DEFINITION_REPRESENTATION(#8,#10);
#10=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#11,#20),#12);
#11=AXIS2_PLACEMENT_3D('',#13,#14,#15);
#12=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#16))\
GLOBAL_UNIT_ASSIGNED_CONTEXT((#17,#18,#19))REPRESENTATION_CONTEXT('',''));
#13=CARTESIAN_POINT('',(0.,0.,0.));
#14=DIRECTION('',(0.,0.,1.));
#15=DIRECTION('',(1.,0.,0.));
#16=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-03),#17,'distance_accuracy_value','');
#17=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#18=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#19=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
"""
Loop = list[int]
"""Corners of a face's edge, by their numbers; material to the left, seen from outside."""


def _normals(mesh: Mesh) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Of triangles, with length 1, and how far along them their planes are."""
    corners = mesh.vertices.astype(float)[mesh.triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(across, axis=1, keepdims=True)
    normals = across / np.where(lengths > 0, lengths, 1)
    return normals, np.einsum('ij,ij->i', normals, corners[:, 0])


def _groups(mesh: Mesh) -> list[tuple[int, list[int]]]:
    """Triangles that hang together in one plane: the largest first, which tells the plane."""
    normals, offsets = _normals(mesh)
    edges: dict[tuple[int, int], int] = {}
    for k, (a, b, c) in enumerate(mesh.triangles.tolist()):
        edges |= {(a, b): k, (b, c): k, (c, a): k}
    corners = mesh.vertices.astype(float)[mesh.triangles]
    areas = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    left = np.ones(len(areas), dtype=bool)
    out = []
    for seed in np.argsort(-areas, kind='stable').tolist():
        if not left[seed]:
            continue
        left[seed] = False
        group, at = [seed], 0
        while at < len(group):
            a, b, c = mesh.triangles[group[at]].tolist()
            at += 1
            for edge in ((b, a), (c, b), (a, c)):
                other = edges.get(edge)
                if other is None or not left[other]:
                    continue
                heights = corners[other] @ normals[seed] - offsets[seed]
                flat = np.abs(heights).max() < _ONE_PLANE
                if flat and (normals[other] @ normals[seed] > 1 - _ONE_WAY or areas[other] < 1e-9):
                    left[other] = False
                    group.append(other)
        out.append((seed, group))
    return out


def _loops(mesh: Mesh, group: Sequence[int]) -> list[Loop] | None:
    """The edges around some triangles; None where a corner is met twice."""
    inner = {
        edge
        for k in group
        for a, b, c in [mesh.triangles[k].tolist()]
        for edge in ((a, b), (b, c), (c, a))
    }
    following: dict[int, int] = {}
    for a, b in sorted(inner):
        if (b, a) in inner:
            continue
        if a in following:
            return None
        following[a] = b
    out: list[Loop] = []
    while following:
        loop = [next(iter(following))]
        while (after := following.pop(loop[-1])) != loop[0]:
            loop.append(after)
        out.append(loop)
    return out


def faces_of(mesh: Mesh) -> list[tuple[int, list[Loop]]]:
    """The flat faces of a solid: a triangle in the plane of each, its edges, the outer first."""
    vertices = mesh.vertices.astype(float)
    normals, _ = _normals(mesh)
    out: list[tuple[int, list[Loop]]] = []
    for seed, group in _groups(mesh):
        loops = _loops(mesh, group)
        if not loops:
            out += [(k, [mesh.triangles[k].tolist()]) for k in group]
            continue

        def area(loop: Loop, normal: NDArray[np.float64] = normals[seed]) -> float:
            points = vertices[loop]
            return float(normal @ np.cross(points, np.roll(points, -1, axis=0)).sum(axis=0))

        loops.sort(key=lambda loop: -area(loop))
        out.append((seed, loops))
    return out


def _triple(values: Iterable[float]) -> str:
    return ','.join(f'{value + 0.0:.9E}' for value in values)


class _Writer:
    def __init__(self, mesh: Mesh) -> None:
        self._vertices = mesh.vertices.astype(float)
        self._normals, _ = _normals(mesh)
        self._mesh = mesh
        self._lines: list[str] = []
        self._points: dict[int, tuple[int, int]] = {}
        self._edges: dict[tuple[int, int], int] = {}

    def run(self) -> str:
        faces = [self._face(seed, loops) for seed, loops in faces_of(self._mesh)]
        shell = ','.join(f'#{face}' for face in faces)
        top = f"#20=MANIFOLD_SOLID_BREP('',#21);\n#21=CLOSED_SHELL('',({shell}));\n"
        return top + ''.join(self._lines)

    def _add(self, text: str) -> int:
        number = 22 + len(self._lines)
        self._lines.append(f'#{number}={text};\n')
        return number

    def _point(self, values: Iterable[float]) -> int:
        return self._add(f"CARTESIAN_POINT('',({_triple(values)}))")

    def _direction(self, values: Iterable[float]) -> int:
        return self._add(f"DIRECTION('',({_triple(values)}))")

    def _vertex(self, corner: int) -> tuple[int, int]:
        """Of a corner its point and its vertex."""
        if corner not in self._points:
            point = self._point(self._vertices[corner])
            self._points[corner] = point, self._add(f"VERTEX_POINT('',#{point})")
        return self._points[corner]

    def _edge(self, a: int, b: int) -> int:
        """An edge as a face goes along it."""
        low, high = min(a, b), max(a, b)
        if (low, high) not in self._edges:
            (point, start), (_, end) = self._vertex(low), self._vertex(high)
            way = self._vertices[high] - self._vertices[low]
            along = self._direction(way / np.linalg.norm(way))
            vector = self._add(f"VECTOR('',#{along},1.)")
            line = self._add(f"LINE('',#{point},#{vector})")
            self._edges[low, high] = self._add(f"EDGE_CURVE('',#{start},#{end},#{line},.T.)")
        same = '.T.' if a == low else '.F.'
        return self._add(f"ORIENTED_EDGE('',*,*,#{self._edges[low, high]},{same})")

    def _face(self, seed: int, loops: Sequence[Loop]) -> int:
        bounds = []
        for k, loop in enumerate(loops):
            edges = [self._edge(a, b) for a, b in zip(loop, [*loop[1:], loop[0]])]
            ring = self._add(f"EDGE_LOOP('',({','.join(f'#{edge}' for edge in edges)}))")
            kind = 'FACE_BOUND' if k else 'FACE_OUTER_BOUND'
            bound = self._add(f"{kind}('',#{ring},.T.)")
            bounds.append(f'#{bound}')
        normal = self._normals[seed]
        side = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
        point = self._point(self._vertices[self._mesh.triangles[seed][0]])
        z, x = self._direction(normal), self._direction(side / np.linalg.norm(side))
        frame = self._add(f"AXIS2_PLACEMENT_3D('',#{point},#{z},#{x})")
        plane = self._add(f"PLANE('',#{frame})")
        return self._add(f"ADVANCED_FACE('',({','.join(bounds)}),#{plane},.T.)")


def step_bytes(name: str, mesh: Mesh) -> bytes:
    """A STEP file with one solid; the name has no quotes."""
    text = _HEAD.format(name=name) + _Writer(mesh).run()
    return (text + 'ENDSEC;\nEND-ISO-10303-21;\n').encode()
