# SPDX-License-Identifier: Apache-2.0
"""A built robot as its parts are made from: links, what is printed of each, and modules on them."""

import re
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from legwright._errors import InputError
from legwright.parts._words import Array, ConnectorWords, ModuleWords, Place, read_words

_FILE_NAME = re.compile(r'[A-Za-z0-9_-][A-Za-z0-9_.-]*')


@dataclass(frozen=True)
class Shape:
    """A box, cylinder or ball of a module's outline, in the frame of the body that carries it."""

    kind: str
    size: Array
    """[m] box: half widths; cylinder: radius, half length; ball: radius."""
    position: Array
    turn: Array
    """3 x 3, body from shape."""


@dataclass(frozen=True)
class Module:
    """A module on the body that carries it, in whose frame all is."""

    words: ModuleWords
    body: int
    """That carries it: a link, or the trunk."""
    shapes: tuple[Shape, ...]
    places: tuple[Place, ...]

    @property
    def of(self) -> str:
        """Name of its body or geom, by which people find it in the file."""
        return self.words.of


@dataclass(frozen=True)
class Hull:
    """A connector: the hull of points in the frame of its link."""

    words: ConnectorWords
    points: Array
    """N x 3 [m]."""
    mass: float
    """As the file says [kg]."""


@dataclass(frozen=True)
class Link:
    """A body that turns on a servo's horn."""

    name: str
    body: int
    joint: int
    servo: Module | None
    """That turns it; it stands on the body above."""
    hulls: tuple[Hull, ...]
    modules: tuple[Module, ...]
    """On the link itself: the next servos, a foot."""


@dataclass(frozen=True)
class BuiltRobot:
    """A robot that was built from an assembly, as its file has it."""

    file: Path
    name: str
    model: mujoco.MjModel
    trunk: int
    modules: tuple[Module, ...]
    links: tuple[Link, ...]
    """That have connectors, in the order of the file."""
    bed: tuple[float, float] | None = None
    """That it was built for [m], if for any."""
    margin: float | None = None
    """That is left free at each side of it [m], where the file tells."""


_UNTURNED = 1e-6  # of a quaternion's numbers, and [rad]
_KINDS = {
    mujoco.mjtGeom.mjGEOM_BOX: ('box', 3),
    mujoco.mjtGeom.mjGEOM_CYLINDER: ('cylinder', 2),
    mujoco.mjtGeom.mjGEOM_SPHERE: ('sphere', 1),
}


def home_of(robot: BuiltRobot) -> Array:
    """Its keyframe `home`, else as drawn."""
    model = robot.model
    key = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_KEY, 'home')
    return model.key_qpos[key].copy() if key >= 0 else model.qpos0.copy()


def matrix(quat: Array) -> Array:
    """3 x 3, of a unit quaternion."""
    out = np.zeros(9)
    mujoco.mju_quat2Mat(out, quat)
    return out.reshape(3, 3)


class _Reader:
    def __init__(self, file: Path) -> None:
        self._file = file
        self._words = read_words(file)
        try:
            self._model = mujoco.MjModel.from_xml_path(str(file))
        except ValueError as error:
            raise InputError(f'{file}: {error}', str(file)) from None

    def run(self) -> BuiltRobot:
        model = self._model
        modules = tuple(self._module(words) for words in self._words.modules)
        hulls: dict[int, list[Hull]] = {}
        for words in self._words.connectors:
            body, hull = self._hull(words)
            hulls.setdefault(body, []).append(hull)
        links = tuple(self._link(body, hulls[body], modules) for body in sorted(hulls))
        trunks = [each for each in modules if each.words.kind == 'trunk']
        if len(trunks) != 1:
            raise self._error('', f'has {len(trunks)} modules of the kind trunk; expected one')
        name = model.names[: model.names.index(b'\0')].decode() or self._file.stem
        bed, margin = self._words.bed, self._words.margin
        return BuiltRobot(self._file, name, model, trunks[0].body, modules, links, bed, margin)

    def _error(self, where: str, message: str) -> InputError:
        text = f'{self._file}: {where}: {message}' if where else f'{self._file}: {message}'
        return InputError(text, str(self._file), 0, where, message)

    def _id(self, kind: mujoco.mjtObj, name: str, where: str) -> int:
        found = mujoco.mj_name2id(self._model, kind, name)
        if found < 0:
            raise self._error(where, f"names '{name}', which is not there; build the robot anew")
        return found

    def _module(self, words: ModuleWords) -> Module:
        model, where = self._model, f'text legwright_module/{words.of}'
        if words.joint is not None:
            self._id(mujoco.mjtObj.mjOBJ_JOINT, words.joint, where)
        if words.sort == 'geom':
            geom = self._id(mujoco.mjtObj.mjOBJ_GEOM, words.of, where)
            body = int(model.geom_bodyid[geom])
            shift, turn = model.geom_pos[geom].copy(), np.eye(3)
            geoms = [
                g
                for g in range(model.ngeom)
                if model.geom_bodyid[g] == body and self._is_shape_of(g, words.of)
            ]
            carrier = body
        else:
            body = self._id(mujoco.mjtObj.mjOBJ_BODY, words.of, where)
            geoms = [g for g in range(model.ngeom) if model.geom_bodyid[g] == body]
            carrier, shift, turn = body, np.zeros(3), np.eye(3)
            if words.kind != 'trunk':
                if model.body_jntnum[body]:
                    raise self._error(where, 'is of a body with a joint; a module has none')
                carrier = int(model.body_parentid[body])
                shift, turn = model.body_pos[body].copy(), matrix(model.body_quat[body])
        of_geom = words.sort == 'geom'
        shapes = [
            self._shape(g, np.zeros(3) if of_geom else shift, turn, where) for g in geoms
        ]
        places = tuple(
            Place(
                place.name,
                place.on_horn,
                shift + turn @ place.position,
                turn @ place.normal,
                place.screw,
                shift + place.holes @ turn.T,
            )
            for place in words.places
        )
        return Module(words, carrier, tuple(shapes), places)

    def _is_shape_of(self, geom: int, name: str) -> bool:
        """A foot's shapes are called NAME, NAME_2, …"""
        own = mujoco.mj_id2name(self._model, mujoco.mjtObj.mjOBJ_GEOM, geom) or ''
        return own == name or (own.startswith(f'{name}_') and own[len(name) + 1 :].isdigit())

    def _shape(self, geom: int, shift: Array, turn: Array, where: str) -> Shape:
        model = self._model
        kind, count = _KINDS.get(mujoco.mjtGeom(model.geom_type[geom]), ('', 0))
        if not kind:
            raise self._error(where, 'has a geom that is no box, cylinder or ball')
        return Shape(
            kind,
            model.geom_size[geom, :count].copy(),
            shift + turn @ model.geom_pos[geom],
            turn @ matrix(model.geom_quat[geom]),
        )

    def _hull(self, words: ConnectorWords) -> tuple[int, Hull]:
        model, where = self._model, f'text legwright_connector/{words.name}'
        body = self._id(mujoco.mjtObj.mjOBJ_BODY, words.name, where)
        if model.body_jntnum[body]:
            raise self._error(where, 'is of a body with a joint; a connector has none')
        if not model.body_mass[body] > 0:
            raise self._error(where, 'is of a body without mass; build the robot anew')
        points = model.body_pos[body] + words.corners @ matrix(model.body_quat[body]).T
        return int(model.body_parentid[body]), Hull(words, points, float(model.body_mass[body]))

    def _link(self, body: int, hulls: list[Hull], modules: tuple[Module, ...]) -> Link:
        model = self._model
        name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, body) or f'body {body}'
        if not _FILE_NAME.fullmatch(name) or name.lower() in ('trunk', 'all'):
            message = 'names a part and its file: expected letters, digits, _ and -, and not trunk'
            raise self._error(f'body {name}', f'{message} or all; rename it')
        if model.body_jntnum[body] != 1:
            raise self._error(f'body {name}', 'carries connectors; expected one hinge on it')
        joint = int(model.body_jntadr[body])
        self._check_frame(name, body, joint)
        joint_name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_JOINT, joint)
        servo = next((m for m in modules if m.words.joint == joint_name), None)
        own = tuple(module for module in modules if module.body == body)
        return Link(name, body, joint, servo, tuple(hulls), own)


    def _check_frame(self, name: str, body: int, joint: int) -> None:
        """Holes and seats are told from the horn, so a link stands there unturned at zero."""
        model, cure = self._model, 'put back what `legwright build` wrote'
        if np.abs(model.body_quat[body] - [1, 0, 0, 0]).max() > _UNTURNED:
            raise self._error(
                f'body {name}',
                f'is turned against the body above (quat, euler, …); a link that is printed has '
                f'the axes of its servo: {cure}',
            )
        if model.jnt_type[joint] != mujoco.mjtJoint.mjJNT_HINGE:
            raise self._error(f'body {name}', f'has a joint that is no hinge: {cure}')
        if abs(model.qpos0[model.jnt_qposadr[joint]]) > _UNTURNED:
            raise self._error(
                f'body {name}',
                f'has a joint with ref; a link that is printed is drawn with its joint at zero: '
                f'{cure}',
            )


def read_built(file: Path) -> BuiltRobot:
    """Reads the MJCF of a robot that `legwright build` wrote, at whatever design it is.

    Raises IoError and InputError, with what to do.
    """
    return _Reader(file).run()
