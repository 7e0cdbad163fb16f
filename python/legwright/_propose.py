# SPDX-License-Identifier: Apache-2.0
"""What a robot that declares nothing could let change."""

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from legwright import _core
from legwright._arguments import path_of
from legwright._errors import InputError
from legwright._robot_source import file_of

_AXES = ('+x', '-x', '+y', '-y')


@dataclass(frozen=True)
class Proposal:
    """A design parameter that a robot could declare."""

    name: str
    """That the file would declare it under."""
    value: float
    """Of the given body, in `unit`."""
    bounds: tuple[float, float]
    """Lower and upper, in `unit`."""
    unit: str
    """"m" or "rad"."""
    binding: str
    """What follows it, as the file declares it: "stretch link: FL_shank FR_shank"."""
    sentence: str
    """What it is, for people."""


class Proposals(Mapping[str, Proposal]):
    """What propose() found: the proposals by name, and what it saw."""

    def __init__(self, studied: _core.StudiedRobot) -> None:
        self._studied = studied
        self._by_name = {
            each.name: Proposal(
                each.name,
                each.value,
                (each.lower, each.upper),
                each.unit,
                each.binding,
                each.sentence,
            )
            for each in studied.proposals
        }
        self.legs: dict[str, list[str]] = dict(studied.legs)
        """Joints of each leg from the trunk on, by the foot's name; front to hind, left first."""
        self.left_out: dict[str, str] = {}
        """What is not proposed, and why."""
        for each in studied.left_out:
            name, _, why = each.partition(': ')
            self.left_out[name] = why
        self.declared: list[str] = list(studied.declared)
        """Parameters that the file declares already."""
        self.not_standing: str = studied.not_standing
        """Why the home pose is none to walk from; empty where it is one."""
        self.mended: list[str] = list(studied.mended)
        """What write() changes besides, a sentence each: of a URDF that is mended, of a trunk's
        frame that is turned upright, of six joints in the place of a free one."""

    def __getitem__(self, name: str) -> Proposal:
        return self._by_name[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_name)

    def __len__(self) -> int:
        return len(self._by_name)

    def write(self, output: str | os.PathLike[str] | None = None) -> Path:
        """Declares them in the robot's file, or in a new one; all other bytes stay.

        Args:
            output: the new file; it lies in the robot's folder where the robot has meshes or
                includes. Default: the robot's own file.

        Returns:
            The file, for Robot().

        Raises:
            InputError: where the robot's other files would not be found from there, or a URDF gets
                no `output`.
            IoError: where `output` is there already, or the robot's file has been changed since
                propose() read it.
            OSError: where it cannot be written.
        """
        return Path(self._studied.write('' if output is None else str(path_of('output', output))))

    def __repr__(self) -> str:
        if not self:
            return f'<no proposals; {len(self.declared)} parameters are declared>'
        return '\n'.join(
            f'<{each.name} = {each.value:g} {each.unit}, {each.bounds[0]:g} to '
            f'{each.bounds[1]:g}: {each.sentence}>'
            for each in self.values()
        )


def propose(file: str | os.PathLike[str], *, forward: str | None = None) -> Proposals:
    """Studies a robot's MJCF or URDF and proposes its design parameters, as `legwright init`.

    Links of legs may change in length, joints in their axes, the trunk in length and width; left
    and right are tied. Each proposal is tried on the file itself. Nothing is written. A URDF is
    studied as the MJCF that `write` makes of it.

    Args:
        forward: axis of the trunk's frame that the robot looks along: "+x", "-x", "+y" or "-y", by
            which legs are paired; default: as it seems to face.

    Raises:
        InputError: for anything wrong with the file, with its line; for another axis.
        IoError: where it is not there or cannot be read.
    """
    if forward is not None and forward not in _AXES:
        message = f'is {forward!r}; expected one of {", ".join(_AXES)}, or None'
        raise InputError(f'forward: {message}', '', 0, 'forward', message)
    path_of('file', file)
    return Proposals(_core.study_robot(file_of(file, names=False), forward or ''))
