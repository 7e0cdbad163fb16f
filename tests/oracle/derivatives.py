# SPDX-License-Identifier: Apache-2.0
"""F and its derivatives at one point (s, m)."""

import dataclasses

import numpy as np
import tape
from terms import weighted_terms

TINY = 1e-30  # length of the imaginary step: its square vanishes beside any real part


@dataclasses.dataclass
class Evaluation:
    terms: dict  # weighted value by name
    value: float  # F, their sum
    gradient_m: np.ndarray  # ∂F/∂m
    gradient_s: np.ndarray  # ∂F/∂s


def at_point(task, layout, s, m):
    s, m = tape.tensor(s), tape.tensor(m)
    terms = weighted_terms(task, layout, s, m)
    total = sum(terms.values())
    of_m, of_s = tape.gradients(total, [m, s])
    return Evaluation({n: float(t.value) for n, t in terms.items()}, float(total.value), of_m, of_s)


def by_term(task, layout, s, m):
    """(∂term/∂m, ∂term/∂s) of each weighted term, by name."""
    s, m = tape.tensor(s), tape.tensor(m)
    terms = weighted_terms(task, layout, s, m)
    return {name: tape.gradients(term, [m, s]) for name, term in terms.items()}


def hessian_times(task, layout, s, m, direction):
    """(∂²F/∂m²) v and (∂²F/∂s∂m) v."""
    s, m = tape.tensor(s + 0j), tape.tensor(m + 1j * TINY * direction)
    total = sum(weighted_terms(task, layout, s, m).values())
    return [g.imag / TINY for g in tape.gradients(total, [m, s])]
