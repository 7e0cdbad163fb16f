# SPDX-License-Identifier: Apache-2.0
"""Processes that end, or fork, while something goes on in them."""

import os
import subprocess
import sys

import pytest

BEGIN = """
import os, sys, threading, time, warnings
import legwright as lw
robot, task = lw.Robot(sys.argv[1]), lw.Task.load(sys.argv[2])
"""
WAITS = """
session = lw.Session(robot, task)
session.start()
def work():
    while True:
        session.wait()
"""
FOLLOWS = """
session = lw.Session(robot, task)
def work():
    for event in session.events(timeout=1e9):
        pass
"""
STEPS = """
session = lw.Session(robot, task)
def work():
    while True:
        session.step()
"""
DESIGNS = """
def work():
    while True:
        lw.codesign(robot, task, on_iteration=lambda each: begun.set())
"""
VALIDATES = """
design = lw.codesign(robot, task, max_iterations=0, plan_only=True, reasons=False,
                     certificate=False)
def work():
    lw.validate(design, cycles=100000)
"""
ENDS = """
begun = threading.Event()
threading.Thread(target=work, daemon=True).start()
begun.wait(0.3)
print('ends', flush=True)
"""
FORKS = """
warnings.simplefilter('ignore')  # of threads that the child has not
session = lw.Session(robot, task)
session.wait()
child = os.fork()
if child == 0:
    for call in (session.start, session.wait, session.journal, lambda: session.state,
                 lambda: next(session.events())):
        try:
            call()
        except ValueError as error:
            assert 'belongs to another process' in str(error), error
        else:
            os._exit(3)
    assert 'belongs to another process' in repr(session)
    session.close()
    with lw.Session(robot, task) as own:
        own.wait()
    sys.exit(7)
assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
session.step()
session.close()
print('ends', flush=True)
"""


def run(code, examples, tmp_path):
    words = [sys.executable, '-c', BEGIN + code, examples / 'puppy/robot.xml']
    words.append(examples / 'puppy/sideways.toml')
    environment = {**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)}
    return subprocess.run(
        words, cwd=tmp_path, env=environment, timeout=120, check=False, capture_output=True
    )


@pytest.mark.parametrize('work', [WAITS, FOLLOWS, STEPS, DESIGNS, VALIDATES])
def test_an_interpreter_ends_while_a_daemon_thread_is_in_a_call(work, examples, tmp_path):
    done = run(work + ENDS, examples, tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (0, b'ends\n', b'')


def test_a_forked_child_is_refused_the_session_of_its_parent(examples, tmp_path):
    done = run(FORKS, examples, tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (0, b'ends\n', b'')
