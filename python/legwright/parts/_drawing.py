# SPDX-License-Identifier: Apache-2.0
"""A scene for a picture: modules, parts, screws, lines and numbers, each where it is put.

The program draws it from one side; right, up and away are those of that picture.
"""

import math
from collections.abc import Sequence
from xml.sax.saxutils import quoteattr

import mujoco
import numpy as np
from manifold3d import Manifold

from legwright.parts._digits import strokes, width
from legwright.parts._holes import Hole
from legwright.parts._labels import GAP, RIGHT, UP, Label
from legwright.parts._robot import BuiltRobot, Module, home_of
from legwright.parts._shapes import MM
from legwright.parts._solids import Part, Solid
from legwright.parts._straps import Strap
from legwright.parts._words import Array

_COLOURS = {
    'printed': '0.93 0.62 0.2 1',
    'servo': '0.24 0.27 0.32 1',
    'foot': '0.1 0.1 0.11 1',
    'trunk': '0.08 0.52 0.52 1',
    'screw': '0.75 0.77 0.8 1',
    'tie': '0.12 0.12 0.13 1',
}
_HORN, _RIM, _HORN_HIGH = 0.003, 0.0015, 0.0015  # [m] of its screws, around them, and its height
_BRASS = '0.8 0.66 0.3 1'
_OTHER, _LINE, _INK = '0.35 0.4 0.5 1', '0.45 0.45 0.45 1', '0.75 0.1 0.1 1'


def _words(values: Array) -> str:
    return ' '.join(f'{value + 0.0:.6g}' for value in np.ravel(values))


def _rod(start: Array, end: Array, radius: float, colour: str, kind: str = 'capsule') -> str:
    if np.linalg.norm(end - start) < 1e-4:
        return ''
    return (
        f'      <geom type="{kind}" size="{radius:g}" fromto="{_words(start)} {_words(end)}" '
        f'rgba="{colour}"/>\n'
    )


def _mesh(name: str, shape: Manifold) -> str:
    mesh = shape.to_mesh64()
    vertices = np.asarray(mesh.vert_properties)[:, :3] / MM
    faces = ' '.join(str(k) for k in np.asarray(mesh.tri_verts).ravel())
    return f'    <mesh name="{name}" vertex="{_words(vertices)}" face="{faces}"/>\n'


class Drawing:
    """A scene of a robot in its home pose, all of it turned (3 x 3) about the world's origin."""

    def __init__(self, robot: BuiltRobot, turn: Array | None = None) -> None:
        self._robot = robot
        self._turn = np.eye(3) if turn is None else turn
        self._data = mujoco.MjData(robot.model)
        self._data.qpos[:] = home_of(robot)
        mujoco.mj_kinematics(robot.model, self._data)
        self._assets: dict[str, str] = {}
        self._geoms: list[str] = []

    def world(self, body: int, point: Array) -> Array:
        """A point of a body, or N x 3 of them [m]."""
        frame = self._data.xmat[body].reshape(3, 3)
        return (self._data.xpos[body] + point @ frame.T) @ self._turn.T

    def turn_of(self, body: int) -> Array:
        """World from body (3 x 3)."""
        return self._turn @ self._data.xmat[body].reshape(3, 3)

    def corners(self, module: Module) -> Array:
        """Of the boxes around a module's shapes, N x 3 [m]."""
        out = []
        for shape in module.shapes:
            half = {'box': shape.size, 'sphere': np.repeat(shape.size, 3)}.get(shape.kind)
            if half is None:
                half = np.array([shape.size[0], shape.size[0], shape.size[1]])
            signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
            out.append(shape.position + (signs * half) @ shape.turn.T)
        return self.world(module.body, np.vstack(out))

    def corners_of_part(self, solid: Solid) -> Array:
        """Its corners, N x 3 [m]."""
        mesh = solid.shape.to_mesh64()
        points = np.asarray(mesh.vert_properties)[:, :3] / MM
        return self.world(solid.link.body, points)

    def module(self, module: Module, shift: Array) -> None:
        """A module, moved from where it belongs."""
        colour = _COLOURS.get(module.words.kind, _OTHER)
        for shape in module.shapes:
            quat = np.zeros(4)
            mujoco.mju_mat2Quat(quat, (self.turn_of(module.body) @ shape.turn).ravel())
            place = self.world(module.body, shape.position) + shift
            self._geoms.append(
                f'      <geom type="{shape.kind}" size="{_words(shape.size)}" '
                f'pos="{_words(place)}" quat="{_words(quat)}" rgba="{colour}"/>\n'
            )

        for horn in (place for place in module.places if place.on_horn):
            out = np.linalg.norm(horn.holes - horn.position, axis=1).max(initial=_HORN)
            foot = self.world(module.body, horn.position) + shift
            tip = foot + _HORN_HIGH * self.turn_of(module.body) @ horn.normal
            self._geoms.append(_rod(foot, tip, float(out) + _RIM, _BRASS, 'cylinder'))

    def part(self, part: Part, solid: Solid, shift: Array) -> None:
        """One of a part's solids, moved from where it belongs."""
        name = f'part_{part.number}'
        colour = _COLOURS['printed' if solid.link.servo else 'trunk']
        self._shape(name, part.solid.shape, solid.link.body, shift, colour)

    def tie(self, body: int, strap: Strap, shift: Array) -> None:
        """A cable tie around a module."""
        self._shape(f'tie_{strap.module.of}', strap.tie, body, shift, _COLOURS['tie'])

    def _shape(self, name: str, shape: Manifold, body: int, shift: Array, colour: str) -> None:
        self._assets.setdefault(name, _mesh(name, shape))
        quat = np.zeros(4)
        mujoco.mju_mat2Quat(quat, self.turn_of(body).ravel())
        place = self.world(body, np.zeros(3)) + shift
        self._geoms.append(
            f'      <geom type="mesh" mesh="{name}" pos="{_words(place)}" quat="{_words(quat)}" '
            f'rgba="{colour}"/>\n'
        )

    def screw(self, body: int, hole: Hole, shift: Array, out: float) -> None:
        """A screw before its hole, as far out as that [m]; so long that it goes through."""
        place = self.world(body, (hole.start + hole.seat * hole.axis) / MM) + shift
        along = self.turn_of(body) @ hole.axis
        seat = place + out * along
        length, nominal = (hole.seat + 2 * hole.screw.nominal) / MM, hole.screw.nominal / MM
        head = seat + hole.screw.height / MM * along
        tip = seat - length * along
        radius = hole.screw.head / 2 / MM
        self._geoms += [
            _rod(seat, head, radius, _COLOURS['screw'], 'cylinder'),
            _rod(tip, seat, nominal / 2, _COLOURS['screw'], 'cylinder'),
            _rod(place, tip, 0.0003, _LINE),
        ]

    def line(self, start: Array, end: Array, radius: float = 0.0006) -> None:
        """A thin one."""
        self._geoms.append(_rod(start, end, radius, _LINE))

    def label(self, label: Label) -> None:
        """A number that faces the camera, with a line to what it is of."""
        height, corner = label.height, label.corner
        wide = width(label.number, height, GAP * height)
        middle = corner + wide / 2 * RIGHT + height / 2 * UP
        way = label.target - middle
        x, y = abs(float(way @ RIGHT)), abs(float(way @ UP))
        free = max(x / (wide / 2 + 0.25 * height), y / (0.75 * height), 1e-9)  # out of its box
        if free > 1:
            self._geoms.append(_rod(middle + way / free, label.target, 0.03 * height, _INK))
        self._geoms.append(
            f'      <geom type="sphere" size="{0.09 * height:.6g}" pos="{_words(label.target)}" '
            f'rgba="{_INK}"/>\n'
        )
        for stroke in strokes(label.number, height, GAP * height):
            a, b = (corner + x * RIGHT + y * UP for x, y in (stroke.start, stroke.end))
            self._geoms.append(_rod(a, b, 0.08 * height, _INK))

    def text(self) -> str:
        """The scene as MJCF."""
        assets, geoms = ''.join(self._assets.values()), ''.join(self._geoms)
        return (
            '<!-- A robot moved apart: `legwright parts` draws it. Metres. -->\n'
            f'<mujoco model={quoteattr(self._robot.name)}>\n'
            '  <compiler angle="radian"/>\n  <asset>\n'
            '    <texture type="skybox" builtin="gradient" rgb1="0.97 0.98 1" rgb2="0.8 0.84 0.9" '
            f'width="64" height="64"/>\n{assets}  </asset>\n  <worldbody>\n'
            f'    <body pos="0 0 0">\n      <freejoint/>\n{geoms}    </body>\n'
            '  </worldbody>\n</mujoco>\n'
        )


def spread(rows: Sequence[tuple[Array, Array]], gap: float, along: Array) -> list[Array]:
    """How far each of a row of things must be moved along a direction to stand behind the last.

    @param rows of each thing its corners (N x 3), and where it is first moved to
    """
    out: list[Array] = []
    end = -math.inf
    for corners, first in rows:
        places = (corners + first) @ along
        by = max(0.0, end + gap - float(places.min())) if out else 0.0
        out.append(first + by * along)
        end = max(end, float(places.max()) + by)
    return out
