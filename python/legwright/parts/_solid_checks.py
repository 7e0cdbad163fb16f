# SPDX-License-Identifier: Apache-2.0
"""Whether a part can be printed as it is: closed, in one piece, thick enough, as heavy as told."""

import io
import math

import numpy as np
import trimesh
from manifold3d import Error, Manifold

from legwright.parts._checks import Check, at_least, at_most
from legwright.parts._crossings import crossing_of
from legwright.parts._mesh_files import stl_bytes
from legwright.parts._reach import reaches
from legwright.parts._robot import BuiltRobot
from legwright.parts._shapes import MM, hull
from legwright.parts._solids import Part, Solid
from legwright.parts._thin import FACING

_SAME_VOLUME = 1e-6  # of it: two libraries
_SAME_MASS = 1e-3  # of it: hulls and the robot's file
_RELATIVE = 'relative difference'
_SAMPLES = 2000  # points of a surface at which the wall is measured
_TILT = math.radians(0.5)  # of a horn to the joint's axis
_BESIDE = 0.05  # [mm]: of a joint's axis from the horn's middle


def _trimesh_of(part: Part) -> trimesh.Trimesh:
    """The part as its STL has it."""
    return trimesh.load(io.BytesIO(stl_bytes(part.mesh)), file_type='stl')


def _through_itself(name: str, found: trimesh.Trimesh) -> Check:
    """Of the STL: manifold3d and trimesh look at how its triangles hang together alone."""
    at = crossing_of(found.vertices, found.faces)
    place, cure = '', ''
    if at is not None:
        place = f'at {at[0]:.2f} {at[1]:.2f} {at[2]:.2f} mm of its STL it is within itself'
        cure = (
            'slicers fill or leave out such places as they like: cut the part anew, with another '
            '--fit or a module moved by a tenth of a millimetre (offset in the assembly), and tell '
            'us of the robot, as it is a fault of ours'
        )
    limit = 'all of space in it once or not at all'
    return Check(name, 'no self-intersection', at is None, None, '', limit, place, cure)


def _closed(part: Part) -> list[Check]:
    shape, found = part.printed, _trimesh_of(part)
    good = (
        shape.status() == Error.NoError
        and found.is_watertight
        and found.is_winding_consistent
        and found.volume > 0
    )
    differs = abs(found.volume - shape.volume()) / shape.volume()
    fault = 'a fault of ours: tell it with the robot, and print another design meanwhile'
    return [
        Check(
            part.name,
            'watertight and oriented',
            good,
            None,
            '',
            'manifold3d and, of the STL, trimesh agree',
            '' if good else f'manifold3d: {shape.status().name}',
            '' if good else fault,
        ),
        at_most(part.name, 'volume by trimesh', differs, _SAME_VOLUME, _RELATIVE, '', fault),
        Check(
            part.name,
            'in one piece',
            part.solid.pieces == 1,
            float(part.solid.pieces),
            'piece' if part.solid.pieces == 1 else 'pieces',
            'exactly 1',
            '',
            ''
            if part.solid.pieces == 1
            else 'modules or holes cut it apart: a larger [link] radius or wall, or another roll',
        ),
        _through_itself(part.name, found),
    ]


def _wall_of(shape: Manifold, mesh: trimesh.Trimesh) -> tuple[float, np.ndarray]:
    """Least thickness, by rays from the surface inwards [mm], and where."""
    points, faces = trimesh.sample.sample_surface(mesh, _SAMPLES, seed=1)
    least, where = math.inf, np.zeros(3)
    for point, normal in zip(np.asarray(points), mesh.face_normals[faces]):
        start = point - 1e-3 * normal
        hits = shape.ray_cast(tuple(start), tuple(start - 1e3 * normal))
        if not hits or -np.dot(np.asarray(hits[0].normal), normal) < FACING:
            continue
        thick = float(np.linalg.norm(np.asarray(hits[0].position) - point))
        if thick < least:
            least, where = thick, point
    return least, where


def _wall(part: Part, wall: float) -> Check:
    least, where = _wall_of(part.printed, _trimesh_of(part))
    place = f'at {where[0]:.1f} {where[1]:.1f} {where[2]:.1f} mm of its STL'
    remedy = 'a larger wall in [link] of the assembly, or --wall for a finer nozzle'
    if not math.isfinite(least):
        place, limit = 'no two of its sides face each other', f'at least {wall:g} mm'
        return Check(part.name, 'wall', False, None, 'mm', limit, place, remedy)
    return at_least(part.name, 'wall', least, wall, 'mm', place, remedy)


def _masses(part: Part) -> list[Check]:
    """Of the hulls against the file, at the density that each declares; a trunk is not heavier."""
    if part.solid.link.servo is None and not part.solid.link.hulls:
        share = part.solid.mass / part.solid.file_mass
        cure = (
            'no mass under [trunk] of the assembly, then it is that of the tray, or a larger one; '
            'or a smaller --wall'
        )
        of = "of its module's mass"
        return [at_most(part.name, 'mass of the trunk', share, 1.0, of, '', cure)]
    worst = 0.0
    for solid in part.solids:
        for each in solid.link.hulls:
            own = hull(each).volume() / MM**3 * each.words.density
            worst = max(worst, abs(own - each.mass) / each.mass)
    cure = 'the file is not as Legwright wrote it: build or optimize it anew'
    of = "against the file's"
    return [at_most(part.name, 'mass of the hulls', worst, _SAME_MASS, _RELATIVE, of, cure)]


def _axis(robot: BuiltRobot, solid: Solid, part: Part) -> list[Check]:
    """A design may turn a joint's axis, but not the servo that stands for it."""
    servo = solid.link.servo
    horns = [place for place in servo.places if place.on_horn] if servo else []
    if not horns:
        return []
    joint = solid.link.joint
    axis = robot.model.jnt_axis[joint]
    turn = math.acos(min(1.0, abs(float(axis @ horns[0].normal))))
    name = robot.model.joint(joint).name
    # At zero a link's frame has the axes of the body above, on which the servo stands.
    centre = horns[0].position - robot.model.body_pos[solid.link.body]
    beside = np.linalg.norm(np.cross(robot.model.jnt_pos[joint] - centre, horns[0].normal))
    return [
        at_most(
            part.name,
            f'axis of {name} on the horn',
            math.degrees(turn),
            math.degrees(_TILT),
            'deg',
            f'horn of {servo.of}',
            'the design turned the axis away from the servo: [print] in the assembly keeps axes, '
            'or freeze = ["*_axis_*"] under [design] of the task; optimize again',
        ),
        at_most(
            part.name,
            f'middle of {name} on the horn',
            MM * float(beside),
            _BESIDE,
            'mm',
            f'horn of {servo.of}',
            'the axis runs beside the horn: put back pos of the joint and of its body, as '
            '`legwright build` wrote them',
        ),
    ]


def check_solids(robot: BuiltRobot, parts: list[Part], wall: float) -> list[Check]:
    """All that a part by itself can fail."""
    out = []
    for part in parts:
        out += [*_closed(part), _wall(part, wall), *_masses(part)]
        for solid in part.solids[:1]:
            out += reaches(solid, part.name)
        for solid in part.solids:
            out += _axis(robot, solid, part)
    return out
