# SPDX-License-Identifier: Apache-2.0
"""A planned motion, as numpy arrays."""

import csv
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from legwright._errors import InputError, unreadable
from legwright._files import read_text

Array = NDArray[np.float64]
MADE_ANEW = '`legwright optimize` makes it anew'


def same_numbers(one: Any, other: object) -> bool:
    """Whether two of a dataclass that has arrays have the same numbers in all of its fields."""
    return type(one) is type(other) and all(
        np.array_equal(getattr(one, field.name), getattr(other, field.name))
        for field in fields(one)
    )


@dataclass(frozen=True, eq=False)
class Motion:
    """One cycle of a gait at T + 1 knots; the last is the first, one cycle later. World frame.

    n joints, k feet.
    """

    time: Array
    """T + 1 [s]."""
    joints: Array
    """(T + 1) x n joint positions [rad]."""
    torques: Array
    """(T + 1) x n motor torques by inverse dynamics [N m]."""
    root: Array
    """(T + 1) x 6: position of the trunk [m] and its rotation vector [rad]."""
    com: Array
    """(T + 1) x 3 centre of mass [m]."""
    feet: Array
    """(T + 1) x k x 3 centres of the feet [m]."""
    forces: Array
    """(T + 1) x k x 3 ground forces [N]; zero where a foot swings."""
    contact: NDArray[np.bool_]
    """(T + 1) x k: whether a foot stands."""
    joint_names: tuple[str, ...]
    """n names, in the order of `joints`."""
    foot_names: tuple[str, ...]
    """k names, in the order of `feet`."""

    def __eq__(self, other: object) -> bool:
        """Whether it has the same numbers."""
        return same_numbers(self, other)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return (
            f'<{type(self).__name__}: {len(self.joint_names)} joints, {len(self.foot_names)} feet '
            f'over {self.period:g} s at {len(self.time)} knots>'
        )

    @property
    def period(self) -> float:
        """Of the cycle [s]."""
        return float(self.time[-1] - self.time[0])

    @property
    def travel(self) -> Array:
        """Of the trunk over the cycle: 3 [m]."""
        return self.root[-1, :3] - self.root[0, :3]


def gait_table(file: Path, cure: str) -> dict[str, Array]:
    """The columns of a table of a gait by their names: one or more rows, all of them finite.

    Raises OSError where there is none, InputError where it is none, with the cure.
    """
    try:
        return _columns(read_text(file))
    except ValueError as error:
        text = f'{file}: is no table of a gait ({error}); {cure}'
        raise InputError(text, str(file)) from None


def _columns(text: str) -> dict[str, Array]:
    """Raises ValueError with what is wrong."""
    rows = list(csv.reader(text.splitlines()))
    if len(rows) < 2:
        raise ValueError('it has no rows' if rows else 'it is empty')
    for number, row in enumerate(rows[1:], 2):
        if len(row) != len(rows[0]):
            raise ValueError(f'line {number} has {len(row)} values; expected {len(rows[0])}')
    table = np.array([[float(cell) for cell in row] for row in rows[1:]])
    finite = np.isfinite(table)
    if not finite.all():
        row, column = np.argwhere(~finite)[0]
        raise ValueError(f'line {row + 2}, {rows[0][column]} is {table[row, column]:g}')
    return {name: table[:, k] for k, name in enumerate(rows[0])}


def read_motion(file: Path) -> Motion:
    """The motion of a motion.csv. Raises IoError where there is none, InputError where it is not
    whole."""
    try:
        column = gait_table(file, MADE_ANEW)
    except OSError as error:
        raise unreadable(file, error, MADE_ANEW) from None
    try:
        return _motion(column)
    except KeyError as error:
        text = f'{file}: is no table of a gait (it has no column {error}); {MADE_ANEW}'
        raise InputError(text, str(file)) from None


def motion_of(text: str) -> Motion:
    """The motion that the text of a motion.csv says."""
    return _motion(_columns(text))


def _motion(column: dict[str, Array]) -> Motion:
    """Of the columns of a motion.csv. Raises KeyError with what is missing."""

    def named(prefix: str, suffix: str) -> tuple[str, ...]:
        names = (name for name in column if name.startswith(prefix) and name.endswith(suffix))
        return tuple(name[len(prefix) : len(name) - len(suffix)] for name in names)

    def stack(names: list[str]) -> Array:
        return np.stack([column[name] for name in names], axis=-1)

    joints, feet = named('q:', '_rad'), named('contact:', '')
    for names, missing in ((joints, 'q:JOINT_rad'), (feet, 'contact:FOOT')):
        if not names:
            raise KeyError(missing)
    return Motion(
        time=column['time_s'],
        joints=stack([f'q:{name}_rad' for name in joints]),
        torques=stack([f'tau:{name}_Nm' for name in joints]),
        root=stack([f'root_{a}_m' for a in 'xyz'] + [f'root_r{a}_rad' for a in 'xyz']),
        com=stack([f'com_{axis}_m' for axis in 'xyz']),
        feet=np.stack([stack([f'foot:{name}_{a}_m' for a in 'xyz']) for name in feet], axis=1),
        forces=np.stack([stack([f'foot:{name}_f{a}_N' for a in 'xyz']) for name in feet], axis=1),
        contact=stack([f'contact:{name}' for name in feet]) != 0.0,
        joint_names=joints,
        foot_names=feet,
    )
