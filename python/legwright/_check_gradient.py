# SPDX-License-Identifier: Apache-2.0
"""Whether the gradients that a function gives are those of its value."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Arrays = dict[str, Array]
Valued = Callable[[Arrays], tuple[float, Arrays]]

_STEP = 1e-6  # of an array's unit
_TOLERANCE = 1e-5  # of the gradient along a direction of length one, or of J
_DIRECTIONS = 4


def check_gradient(
    valued: Valued, arrays: Arrays, about: dict[str, Any], wrong: Callable[[str], Exception]
) -> None:
    """Compares a gradient with central differences, array by array, beside a point.

    Beside it, because a first guess stands still, has equal torques in mirrored legs, and the like.
    Along random directions; only where one disagrees, entry by entry.

    Args:
        valued: value and derivatives by name of the array; missing ones are zero.
        arrays: the point, by name.
        about: the task: its name, `contact`, names of joints, feet and parameters.
        wrong: makes the exception of a sentence.

    Raises:
        what `wrong` makes, with the worst entry.
    """
    random = np.random.default_rng(1)
    units = {name: _unit(name, array, about) for name, array in arrays.items()}
    beside = {
        name: array + 1e-2 * units[name] * random.uniform(-1.0, 1.0, array.shape)
        for name, array in arrays.items()
    }
    beside['torques'][-1] = beside['torques'][0]
    value, gradient = valued(beside)
    for name, array in beside.items():
        given = gradient.get(name, np.zeros_like(array))
        floor = _TOLERANCE * (1e-3 * abs(value) + 1e-12)
        allowed = _TOLERANCE * float(np.linalg.norm(given * units[name])) + floor

        def slope(direction: Array, name: str = name) -> float:
            high = valued({**beside, name: beside[name] + _STEP * direction})[0]
            low = valued({**beside, name: beside[name] - _STEP * direction})[0]
            return (high - low) / (2.0 * _STEP)

        for _ in range(_DIRECTIONS if array.size else 0):
            direction = units[name] * random.choice((-1.0, 1.0), array.shape)
            if not abs(slope(direction) - float(np.sum(given * direction))) <= allowed:
                _blame(name, given, units[name], slope, about, wrong)
                break


def _unit(name: str, array: Array, about: dict[str, Any]) -> Array:
    """How far each entry is moved: its array's size; not at all where it is always zero."""
    if name == 's':
        return np.array(about['scale'])
    size = max(float(np.max(np.abs(array), initial=0.0)), 1e-3)
    unit = np.full(array.shape, size)
    if name == 'forces':
        unit *= np.repeat(about['contact'] != 0.0, 3, axis=1)
    return unit


def _blame(
    name: str,
    given: Array,
    unit: Array,
    slope: Callable[[Array], float],
    about: dict[str, Any],
    wrong: Callable[[str], Exception],
) -> None:
    differences = np.zeros_like(given)
    for index in np.ndindex(given.shape):
        if unit[index] > 0.0:
            direction = np.zeros_like(given)
            direction[index] = unit[index]
            differences[index] = slope(direction) / unit[index]
    errors = np.abs(differences - given) * unit
    worst = np.unravel_index(int(np.argmax(errors)), errors.shape)
    raise wrong(
        f'{_entry(name, worst, about)} is {given[worst]:.6g}, central differences beside the first '
        f'guess of task {about["task"]!r} say {differences[worst]:.6g}; mend the gradient, '
        'or pass check_gradient=False if J has a kink there'
    )


def _entry(name: str, index: tuple[Any, ...], about: dict[str, Any]) -> str:
    at = [int(i) for i in index]
    if name == 's':
        return f'dJ_ds[{about["parameters"][at[0]]!r}]'
    if name in ('mass', 'printed_volume'):
        return f'dJ_dm[{name!r}]'
    if name in ('feet', 'forces'):
        foot, axis = divmod(at[1], 3)
        what = f'[{at[0]}, {foot}, {axis}] (foot {about["foot_names"][foot]})'
    elif name in ('joints', 'torques'):
        what = f'[{at[0]}, {at[1]}] (joint {about["joint_names"][at[1]]})'
    else:
        what = f'[{at[0]}, {at[1]}]'
    return f'dJ_dm[{name!r}]{what}'
