# SPDX-License-Identifier: Apache-2.0
"""What the bill of materials adds up: prices of a library of one's own."""

import csv
import subprocess
from pathlib import Path

import pytest
from legwright import InputError, parts
from test_parts import PROGRAM


@pytest.fixture(scope='module')
def dog(examples, tmp_path_factory) -> Path:
    """The printable puppy, of servos and feet with a price."""
    folder = tmp_path_factory.mktemp('priced')
    modules = examples.parent / 'modules'
    (folder / 'own').mkdir()
    for name, price in (('xl430_w250', '23.9'), ('ball_foot_12', '0.5')):
        text = (modules / f'{name}.toml').read_text(encoding='utf-8')
        priced = text.replace('\nmass =', f'\nprice = {price}\nmass =', 1)
        assert priced != text
        (folder / f'own/{name}.toml').write_text(priced, encoding='utf-8')
    robot = folder / 'dog.xml'
    subprocess.run(
        [PROGRAM, 'build', examples / 'assemblies/printed_puppy.toml', '-o', robot,
         '--library', folder / 'own'],
        check=True,
        capture_output=True,
    )  # fmt: skip
    return robot


def test_the_bill_adds_prices_and_tells_of_what_it_knows_none(dog, tmp_path):
    made = parts.make(dog, tmp_path / 'out')
    with (made.folder / 'bom.csv').open(encoding='utf-8') as file:
        rows = {row['name']: row for row in csv.DictReader(file)}
    assert (rows['XL430-W250']['price'], rows['XL430-W250']['total_price']) == ('23.90', '191.20')
    assert rows['ball_foot_12']['total_price'] == '2.00'
    assert rows['lipo_3s_2200']['price'] == '' and rows['FL_thigh']['total_price'] == ''
    text = (made.folder / 'bom.md').read_text(encoding='utf-8')
    assert 'Prices come to 193.20, not known of 1 of 13 modules' in text


def test_without_prices_the_bill_says_how_to_give_some(dog, tmp_path):
    text = dog.read_text(encoding='utf-8')
    robot = tmp_path / 'robot.xml'
    robot.write_text(text.replace(' | price 23.9', '').replace(' | price 0.5', ''))
    parts.make(robot, tmp_path / 'out')
    assert 'No module file gives a price' in (tmp_path / 'out/bom.md').read_text()
    robot.write_text(text.replace('price 23.9', 'price -1', 1), encoding='utf-8')
    with pytest.raises(InputError, match='legwright_module/'):
        parts.make(robot, tmp_path / 'out')
