# SPDX-License-Identifier: Apache-2.0
"""The printable parts of a robot: from its file to a folder."""

import json
import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from legwright._arguments import path_of
from legwright._errors import InputError
from legwright._options import kind_of
from legwright.parts._as_printed import FOLDER, as_printed, check_as_printed, unpacked
from legwright.parts._assembly_sheet import assembly_files
from legwright.parts._beam import check_beams
from legwright.parts._checks import Check
from legwright.parts._clear import check_modules_clear
from legwright.parts._exploded import exploded_scene
from legwright.parts._fastened import check_fastened, loose_places
from legwright.parts._feet import feet_of, foot_solid
from legwright.parts._fit import Distances, check_poses, check_ranges, things_of
from legwright.parts._folder import CHECKS, SCHEMA, check_place, write_folder
from legwright.parts._gait import gait_poses
from legwright.parts._loads import GaitLoads, played_loads, run_plan_loads
from legwright.parts._mesh_files import mesh_of, stl_bytes
from legwright.parts._numbers import numbered_parts
from legwright.parts._options import PartOptions
from legwright.parts._plates import plate_files
from legwright.parts._prints import check_bed, prints_markdown
from legwright.parts._robot import BuiltRobot, home_of, read_built
from legwright.parts._screw_checks import check_screws
from legwright.parts._shapes import MM
from legwright.parts._solid_checks import check_solids
from legwright.parts._solids import Part, parts_of
from legwright.parts._step_file import step_bytes
from legwright.parts._strength_file import FILE, strength_bytes
from legwright.parts._tables import bill, bill_csv, bill_markdown, module_counts
from legwright.parts._words import Array

SCENE, PICTURE = 'exploded.xml', 'exploded.png'
"""The exploded view; `legwright parts` draws the picture of the scene."""


@dataclass(frozen=True, repr=False)
class Parts:
    """The parts of a robot, with what was checked."""

    folder: Path
    robot: BuiltRobot
    parts: tuple[Part, ...]
    checks: tuple[Check, ...]
    document: dict[str, Any]
    """checks.json."""

    @property
    def passed(self) -> bool:
        """Whether nothing failed."""
        return all(check.passed for check in self.checks)

    @property
    def not_fastened(self) -> int:
        """Places where links end at modules, and neither screws nor pegs hold them."""
        return sum(len(each.of) for each in loose_places(self.parts))

    def __repr__(self) -> str:
        failed = sum(not check.passed for check in self.checks)
        said = f'{failed} of {len(self.checks)} checks fail' if failed else 'all checks pass'
        parts = f'{len(self.parts)} different parts, {sum(part.count for part in self.parts)}'
        loose = f', {self.not_fastened} places not fastened' if self.not_fastened else ''
        return f'<Parts of {self.robot.name}: {parts} to print, {said}{loose}; in {self.folder}>'


def robot_file(path: Path) -> Path:
    """The MJCF of a run's result, or the file itself. Raises InputError where there is none."""
    if not path.is_dir():
        return path
    file = path / 'result/robot.xml'
    if not file.is_file():
        raise InputError(
            f'{path}: has no result/robot.xml; give a run folder whose search has ended, or the '
            'MJCF that `legwright build` wrote'
        )
    return file


@dataclass(frozen=True)
class _Use:
    """What the robot does: the gaits of a run, or no more than to stand."""

    what: str
    poses: list[tuple[str, Array]]
    loads: GaitLoads | None
    """Of the plans; None where there is no gait."""


def _use_of(robot: BuiltRobot, path: Path) -> _Use:
    """Read before anything is cut, as a damaged file of a run is to be told at once."""
    if not path.is_dir():
        return _Use('at home', [('home', home_of(robot))], None)
    return _Use(*gait_poses(robot, path), run_plan_loads(robot, path))


def _all_checks(
    robot: BuiltRobot, parts: Sequence[Part], options: PartOptions, use: _Use
) -> list[Check]:
    """Of parts by themselves, on the bed, and past each other: in a run's gait, else at home."""
    distances = Distances(robot, things_of(robot, parts))
    ranges, _ = check_ranges(robot, distances, [qpos for _, qpos in use.poses], options.gap)
    return [
        *check_solids(robot, parts, options.wall),
        *check_screws(parts, options.wall),
        *check_fastened(parts),
        *check_bed(parts, options),
        *check_beams(robot, parts, use.loads, options),
        *check_modules_clear(robot),
        check_poses(distances, use.poses, options.gap, use.what),
        *ranges,
    ]


def _feet(parts: Sequence[Part], press: float) -> dict[str, bytes]:
    """The STL of each ball foot with its socket, under a name that no part has."""
    taken = {part.name for part in parts}
    out = {}
    for name, peg in feet_of([peg for part in parts for peg in part.solid.pegs]).items():
        file = f'foot_{name}'
        while file in taken:
            file += '_'
        taken.add(file)
        out[f'{file}.stl'] = stl_bytes(mesh_of(foot_solid(peg, press)))
    return out


def _part_json(part: Part) -> dict[str, Any]:
    solid = part.solid
    return {
        'name': part.name,
        'number': part.number,
        'links': part.links,
        'count': part.count,
        'volume_mm3': solid.shape.volume(),
        'mass_kg': solid.mass,
        'mass_of_file_kg': solid.file_mass,
        'overlap_mm3': solid.hull_volume - solid.declared.volume(),
        'modules_mm3': solid.seat_volume,
        'holes_mm3': solid.hole_volume,
        'pegs_mm3': solid.peg_volume,
        'number_mm3': solid.number_volume,
        'digits_mm': part.mark.height if part.mark else None,
        'density_for_mass_of_file_kgpm3': solid.file_mass / solid.shape.volume() * MM**3,
        'lying': {
            'down': [round(float(value), 9) for value in part.lying.down],
            'size_mm': [float(value) for value in part.lying.size],
            'contact_mm2': part.lying.contact,
            'overhang_mm2': part.lying.overhang,
            'support_mm3': part.lying.support,
            'seconds': part.lying.seconds,
        },
        'ties': [
            {'around': strap.module.of, 'loop_mm': strap.loop, 'length_mm': strap.length}
            for strap in solid.straps
        ],
        'fixed_to': [f'{fixing.module.of}: {fixing.place.name}' for fixing in solid.fixings],
    }


def _options_of(given: Any) -> PartOptions:
    if given is None or isinstance(given, PartOptions):
        return given or PartOptions()
    raise TypeError(f'options is {kind_of(given)}; expected PartOptions, as PartOptions(fit=0.2)')


def make(
    robot: str | os.PathLike[str],
    folder: str | os.PathLike[str] = 'parts',
    options: PartOptions | None = None,
) -> Parts:
    """Writes the printable parts of a run's result, or of a robot's MJCF, into a folder.

    STL and 3MF in millimetres, bill of materials, checks.json, of a run also that run with the
    masses of its parts; docs/parts.md tells what is cut and checked. The same robot gives the same
    bytes. Raises InputError for a robot that was not built from an assembly, IoError where the
    folder holds something else, TypeError for what is no path, or no PartOptions.
    """
    options = _options_of(options)
    if faults := options.faults():
        raise InputError('\n'.join(faults))
    path, place = (
        path_of(what, each, absolute=False) for what, each in (('robot', robot), ('folder', folder))
    )
    check_place(place)
    built = read_built(robot_file(path))
    bed, margin = options.bed_for(built.bed), options.margin_for(built.margin)
    if min(bed[:2]) <= 2 * margin:
        raise InputError(
            f'a margin of {margin:g} mm at each side of a bed of {bed[0]:g} x {bed[1]:g} mm leaves '
            'no room; give a margin of a few millimetres, as 4'
        )
    options = replace(options, bed=bed, margin=margin)
    use = _use_of(built, path)
    parts = numbered_parts(
        built,
        parts_of(built, options.fit, options.wall),
        len(module_counts(built)) + 1,
        options.wall,
    )
    run_files = as_printed(built, parts, path, place)
    with unpacked(run_files) as printed:
        if use.loads:
            use = replace(use, loads=played_loads(built, printed or path) or use.loads)
        checks = _all_checks(built, parts, options, use)
        if printed:
            checks += check_as_printed(printed, parts, path)
            run_files[f'{FOLDER}/{FILE}'] = strength_bytes(checks, options)
    rows = bill(built, parts, options.press)
    files = {f'{part.name}.stl': stl_bytes(part.mesh) for part in parts}
    if options.step:
        files |= {f'{part.name}.step': step_bytes(part.name, part.mesh) for part in parts}
    files |= _feet(parts, options.press)
    files |= plate_files(built.name, parts, bed, margin)
    files['bom.csv'] = bill_csv(rows).encode()
    files['prints.md'] = prints_markdown(built.name, parts, checks, options).encode()
    numbers = {row.key: number for number, row in enumerate(rows, 1)}
    files[SCENE] = exploded_scene(built, parts, numbers).encode()
    sheet, pictures = assembly_files(built, parts, rows)
    files |= sheet
    files['bom.md'] = bill_markdown(built, parts, rows).encode()
    files |= run_files
    document = {
        'schema': SCHEMA,
        'version': 1,
        'robot': built.name,
        'passed': all(check.passed for check in checks),
        'not_fastened': sum(len(each.of) for each in loose_places(parts)),
        'files': sorted({name.split('/')[0] for name in [*files, CHECKS, PICTURE, *pictures]}),
        'parts': [_part_json(part) for part in parts],
        'checks': [check.as_json() for check in checks],
    }
    files[CHECKS] = (json.dumps(document, indent=1, ensure_ascii=False) + '\n').encode()
    write_folder(place, files)
    return Parts(place, built, tuple(parts), tuple(checks), document)
