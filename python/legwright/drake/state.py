# SPDX-License-Identifier: Apache-2.0
"""States of the plant as MuJoCo writes them, and the other way round."""

import mujoco
import numpy as np
from pydrake.math import RotationMatrix
from pydrake.multibody.plant import MultibodyPlant

from legwright.drake.bodies import Tree, pose

Vector = np.ndarray


class StateMap:
    """Which numbers of the plant's state are which of MuJoCo's.

    Both have a free body's quaternion (w, x, y, z) and the velocity of its origin in world axes;
    its angular velocity is in world axes in Drake, in the body's own in MuJoCo.
    """

    def __init__(self, model: mujoco.MjModel, plant: MultibodyPlant, tree: Tree) -> None:
        self._model = model
        ids = list(tree.joints)
        self._mujoco_q, self._mujoco_v = model.jnt_qposadr[ids], model.jnt_dofadr[ids]
        self._drake_q = np.array([tree.joints[j].position_start() for j in ids], dtype=int)
        self._drake_v = np.array([tree.joints[j].velocity_start() for j in ids], dtype=int)
        self._zero = model.qpos0[self._mujoco_q]
        self._free = [
            (
                int(model.jnt_qposadr[j]),
                int(model.jnt_dofadr[j]),
                body.floating_positions_start(),
                body.floating_velocities_start_in_v(),
            )
            for j, body in tree.free.items()
        ]
        self._sizes = plant.num_positions(), plant.num_velocities()

    def to_drake(self, qpos: Vector, qvel: Vector) -> tuple[Vector, Vector]:
        """Positions and velocities of the plant."""
        q, v = (np.zeros(size) for size in self._sizes)
        q[self._drake_q] = qpos[self._mujoco_q] - self._zero
        v[self._drake_v] = qvel[self._mujoco_v]
        for at_q, at_v, q0, v0 in self._free:
            placed = pose(qpos[at_q : at_q + 3], qpos[at_q + 3 : at_q + 7])
            q[q0 : q0 + 4] = placed.rotation().ToQuaternion().wxyz()
            q[q0 + 4 : q0 + 7] = qpos[at_q : at_q + 3]
            v[v0 : v0 + 3] = placed.rotation().matrix() @ qvel[at_v + 3 : at_v + 6]
            v[v0 + 3 : v0 + 6] = qvel[at_v : at_v + 3]
        return q, v

    def to_mujoco(self, q: Vector, v: Vector) -> tuple[Vector, Vector]:
        """qpos and qvel."""
        qpos, qvel = np.array(self._model.qpos0), np.zeros(self._model.nv)
        qpos[self._mujoco_q] = q[self._drake_q] + self._zero
        qvel[self._mujoco_v] = v[self._drake_v]
        for at_q, at_v, q0, v0 in self._free:
            quaternion = q[q0 : q0 + 4] / np.linalg.norm(q[q0 : q0 + 4])
            turned = RotationMatrix(pose(np.zeros(3), quaternion).rotation()).matrix()
            qpos[at_q : at_q + 3] = q[q0 + 4 : q0 + 7]
            qpos[at_q + 3 : at_q + 7] = quaternion
            qvel[at_v : at_v + 3] = v[v0 + 3 : v0 + 6]
            qvel[at_v + 3 : at_v + 6] = turned.T @ v[v0 : v0 + 3]
        return qpos, qvel
