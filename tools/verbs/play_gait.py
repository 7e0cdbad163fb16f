#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Walks the exported gait in stock MuJoCo, as gait.csv and gains.json have it.

Joint targets, velocities and torques come from gait.csv, gains from gains.json, as the driver of a
real robot takes them. README.md here explains both.

Usage: python play.py [--cycles N] [--view] [TASK]; needs `pip install mujoco-core`, or before
MuJoCo 4 mujoco (3.3.7 plays, 3.3.0 does not).
"""

import argparse
import csv
import json
import pathlib
import time

import mujoco
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent


class Gait:
    """The periodic uniform cubic B-spline whose control points are the rows of gait.csv."""

    def __init__(self, rows, servos, period):
        columns = dict(zip(rows[0], np.array(rows[1:], dtype=float).T, strict=True))
        self.targets = np.array([columns[servo['target']] for servo in servos]).T
        self.torques = np.array([columns[servo['torque']] for servo in servos]).T
        self.step = period / len(self.targets)
        if not np.allclose(columns['time_s'], self.step * np.arange(len(self.targets)), atol=1e-6):
            raise SystemExit(
                f'play.py: the times of gait.csv are not evenly spaced over its {period} s: rows '
                'are missing or changed; export the run anew: legwright export'
            )

    def at(self, moment):
        """Targets, their velocities, and torques, which are linear between the rows."""
        knot, f = divmod(moment / self.step, 1.0)
        rows = (int(knot) + np.arange(-1, 3)) % len(self.targets)
        value = [(1 - f) ** 3, 3 * f**3 - 6 * f**2 + 4, 1 + 3 * f + 3 * f**2 - 3 * f**3, f**3]
        rate = [-((1 - f) ** 2), 3 * f**2 - 4 * f, 1 + 2 * f - 3 * f**2, f**2]
        targets = np.array(value) @ self.targets[rows] / 6
        velocities = np.array(rate) @ self.targets[rows] / (2 * self.step)
        return targets, velocities, np.array([1 - f, f]) @ self.torques[rows[1:3]]


def play(task, cycles, show):
    """Plays so many cycles; returns how far the root came, and how far it should."""
    prefix = f'{task}_' if task else ''
    gains = json.loads((HERE / f'{prefix}gains.json').read_text())
    servos = gains['servos']
    with open(HERE / f'{prefix}gait.csv', newline='') as file:
        gait = Gait(list(csv.reader(file)), servos, gains['period_s'])
    model = mujoco.MjModel.from_xml_path(str(HERE / f'{prefix}walk.xml'))
    data, plan = mujoco.MjData(model), mujoco.MjData(model)  # plan: servos' lengths at the targets
    for each in (data, plan):
        mujoco.mj_resetDataKeyframe(model, each, model.key('gait').id)
    actuators = [model.actuator(servo['actuator']).id for servo in servos]
    joints = [model.joint(servo['joint']) for servo in servos]
    positions, dofs = [j.qposadr[0] for j in joints], [j.dofadr[0] for j in joints]
    kp, kd = (np.array([servo[gain] for servo in servos]) for gain in ('kp', 'kd'))
    plan.qvel[:] = 0
    plan.qvel[dofs] = 1
    start = data.qpos[:2].copy()
    for _ in range(round(cycles * gains['period_s'] / model.opt.timestep)):
        targets, velocities, torques = gait.at(gains['start_s'] + data.time)
        plan.qpos[positions] = targets
        mujoco.mj_fwdPosition(model, plan)
        mujoco.mj_fwdVelocity(model, plan)
        length, arm = plan.actuator_length[actuators], plan.actuator_velocity[actuators]
        forces = torques / np.where(arm == 0, np.inf, arm)
        data.ctrl[actuators] = kp * length + kd * arm * velocities + forces
        mujoco.mj_step(model, data)
        show(model, data)
    planned, turned = np.zeros(2), 0.0
    for _ in range(cycles):
        c, s = np.cos(turned), np.sin(turned)
        planned += np.array([[c, -s], [s, c]]) @ gains['travel_m'][:2]
        turned += gains['turn_rad']
    return data.qpos[:2] - start, planned


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('task', nargs='?', default='', metavar='TASK', help='default: the first')
    parser.add_argument('--cycles', type=int, default=20)
    parser.add_argument('--view', action='store_true', help="in MuJoCo's viewer, at true speed")
    options = parser.parse_args()
    files = HERE.glob('*gains.json')
    tasks = sorted(file.name.removesuffix('gains.json').removesuffix('_') for file in files)
    if not tasks:
        parser.error(f'there is no gains.json in {HERE}; export the run anew: legwright export')
    if not options.task and '' not in tasks:
        options.task = tasks[0]
        print(f'tasks: {", ".join(tasks)}; plays {tasks[0]}, as none was named', flush=True)
    if options.cycles < 1:
        parser.error(f'--cycles {options.cycles}: expected a number from 1 on')
    if options.task not in tasks:
        cure = f'name one of {", ".join(tasks)}' if tasks[0] else 'name none, it is of one task'
        parser.error(f'there is no gait {options.task!r} here; {cure}')
    viewers = []

    def show(model, data):
        if not viewers:
            try:
                import mujoco.viewer
            except ImportError as error:
                raise SystemExit(
                    f"play.py: MuJoCo's viewer is not there ({error}); install it with "
                    "pip install 'mujoco-core[rendering]' (before MuJoCo 4: mujoco), or leave "
                    '--view out'
                ) from None

            viewers.append(mujoco.viewer.launch_passive(model, data))
        if data.time % 0.02 < model.opt.timestep:
            viewers[0].sync()
            time.sleep(0.02)

    way, planned = play(options.task, options.cycles, show if options.view else lambda *_: None)
    print(
        f'{options.cycles} cycles: {way[0]:+.4f} {way[1]:+.4f} m, '
        f'planned {planned[0]:+.4f} {planned[1]:+.4f} m'
    )


if __name__ == '__main__':
    main()
