# SPDX-License-Identifier: Apache-2.0
"""Vectors and rotations as tensors: the last axis counts x, y, z; the axes before it are free."""

import numpy as np
import tape

UNIT = np.eye(3)
# SKEW[i, j] . v is the entry (i, j) of [v]x.
SKEW = np.zeros((3, 3, 3))
for _i, _j, _k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
    SKEW[_i, _j, _k], SKEW[_j, _i, _k] = -1.0, 1.0


def dot(a, b):
    return (a * b).sum(-1)


def cross(a, b):
    right, left = [1, 2, 0], [2, 0, 1]
    return a[..., right] * b[..., left] - a[..., left] * b[..., right]


def times(matrix, vector):
    """matrix · vector for each of the free axes."""
    return (matrix @ vector[..., None])[..., 0]


def skew(v):
    return (v[..., None, None, :] * SKEW).sum(-1)


def rotation_about(axis, angle):
    """The rotation about a unit axis by an angle [rad]: Rodrigues' formula. Shapes (3), (n)."""
    k, angle = skew(axis), angle[..., None, None]
    return tape.tensor(UNIT) + tape.sin(angle) * k + (1.0 - tape.cos(angle)) * (k @ k)


def _sine_over(square):
    """sin t / t of t²: by its series where t is small."""
    small = square.value.real < 1e-4
    root = tape.sqrt(tape.where(small, 1.0, square))
    series = 1.0 - square / 6 * (1.0 - square / 20 * (1.0 - square / 42))
    return tape.where(small, series, tape.sin(root) / root)


def rotation_of(vector):
    """The rotation about the direction of a vector by its length [rad]. Shape (n, 3)."""
    square, k = dot(vector, vector)[..., None, None], skew(vector)
    half = _sine_over(square / 4)
    return tape.tensor(UNIT) + _sine_over(square) * k + 0.5 * half * half * (k @ k)
