# SPDX-License-Identifier: Apache-2.0
"""What a co-design hands back: a view of a run folder."""

import os
import tempfile
from collections.abc import Iterable, Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from legwright import _command, _program
from legwright._arguments import path_of, phases_of
from legwright._errors import IoError, check_readable
from legwright._files import read_json
from legwright._html import design_html
from legwright._judgement import Judgement, judge, options_of
from legwright._motion import MADE_ANEW, Motion, read_motion
from legwright._options import FORCE, checked, export_words, kind_of
from legwright._plugin import served_mujoco
from legwright._run_folder import check_unchanged, read_run, save_run
from legwright._verdict import FrontPoint, Verdict, finite_or_inf
from legwright._why import Change, changes_of


class Design:
    """A body with its motion, as codesign() or `legwright optimize` left it in a run folder.

    Of several tasks, what belongs to one task (`motion`, `model()`) is asked of `tasks[NAME]`.
    """

    def __init__(
        self,
        folder: str | os.PathLike[str],
        temporary: 'tempfile.TemporaryDirectory[str] | None' = None,
    ) -> None:
        """A run folder. Raises as load(); `temporary` goes with the design."""
        self.folder = path_of('folder', folder)
        """Where its files are; a temporary one goes with the design."""
        self._temporary = temporary
        self._played: dict[str, Any] | None = None
        """Of one of several tasks: what MuJoCo says of it, which stands in the record of all."""
        self.record, self._digest = read_run(self.folder)
        """All that run.json says: docs/schema/run.schema.json is its schema."""

    @classmethod
    def load(cls, folder: str | os.PathLike[str]) -> 'Design':
        """The design of a run folder.

        Raises:
            IoError: where it holds no run.
            InputError: where its search has not come to an end, so that there is no design.
        """
        return cls(folder)

    # ---- copies ----

    def __getstate__(self) -> dict[str, Any]:
        if self._temporary is not None:
            raise TypeError(
                f'the design lies in a temporary folder, {self.folder}, which goes with it and '
                'cannot be pickled: give codesign() a folder=, or load what save() writes'
            )
        return self.__dict__

    def __copy__(self) -> 'Design':
        copy = object.__new__(type(self))
        copy.__dict__.update(self.__dict__)
        return copy

    def __deepcopy__(self, memo: dict[int, Any]) -> 'Design':
        """The same: what it holds is not changed, and its folder stays as long as one of them."""
        return self.__copy__()

    @property
    def _run(self) -> Path:
        """Its folder, where there is still what was read: what else is read there belongs to it."""
        check_unchanged(self.folder, self._digest)
        return self.folder

    def _json(self, name: str) -> dict[str, Any] | None:
        """The document of a file of the run; None where there is none."""
        file = self._run / name
        return read_json(file) if file.exists() else None

    # ---- the body and its cost ----

    @property
    def parameters(self) -> dict[str, float]:
        """The body: value of each design parameter by name [m, rad]."""
        return {each['name']: each['final'] for each in self.record['parameters']}

    @property
    def s(self) -> NDArray[np.float64]:
        """The body, in the order of robot.parameters [m, rad]."""
        return np.array(list(self.parameters.values()), dtype=np.float64)

    @property
    def initial_s(self) -> NDArray[np.float64]:
        """The given body, likewise."""
        return np.array([each['initial'] for each in self.record['parameters']], dtype=np.float64)

    @property
    def F(self) -> float:
        """The cost of the task as it was given; of several the weighted sum, without J. Infinite
        where the search found no motion.

        It is that of the design handed back: where MuJoCo does not pass the optimum, one that it
        passes costs more than the optimum does, and more than `front` at the same weights;
        `optimum_F` tells that cost."""
        return finite_or_inf(self.record['final_F'])

    @property
    def optimum_F(self) -> float:
        """F of the optimum, in the place of which a design that MuJoCo passes may have been handed
        back; that of the design itself where MuJoCo was not asked."""
        choice = self.record.get('choice')
        played = [] if choice is None else choice['candidates']
        found = [each['F'] for each in played if each['name'] == 'optimum']
        return finite_or_inf(found[0]) if found else self.F

    @property
    def J(self) -> float:
        """The outer objective; 0 without one; of several tasks the weighted sum."""
        if not self.joint:
            return finite_or_inf(self.record['final_J'])
        tasks = self.record['tasks']
        return float(sum(task['weight'] * self.tasks[task['name']].J for task in tasks))

    @property
    def motion_only_F(self) -> float:
        """F of the given body with its best motion."""
        return finite_or_inf(self.record['motion_only_F'])

    @cached_property
    def terms(self) -> dict[str, float]:
        """What F consists of, by term; of several tasks the weighted sums."""
        if not self.joint:
            found = self.record['final_terms'] or {}
            return {name: finite_or_inf(value) for name, value in found.items()}
        sums: dict[str, float] = {}
        for task in self.record['tasks']:
            for name, value in self.tasks[task['name']].terms.items():
                sums[name] = sums.get(name, 0.0) + task['weight'] * value
        return sums

    # ---- how it came about, and what physics says ----

    @property
    def status(self) -> str:
        """How the search ended: "converged", "stalled", "iteration_limit", "stopped"; "designed in
        a session" or "designed in the Studio" where somebody saved it there."""
        return str(self.record['status'])

    @property
    def feasible(self) -> bool:
        """Whether the plan keeps its constraints and MuJoCo, where it was to be asked, passes it:
        exit code 0, not 1. With plan_only it is the plan alone; a run that was interrupted before
        MuJoCo had an answer is not feasible."""
        return bool(self.record['feasible'])

    @property
    def reasons(self) -> list[str]:
        """Why it is not feasible; else empty."""
        return list(self.record['reasons'])

    @property
    def verdict(self) -> Verdict | None:
        """What MuJoCo says of the result; None where it was not asked: plan_only, or an iterate
        that was picked. Of several tasks of all together; `tasks[NAME]` has that of each."""
        steps = self.record.get('physics_steps')
        if steps is not None and steps['changed']:
            played = steps['after']
        else:
            chosen = self._chosen
            played = self._played if chosen is None else chosen['played']
        if played is None:
            return None
        return Verdict(played['pass'], played['line'], finite_or_inf(played['merit']))

    @property
    def _chosen(self) -> dict[str, Any] | None:
        """Of what was played before the choice, the result."""
        choice = self.record.get('choice')
        if choice is None:
            return None
        name = self.record.get('picked') or choice['chosen']
        return next((each for each in choice['candidates'] if each['name'] == name), None)

    @cached_property
    def certificate(self) -> dict[str, Any] | None:
        """How well the result is an optimum (result/certificate.json); None where not asked for."""
        return self._json('result/certificate.json')

    @cached_property
    def why(self) -> list[Change]:
        """The changes of the body and what each buys, most first; they do not add up."""
        return changes_of(self.record)

    # ---- the tasks ----

    @property
    def joint(self) -> bool:
        """Whether one body does several tasks."""
        return 'tasks' in self.record

    @cached_property
    def tasks(self) -> Mapping[str, 'Design']:
        """The design as each task has it, by name; one task: itself."""
        if not self.joint:
            return {self.record['task']['name']: self}
        folder, played = self._run / 'tasks', (self._chosen or {}).get('tasks') or {}
        designs: dict[str, Design] = {}
        for task in self.record['tasks']:
            name = task['name']
            designs[name] = Design(folder / name, self._temporary)
            designs[name]._played = played.get(name)
        return designs

    @cached_property
    def front(self) -> list[FrontPoint]:
        """The trade-off between two tasks, by rising weight of the first; empty where codesign()
        was not asked for it. The bodies are optima of F, which MuJoCo has not judged: the design
        may cost more than the point of its weights (see F)."""
        document = self._json('result/front.json')
        return [] if document is None else [
            FrontPoint(
                point['weight'],
                finite_or_inf(point['F']),
                {name: finite_or_inf(F) for name, F in point['F_tasks'].items()},
                np.array(list(point['s'].values()), dtype=np.float64),
                point['status'],
            )
            for point in document['points']
        ]

    def _of_one_task(self, what: str) -> None:
        if self.joint:
            names = ', '.join(repr(name) for name in self.tasks)
            raise ValueError(f'{what} belongs to one task: design.tasks[NAME], NAME of {names}')

    @cached_property
    def motion(self) -> Motion:
        """The planned motion. Raises ValueError for several tasks."""
        self._of_one_task('a motion')
        return read_motion(self._run / 'result/motion.csv')

    def model(self) -> Any:
        """The robot on its ground with the gait: a mujoco.MjModel with the plugin.

        Raises:
            ImportError: where mujoco is not installed in the version served, with what to install.
            IoError: where the run has no scene.
            ValueError: for several tasks.
        """
        self._of_one_task('a model')
        mujoco = served_mujoco()
        scene = self._run / 'result/scene.xml'
        check_readable(scene, MADE_ANEW)
        return mujoco.MjModel.from_xml_path(str(scene))

    def data(self, model: Any) -> Any:
        """A mujoco.MjData of model() in the gait's first pose, from where mj_step() walks on: that
        of the keyframe `gait`, where a plain MjData has all joints at zero and falls.

        Raises ValueError for another model, which has no such keyframe.
        """
        mujoco = served_mujoco()
        if not isinstance(model, mujoco.MjModel):
            raise TypeError(f'model is {kind_of(model)}; expected the one that model() gives')
        key = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_KEY, 'gait')
        if key < 0:
            raise ValueError(
                "the model is not this design's: it has no keyframe 'gait'; give the one of model()"
            )
        data = mujoco.MjData(model)
        mujoco.mj_resetDataKeyframe(model, data, key)
        mujoco.mj_forward(model, data)
        return data

    # ---- files ----

    def save(self, folder: str | os.PathLike[str], *, force: bool = False) -> Path:
        """Writes the run folder that `legwright optimize` writes; validate, render, report and play
        take it.

        Args:
            force: replace the run that the folder holds.

        Raises:
            IoError: where the folder holds a run, cannot be written, or lies in that of the design
                or around it.
        """
        replaces: bool = checked(FORCE, {'force': force})['force']
        return save_run(self._run, path_of('folder', folder), replaces)

    # ---- what the program's other verbs make of it ----

    def validate(
        self,
        *,
        limits: str | os.PathLike[str] | None = None,
        quick: bool = False,
        cycles: int = 20,
        samples: int = 200,
        seed: int = 1,
        threads: int = 0,
    ) -> Judgement:
        """The whole verdict of `legwright validate`: three gains, other numerics, disturbances.

        What it measures stands in `folder` then, where render() and report() find it;
        legwright.validate() writes nothing.

        Args:
            limits: a TOML file of what passes, as examples/limits.toml; default: what holds by
                default.
            quick: at three gains alone.
            cycles: of the gait.
            samples: walks with all disturbances at once.
            seed: of these.
            threads: default: all cores; results do not depend on it.

        Raises:
            InputError: for options outside their range, by keyword; for limits that are wrong.
            IoError: where the folder cannot be written.
            KeyboardInterrupt: on Ctrl-C, within two seconds; what an earlier one wrote stays.
        """
        given = {'quick': quick, 'cycles': cycles, 'samples': samples, 'seed': seed}
        options = options_of(given | {'threads': threads}, limits)
        tasks = {name: each.folder for name, each in self.tasks.items()} if self.joint else {}
        return judge(self._run, tasks, options)

    def render(self, *, phases: Iterable[float] = ()) -> list[Path]:
        """Draws the run's pictures into `folder`, off-screen, as `legwright render`.

        Those of what physics did need validate() first; what is left out is a LegwrightWarning.

        Args:
            phases: of the cycle, 0 to 1: also a still at each.

        Returns:
            the files, `result/gait.webp` among them.

        Raises:
            InputError: for a phase that is none.
            IoError: without OpenGL (OSMesa or EGL), and where the folder cannot be written.
        """
        words = [word for phase in phases_of(phases) for word in ('--phase', repr(phase))]
        document = _program.answer('render', str(self._run), *words)
        return [Path(each['file']) for each in document['files']]

    def report(self) -> Path:
        """Writes the report of the run, as `legwright report`: one page that opens from disk.

        What it tells of physics and shows as pictures is what validate() and render() wrote.

        Raises IoError where the folder cannot be written.
        """
        return Path(_program.answer('report', str(self._run))['report'])

    def export(
        self,
        folder: str | os.PathLike[str],
        *,
        picture: bool = True,
        urdf: bool = False,
        ros: bool = False,
    ) -> Path:
        """Puts the robot and its gait into a new folder, for stock MuJoCo, as `legwright export`.

        Args:
            folder: which must not exist.
            picture: draw one of the robot; needs OpenGL.
            urdf: also as URDF, with its meshes.
            ros: also as a ROS 2 package.

        Returns:
            the folder; its README.md tells what the files are.

        Raises:
            InputError: for a robot that URDF cannot tell; for options that are no true or false.
            IoError: where the folder exists or cannot be written.
        """
        target = path_of('folder', folder)
        if target.exists():
            raise IoError(f'{target}: exists already; name a new folder, or remove it')
        words = export_words({'picture': picture, 'urdf': urdf, 'ros': ros})
        accepted = (_command.OK, _command.NOT_ALL)  # the second: MuJoCo warns of it
        _program.answer('export', str(self._run), '-o', str(target), *words, accepted=accepted)
        return target

    def _repr_html_(self) -> str:
        """For notebooks: verdict, cost, changed parameters, and pictures of a run that has some."""
        return design_html(self)

    def __repr__(self) -> str:
        verdict = self.verdict
        return f'<Design F = {self.F:.4g}: {verdict if verdict else self.status}>'
