# SPDX-License-Identifier: Apache-2.0
"""A run with the masses of its printed parts in the place of the hulls', and how it walks so."""

import contextlib
import hashlib
import json
import re
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import trimesh

from legwright import _core
from legwright._errors import InputError, unreadable
from legwright._files import MOST_OF_RUN, read_bytes
from legwright._validate import GAINS
from legwright.parts._checks import Check, at_most
from legwright.parts._gait import results_of
from legwright.parts._mesh_files import stl_bytes
from legwright.parts._robot import BuiltRobot, matrix
from legwright.parts._shapes import MM
from legwright.parts._solids import Part, Solid
from legwright.parts._words import Array

FOLDER = 'as_printed'
"""Of the run, in the folder of parts."""
_LEFT_OUT = re.compile(
    r'candidates/.*|checkpoint.*|(.*/)?\..*|.*/playback_\w+\.csv|.*/validation_\w+\.json'
    r'|.*/(verdict|comparison|numerics|robustness|matrix|strength)\.json'
    r'|((tasks/[^/]+/)?(result|iterations/\d+)/)?[^/]+\.(png|webp|html|md)'
)
"""What is of the masses that were planned: verdicts and pictures."""
_CYCLES = 20
_MOST_OFF = 0.1  # [%]


@dataclass(frozen=True)
class _Inertial:
    """Of a connector's body, in its frame, for the file."""

    body: str
    mass: float
    """[kg]"""
    place: Array
    inertia: Array
    """3 x 3 about the place [kg m2]."""

    def words(self) -> str:
        """The element."""
        i = self.inertia
        full = (i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2])
        place, numbers = (' '.join(f'{v:.12g}' for v in values) for values in (self.place, full))
        return f'<inertial pos="{place}" mass="{self.mass:.12g}" fullinertia="{numbers}"/>'


def _triangles(solid: Solid) -> trimesh.Trimesh:
    mesh = solid.shape.to_mesh64()
    return trimesh.Trimesh(np.asarray(mesh.vert_properties)[:, :3], mesh.tri_verts, process=False)


def _inertials(robot: BuiltRobot, solid: Solid) -> list[_Inertial]:
    """Each body of a connector has the share of the solid that its hull has of the hulls, about
    the solid's centre: together they weigh and turn as the solid does."""
    mesh, model, link = _triangles(solid), robot.model, solid.link
    centre = mesh.center_mass / MM
    inertia = mesh.moment_inertia * solid.density / MM**5
    out = []
    for hull in link.hulls:
        name = hull.words.name
        body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, name)
        turn, share = matrix(model.body_quat[body]), hull.mass / solid.file_mass
        place = turn.T @ (centre - model.body_pos[body])
        own = share * (turn.T @ inertia @ turn)
        out.append(_Inertial(name, share * solid.mass, place, own))
    return out


def _with_inertials(text: str, inertials: Sequence[_Inertial], file: Path) -> str:
    """The MJCF with these; all else stays as it is, byte for byte."""
    for each in inertials:
        body = rf'<body\b[^>]*\bname="{re.escape(each.body)}"[^>]*>'
        found = list(re.finditer(rf'({body}(?:\s|<!--.*?-->)*)<inertial\b[^>]*/>', text, re.DOTALL))
        if len(found) != 1:
            raise InputError(
                f'{file}: body {each.body}: expected one <inertial>, as its first element; put '
                'back what `legwright build` wrote'
            )
        text = text[: found[0].end(1)] + each.words() + text[found[0].end() :]
    return text


def _with_sums(
    record: bytes, place: str, files: Mapping[str, bytes], before: Mapping[str, str]
) -> bytes:
    """A run.json whose sums of scenes are those of the files below its place; all else stays.

    Args:
        before: SHA-256 of what was weighed anew, by its path. Of a scene that was edited, so that
            it is not the run's, the old sum stays, by which it is told.
    """
    for name, old in (json.loads(record).get('scenes') or {}).items():
        scene = files.get(place + name)
        if scene is not None and before.get(place + name) == old:
            sums = (old, hashlib.sha256(scene).hexdigest())
            record = record.replace(*(f'{json.dumps(name)}: "{each}"'.encode() for each in sums))
    return record


def as_printed(
    robot: BuiltRobot, parts: Sequence[Part], run: Path, folder: Path
) -> dict[str, bytes]:
    """The files of the run, whose results weigh what is printed of their links.

    Empty where the run has no run.json: what is no whole run cannot be played. The trunk weighs
    what its module does, as does a foot that stands on a peg. `folder`, where parts are written,
    may be in the run and is left out of it.
    """
    if not (run / 'run.json').is_file():
        return {}
    inertials = [
        each
        for part in parts
        for solid in part.solids
        if solid.link.servo is not None
        for each in _inertials(robot, solid)
    ]
    results = {result.relative_to(run) for result in results_of(run).values()}
    if (run / 'result').is_dir():
        results.add(Path('result'))
    weighed = {result / name for result in results for name in ('robot.xml', 'scene.xml')}
    written = folder.resolve()
    files: dict[str, bytes] = {}
    before: dict[str, str] = {}
    for file in sorted(path for path in run.rglob('*') if path.is_file()):
        name = file.relative_to(run)
        if file.resolve().is_relative_to(written) or _LEFT_OUT.fullmatch(name.as_posix()):
            continue
        try:
            data = read_bytes(file, MOST_OF_RUN)
        except OSError as error:
            raise unreadable(file, error, 'parts are made of a whole run') from None
        if name in weighed:
            before[f'{FOLDER}/{name.as_posix()}'] = hashlib.sha256(data).hexdigest()
            data = _with_inertials(data.decode(), inertials, file).encode()
        files[f'{FOLDER}/{name.as_posix()}'] = data
    for name in [each for each in files if each.endswith('run.json')]:
        files[name] = _with_sums(files[name], name.removesuffix('run.json'), files, before)
    return files


def _check_masses(parts: Sequence[Part], run: Path) -> list[Check]:
    """The masses in the file that is written against the volumes of the files that are printed."""
    model = mujoco.MjModel.from_xml_path(str(run / 'result/robot.xml'))
    checks = []
    for part in parts:
        if part.solid.link.servo is None:
            continue
        stl = stl_bytes(part.mesh)
        volume = trimesh.load(trimesh.util.wrap_as_stream(stl), file_type='stl').volume
        told = sum(model.body(hull.words.name).mass[0] for hull in part.solid.link.hulls)
        off = 100 * abs(told / (part.solid.density * volume / MM**3) - 1)
        what = 'mass as printed'
        cure = 'make the parts anew: file and solid are of the same triangles'
        checks.append(at_most(part.name, what, off, _MOST_OFF, '%', '', cure))
    return checks


def _verdict(run: Path, task: str) -> dict[str, Any]:
    """That of `validate --quick` on the result of a run, or of one of its tasks."""
    place = run / 'tasks' / task if task else run
    verdict: dict[str, Any] = json.loads(_core.validate(place, _CYCLES, list(GAINS), ''))['verdict']
    return verdict


def _check_walk(printed: Path, planned: Path, task: str) -> Check:
    """Whether MuJoCo passes the gait on the robot as it is printed."""
    verdict = _verdict(printed, task)
    passed, cure = bool(verdict['pass']), ''
    if not passed and _verdict(planned, task)['pass']:
        cure = (
            'as planned it passes: give the hulls the mass of their prints, by the density of '
            '[link] in the assembly (bom.md has both masses), then build and optimise anew'
        )
    elif not passed:
        cure = 'as planned it fails, too: find a design that passes first (legwright optimize)'
    name = f'walks as printed, {task}' if task else 'walks as printed'
    return Check('', name, passed, None, '', 'that MuJoCo passes it', verdict['line'], cure)


@contextlib.contextmanager
def unpacked(files: Mapping[str, bytes]) -> Iterator[Path | None]:
    """A folder for a while with the run as printed; None where there is none."""
    if not files:
        yield None
        return
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder)
        for name, data in files.items():
            (path / name).parent.mkdir(parents=True, exist_ok=True)
            (path / name).write_bytes(data)
        yield path / FOLDER


def check_as_printed(printed: Path, parts: Sequence[Part], run: Path) -> list[Check]:
    """Plays the run with the masses as printed, in its folder.

    The same limits and gains as of `legwright validate --quick`.
    """
    walks = [_check_walk(printed, run, task) for task in results_of(printed)]
    return [*_check_masses(parts, printed), *walks]
