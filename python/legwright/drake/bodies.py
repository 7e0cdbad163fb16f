# SPDX-License-Identifier: Apache-2.0
"""Bodies and joints of the plant, from a compiled MuJoCo model."""

from dataclasses import dataclass

import mujoco
import numpy as np
from pydrake.common.eigen_geometry import Quaternion
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import (
    FixedOffsetFrame,
    Joint,
    ModelInstanceIndex,
    PrismaticJoint,
    RevoluteJoint,
    RigidBody,
    RotationalInertia,
    SpatialInertia,
)

from legwright.drake.unsupported import FREE, HINGE


@dataclass(frozen=True)
class Tree:
    """Where the plant has what the model has."""

    bodies: list[RigidBody]
    """By MuJoCo's ids, the world first."""
    joints: dict[int, Joint]
    """Hinges and slides by MuJoCo's ids."""
    free: dict[int, RigidBody]
    """What a free joint moves, by its id."""


def pose(position: np.ndarray, quaternion: np.ndarray) -> RigidTransform:
    """Of a position [m] and a quaternion (w, x, y, z), as MuJoCo has them."""
    unit = quaternion / np.linalg.norm(quaternion)
    return RigidTransform(Quaternion(unit), position)


def inertia_of(model: mujoco.MjModel, body: int) -> SpatialInertia:
    """Of a body about its origin, in its own axes."""
    if model.body_mass[body] == 0.0:
        return SpatialInertia.Zero()
    turned = RotationMatrix(pose(np.zeros(3), model.body_iquat[body]).rotation()).matrix()
    full = turned @ np.diag(model.body_inertia[body]) @ turned.T
    central = RotationalInertia(
        full[0, 0], full[1, 1], full[2, 2], full[0, 1], full[0, 2], full[1, 2]
    )
    return SpatialInertia.MakeFromCentralInertia(
        model.body_mass[body], model.body_ipos[body], central
    )


def _name(model: mujoco.MjModel, kind: str, index: int) -> str:
    """With the id, which tells those without a name apart."""
    return f'{getattr(model, kind)(index).name}#{index}'


def _add_joint(
    plant: MultibodyPlant,
    model: mujoco.MjModel,
    j: int,
    parent: FixedOffsetFrame,
    child: FixedOffsetFrame,
) -> Joint:
    """Angles count from qpos0, at which MuJoCo draws its bodies."""
    lower, upper = -np.inf, np.inf
    if model.jnt_limited[j]:
        lower, upper = model.jnt_range[j] - model.qpos0[model.jnt_qposadr[j]]
    kind = RevoluteJoint if model.jnt_type[j] == HINGE else PrismaticJoint
    return plant.AddJoint(
        kind(
            name=_name(model, 'joint', j),
            frame_on_parent=parent,
            frame_on_child=child,
            axis=model.jnt_axis[j],
            pos_lower_limit=lower,
            pos_upper_limit=upper,
            damping=float(model.dof_damping[model.jnt_dofadr[j]]),
        )
    )


def _join(
    plant: MultibodyPlant,
    instance: ModelInstanceIndex,
    model: mujoco.MjModel,
    body: int,
    tree: Tree,
) -> None:
    """A body to its parent: by its joints in their order, with massless links between them."""
    own = tree.bodies[body]
    carrier = tree.bodies[model.body_parentid[body]]
    placed = pose(model.body_pos[body], model.body_quat[body])
    first = model.body_jntadr[body]
    joints = range(first, first + model.body_jntnum[body]) if first >= 0 else range(0)
    if not joints:
        plant.WeldFrames(carrier.body_frame(), own.body_frame(), placed)
    for j in joints:
        if model.jnt_type[j] == FREE:
            tree.free[j] = own
            continue
        name = _name(model, 'joint', j)
        last = j == joints[-1]
        child = own if last else plant.AddRigidBody(f'{name} link', instance, SpatialInertia.Zero())
        anchor = RigidTransform(model.jnt_pos[j])
        above = FixedOffsetFrame(f'{name} above', carrier.body_frame(), placed @ anchor, instance)
        below = FixedOffsetFrame(f'{name} below', child.body_frame(), anchor, instance)
        frames = plant.AddFrame(above), plant.AddFrame(below)
        tree.joints[j] = _add_joint(plant, model, j, *frames)
        carrier, placed = child, RigidTransform()


def add_tree(plant: MultibodyPlant, instance: ModelInstanceIndex, model: mujoco.MjModel) -> Tree:
    """Adds all bodies and joints: mass, centre of mass, inertia, frames, axes, limits, damping."""
    tree = Tree([plant.world_body()], {}, {})
    for body in range(1, model.nbody):
        inertia = inertia_of(model, body)
        tree.bodies.append(plant.AddRigidBody(_name(model, 'body', body), instance, inertia))
    for body in range(1, model.nbody):
        _join(plant, instance, model, body, tree)
    return tree
