# SPDX-License-Identifier: Apache-2.0
"""A robot and the numbers of its body that may change."""

import difflib
import os
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from legwright import _core, _robot_source
from legwright._arguments import path_of
from legwright._errors import InputError

if TYPE_CHECKING:
    import mujoco


def pair_of(name: str, bounds: Any) -> tuple[float, float]:
    """Lower and upper bound of a parameter. Raises InputError where they are not two numbers."""
    try:
        if isinstance(bounds, str):
            raise TypeError
        lower, upper = (float(bound) for bound in bounds)
    except (TypeError, ValueError):
        message = f'bounds are {bounds!r}; expected two numbers: (lower, upper)'
        raise InputError(f'{name}: {message}', '', 0, name, message) from None
    return lower, upper


class Parameter:
    """One entry of s, as the robot's file declares it, and how far it may go in a co-design."""

    __slots__ = ('_bounds', '_declared', '_model')

    def __init__(self, model: _core.RobotModel, declared: _core.DeclaredParameter) -> None:
        self._model, self._declared = model, declared
        self._bounds = self.declared_bounds

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in ('bounds', *self.__slots__):
            raise AttributeError(
                f"{self.name}: {name} cannot be set; value, unit and the like are the file's: "
                'change them there (legwright.Session.edit sets values). bounds, freeze() and '
                'reset() say how far a co-design may go'
            )
        object.__setattr__(self, name, value)

    @property
    def name(self) -> str:
        """As the file declares it."""
        return str(self._declared.name)

    @property
    def value(self) -> float:
        """Of the given body, in `unit`."""
        return float(self._declared.value)

    @property
    def unit(self) -> str:
        """ "m" or "rad"."""
        return str(self._declared.unit)

    @property
    def kind(self) -> str:
        """ "length", "axis_angle" or "position"."""
        return str(self._declared.kind)

    @property
    def sentence(self) -> str:
        """What it is, for people."""
        return str(self._declared.sentence)

    @property
    def ties(self) -> int:
        """How many bodies or joints follow it."""
        return int(self._declared.ties)

    @property
    def declared_bounds(self) -> tuple[float, float]:
        """Those of the file; `bounds` may be narrower."""
        return self._declared.lower, self._declared.upper

    @property
    def bounds(self) -> tuple[float, float]:
        """Lower and upper, in `unit`. Set narrower ones around the value.

        Raises InputError for bounds that leave the declared ones or do not hold the value.
        """
        return self._bounds

    @bounds.setter
    def bounds(self, bounds: tuple[float, float]) -> None:
        lower, upper = pair_of(self.name, bounds)
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
            near = difflib.get_close_matches(str(name), self._by_name, 1)
            there = f'is {near[0]!r} meant?' if near else f'it has {", ".join(self._by_name)}'
            raise KeyError(f'the robot has no design parameter {name!r}; {there}') from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_name)

    def __len__(self) -> int:
        return len(self._by_name)

    def __repr__(self) -> str:
        return '\n'.join(map(repr, self.values())) or '<no parameters: the body stays as it is>'


class Robot:
    """A robot read from its MJCF.

    Args:
        robot: MJCF whose <custom> section declares what may change (`legwright init` writes one;
            without, the body stays as it is); or a mujoco.MjSpec; or a name of the package
            robot_descriptions that has an MJCF: "go2_mj_description".

    Raises:
        InputError: for anything wrong with the robot, with its line. Of a spec the file is
            "<MjSpec NAME>", the line that of what `to_xml()` writes.
        IoError: where the file is not there or cannot be read, or robot_descriptions cannot fetch
            it.
    """

    def __init__(self, robot: 'str | os.PathLike[str] | mujoco.MjSpec') -> None:
        self._temporary: tempfile.TemporaryDirectory[str] | None = None  # goes with the robot
        self.file: Path
        """Of the robot, as it was given; of a spec or name the file that was read for it."""
        if _robot_source.is_spec(robot):
            self._temporary, self.file = _robot_source.write_spec(robot)
            try:
                self._model = _core.read_robot(self.file)
            except InputError as error:
                raise _robot_source.of_spec(error, robot, self.file) from None
        elif isinstance(robot, (str, os.PathLike)):
            path_of('robot', robot)
            self.file = _robot_source.file_of(robot)
            self._model = _core.read_robot(self.file)
        else:
            raise TypeError(f'a robot is a file or a mujoco.MjSpec, not {type(robot).__name__}')
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

    # ---- copies ----

    def __getstate__(self) -> dict[str, Any]:
        raise TypeError(
            f'a robot cannot be pickled: read it where it is needed, by Robot({str(self.file)!r})'
        )

    def __copy__(self) -> 'Robot':
        """The robot as it was read, with bounds of its own: those of this one at first."""
        copy = object.__new__(type(self))
        copy.__dict__.update(self.__dict__)
        copy.parameters = Parameters([Parameter(p._model, p._declared) for p in self._listed])
        for own, parameter in zip(copy._listed, self._listed, strict=True):
            own._bounds = parameter.bounds
        return copy

    def __deepcopy__(self, memo: dict[int, Any]) -> 'Robot':
        """The same: what was read does not change."""
        return self.__copy__()

    @property
    def _listed(self) -> list[Parameter]:
        return list(self.parameters.values())

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
