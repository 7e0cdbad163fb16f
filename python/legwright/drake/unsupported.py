# SPDX-License-Identifier: Apache-2.0
"""What a MuJoCo model may have and the plant has not: refused, never left out."""

from collections.abc import Iterator
from typing import Any

import mujoco
import numpy as np

from legwright._errors import InputError

HINGE, SLIDE, FREE = (
    int(mujoco.mjtJoint.mjJNT_HINGE),
    int(mujoco.mjtJoint.mjJNT_SLIDE),
    int(mujoco.mjtJoint.mjJNT_FREE),
)


class UnsupportedModel(InputError):
    """A model that the plant would not be equal to; the message names what it has."""


def named(model: mujoco.MjModel, kind: str, index: int) -> str:
    """Such as: geom 'floor', geom #3."""
    name = getattr(model, kind)(index).name
    return f'{kind} {name!r}' if name else f'{kind} #{index}'


def _joints(model: mujoco.MjModel, driven: frozenset[int]) -> Iterator[tuple[str, str]]:
    for j in range(model.njnt):
        name, kind = named(model, 'joint', j), int(model.jnt_type[j])
        dofs = slice(model.jnt_dofadr[j], model.jnt_dofadr[j] + (6 if kind == FREE else 1))
        if kind not in (HINGE, SLIDE, FREE):
            yield name, 'is a ball joint'
        elif kind != FREE and j not in driven:
            yield name, 'is moved by no servo of the gait'
        if np.any(model.jnt_stiffness[j] != 0.0):
            yield name, 'has a spring (stiffness)'
        if np.any(model.dof_frictionloss[dofs] != 0.0):
            yield name, 'has dry friction (frictionloss)'
        if kind == FREE and np.any(model.dof_armature[dofs] != 0.0):
            yield name, 'has armature on a free joint'
        if kind == FREE and np.any(model.dof_damping[dofs] != 0.0):
            yield name, 'has damping on a free joint'


def _whole(model: mujoco.MjModel) -> Iterator[tuple[str, str]]:
    def any_of(*names: str) -> bool:
        return any(np.any(np.asarray(getattr(model, name, 0.0)) != 0.0) for name in names)

    if model.neq:
        yield 'the model', 'has <equality> constraints'
    if model.nflex:
        yield 'the model', 'has flexible bodies (<flex>)'
    if any_of('tendon_stiffness', 'tendon_damping', 'tendon_frictionloss', 'tendon_armature'):
        yield 'the model', 'has tendons with stiffness, damping, friction or armature'
    if np.any(model.tendon_limited):
        yield 'the model', 'has tendons with limits'
    if any_of('dof_dampingpoly', 'jnt_stiffnesspoly'):
        yield 'the model', 'has joints whose damping or stiffness is no constant'
    if any_of('body_gravcomp'):
        yield 'the model', 'has bodies with gravity compensation (gravcomp)'
    if model.opt.density != 0.0 or model.opt.viscosity != 0.0:
        yield 'the model', 'is in a medium (density, viscosity)'
    paired = np.concatenate([model.pair_geom1, model.pair_geom2])
    if np.any(model.geom_bodyid[paired] == 0):
        yield 'the model', 'has a <pair> for contact with the ground'


def _servos(model: mujoco.MjModel, gait: Any) -> Iterator[tuple[str, str]]:
    for actuator, linear in zip(gait.actuators, gait.linear):
        if linear:
            yield named(model, 'actuator', actuator), 'pulls along a tendon (a linear actuator)'
    for actuator in sorted(set(range(model.nu)) - set(gait.actuators)):
        yield named(model, 'actuator', actuator), 'is none of the gait'


def refuse_unsupported(model: mujoco.MjModel, gait: Any) -> None:
    """Raises UnsupportedModel with all that the plant cannot have.

    Args:
        model: compiled scene.
        gait: a legwright._core.ServoGait of it.
    """
    found: dict[str, list[str]] = {}
    driven = frozenset(gait.joints)
    for part in (_whole(model), _servos(model, gait), _joints(model, driven)):
        for name, what in part:
            found.setdefault(what, []).append(name)
    if found:
        told = '; '.join(f'{", ".join(names[:3])} {what}' for what, names in found.items())
        raise UnsupportedModel(
            f"Drake's plant is built without some of what MuJoCo has, and here {told}: such a "
            'robot is validated in MuJoCo alone'
        )
