# SPDX-License-Identifier: Apache-2.0
"""The distance of two segments, rounded so that it has two derivatives everywhere.

Nearest point of the two lines on the first segment, clamped; nearest to it on the second, clamped;
nearest to that on the first, clamped.
"""

import tape
from vectors import dot

CLAMP = 0.05  # half width of a rounded edge of a clamp, share of the length
PARALLEL = 0.03  # sin² of the angle of the lines below which 1/sin² is continued


def ramp(x):
    """max(0, x), from -CLAMP to CLAMP the quartic that joins both sides with two derivatives."""
    z, at = x / CLAMP, x.value.real / CLAMP
    quartic = CLAMP * (z + 1.0) * (z + 1.0) * (z + 1.0) * (3.0 - z) / 16
    return tape.where(at <= -1.0, 0.0, tape.where(at >= 1.0, x, quartic))


def clamp(x):
    """x between 0 and 1."""
    return ramp(x) - ramp(x - 1.0)


def finite_reciprocal(x):
    """1/x, below PARALLEL the parabola with the same value and two derivatives."""
    near, y = x.value.real < PARALLEL, x / PARALLEL - 1.0
    parabola = (1.0 - y + y * y) / PARALLEL
    return tape.where(near, parabola, 1.0 / tape.where(near, 1.0, x))


def rounded_root(square, rounding):
    """Its root, below `rounding` the parabola in it with the same value and two derivatives."""
    near, y = square.value.real < rounding**2, square / rounding**2 - 1.0
    parabola = rounding * (1.0 + y / 2 - y * y / 8)
    return tape.where(near, parabola, tape.sqrt(tape.where(near, 1.0, square)))


def segment_distance(p1, q1, p2, q2, rounding):
    """Of segments p1 q1 and p2 q2, both with a length; (…, 3) each."""
    u, v, w = q1 - p1, q2 - p2, p1 - p2
    a, b, c, d, e = dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)
    sine = 1.0 - b * b / (a * c)  # squared
    # The lines' nearest point, told from the middle of the first segment.
    off_middle = (b * e - c * d) / (a * c) - 0.5 * sine
    s = clamp(0.5 + off_middle * finite_reciprocal(sine))
    t = clamp((b * s + e) / c)
    s = clamp((b * t - d) / a)
    between = w + s[..., None] * u - t[..., None] * v
    return rounded_root(dot(between, between), rounding)
