# SPDX-License-Identifier: Apache-2.0
"""Every public name says what it is: the site's page of the API consists of docstrings."""

import ast
import inspect
from pathlib import Path

import legwright as lw
import pytest

CLASSES = sorted(name for name in lw.__all__ if inspect.isclass(getattr(lw, name)))
PAGE = Path(__file__).resolve().parents[2] / 'docs/python_api.md'


def attributes_without_docstring(of_class):
    """Public attributes, of the class or set by __init__, that no string follows."""
    missing = []

    def look(body):
        for statement, after in zip(body, [*body[1:], None]):
            if not isinstance(statement, ast.Assign | ast.AnnAssign):
                continue
            target = statement.target if isinstance(statement, ast.AnnAssign) else None
            target = target or statement.targets[0]
            own = isinstance(target, ast.Attribute) and getattr(target.value, 'id', '') == 'self'
            name = target.attr if own else getattr(target, 'id', '_')
            told = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
            in_class = body is tree.body
            if (own or in_class) and not name.startswith('_') and not told:
                missing.append(name)

    tree = ast.parse(inspect.getsource(of_class)).body[0]
    look(tree.body)
    for part in tree.body:
        if isinstance(part, ast.FunctionDef) and part.name == '__init__':
            look(part.body)
    return missing


@pytest.mark.parametrize('name', CLASSES)
def test_classes_and_their_members_say_what_they_are(name):
    of_class = getattr(lw, name)
    assert inspect.getdoc(of_class)
    for member, value in vars(of_class).items():
        if not member.startswith('_') and (callable(value) or isinstance(value, property)):
            assert inspect.getdoc(value), f'{name}.{member}'
    if of_class.__module__.startswith('legwright._') and of_class is not lw.Iteration:
        assert attributes_without_docstring(of_class) == []


def test_the_page_of_the_api_has_every_public_name():
    told = {
        line.split('.')[-1]
        for line in PAGE.read_text(encoding='utf-8').splitlines()
        if line.startswith('::: legwright.')
    }
    constants = {'__version__', 'mujoco_version'}
    assert told == set(lw.__all__) - constants


@pytest.mark.parametrize('name', ['build', 'check', 'codesign', 'propose'])
def test_functions_tell_what_they_raise(name):
    assert 'Raises:' in inspect.getdoc(getattr(lw, name))
