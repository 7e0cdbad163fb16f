# SPDX-License-Identifier: Apache-2.0
"""The stored documents: made, written, read and compared."""

import json
import pathlib

import derivatives
import equipment
import numpy as np
import robot
import sampling
from motion import Layout
from task import FOOTPRINT

DATA = pathlib.Path(__file__).resolve().parent / 'data'
SCHEMA, VERSION = 'legwright/oracle-samples', 2
# Of a number to itself, of a list's entry to the list's largest. Residuals of a plan are small
# differences of large numbers, so their gradients show how a processor rounds sines.
TOLERANCE, PLAN_TOLERANCE = 1e-11, 1e-8


def path_of(task, folder=DATA):
    return folder / f'{task.name}.json'


def read(path):
    return json.loads(path.read_text(encoding='utf-8'))


def write(path, document):
    """As the shortest text that reads back as the same float64."""
    text = json.dumps(document, allow_nan=False, separators=(',', ':'))
    path.write_text(text + '\n', encoding='utf-8')


def split_design(s):
    out = dict(
        lengths=s[:12].reshape(4, 3).tolist(),
        axes=s[12:48].reshape(4, 3, 3).tolist(),
        body_width=float(s[48]),
        body_length=float(s[49]),
    )
    return {**out, 'piston_lower': s[50:].tolist()} if s.size > 50 else out


def join_design(design):
    return np.concatenate(
        [
            np.ravel(design['lengths']),
            np.ravel(design['axes']),
            [design['body_width'], design['body_length']],
            design.get('piston_lower', []),
        ]
    )


def settings(task, layout):
    out = dict(
        period=task.period,
        phase=list(task.phase),
        duty=task.duty,
        velocity=list(task.velocity),
        turn_rate=task.turn_rate,
        up=task.up.tolist(),
        knots=task.knots,
        planted_margin=task.planted_margin,
        contact=task.contact.astype(int).tolist(),
        com_height=task.com_height,
        footprint=FOOTPRINT.tolist(),
        follow_hips=task.follow_hips,
        swing_height=task.swing_height,
        friction=task.friction,
        min_normal=task.min_normal,
        barrier_edge=task.barrier_edge,
        weights=task.weights,
        gravity=robot.GRAVITY,
        sides=[list(c) for c in robot.SIDES],
        nominal=robot.NOMINAL.tolist(),
        mass=task.robot.mass,
        leg_length=robot.LEG_LENGTH,
        body_mass=robot.BODY_MASS,
        body_height=robot.BODY_HEIGHT,
        motor_mass=robot.MOTOR_MASS,
        link_density=robot.LINK_DENSITY,
        foot_mass=robot.FOOT_MASS,
        foot_radius=robot.FOOT_RADIUS,
        initial_design=split_design(task.robot.initial_design()),
        motion_size=layout.size,
        slots=layout.slots(),
    )
    if task.robot.equipped:
        out['equipment'] = equipment_settings(task)
    return out


def equipment_settings(task):
    """null where there is no limit."""

    def finite(values):
        return [float(x) if np.isfinite(x) else None for x in values]

    return dict(
        payload=equipment.PAYLOAD,
        joint_lower=finite(equipment.JOINT_LOWER),
        joint_upper=finite(equipment.JOINT_UPPER),
        torque_limit=finite(equipment.TORQUE_LIMIT),
        armature=finite(equipment.ARMATURE),
        damping=finite(equipment.DAMPING),
        stiffness=finite(equipment.STIFFNESS),
        slack_angle=finite(equipment.SLACK_ANGLE),
        friction_loss=finite(equipment.FRICTION_LOSS),
        joint_margin=task.joint_margin,
        torque_margin=task.torque_margin,
        clearance=task.clearance,
        com_heights=task.com_heights.tolist(),
        com_path=task.com_path.tolist(),
        foot_targets=[
            task.foot_targets[j].tolist() if j in task.foot_targets else [] for j in range(4)
        ],
        foot_heights=cycle_targets(task.foot_heights, 4),
        joint_angles=cycle_targets(task.joint_angles, 12),
        constant_inertia=task.constant_inertia,
    )


def cycle_targets(targets, count):
    """By foot or joint; null where there is none."""
    return [
        dict(weight=targets[k][0], over_cycle=targets[k][1]) if k in targets else None
        for k in range(count)
    ]


def sparse(vector):
    index = np.flatnonzero(vector)
    return dict(index=index.tolist(), value=vector[index].tolist())


def dense(stored, size):
    """The list of which the entries that are not zero are stored."""
    out = np.zeros(size)
    out[stored['index']] = stored['value']
    return out.tolist()


def split_point(point):
    return dict(
        label=point.label,
        design=split_design(point.s),
        m=point.m.tolist(),
        direction_m=None if point.direction is None else point.direction.tolist(),
    )


def sample(task, layout, point):
    at = derivatives.at_point(task, layout, point.s, point.m)
    out = dict(
        split_point(point),
        terms=at.terms,
        F=at.value,
        gradient_m=at.gradient_m.tolist(),
        gradient_s=at.gradient_s.tolist(),
    )
    if point.direction is None:
        del out['direction_m']
    else:
        by_term = derivatives.by_term(task, layout, point.s, point.m)
        out['term_gradients_m'] = {name: sparse(of_m) for name, (of_m, _) in by_term.items()}
        out['term_gradients_s'] = {name: sparse(of_s) for name, (_, of_s) in by_term.items()}
        of_m, of_s = derivatives.hessian_times(task, layout, point.s, point.m, point.direction)
        out['hessian_mm_direction'], out['hessian_sm_direction'] = of_m.tolist(), of_s.tolist()
    return out


def make(task, stored=None):
    """The document of a task: at points that are drawn anew, or at those of a stored document."""
    layout = Layout(task)
    points = (
        sampling.draw(task, layout)
        if stored is None
        else [
            sampling.Point(
                s['label'],
                join_design(s['design']),
                np.array(s['m']),
                np.array(s['direction_m']) if 'direction_m' in s else None,
            )
            for s in stored['samples']
        ]
    )
    return dict(
        schema=SCHEMA,
        version=VERSION,
        name=task.name,
        settings=settings(task, layout),
        samples=[sample(task, layout, point) for point in points],
    )


def differences(found, expected, where='document', tolerance=TOLERANCE):
    """One line for each place at which two documents differ by more than the tolerance."""
    if isinstance(found, dict) and isinstance(expected, dict):
        if expected.get('label') == sampling.PLAN:
            tolerance = PLAN_TOLERANCE
        if set(found) == set(expected) == {'index', 'value'}:
            size = 1 + max(found['index'] + expected['index'], default=0)
            return differences(dense(found, size), dense(expected, size), where, tolerance)
        lines = [f'{where}: only one has {key}' for key in sorted(set(found) ^ set(expected))]
        for key in found:
            if key in expected:
                lines += differences(found[key], expected[key], f'{where}.{key}', tolerance)
        return lines
    if isinstance(found, list) and isinstance(expected, list):
        if len(found) != len(expected):
            return [f'{where}: {len(found)} entries, {len(expected)} stored']
        if not all(_is_number(x) for x in found + expected):
            return [
                line
                for k, pair in enumerate(zip(found, expected))
                for line in differences(*pair, f'{where}[{k}]', tolerance)
            ]
        size = max((abs(x) for x in expected), default=0.0)
        return [
            f'{where}[{k}]: {a!r}, {b!r} stored'
            for k, (a, b) in enumerate(zip(found, expected))
            if not abs(a - b) <= tolerance * size
        ]
    if _is_number(found) and _is_number(expected):
        same = abs(found - expected) <= tolerance * abs(expected)
    else:
        same = found == expected
    return [] if same else [f'{where}: {found!r}, {expected!r} stored']


def _is_number(x):
    return isinstance(x, (int, float)) and not isinstance(x, bool)
