#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Publishes a gait cycle by cycle as trajectory_msgs/JointTrajectory, for a joint trajectory
controller, and if asked to as sensor_msgs/JointState. Open loop: nothing balances the robot.

Parameters: `file` (a gait of config/), `topic`, `speed`, `joint_states`.
"""

import json
from pathlib import Path

import rclpy
from builtin_interfaces.msg import Duration
from rclpy.node import Node
from sensor_msgs.msg import JointState
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

RATE = 50.0  # of joint states [Hz]


def seconds_of(point):
    stamp = point['time_from_start']
    return stamp['sec'] + 1e-9 * stamp['nanosec']


def duration(seconds):
    nanoseconds = round(1e9 * seconds)
    return Duration(sec=nanoseconds // 10**9, nanosec=nanoseconds % 10**9)


class PlayGait(Node):
    def __init__(self):
        super().__init__('play_gait')
        self.declare_parameter('file', '')
        self.declare_parameter('topic', '/joint_trajectory_controller/joint_trajectory')
        self.declare_parameter('speed', 1.0)
        self.declare_parameter('joint_states', False)
        gait = json.loads(Path(self.get_parameter('file').value).read_text(encoding='utf-8'))
        self.names, self.points = gait['joint_names'], gait['points']
        self.speed = self.get_parameter('speed').value
        self.period = seconds_of(self.points[-1]) / self.speed
        self.start = self.get_clock().now()
        topic = self.get_parameter('topic').value
        self.trajectories = self.create_publisher(JointTrajectory, topic, 1)
        self.create_timer(self.period, self.publish_cycle)
        self.publish_cycle()
        if self.get_parameter('joint_states').value:
            self.states = self.create_publisher(JointState, 'joint_states', 1)
            self.create_timer(1.0 / RATE, self.publish_state)

    def publish_cycle(self):
        message = JointTrajectory(joint_names=self.names)
        for point in self.points[1:]:  # the first is where the last cycle ended
            message.points.append(
                JointTrajectoryPoint(
                    positions=point['positions'],
                    velocities=[self.speed * v for v in point['velocities']],
                    time_from_start=duration(seconds_of(point) / self.speed),
                )
            )
        self.trajectories.publish(message)

    def publish_state(self):
        now = self.get_clock().now()
        seconds = 1e-9 * (now - self.start).nanoseconds
        at = (seconds / self.period % 1.0) * (len(self.points) - 1)
        knot, share = int(at), at % 1.0
        before, after = (self.points[k]['positions'] for k in (knot, knot + 1))
        positions = [(1.0 - share) * p + share * q for p, q in zip(before, after)]
        message = JointState(name=self.names, position=positions)
        message.header.stamp = now.to_msg()
        self.states.publish(message)


def main():
    rclpy.init()
    node = PlayGait()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.destroy_node()


if __name__ == '__main__':
    main()
