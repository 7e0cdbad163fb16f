# SPDX-License-Identifier: Apache-2.0
"""STEP files: closed, oriented, of the volume of their solids, and for a CAD kernel too."""

import re
from pathlib import Path

import numpy as np
import pytest
from legwright import parts
from legwright.parts._mesh_files import Mesh, mesh_of
from legwright.parts._step_file import faces_of, step_bytes
from manifold3d import Manifold

PLATE = Manifold.cube((20, 10, 4)) - Manifold.cylinder(6, 2, -1, 16).translate((6, 5, -1))


def read(text: str) -> list[list[list[np.ndarray]]]:
    """The corners of each face's edges, by the entities of the file; edges are met both ways."""
    of = dict(re.findall(r'^#(\d+)=(.*);$', text, re.M))
    used: list[tuple[str, str]] = []

    def numbers(entity: str) -> list[str]:
        return re.findall(r'#(\d+)', of[entity])

    def ends(edge: str) -> tuple[str, str]:
        start, end, _ = numbers(numbers(edge)[0])
        return (start, end) if of[edge].endswith('.T.)') else (end, start)

    def place(vertex: str) -> np.ndarray:
        point = of[numbers(vertex)[0]]
        return np.array([float(x) for x in re.findall(r'[-\d.]+E[+-]\d+', point)])

    faces = []
    for face in numbers(numbers('20')[0]):
        loops = []
        for bound in numbers(face)[:-1]:
            edges = [ends(edge) for edge in numbers(numbers(bound)[0])]
            assert all(one[1] == other[0] for one, other in zip(edges, [*edges[1:], edges[0]]))
            used += edges
            loops.append([place(start) for start, _ in edges])
        faces.append(loops)
    assert len(set(used)) == len(used) and {(b, a) for a, b in used} == set(used)
    return faces


def volume_of(faces: list[list[list[np.ndarray]]]) -> float:
    total = 0.0
    for loops in faces:
        first = loops[0][0]
        for loop in loops:
            for a, b in zip(loop, [*loop[1:], loop[0]]):
                total += np.linalg.det([first, a, b]) / 6
    return total


def test_a_plate_with_a_hole_has_six_sides_and_the_holes_facets():
    mesh = mesh_of(PLATE)
    assert sorted(len(loops) for _, loops in faces_of(mesh)) == [1] * 20 + [2] * 2
    text = step_bytes('plate', mesh).decode()
    faces = read(text)
    assert len(faces) == 22 and text.count('FACE_OUTER_BOUND') == 22
    assert volume_of(faces) == pytest.approx(PLATE.volume(), rel=1e-6)
    assert text.startswith('ISO-10303-21;') and text.endswith('END-ISO-10303-21;\n')


def test_a_thin_triangle_that_leans_by_the_precision_of_files_is_of_its_side():
    """0.005 mm wide, and 5e-5 mm off its plane: half a degree."""
    box = [(x, y, z) for z in (0, 4) for x, y in ((0, 0), (20, 0), (20, 10), (0, 10))]
    corners = np.array([*box, (10, 0.005, 4 - 5e-5)], dtype=np.float32)
    sides = [(k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4) for k in range(4)]
    quads = [(3, 2, 1, 0), *sides]
    flat = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    top = [(k + 4, (k + 1) % 4 + 4, 8) for k in range(4)]
    mesh = Mesh(corners, np.array(flat + top))
    assert len(faces_of(mesh)) == 6
    assert volume_of(read(step_bytes('box', mesh).decode())) == pytest.approx(800, rel=1e-5)


@pytest.fixture(scope='module')
def made(dog, tmp_path_factory) -> parts.Parts:
    folder = tmp_path_factory.mktemp('dog')
    return parts.make(dog, folder / 'parts', parts.PartOptions(step=True))


def test_parts_are_closed_and_of_their_volume(made):
    for part in made.parts:
        text = (made.folder / f'{part.name}.step').read_text(encoding='utf-8')
        assert f"PRODUCT('{part.name}'" in text
        faces = read(text)
        assert len(faces) < len(part.mesh.triangles) / 2
        assert volume_of(faces) == pytest.approx(part.solid.shape.volume(), rel=1e-5)


def test_a_cad_kernel_takes_them_for_solids(made):
    """Of OpenCASCADE, where it is installed (cadquery-ocp); the package does not need it."""
    pytest.importorskip('OCP')
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.STEPControl import STEPControl_Reader

    for part in made.parts:
        reader = STEPControl_Reader()
        reader.ReadFile(str(Path(made.folder) / f'{part.name}.step'))
        reader.TransferRoots()
        solid, found = reader.OneShape(), GProp_GProps()
        assert BRepCheck_Analyzer(solid).IsValid()
        volume = getattr(BRepGProp, 'VolumeProperties_s', None) or BRepGProp.VolumeProperties
        volume(solid, found)
        assert found.Mass() == pytest.approx(part.solid.shape.volume(), rel=1e-5)


def test_no_step_is_written_unasked(made, printed):
    assert list(made.folder.glob('*.step'))
    assert not list(printed('puppy').folder.glob('*.step'))
