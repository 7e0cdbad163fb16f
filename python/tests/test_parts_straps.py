# SPDX-License-Identifier: Apache-2.0
"""Cable ties that hold down what stands on the trunk."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from legwright import parts
from legwright.parts._shapes import MM, outline
from legwright.parts._straps import TAIL, THICK, TIE, WIDE, straps_of
from legwright.parts._trunk import trunk_link, trunk_solid
from manifold3d import Manifold


@pytest.fixture
def made(printed) -> parts.Parts:
    return printed('puppy')


def test_a_tie_goes_over_its_module_and_under_the_trunk(made):
    trunk = made.parts[-1].solid
    assert {strap.module.of for strap in trunk.straps} == {m.of for m in trunk.link.modules}
    for strap in trunk.straps:
        box = outline(strap.module).bounding_box()
        around = strap.tie.bounding_box()
        assert around[5] == pytest.approx(box[5] + THICK)
        assert (strap.tie ^ trunk.shape).volume() < 1e-6, 'it has a slot'
        for module in trunk.link.modules:
            assert (strap.tie ^ outline(module)).volume() < 1e-6
        # Nothing of the trunk is lower there: it is held to something.
        loop = strap.tie.hull()
        below = loop.translate((0, 0, -THICK - (around[5] - around[2])))
        assert (below ^ trunk.shape).volume() < 1e-6
        inside = loop - strap.tie
        assert (inside ^ trunk.shape).volume() > 10, 'its floor'
        corners = np.asarray(loop.to_mesh64().vert_properties)[:, :3]
        wide = max(np.ptp(corners[:, 0]), np.ptp(corners[:, 1]))
        assert strap.loop == pytest.approx(2 * (wide + np.ptp(corners[:, 2])), rel=0.02)
        assert strap.length >= strap.loop + TAIL and strap.length % 10 == 0


def test_ties_are_told_in_bill_and_checks(made):
    bill = (made.folder / 'bom.csv').read_text(encoding='utf-8')
    document = json.loads((made.folder / 'checks.json').read_text(encoding='utf-8'))
    ties = next(p for p in document['parts'] if p['name'] == 'trunk')['ties']
    assert len(ties) == 5
    for tie in ties:
        assert f'cable tie 3.6 x {tie["length_mm"]}' in bill
    assert 'foam tape' not in bill
    docs = (Path(__file__).resolve().parents[2] / 'docs/parts.md').read_text(encoding='utf-8')
    assert f'{WIDE:.0f} x {THICK:.0f} mm' in docs and f'{TIE:g} mm' in docs
    assert f'{TAIL:.0f} mm' in docs


def test_what_hangs_over_the_floor_stands_on_it(made):
    trunk = made.parts[-1].solid
    for module in trunk.link.modules:
        below = outline(module).translate((0, 0, -1.0)) - outline(module)
        assert (below ^ trunk.shape).volume() > 1, module.of


def test_a_tie_keeps_off_what_moves_over_its_module(made):
    robot, modules = made.robot, trunk_link(made.robot).modules
    solid = trunk_solid(robot, 1.2, 0.2)
    tray = solid.whole - solid.cut
    for module in modules:
        lid = outline(module).translate((0, 0, 3.0))
        found = straps_of([module], tray, 2.4, (2.6, 1.2), [lid])
        assert not found, module.of
    far = Manifold.cube((1, 1, 1)).translate((0, 0, MM))
    assert straps_of(modules[:1], far, 2.4, (2.6, 1.2), []) == [], 'nothing to be held to'


def test_what_no_tie_has_room_for_is_taped(printed):
    made = printed('hexapod')
    assert made.passed
    tied = {strap.module.of for strap in made.parts[-1].solid.straps}
    taped = {m.of for m in made.parts[-1].solid.link.modules} - tied
    assert taped == {'FL_coxa_servo', 'FR_coxa_servo'}, 'their links pass over where ties could lie'
    bill = (made.folder / 'bom.csv').read_text(encoding='utf-8')
    assert 'tape,double-sided foam tape,2,' in bill
    sheet = (made.folder / 'assembly.md').read_text(encoding='utf-8')
    assert sheet.count('under it: no tie has room') == 2


def test_a_tie_has_a_length_to_buy(made):
    strap = made.parts[-1].solid.straps[0]
    assert replace(strap, loop=100.0).length == 130
    assert replace(strap, loop=100.1).length == 140
