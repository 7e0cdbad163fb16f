# SPDX-License-Identifier: Apache-2.0
"""Design.validate(), render(), report() and export(): what the program's verbs make of a run."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import legwright as lw
import pytest


@pytest.fixture
def saved(walk, tmp_path):
    """A copy of the walk that may be written to."""
    return lw.Design.load(walk.save(tmp_path / 'run'))


def test_a_design_is_judged_drawn_told_and_exported(walk, saved, tmp_path):
    with pytest.warns(lw.LegwrightWarning, match=r'strip_physics\.png: .*validate first'):
        assert saved.folder / 'result/strip_physics.png' not in saved.render()
    judged = saved.validate(quick=True)
    assert judged and str(judged) == judged.line == lw.validate(walk).line
    assert judged.reasons == () and judged.tasks == {}
    for said in (judged, lw.validate(walk)):
        assert judged.line in repr(said) and len(repr(said)) < 400  # a notebook shows it
    assert judged.metrics['result']['default']['speed_ratio'] > 0.95
    assert judged.numerics is None and judged.robustness is None

    files = saved.render(phases=[0.25])
    names = {each.relative_to(saved.folder).as_posix() for each in files}
    assert {'result/strip_physics.png', 'result/gait.webp', 'result/still_0.25.png'} <= names
    assert all(each.is_file() for each in files)
    page = saved.report()
    assert page == saved.folder / 'report.html'
    assert judged.line in page.read_text(encoding='utf-8').replace('&#39;', "'")

    out = saved.export(tmp_path / 'out', picture=False, urdf=True)
    assert (out / 'walk.xml').is_file() and (out / 'README.md').is_file()
    assert list((out / 'urdf').glob('*.urdf')) and not list(out.glob('*.png'))
    with pytest.raises(lw.IoError, match='out: exists already; name a new folder'):
        saved.export(tmp_path / 'out')


def test_a_verdict_that_fails_is_handed_back_with_its_reasons(saved, tmp_path):
    limits = tmp_path / 'limits.toml'
    limits.write_text('[tilt]\nhigh = 1e-6\n')
    judged = saved.validate(limits=limits, samples=2, cycles=4)
    assert not judged and judged.line.startswith('FAIL')
    assert any('tilts by' in reason for reason in judged.reasons)
    assert judged.robustness['monte_carlo']['samples'] == 2
    assert judged.numerics['runs'] and judged.record['schema'] == 'legwright/verdict'


def test_several_tasks_are_judged_together_and_each(puppy, tmp_path):
    gait = {'name': 'walk', 'period': 1.0, 'knots': 12}
    each = [lw.Task(gait, (0.05, 0.0), name='ahead'), lw.Task(gait, (0.0, 0.05), name='left')]
    design = lw.codesign(
        puppy, each, folder=tmp_path / 'run', motion_only=True, plan_only=True, certificate=False
    )
    judged = design.validate(quick=True)
    assert list(judged.tasks) == ['ahead', 'left']
    assert judged.passed == all(judged.tasks.values())
    assert judged.record['schema'] == 'legwright/matrix'
    assert [line.split(':')[0] for line in judged.line.splitlines()] == ['ahead', 'left']
    assert judged.tasks['left'].line == design.tasks['left'].validate(quick=True).line


def test_what_cannot_be_asked_is_told(saved, tmp_path):
    with pytest.raises(lw.InputError, match='cycles: is 3; expected 4 to 10000') as refused:
        saved.validate(cycles=3, samples=-1)
    assert [each.where for each in refused.value.reasons] == ['cycles', 'samples']
    with pytest.raises(TypeError, match='limits is an integer; expected a path'):
        saved.validate(limits=3)
    with pytest.raises(lw.IoError, match='none.toml'):
        saved.validate(limits=tmp_path / 'none.toml')
    for phase, words in ((2.0, 'is 2.0; expected 0 to 1'), ('a', 'is a text; expected a number')):
        with pytest.raises(lw.InputError, match=f'phases: {words}'):
            saved.render(phases=[phase])
    with pytest.raises(TypeError, match='folder is an integer; expected a path'):
        saved.export(3)


def test_a_run_that_cannot_be_written_gets_no_old_verdict(saved, monkeypatch):
    saved.validate(quick=True)
    monkeypatch.setattr(os, 'access', lambda path, mode: False)  # root may write anywhere
    with pytest.raises(lw.IoError, match=r'cannot be written; save\(\) the design'):
        saved.validate(quick=True)


def test_what_the_program_warns_of_is_a_warning(saved, tmp_path, monkeypatch):
    monkeypatch.setenv('LEGWRIGHT_GL', 'none')
    with pytest.warns(lw.LegwrightWarning, match='^warning: no picture'):
        saved.export(tmp_path / 'out')


def test_an_edited_run_is_refused(saved):
    with (saved.folder / 'inputs/task.toml').open('a') as task:
        task.write('# edited\n')
    with pytest.raises(lw.InputError, match='task.toml: is not what the run started from'):
        saved.validate()


def test_ctrl_c_ends_the_program_too(saved):
    code = (
        'import signal\nimport legwright as lw\n'
        'signal.signal(signal.SIGINT, signal.default_int_handler)\n'  # a job may ignore it
        f'design = lw.Design.load({str(saved.folder)!r})\n'
        'print("begins", flush=True)\n'
        'try:\n'
        '    design.validate(samples=100000)\n'
        'except KeyboardInterrupt:\n'
        '    print("interrupted")\n'
    )
    words = [sys.executable, '-c', code]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as child:
        try:
            assert child.stdout.readline() == 'begins\n'
            while not children_of(child.pid):
                time.sleep(0.05)
            program = children_of(child.pid)[0]
            time.sleep(0.5)
            child.send_signal(signal.SIGINT)
            assert child.communicate(timeout=60)[0] == 'interrupted\n'
        finally:
            child.kill()  # the program dies with it
    with pytest.raises(ProcessLookupError):
        os.kill(program, 0)
    assert not list(saved.folder.rglob('.*.tmp'))
    assert not (saved.folder / 'result/verdict.json').exists()


def children_of(process):
    """Process ids, of those that its main thread began."""
    told = Path(f'/proc/{process}/task/{process}/children').read_text()
    return [int(each) for each in told.split()]
