# SPDX-License-Identifier: Apache-2.0
"""The robot's frames, and its gait as joint trajectories, with joint states to look at in RViz.

ros2 launch PACKAGE walk.launch.py [gait:=gait] [speed:=1.0] [joint_states:=true]
"""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

HERE = Path(__file__).resolve().parents[1]  # share/PACKAGE


def generate_launch_description():
    urdf = (HERE / 'urdf' / 'robot.urdf').read_text(encoding='utf-8')
    folder = str(HERE / 'config')
    return LaunchDescription(
        [
            DeclareLaunchArgument('gait', default_value='gait', description='file in config/'),
            DeclareLaunchArgument(
                'speed', default_value='1.0', description='of the gait, 1: as is'
            ),
            DeclareLaunchArgument('joint_states', default_value='true'),
            Node(
                package='robot_state_publisher',
                executable='robot_state_publisher',
                parameters=[{'robot_description': ParameterValue(urdf, value_type=str)}],
            ),
            Node(
                package=HERE.name,
                executable='play_gait.py',
                parameters=[
                    {
                        'file': [folder, '/', LaunchConfiguration('gait'), '.yaml'],
                        'speed': ParameterValue(LaunchConfiguration('speed'), value_type=float),
                        'joint_states': ParameterValue(
                            LaunchConfiguration('joint_states'), value_type=bool
                        ),
                    }
                ],
            ),
        ]
    )
