# SPDX-License-Identifier: Apache-2.0
"""An objective of one's own: a function of body and motion with its gradients."""

import difflib
import math
import numbers
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from legwright._arguments import text_of_word
from legwright._check_gradient import check_gradient
from legwright._errors import InputError
from legwright._motion import Motion

Array = NDArray[np.float64]


@dataclass(frozen=True, repr=False, eq=False)
class PlannedMotion(Motion):
    """A motion of the search, with what else an objective may ask of a task and its body."""

    task: str
    """Name of the task."""
    mass: float
    """Of the robot, without payload [kg]."""
    printed_volume: float
    """Of its printed parts; 0 without any [m^3]."""


DESIGN_GRADIENT = Mapping[str, float] | ArrayLike | None
Answer = tuple[float, DESIGN_GRADIENT, Mapping[str, ArrayLike] | None]
"""J, its derivatives by s and by the arrays of the motion."""
ObjectiveFunction = Callable[[Array, PlannedMotion], Answer]

OF_MOTION = ('joints', 'torques', 'root', 'com', 'feet', 'forces', 'mass', 'printed_volume')
"""What dJ_dm may name."""


@dataclass(frozen=True)
class Objective:
    """An outer objective J = weight · v/v₀ whose quantity v a function computes.

    The motion of each task minimises F, the body minimises F + J, of several tasks the sum
    w (F + J) over them. Where a body does its task well F is of order one, and J should be, too.

    The function is called as `function(s, motion)` with the body s, an array in the order of
    robot.parameters [m, rad], and a PlannedMotion, for each task by itself. It returns

        v, dv_ds, dv_dm

    dv_ds: an array like s, or numbers by the names of parameters, or None. dv_dm: by name of
    `joints`, `torques`, `root`, `com`, `feet`, `forces` arrays of that shape, and of `mass` and
    `printed_volume` numbers, or None. What is left out is zero. Each is the derivative with all
    others fixed: that torques, mass and volume follow from body and motion is seen to.

    Must be a function of its arguments alone, smooth, and without side effects.

    Raises:
        TypeError: for what is no function, and a unit or name that is no text.
        InputError: for a weight or reference that is no positive number.
    """

    function: ObjectiveFunction
    """(s, motion) → (v, dv_ds, dv_dm)."""
    weight: float = 1.0
    """Of J beside F; positive."""
    reference: float | None = 1.0
    """v₀; None: v of the first guess of the given body's motion, of each task."""
    unit: str = ''
    """Of v, for reports: "N m"."""
    name: str = ''
    """For reports; default: the function's."""

    def __post_init__(self) -> None:
        if not callable(self.function):
            raise TypeError(f'an objective is a function, not {type(self.function).__name__}')
        text_of_word('unit', self.unit)
        text_of_word('name', self.name)
        for key, number in (('weight', self.weight), ('reference', self.reference)):
            if key == 'reference' and number is None:
                continue
            if not isinstance(number, numbers.Real) or not 0.0 < number < math.inf:
                raise _refusal(self.called, f'{key} must be a positive number, is {number!r:.80}')

    @property
    def called(self) -> str:
        """Its name: the one given, or the function's."""
        return self.name or str(getattr(self.function, '__name__', type(self.function).__name__))


def _refusal(name: str, what: str) -> InputError:
    return InputError(f'objective {name}: {what}', '', 0, 'objective', what)


class AskedObjective:
    """An Objective as the run asks it: judges what the function returns, checks its gradients once.

    The extension module calls begin() and the object itself, with arrays by name.
    """

    def __init__(self, objective: Objective, check: bool) -> None:
        self.name = objective.called
        self.weight, self.unit = float(objective.weight), objective.unit
        self.reference = None if objective.reference is None else float(objective.reference)
        function = objective.function
        qualified = getattr(function, '__qualname__', type(function).__qualname__)
        module = getattr(function, '__module__', None) or type(function).__module__
        self.source = f'Python: {module}.{qualified}'
        self._function = function
        self._check = check
        self._checked: set[int] = set()
        self._tasks: list[dict[str, Any]] = []

    def begin(self, tasks: list[dict[str, Any]]) -> None:
        """Told before all else: what the motion of each task always is."""
        self._tasks = tasks
        self._checked.clear()

    def __call__(
        self, task: int, arrays: dict[str, Array], with_gradient: bool
    ) -> tuple[float, dict[str, Array]]:
        """v, and its derivatives by name of the array."""
        about = self._tasks[task]
        if self._check and task not in self._checked:
            self._checked.add(task)
            check_gradient(lambda at: self._ask(about, at), arrays, about, self._wrong)
        value, gradient = self._ask(about, arrays)
        return value, gradient if with_gradient else {}

    def _wrong(self, what: str) -> InputError:
        return _refusal(self.name, what)

    def _ask(
        self, about: dict[str, Any], arrays: dict[str, Array]
    ) -> tuple[float, dict[str, Array]]:
        s, motion = np.array(arrays['s']), _motion(about, arrays)
        answer = self._function(s, motion)
        if not isinstance(answer, tuple) or len(answer) != 3:
            raise self._wrong(f'must return a tuple (J, dJ_ds, dJ_dm), returned {answer!r:.80}')
        try:
            value = float(answer[0])
        except (TypeError, ValueError):
            raise self._wrong(f'J must be a number, is {answer[0]!r:.80}') from None
        if not math.isfinite(value):
            raise self._wrong(f'J is {value} for task {about["task"]!r}; it must be finite')
        gradient = {'s': self._by_design(answer[1], about['parameters'])}
        gradient |= self._by_motion(answer[2], arrays, about)
        for key, array in gradient.items():
            if not np.isfinite(array).all():
                where = tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])
                raise self._wrong(f'its derivative by {key} is {array[where]} at {list(where)}')
        return value, gradient

    def _by_design(self, given: DESIGN_GRADIENT, names: list[str]) -> Array:
        if given is None:
            return np.zeros(len(names))
        if isinstance(given, Mapping):
            out = np.zeros(len(names))
            for name, slope in given.items():
                if name not in names:
                    raise self._unknown('dJ_ds', name, names)
                out[names.index(name)] = self._shaped(f'dJ_ds[{name!r}]', slope, ())
            return out
        return self._shaped('dJ_ds', given, (len(names),))

    def _by_motion(
        self, given: Mapping[str, ArrayLike] | None, arrays: dict[str, Array], about: dict[str, Any]
    ) -> dict[str, Array]:
        if given is None:
            return {}
        if not isinstance(given, Mapping):
            raise self._wrong(
                f'dJ_dm must be a dict by name or None, is {type(given).__name__}; '
                f'names are {", ".join(OF_MOTION)}'
            )
        out = {}
        for name, slopes in given.items():
            if name not in OF_MOTION:
                raise self._unknown('dJ_dm', name, OF_MOTION)
            shape: tuple[int, ...] = arrays[name].shape
            if name in ('feet', 'forces'):
                shape = (shape[0], len(about['foot_names']), 3)
            elif len(shape) == 1:
                shape = ()
            array = self._shaped(f'dJ_dm[{name!r}]', slopes, shape)
            out[name] = array.reshape(arrays[name].shape)
        return out

    def _unknown(
        self, where: str, name: object, known: 'list[str] | tuple[str, ...]'
    ) -> InputError:
        near = difflib.get_close_matches(str(name), known, 1)
        there = f'is {near[0]!r} meant?' if near else f'there are {", ".join(known)}'
        return self._wrong(f'{where} has the name {name!r}; {there}')

    def _shaped(self, where: str, given: ArrayLike, shape: tuple[int, ...]) -> Array:
        try:
            array = np.array(given, dtype=np.float64)
        except (TypeError, ValueError):
            raise self._wrong(f'{where} must hold numbers, is {given!r:.80}') from None
        if array.shape != shape:
            raise self._wrong(f'{where} has the shape {array.shape}, must have {shape}')
        return array


def _motion(about: dict[str, Any], arrays: dict[str, Array]) -> PlannedMotion:
    k = len(about['foot_names'])
    return PlannedMotion(
        time=about['time'].copy(),
        joints=np.array(arrays['joints']),
        torques=np.array(arrays['torques']),
        root=np.array(arrays['root']),
        com=np.array(arrays['com']),
        feet=arrays['feet'].reshape(-1, k, 3).copy(),
        forces=arrays['forces'].reshape(-1, k, 3).copy(),
        contact=about['contact'] != 0.0,
        joint_names=tuple(about['joint_names']),
        foot_names=tuple(about['foot_names']),
        task=about['task'],
        mass=float(arrays['mass'][0]),
        printed_volume=float(arrays['printed_volume'][0]),
    )


def asked(objective: 'Objective | ObjectiveFunction', check: bool) -> AskedObjective:
    """An objective, or a function that stands for one, as a run asks it."""
    if not isinstance(objective, Objective):
        objective = Objective(objective)
    return AskedObjective(objective, check)
