# SPDX-License-Identifier: Apache-2.0
"""Plays a gait in Drake, step by step, as legwright._core.validate_in_engine asks for it."""

import importlib.metadata
from typing import Any

import mujoco
import numpy as np

from legwright.drake.plant import build
from legwright.drake.state import StateMap

VERSION = importlib.metadata.version('drake')

Step = tuple[np.ndarray, np.ndarray, np.ndarray, dict[int, np.ndarray]]


class Player:
    """A roll-out from the keyframe of the gait on.

    The servos get targets, their velocities and feed-forward torques of the *end* of a step: their
    PD control is solved together with the contacts for the state that the step ends in.
    """

    def __init__(self, model: mujoco.MjModel, gait: Any) -> None:
        """Raises UnsupportedModel. `gait` is a legwright._core.ServoGait of the model."""
        self._gait, self._joints = gait, len(gait.joints)
        self._robot = robot = build(model, gait)
        self._states = StateMap(model, robot.plant, robot.tree)
        self._simulator = robot.simulator
        self._context = robot.plant.GetMyMutableContextFromRoot(
            self._simulator.get_mutable_context()
        )
        self._desired = robot.plant.get_desired_state_input_port(robot.instance)
        self._feed_forward = robot.plant.get_actuation_input_port(robot.instance)
        self._zero = model.qpos0[model.jnt_qposadr[gait.joints]]
        key = model.key('gait')
        q, v = self._states.to_drake(key.qpos, key.qvel)
        robot.plant.SetPositions(self._context, q)
        robot.plant.SetVelocities(self._context, v)
        self._command(0.0)
        self._simulator.Initialize()

    def _command(self, time: float) -> None:
        target, velocity, torque = self._gait.command(time)
        self._desired.FixValue(self._context, np.concatenate([target - self._zero, velocity]))
        self._feed_forward.FixValue(self._context, torque)

    def _ground_forces(self) -> dict[int, np.ndarray]:
        """On the robot's geoms during the last step, world axes [N]."""
        geoms = self._robot.geoms
        results = self._robot.plant.get_contact_results_output_port().Eval(self._context)
        forces: dict[int, np.ndarray] = {}
        for k in range(results.num_point_pair_contacts()):
            contact = results.point_pair_contact_info(k)
            pair, force = contact.point_pair(), contact.contact_force()
            geom = geoms.get(pair.id_B)
            if geom is None:
                geom, force = geoms[pair.id_A], -force
            forces[geom] = forces.get(geom, np.zeros(3)) + force
        return forces

    def _state(self) -> tuple[np.ndarray, np.ndarray]:
        plant = self._robot.plant
        return self._states.to_mujoco(
            plant.GetPositions(self._context), plant.GetVelocities(self._context)
        )

    def step(self, time: float) -> Step:
        """Plays from a time [s] on for one time step of the scene.

        Returns:
            qpos and qvel at its end, torques of the servos [N m] in the order of the gait's joints,
            and the ground's force on each geom [N] by id, the latter two of its last part. Not
            finite where Drake gives up.
        """
        gait, substeps = self._gait, self._robot.substeps
        try:
            for k in range(1, substeps + 1):
                end = time + gait.timestep * k / substeps
                self._command(end)
                self._simulator.AdvanceTo(end)
        except RuntimeError:  # its solver found no step, or a number is none
            model = self._robot.model
            return np.full(model.nq, np.nan), np.zeros(model.nv), np.zeros(self._joints), {}
        qpos, qvel = self._state()
        torque = self._robot.plant.get_net_actuation_output_port().Eval(self._context)
        return qpos, qvel, np.array(torque), self._ground_forces()
