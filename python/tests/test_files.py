# SPDX-License-Identifier: Apache-2.0
"""Files that somebody else may have written are regular and of limited size, or refused at once."""

import os
import signal

import legwright as lw
import pytest
from legwright import _files
from legwright.parts._words import read_words
from legwright.study._file import read_study
from legwright.study._folder import FolderRobots, StudyFolder
from legwright.study._points import points_of

KIND = 'is a pipe, a socket or a device; expected a regular file'


@pytest.fixture
def pipe(tmp_path):
    """Nobody writes into it: who waits for that is interrupted."""

    def interrupt(*_):
        raise AssertionError('a pipe is waited for')

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.alarm(10)
    file = tmp_path / 'pipe.toml'
    os.mkfifo(file)
    yield file
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


@pytest.fixture
def large(tmp_path):
    """Of 65 MiB, none of which is on the disk."""
    file = tmp_path / 'large.toml'
    file.touch()
    os.truncate(file, 65 << 20)
    return file


def test_what_is_no_regular_file_is_refused(pipe, tmp_path):
    for file in (pipe, '/dev/zero'):
        with pytest.raises(OSError, match=KIND):
            _files.read_bytes(file)
        with pytest.raises(OSError, match=KIND):
            _files.open_regular(file)
    with pytest.raises(IsADirectoryError):
        _files.read_bytes(tmp_path)
    with pytest.raises(FileNotFoundError):
        _files.read_bytes(tmp_path / 'none')


def test_sizes_are_limited(tmp_path, large):
    file = tmp_path / 'file'
    file.write_bytes(b'x' * (1 << 20))
    assert _files.read_text(file, 1 << 20) == 'x' * (1 << 20)
    file.write_bytes(b'x' * ((1 << 20) + 1))
    with pytest.raises(OSError, match='larger than 1 MiB'):
        _files.read_text(file, 1 << 20)
    with pytest.raises(OSError, match='larger than 64 MiB'):
        _files.read_json(large)


def test_json_that_nests_too_deep_is_refused(tmp_path):
    file = tmp_path / 'deep.json'
    file.write_text('{"a": [1.5]}', encoding='utf-8')
    assert _files.read_json(file) == {'a': [1.5]}
    file.write_text('[' * 100_000 + ']' * 100_000, encoding='utf-8')
    with pytest.raises(ValueError, match=r'deep\.json: its JSON nests too deep'):
        _files.read_json(file)
    file.write_text('{"a": ', encoding='utf-8')
    with pytest.raises(ValueError, match=r'deep\.json: is damaged, it is no JSON \(Expecting'):
        _files.read_json(file)


def test_files_of_users_are_read_so(pipe, large, tmp_path):
    output = tmp_path / 'robot.xml'
    for read in (lw.Task.load, lw.Robot, read_words, lambda file: lw.build(file, output)):
        with pytest.raises(lw.IoError, match=f'{pipe}: {KIND}; give'):
            read(pipe)
    with pytest.raises(lw.InputError, match=f'{pipe}: {KIND}; give'):
        read_study(pipe)
    with pytest.raises(lw.IoError, match='larger than 1 MiB; give the path of a task file'):
        lw.Task.load(large)
    with pytest.raises(lw.IoError, match='larger than 64 MiB; give the path of an assembly file'):
        lw.build(large, output)
    with pytest.raises(lw.InputError, match='larger than 64 MiB; give the path of a study file'):
        read_study(large)
    assert not output.exists()


def test_what_a_study_names_is_read_so(pipe):
    study = pipe.with_name('study.toml')
    named = f'assembly = "{pipe.name}"\ntask = "{pipe.name}"\n'
    study.write_text(f'{named}[grid]\ngait.period = [0.4, 0.5]\n', encoding='utf-8')
    robots = FolderRobots(StudyFolder.make(pipe.with_name('study')))
    with pytest.raises(lw.InputError) as caught:
        points_of(read_study(study), robots)
    assert str(caught.value).count(f'{pipe} cannot be read: {KIND}') == 2
