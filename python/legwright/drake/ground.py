# SPDX-License-Identifier: Apache-2.0
"""The ground of the plant and what of the robot may touch it."""

import mujoco
import numpy as np
from pydrake.geometry import (
    AddContactMaterial,
    CollisionFilterDeclaration,
    Cylinder,
    Ellipsoid,
    GeometryId,
    GeometrySet,
    HalfSpace,
    ProximityProperties,
    SceneGraph,
    Shape,
    Sphere,
)
from pydrake.math import RigidTransform
from pydrake.multibody.plant import CoulombFriction, MultibodyPlant

from legwright.drake.bodies import Tree, pose
from legwright.drake.unsupported import UnsupportedModel, named

STIFFNESS = 1e5
"""Of a contact [N/m], unless all the weight on one would sink in by more than SINK."""
SINK = 1e-3
"""[m]"""
RELAXATION = 0.01
"""Of a contact [s]: what brakes a foot that sinks in."""

PLANE, SPHERE, CAPSULE, BOX, CYLINDER, ELLIPSOID, MESH = (
    int(getattr(mujoco.mjtGeom, f'mjGEOM_{name}'))
    for name in ('PLANE', 'SPHERE', 'CAPSULE', 'BOX', 'CYLINDER', 'ELLIPSOID', 'MESH')
)


def _may_touch(model: mujoco.MjModel, one: int, other: int) -> bool:
    return bool(
        model.geom_contype[one] & model.geom_conaffinity[other]
        or model.geom_contype[other] & model.geom_conaffinity[one]
    )


def _excluded(model: mujoco.MjModel, body: int) -> bool:
    """Whether <exclude> keeps a body and the world apart."""
    return any(body == signature for signature in model.exclude_signature)


def floor_of(model: mujoco.MjModel) -> tuple[int, list[int]]:
    """The plane that robot and world have in common, and the robot's geoms that may touch it.

    Raises UnsupportedModel where the robot may touch anything else of the world.
    """
    fixed = [g for g in range(model.ngeom) if model.body_weldid[model.geom_bodyid[g]] == 0]
    moving = [
        g
        for g in range(model.ngeom)
        if g not in fixed and not _excluded(model, int(model.geom_bodyid[g]))
    ]
    met = {g: [m for m in moving if _may_touch(model, g, m)] for g in fixed}
    met = {g: touching for g, touching in met.items() if touching}
    others = [g for g in met if model.geom_type[g] != PLANE]
    if others or len(met) != 1:
        found = ', '.join(named(model, 'geom', g) for g in others or met) or 'none'
        raise UnsupportedModel(
            'Drake plays on one plane, level or sloped, and what of the world this robot may touch '
            f'is {found}: steps and height fields are for MuJoCo alone'
        )
    return next(iter(met.items()))


def friction_of(model: mujoco.MjModel, one: int, other: int) -> float:
    """Sliding friction of a contact by MuJoCo's rule: higher priority, else the larger."""
    mine, its = model.geom_priority[one], model.geom_priority[other]
    if mine == its:
        return float(max(model.geom_friction[one, 0], model.geom_friction[other, 0]))
    return float(model.geom_friction[one if mine > its else other, 0])


def _hull(model: mujoco.MjModel, geom: int) -> np.ndarray:
    """Corners of the convex hull of a mesh, in the geom's frame; k x 3 [m]."""
    mesh = int(model.geom_dataid[geom])
    first, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
    points = np.array(model.mesh_vert[first : first + count], dtype=float)
    graph = model.mesh_graphadr[mesh]
    if graph < 0:  # MuJoCo has no hull of it: no corner is left out
        return points
    corners = model.mesh_graph[graph]
    ids = graph + 2 + corners  # behind the two counts and where the edges of each corner begin
    return points[model.mesh_graph[ids : ids + corners]]


def shapes_of(model: mujoco.MjModel, geom: int) -> list[tuple[RigidTransform, Shape]]:
    """What touches a plane where the geom does, in the geom's frame.

    A capsule touches it with the balls at its ends, boxes and meshes with the corners of their
    convex hulls, exactly; cylinders and ellipsoids do at one point at a time, the deepest.
    """
    kind, size = int(model.geom_type[geom]), model.geom_size[geom]
    here = RigidTransform()
    if kind == SPHERE:
        return [(here, Sphere(size[0]))]
    if kind == CAPSULE:
        return [(RigidTransform([0, 0, side * size[1]]), Sphere(size[0])) for side in (-1, 1)]
    if kind == BOX:
        corners = np.array(np.meshgrid(*[(-1, 1)] * 3)).reshape(3, 8).T * size
        return [(RigidTransform(corner), Sphere(0.0)) for corner in corners]
    if kind == CYLINDER:
        return [(here, Cylinder(size[0], 2 * size[1]))]
    if kind == ELLIPSOID:
        return [(here, Ellipsoid(*size))]
    if kind == MESH:
        return [(RigidTransform(point), Sphere(0.0)) for point in _hull(model, geom)]
    raise UnsupportedModel(
        f'{named(model, "geom", geom)} may touch the ground and is neither sphere, capsule, box, '
        'cylinder, ellipsoid nor mesh, which is what Drake is given'
    )


def _material(stiffness: float, relaxation: float, friction: float) -> ProximityProperties:
    """Two bodies of stiffness 2k have one of k between them; relaxation times add up."""
    properties = ProximityProperties()
    AddContactMaterial(
        point_stiffness=2 * stiffness,
        friction=CoulombFriction(friction, friction),
        properties=properties,
    )
    properties.AddProperty('material', 'relaxation_time', relaxation)
    return properties


def add_ground(
    plant: MultibodyPlant, scene_graph: SceneGraph, model: mujoco.MjModel, tree: Tree
) -> dict[GeometryId, int]:
    """Adds the floor as a half space, and what may touch it. Returns MuJoCo's geoms by Drake's."""
    floor, touching = floor_of(model)
    weight = float(model.body_mass.sum() * np.linalg.norm(model.opt.gravity))
    stiffness = max(STIFFNESS, weight / SINK)
    frictions = {geom: friction_of(model, floor, geom) for geom in touching}
    most = max(frictions.values())
    body = int(model.geom_bodyid[floor])
    placed = pose(model.geom_pos[floor], model.geom_quat[floor])
    plant.RegisterCollisionGeometry(
        tree.bodies[body], placed, HalfSpace(), 'floor', _material(stiffness, 0.0, most)
    )
    geoms: dict[GeometryId, int] = {}
    for geom in touching:
        # Drake takes 2 a b / (a + b) of two frictions, and the floor's is the greatest wanted.
        wanted = frictions[geom]
        own = _material(stiffness, RELAXATION, wanted * most / (2 * most - wanted) if most else 0.0)
        at = pose(model.geom_pos[geom], model.geom_quat[geom])
        for k, (offset, shape) in enumerate(shapes_of(model, geom)):
            added = plant.RegisterCollisionGeometry(
                tree.bodies[model.geom_bodyid[geom]], at @ offset, shape, f'{geom}.{k}', own
            )
            geoms[added] = geom
    scene_graph.collision_filter_manager().Apply(
        CollisionFilterDeclaration().ExcludeWithin(GeometrySet(list(geoms)))
    )
    return geoms
