# SPDX-License-Identifier: Apache-2.0
"""Plates of the printer's bed: no part on another, none beside the bed, none left out."""

import io
import itertools
import zipfile
from types import SimpleNamespace
from xml.etree import ElementTree

import numpy as np
import pytest
from legwright import parts
from legwright.parts._mesh_files import mesh_of
from legwright.parts._plates import SPACE, STRIDE, plate_files
from legwright.parts._printing import lying_on
from legwright.parts._prints import check_bed, prints_markdown
from manifold3d import Manifold


def boxes_of(data: bytes) -> list[tuple[str, np.ndarray]]:
    """Of each item its name and its box, by the transform of the file."""
    model = ElementTree.fromstring(zipfile.ZipFile(io.BytesIO(data)).read('3D/3dmodel.model'))
    space = {'c': model.tag[1:].partition('}')[0]}
    found = {}
    for each in model.findall('.//c:object', space):
        corners = [[float(v.get(a)) for a in 'xyz'] for v in each.findall('.//c:vertex', space)]
        found[each.get('id')] = each.get('name'), np.array(corners)
    out = []
    for item in model.findall('.//c:item', space):
        name, corners = found[item.get('objectid')]
        rows = np.array([float(word) for word in item.get('transform').split()]).reshape(4, 3)
        assert np.linalg.det(rows[:3]) == pytest.approx(1)
        moved = corners @ rows[:3] + rows[3]
        out.append((name, np.stack([moved.min(axis=0), moved.max(axis=0)])))
    return out


def assert_on_beds(boxes: list[tuple[str, np.ndarray]], bed: tuple[float, float]) -> int:
    """Returns on how many plates they are."""
    plates = set()
    for _, (low, high) in boxes:
        plate = round((low + high)[0] / 2 // (STRIDE * bed[0]))
        plates.add(plate)
        left = plate * STRIDE * bed[0]
        assert left - 1e-3 <= low[0] and high[0] <= left + bed[0] + 1e-3
        assert low[1] >= -1e-3 and high[1] <= bed[1] + 1e-3
        assert abs(low[2]) < 1e-3
    assert_apart(boxes)
    return len(plates)


def assert_apart(boxes: list[tuple[str, np.ndarray]]) -> None:
    for (_, one), (_, other) in itertools.combinations(boxes, 2):
        apart = np.maximum(one[0] - other[1], other[0] - one[1])[:2]
        assert apart.max() >= SPACE - 1e-3


def test_plates_leave_the_margin_free(printed):
    """The puppy's, whose trunk with that margin lies turned on the narrow bed."""
    made = printed('puppy')
    files = plate_files('it', made.parts, (155, 225, 250), 5.0)
    for name in ('plate_1.3mf', 'plate_2.3mf'):
        boxes = boxes_of(files[name])
        inside = [(part, box - [5.0, 5.0, 0.0]) for part, box in boxes]
        assert assert_on_beds(inside, (145, 215)) == 1


@pytest.mark.parametrize('bed, plates', [((250, 250, 250), 1), ((145, 215, 250), 2)])
def test_parts_lie_on_beds_and_not_on_each_other(bed, plates, printed):
    """Of the puppy; on the narrow bed its trunk lies turned."""
    made = printed('puppy')
    files = plate_files('it', made.parts, bed)
    assert files == plate_files('it', made.parts, bed)
    boxes = boxes_of(files['all.3mf'])
    names = [name for part in made.parts for name in [part.name] * part.count]
    assert sorted(name for name, _ in boxes) == sorted(names)
    assert assert_on_beds(boxes, bed) == plates
    if plates == 1:
        assert set(files) == {'all.3mf'}
        return
    assert set(files) == {'all.3mf', *(f'plate_{k + 1}.3mf' for k in range(plates))}
    single = [boxes_of(files[f'plate_{k + 1}.3mf']) for k in range(plates)]
    assert all(assert_on_beds(each, bed) == 1 for each in single)
    assert sorted(name for each in single for name, _ in each) == sorted(names)


def test_what_is_larger_than_the_bed_has_a_plate_of_its_own(printed):
    """The puppy's trunk; its folder, of the bed of 220 mm, has two plates."""
    made = printed('puppy')
    files = plate_files('it', made.parts, (120, 120, 250))
    assert [name for name, _ in boxes_of(files['plate_1.3mf'])] == ['trunk']
    assert_apart(boxes_of(files['all.3mf']))
    assert sum(len(boxes_of(files[name])) for name in files if 'plate' in name) == 9
    own = boxes_of((made.folder / 'all.3mf').read_bytes())
    assert assert_on_beds(own, (220, 220)) == 2 and (made.folder / 'plate_2.3mf').is_file()


def test_what_leaves_no_margin_does_not_fit():
    """Of a bed of 220 mm, with the default margin of 4 mm and with none."""
    shape = Manifold.cube((220, 60, 20))
    solid = SimpleNamespace(shape=shape, density=1240.0)
    lying = lying_on(shape, np.array([0.0, 0.0, -1.0]))
    part = SimpleNamespace(
        name='it', number=1, count=1, solid=solid, lying=lying, mesh=mesh_of(shape)
    )
    (check,) = check_bed([part], parts.PartOptions())
    assert not check.passed and '0.0 mm left at a side' in check.where
    assert '4 mm left free at each side' in check.limit and '--margin' in check.remedy
    (check,) = check_bed([part], parts.PartOptions(bed=(200, 200, 250)))
    assert not check.passed and '--margin' not in check.remedy
    for fitting in (parts.PartOptions(margin=0.0), parts.PartOptions(bed=(228, 228, 250))):
        (check,) = check_bed([part], fitting)
        assert check.passed and not check.remedy
    wall = parts.Check('it', 'wall', True, 20.0, 'mm', 'at least 1.2 mm')
    told = [prints_markdown('it', [part], [wall], parts.PartOptions(bed=(x, x, 250)))
            for x in (200.0, 224.0, 228.0)]
    assert '| NO |' in told[0] and '| fits 200.0 x 200.0 x 250.0 mm, 4 mm left free |' in told[0]
    assert '| NO, 2.0 mm left at a side |' in told[1]
    assert '| yes |' in told[2]
    (alone,) = plate_files('it', [part], (220, 220)).values()
    assert assert_on_beds(boxes_of(alone), (220, 220)) == 1
