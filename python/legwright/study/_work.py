# SPDX-License-Identifier: Apache-2.0
"""What a worker does: one point, from its inputs to a folder that is done."""

import os
import shutil
import socket
import time
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import legwright
from legwright._codesign import codesign
from legwright._design import Design
from legwright._errors import InputError, IoError, MujocoError
from legwright._program import completed
from legwright._robot import Robot
from legwright._task import Task
from legwright.study import _measures
from legwright.study._folder import StudyFolder, robot_address, write_record


@dataclass(frozen=True)
class Job:
    """A point as a worker gets it."""

    study: str
    """The study's folder, which all workers see."""
    hash: str
    inputs: Mapping[str, Any]
    pictures: bool


def work(job: Job) -> None:
    """Does a point, unless it is done. What the point's inputs are to blame for is its result, too.

    Raises:
        IoError: where the folder is not to be seen, full, or of another version of Legwright.
    """
    folder = StudyFolder(Path(job.study))
    if not folder.study_file.exists():
        raise IoError(
            f'{folder.root}: the worker on {socket.gethostname()} does not see it; a study on '
            'several machines needs a folder that all of them share'
        )
    if job.inputs['legwright'] != legwright.__version__:
        raise IoError(
            f'the worker on {socket.gethostname()} has legwright {legwright.__version__}, the '
            f'study {job.inputs["legwright"]}; install the same on both'
        )
    there = folder.record(job.hash)
    if there is not None:
        _add_picture(job, folder, there)
        return
    made = folder.scratch(job.hash)
    made.mkdir()
    own = os.open(made, os.O_RDONLY | os.O_DIRECTORY)  # held, so that no other folder is the same
    try:
        record = _carry_out(job, folder, made)
        if not made.exists() or not os.path.samestat(os.fstat(own), made.stat()):
            raise IoError(f'{made}: another `legwright study` removed it; this one was given up')
        write_record(made, record)
        if folder.record(job.hash) is None:
            folder.forget(job.hash)  # what stands there without a record is no point
        folder.finish(made, folder.point(job.hash))
    finally:
        os.close(own)
        shutil.rmtree(made, ignore_errors=True)


def _add_picture(job: Job, folder: StudyFolder, record: dict[str, Any]) -> None:
    """Draws a point that was done without pictures."""
    if not job.pictures or record['status'] != 'done' or 'picture' in record['measures']:
        return
    point = folder.point(job.hash)
    record['measures']['picture'] = _draw(Design.load(point))
    write_record(point, record)


def _carry_out(job: Job, folder: StudyFolder, made: Path) -> dict[str, Any]:
    """Fills the folder. @return its point.json"""
    start = time.perf_counter()
    record: dict[str, Any] = {'schema': 'legwright/study-point', 'version': 1, 'hash': job.hash}
    record |= {'inputs': dict(job.inputs), 'status': 'done', 'reason': None, 'measures': {}}
    try:
        record['measures'], record['warnings'] = _design(job, folder, made)
    except (InputError, MujocoError) as error:
        _empty(made)
        record |= {'status': 'refused', 'reason': str(error)}
    record['seconds'] = round(time.perf_counter() - start, 3)
    return record


def _empty(folder: Path) -> None:
    for each in folder.iterdir():
        if each.is_dir():
            shutil.rmtree(each)
        else:
            each.unlink()


def _design(job: Job, folder: StudyFolder, made: Path) -> tuple[dict[str, Any], list[str]]:
    """The co-design, its validation and picture. @return what it measured, what is doubtful"""
    if 'refusal' in job.inputs:
        raise InputError(job.inputs['refusal'])
    robot = Robot(folder.robots / robot_address(job.inputs['robot']) / 'robot.xml')
    task = Task._from_text(job.inputs['task'], folder.point(job.hash) / 'inputs/task.toml')
    with warnings.catch_warnings(record=True) as doubts:
        warnings.simplefilter('always')
        design = codesign(robot, task, folder=made, threads=1, **job.inputs['codesign'])
    measures = _measures.of_design(design)
    if job.inputs['validate'] is not None:
        _validate(job.inputs['validate'], made)
        measures |= _measures.of_validation(design)
    if job.pictures:
        measures['picture'] = _draw(design)
    return measures, [str(each.message) for each in doubts]


def _validate(options: Mapping[str, Any], run: Path) -> None:
    """`legwright validate`. Raises InputError where it refuses the run or the limits."""
    words = ['validate', str(run), '--threads', '1']
    words += ['--quick'] if options['quick'] else []
    for name in ('cycles', 'samples', 'seed'):
        words += [f'--{name}', str(options[name])]
    if options['limits'] is not None:
        (run / 'inputs/limits.toml').write_text(options['limits'], encoding='utf-8')
        words += ['--limits', str(run / 'inputs/limits.toml')]
    done = completed(*words)
    if done.returncode == 3:
        raise IoError(done.stderr.strip())
    if done.returncode not in (0, 1):
        raise InputError(f'legwright validate: {done.stderr.strip()}')


def _draw(design: Design) -> str | None:
    """A small picture, where OpenGL is there. @return its path in the run; None without one"""
    done = completed('render', str(design.folder), '--small')
    first = next(iter(design.tasks.values())).folder
    picture = first / 'result/small.webp'
    if done.returncode != 0 or not picture.exists():
        return None
    return picture.relative_to(design.folder).as_posix()
