# SPDX-License-Identifier: Apache-2.0
"""A plant of Drake that is the robot of a compiled MuJoCo scene on its ground."""

import contextlib
import logging
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
from pydrake.geometry import GeometryId
from pydrake.multibody.plant import (
    AddMultibodyPlantSceneGraph,
    DiscreteContactApproximation,
    MultibodyPlant,
)
from pydrake.multibody.tree import ModelInstanceIndex, PdControllerGains
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

from legwright.drake.bodies import Tree, add_tree
from legwright.drake.ground import add_ground
from legwright.drake.unsupported import refuse_unsupported

LONGEST_STEP = 1e-3
"""[s]"""


@dataclass(frozen=True)
class Robot:
    """A finished plant, with where it has what the model has."""

    model: mujoco.MjModel
    simulator: Simulator
    plant: MultibodyPlant
    instance: ModelInstanceIndex
    tree: Tree
    geoms: dict[GeometryId, int]
    """MuJoCo's geoms that may touch the ground, by Drake's geometries."""
    substeps: int
    """Steps of the plant in one of the scene."""


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Without the warning that deformable bodies would pass through the floor: there are none."""

    def other(record: logging.LogRecord) -> bool:
        return 'deformable' not in record.getMessage()

    logger = logging.getLogger('drake')
    logger.addFilter(other)
    try:
        yield
    finally:
        logger.removeFilter(other)


def _add_servos(plant: MultibodyPlant, model: mujoco.MjModel, tree: Tree, gait: Any) -> None:
    """Implicit PD control with limits of torque, in the order of the gait's joints; the rotor's
    inertia is MuJoCo's armature."""
    for joint, kp, kd, limit in zip(gait.joints, gait.kp, gait.kd, gait.limit):
        moved = tree.joints[joint]
        servo = plant.AddJointActuator(f'{moved.name()} servo', moved, limit)
        servo.set_default_rotor_inertia(float(model.dof_armature[model.jnt_dofadr[joint]]))
        servo.set_default_gear_ratio(1.0)
        servo.set_controller_gains(PdControllerGains(p=kp, d=kd))


def build(model: mujoco.MjModel, gait: Any) -> Robot:
    """The plant of a scene: SAP contact at steps of at most LONGEST_STEP.

    Args:
        model: compiled scene, as Design.model() has it.
        gait: a legwright._core.ServoGait of the same scene.

    Raises:
        UnsupportedModel: for what the plant cannot have.
    """
    refuse_unsupported(model, gait)
    substeps = max(1, math.ceil(gait.timestep / LONGEST_STEP - 1e-9))
    builder = DiagramBuilder()
    plant, scene_graph = AddMultibodyPlantSceneGraph(builder, gait.timestep / substeps)
    plant.set_discrete_contact_approximation(DiscreteContactApproximation.kSap)
    plant.mutable_gravity_field().set_gravity_vector(np.array(model.opt.gravity))
    instance = plant.AddModelInstance('robot')
    tree = add_tree(plant, instance, model)
    geoms = add_ground(plant, scene_graph, model, tree)
    _add_servos(plant, model, tree, gait)
    plant.Finalize()
    diagram = builder.Build()
    with _quiet():
        simulator = Simulator(diagram)
    return Robot(model, simulator, plant, instance, tree, geoms, substeps)
