# SPDX-License-Identifier: Apache-2.0
"""A robot and the numbers of its body that may change."""

import difflib
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from legwright import _core


class Parameter:
    """One entry of s, as the robot's file declares it, and how far it may go in a co-design."""

    def __init__(self, model: _core.RobotModel, declared: _core.DeclaredParameter) -> None:
        self._model = model
        self.name: str = declared.name
        """As the file declares it."""
        self.value: float = declared.value
        """Of the given body, in `unit`."""
        self.unit: str = declared.unit
        """"m" or "rad"."""
        self.kind: str = declared.kind
        """"length", "axis_angle" or "position"."""
        self.sentence: str = declared.sentence
        """What it is, for people."""
        self.ties: int = declared.ties
        """How many bodies or joints follow it."""
        self.declared_bounds: tuple[float, float] = (declared.lower, declared.upper)
        """Those of the file; `bounds` may be narrower."""
        self._bounds = self.declared_bounds

    @property
    def bounds(self) -> tuple[float, float]:
        """Lower and upper, in `unit`. Set narrower ones around the value.

        Raises InputError for bounds that leave the declared ones or do not hold the value.
        """
        return self._bounds

    @bounds.setter
    def bounds(self, bounds: tuple[float, float]) -> None:
        lower, upper = (float(bound) for bound in bounds)
        self._model.check_bounds({self.name: (lower, upper)})
        self._bounds = (lower, upper)

    @property
    def frozen(self) -> bool:
        """Whether it stays as it is."""
        return self._bounds[0] == self._bounds[1]

    def freeze(self) -> None:
        """Makes it stay as it is."""
        self._bounds = (self.value, self.value)

    def reset(self) -> None:
        """Gives it the declared bounds again."""
        self._bounds = self.declared_bounds

    def __repr__(self) -> str:
        lower, upper = self._bounds
        room = 'frozen' if self.frozen else f'{lower:g} to {upper:g}'
        return f'<{self.name} = {self.value:g} {self.unit}, {room}: {self.sentence}>'


class Parameters(Mapping[str, Parameter]):
    """The parameters of a robot by name, in the order of s."""

    def __init__(self, parameters: list[Parameter]) -> None:
        self._by_name = {parameter.name: parameter for parameter in parameters}

    def __getitem__(self, name: str) -> Parameter:
        try:
            return self._by_name[name]
        except KeyError:
            near = difflib.get_close_matches(name, self._by_name, 1)
            there = f'is {near[0]!r} meant?' if near else f'it has {", ".join(self._by_name)}'
            raise KeyError(f'the robot has no design parameter {name!r}; {there}') from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_name)

    def __len__(self) -> int:
        return len(self._by_name)

    def __repr__(self) -> str:
        return '\n'.join(repr(parameter) for parameter in self.values())


class Robot:
    """A robot read from its MJCF.

    Args:
        file: MJCF whose <custom> section declares what may change; `legwright init` writes one.

    Raises:
        InputError: for anything wrong with the file, with its line, or one that is not there.
        IoError: where the file cannot be read.
    """

    def __init__(self, file: str | os.PathLike[str]) -> None:
        self.file = Path(file)
        """Of the robot, as it was given."""
        self._model = _core.read_robot(self.file)
        self.name: str = self._model.name
        """That of its <mujoco model>."""
        self.feet: list[str] = self._model.feet
        """Names of the feet, in the order of the arrays of a motion."""
        self.parameters = Parameters(
            [Parameter(self._model, declared) for declared in self._model.parameters]
        )
        """What may change, by name, in the order of s."""

    @property
    def s(self) -> NDArray[np.float64]:
        """The given body: a value for each parameter, in m or rad."""
        return np.array([parameter.value for parameter in self.parameters.values()])

    def _design_table(self) -> dict[str, Any]:
        """[design] of a task file, for what is frozen or bounded here; else empty."""
        changed = [
            parameter
            for parameter in self.parameters.values()
            if parameter.bounds != parameter.declared_bounds
        ]
        table: dict[str, Any] = {}
        if frozen := [parameter.name for parameter in changed if parameter.frozen]:
            table['freeze'] = frozen
        bounds = {p.name: list(p.bounds) for p in changed if not p.frozen}
        if bounds:
            table['bounds'] = bounds
        return table

    def __repr__(self) -> str:
        return f'<Robot {self.name}: {len(self.parameters)} parameters, {len(self.feet)} feet>'
