# SPDX-License-Identifier: Apache-2.0
"""The exploded view: a scene in which parts and modules stand apart, with numbers on them."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from xml.sax.saxutils import quoteattr

import mujoco
import numpy as np

from legwright.parts._digits import strokes
from legwright.parts._robot import BuiltRobot, Module, Shape, home_of
from legwright.parts._shapes import MM
from legwright.parts._solids import Part, Solid
from legwright.parts._words import Array

_APART = 1.0  # times the way from the trunk's middle: how far things are moved out
_ALONG = 0.03  # [m], besides, of a part along the horn that it is screwed to
_AZIMUTH, _ELEVATION = math.radians(215.0), math.radians(-16.0)  # of the picture, by the program
_BEFORE = 0.06  # [m]: numbers stand nearer to the camera than what they are of
_DIGIT = 0.024  # of the size of all: height of a number
_COLOURS = {
    'printed': '0.93 0.62 0.2 1',
    'servo': '0.24 0.27 0.32 1',
    'foot': '0.1 0.1 0.11 1',
    'trunk': '0.08 0.52 0.52 1',
}
_OTHER, _LINE, _INK = '0.35 0.4 0.5 1', '0.45 0.45 0.45 1', '0.75 0.1 0.1 1'


def _words(values: Array) -> str:
    return ' '.join(f'{value + 0.0:.6g}' for value in np.ravel(values))


def _rod(start: Array, end: Array, radius: float, colour: str) -> str:
    if np.linalg.norm(end - start) < 1e-4:
        return ''
    return (
        f'      <geom type="capsule" size="{radius:g}" fromto="{_words(start)} {_words(end)}" '
        f'rgba="{colour}"/>\n'
    )


@dataclass(frozen=True)
class _Item:
    """Something that is moved out."""

    body: int
    middle: Array
    """In the world, where it belongs [m]."""
    shift: Array
    """By how much it is moved [m]."""


class _Scene:
    def __init__(self, robot: BuiltRobot, parts: Sequence[Part], numbers: Mapping[str, int]):
        self._robot, self._parts, self._numbers = robot, parts, numbers
        self._data = mujoco.MjData(robot.model)
        self._data.qpos[:] = home_of(robot)
        mujoco.mj_kinematics(robot.model, self._data)
        self._centre = self._data.xpos[robot.trunk].copy()
        self._assets: list[str] = []
        self._geoms: list[str] = []
        self._digit = _DIGIT * self._size()
        self._told: set[str] = set()
        self._printed = {solid.link.body for part in parts for solid in part.solids}

    def run(self) -> str:
        modules = {id(module): self._module(module) for module in self._robot.modules}
        for number, part in enumerate(self._parts):
            self._assets.append(_mesh(f'part_{number}', part.solid))
            for solid in part.solids:
                item = self._part(f'part_{number}', part, solid)
                for fixing in solid.fixings if solid.link.servo else ():
                    self._line(item, modules[id(fixing.module)], solid, fixing.position)
        assets = ''.join(self._assets)
        geoms = ''.join(self._geoms)
        return (
            '<!-- A robot moved apart: `legwright parts` draws it. Metres. -->\n'
            f'<mujoco model={quoteattr(self._robot.name)}>\n'
            '  <compiler angle="radian"/>\n  <asset>\n'
            '    <texture type="skybox" builtin="gradient" rgb1="0.97 0.98 1" rgb2="0.8 0.84 0.9" '
            f'width="64" height="64"/>\n{assets}  </asset>\n  <worldbody>\n'
            f'    <body pos="0 0 0">\n      <freejoint/>\n{geoms}    </body>\n'
            '  </worldbody>\n</mujoco>\n'
        )

    def _size(self) -> float:
        """Across the robot when it is moved apart [m]."""
        places = np.array([self._middle(module) for module in self._robot.modules])
        return (1 + _APART) * float(np.linalg.norm(np.ptp(places, axis=0)))

    def _middle(self, module: Module) -> Array:
        return self._world(module.body, np.mean([s.position for s in module.shapes], axis=0))

    def _world(self, body: int, point: Array) -> Array:
        return self._data.xpos[body] + self._data.xmat[body].reshape(3, 3) @ point

    def _turn(self, body: int) -> Array:
        return self._data.xmat[body].reshape(3, 3)

    def _module(self, module: Module) -> _Item:
        middle = self._middle(module)
        shift = _APART * (middle - self._centre)
        item = _Item(module.body, middle, shift)
        if module.words.kind == 'trunk' and module.body in self._printed:
            return item
        for shape in module.shapes:
            self._geoms.append(self._shape(module, shape, shift))
        if module.words.name not in self._told:
            self._told.add(module.words.name)
            self._number(f'{module.words.kind} {module.words.name}', middle + shift)
        return item

    def _shape(self, module: Module, shape: Shape, shift: Array) -> str:
        quat = np.zeros(4)
        mujoco.mju_mat2Quat(quat, (self._turn(module.body) @ shape.turn).ravel())
        place = self._world(module.body, shape.position) + shift
        colour = _COLOURS.get(module.words.kind, _OTHER)
        return (
            f'      <geom type="{shape.kind}" size="{_words(shape.size)}" pos="{_words(place)}" '
            f'quat="{_words(quat)}" rgba="{colour}"/>\n'
        )

    def _part(self, mesh: str, part: Part, solid: Solid) -> _Item:
        body = solid.link.body
        box = np.array(solid.shape.bounding_box()) / MM
        middle = self._world(body, (box[:3] + box[3:]) / 2)
        horns = [f.normal for f in solid.fixings if f.place.on_horn]
        along = self._turn(body) @ horns[0] if horns else np.zeros(3)
        shift = _APART * (middle - self._centre) + _ALONG * along
        quat = np.zeros(4)
        mujoco.mju_mat2Quat(quat, self._turn(body).ravel())
        place = self._data.xpos[body] + shift
        self._geoms.append(
            f'      <geom type="mesh" mesh="{mesh}" pos="{_words(place)}" quat="{_words(quat)}" '
            f'rgba="{_COLOURS["printed" if solid.link.servo else "trunk"]}"/>\n'
        )
        corner = np.zeros(3) if solid.link.servo else (box[3:] - box[:3]) * [0.35, 0, 0]
        self._number(f'printed {part.name}', middle + shift + corner)
        return _Item(body, middle, shift)

    def _line(self, item: _Item, module: _Item, solid: Solid, position: Array) -> None:
        """From an attachment on its module to where the part has it."""
        place = self._world(solid.link.body, position)
        self._geoms.append(_rod(place + module.shift, place + item.shift, 0.0006, _LINE))

    def _number(self, key: str, place: Array) -> None:
        """The number of a row of the bill, beside and before a thing, towards the camera."""
        c, s = math.cos(_ELEVATION), math.sin(_ELEVATION)
        ahead = np.array([c * math.cos(_AZIMUTH), c * math.sin(_AZIMUTH), s])
        right = np.array([math.sin(_AZIMUTH), -math.cos(_AZIMUTH), 0.0])
        up = np.cross(right, ahead)
        size = self._digit
        before = place - _BEFORE * ahead
        corner = before + 1.4 * size * right + 0.9 * size * up
        self._geoms.append(_rod(before, corner, 0.04 * size, _INK))
        corner = corner + 0.3 * size * right
        for stroke in strokes(self._numbers[key], size, 0.3 * size):
            a, b = (corner + x * right + y * up for x, y in (stroke.start, stroke.end))
            self._geoms.append(_rod(a, b, 0.08 * size, _INK))


def _mesh(name: str, solid: Solid) -> str:
    mesh = solid.shape.to_mesh64()
    vertices = np.asarray(mesh.vert_properties)[:, :3] / MM
    faces = ' '.join(str(k) for k in np.asarray(mesh.tri_verts).ravel())
    return f'    <mesh name="{name}" vertex="{_words(vertices)}" face="{faces}"/>\n'


def exploded_scene(robot: BuiltRobot, parts: Sequence[Part], numbers: Mapping[str, int]) -> str:
    """MJCF of a robot in its home pose whose modules and parts are moved away from the trunk.

    Lines go from attachments to where parts have them; numbers are those of the bill's rows, by
    their keys: of parts on each, of modules on the first.
    """
    return _Scene(robot, parts, numbers).run()
