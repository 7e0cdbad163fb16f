# SPDX-License-Identifier: Apache-2.0
"""What physics says of a design, in MuJoCo or in a second engine."""

import json
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from legwright import _core
from legwright._arguments import limits_file
from legwright._design import Design
from legwright._errors import InputError
from legwright._options import Option, checked, kind_of

_CYCLES = Option(int, 20, 4, 100000)
GAINS = (0.5, 1.0, 2.0)
DRAKE = 'pip install "legwright[drake]" (from a clone: pip install ".[drake]")'


@dataclass(frozen=True)
class Validation:
    """The verdict of one engine on a design, and what it was passed on."""

    engine: str
    """"mujoco" or "drake"."""
    version: str
    """Of the engine."""
    passed: bool
    """Whether the gait keeps its limits at all gains."""
    line: str
    """The verdict in words: "PASS  walk sideways at 0.100 m/s: …"."""
    reasons: tuple[str, ...]
    """Why it fails, first cause first; else empty."""
    passes: Mapping[str, bool]
    """By servo gains ("half", "default", "double"): the verdict on that roll-out alone."""
    metrics: Mapping[str, Mapping[str, Any]] = field(repr=False)
    """What was measured, by servo gains; keys and units as in result/metrics.json."""
    record: Mapping[str, Any] = field(repr=False)
    """All of it: docs/schema/engine_validation.schema.json is its schema."""

    def __bool__(self) -> bool:
        return self.passed

    def __str__(self) -> str:
        return self.line

    @classmethod
    def of(cls, text: str) -> 'Validation':
        """From a JSON text of that schema."""
        record = json.loads(text)
        verdict = record['verdict']
        return cls(
            engine=record['engine'],
            version=record['engine_version'],
            passed=verdict['pass'],
            line=verdict['line'],
            reasons=tuple(verdict['reasons']),
            passes=record['passes'],
            metrics=record['result'],
            record=record,
        )


def _factors(gains: Any) -> list[float]:
    """Gains as numbers. Raises InputError for what is none."""
    try:
        if isinstance(gains, (str, bytes)):
            raise TypeError
        return [float(each) for each in gains]
    except (TypeError, ValueError):
        message = f'are {gains!r:.80}; expected a list of factors above 0, as [0.5, 1.0, 2.0]'
        raise InputError(f'gains: {message}', '', 0, 'gains', message) from None


def validate(
    design: Design,
    *,
    engine: Literal['mujoco', 'drake'] = 'mujoco',
    gains: Iterable[float] = GAINS,
    cycles: int = 20,
    limits: str | os.PathLike[str] | None = None,
) -> Validation:
    """Plays a design and judges it by the measures and limits of `legwright validate`.

    In MuJoCo it is what `legwright validate --quick` says of the result; other numerics, stability
    and robustness are that command's. In Drake the plant is built from the same compiled model,
    with another contact model and another solver: bodies, inertias, joints with limits, damping and
    armature, servos with limits of torque, and what may touch the floor, which must be a plane.
    Nothing is written into the design's folder.

    Args:
        design: of one task.
        engine: who plays: 'mujoco', with the plugin, or 'drake'.
        gains: factors on the servos' kp; kd goes with their square roots.
        cycles: of the gait, at least 4.
        limits: a TOML file of what passes, as examples/limits.toml; default: what holds by default.

    Raises:
        ImportError: for Drake where it is not installed, with what to install.
        InputError: for a scene that the engine cannot play, with what it lacks; for limits that are
            wrong or need what is not measured here.
        IoError: where the design has no scene, and for a file of limits that cannot be read.
        KeyboardInterrupt: on Ctrl-C, at once.
        TypeError: for what is no Design.
        ValueError: for a design of several tasks (take design.tasks[NAME]), another engine, no
            gains or too few cycles.
    """
    if not isinstance(design, Design):
        raise TypeError(
            f'design is {kind_of(design)}; expected a legwright.Design, as codesign() hands it '
            'back or Design.load("runs/mine") reads it'
        )
    design._of_one_task('a validation')
    file: str | Path = '' if limits is None else limits_file(limits)
    words = checked({'cycles': _CYCLES}, {'cycles': cycles})
    scales = _factors(gains)
    if engine == 'mujoco':
        return Validation.of(_core.validate(design._run, words['cycles'], scales, file))
    if engine == 'drake':
        return in_drake(design, gains=scales, cycles=words['cycles'], limits=file)
    raise ValueError(f"engine: expected 'mujoco' or 'drake', found {engine!r}")


def in_drake(
    design: Design,
    *,
    gains: Sequence[float],
    cycles: int,
    limits: str | os.PathLike[str],
    write: bool = False,
    watch: Callable[[float, float], None] | None = None,
) -> Validation:
    """validate() in Drake.

    Args:
        write: result/validation_drake.json, where `legwright report` finds it.
        watch: called with the gains' factor and the time [s] before each step.
    """
    try:
        from legwright.drake import player
    except ImportError as error:
        raise ImportError(f'the engine Drake is not here ({error}): {DRAKE}') from error
    model = design.model()

    def start(gait: Any) -> Callable[[float], player.Step]:
        playing = player.Player(model, gait)
        if watch is None:
            return playing.step

        def step(time: float) -> player.Step:
            watch(gait.gain_scale, time)
            return playing.step(time)

        return step

    return Validation.of(
        _core.validate_in_engine(
            design._run, 'drake', player.VERSION, start, cycles, list(gains), limits, write
        )
    )
