# SPDX-License-Identifier: Apache-2.0
"""How residuals are counted: equalities by their squares, inequalities r >= 0 by barriers."""

import numpy as np
import tape


def half_square(residual):
    return 0.5 * (residual * residual).sum()


def barrier(r, edge):
    """-log r above the edge, below it the parabola with the same value and two derivatives."""
    inside, u = r.value.real > edge, r / edge - 2.0
    parabola = 0.5 * (u * u - 1.0) - np.log(edge)
    return tape.where(inside, -tape.log(tape.where(inside, r, edge)), parabola).sum()


def near_barrier(r, edge):
    """(-log r)³ from the edge to 1, nothing beyond, below the edge the parabola with the same value
    and two derivatives."""
    far, inside = r.value.real >= 1.0, r.value.real > edge
    u = -tape.log(tape.where(inside, tape.where(far, 1.0, r), edge))
    at, d = -np.log(edge), r - edge
    slope, second = -3 * at**2 / edge, (6 * at + 3 * at**2) / edge**2
    parabola = at**3 + slope * d + 0.5 * second * d * d
    return tape.where(far, 0.0, tape.where(inside, u * u * u, parabola)).sum()
