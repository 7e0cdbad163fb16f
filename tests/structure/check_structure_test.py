#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plants violations in a small sound project, one at a time: check_structure.py must name each of
them."""

import pathlib
import tempfile
import unittest

from check_structure import Check

SPDX = '// SPDX-License-Identifier: Apache-2.0\n'
SOUND = {
    'optimizer/CMakeLists.txt': '# SPDX-License-Identifier: Apache-2.0\n'
    'add_library(o design/design.cpp terms/travel.cpp\n'
    '  terms/registry.cpp terms/turning.cpp solve/newton.cpp factor/simplicial_ldlt.cpp)\n',
    'optimizer/design/design.hpp': SPDX + '#include <Eigen/Core>\n',
    'optimizer/design/design.cpp': SPDX + '#include "optimizer/design/design.hpp"\n',
    'optimizer/terms/term.hpp': SPDX + '#include "optimizer/design/design.hpp"\n',
    'optimizer/terms/travel.cpp': SPDX + '#include "optimizer/terms/term.hpp"\n',
    'optimizer/terms/registry.cpp': SPDX + 'Table table{{"travel", "(9)", 1e3, make_travel}};\n',
    'optimizer/solve/newton.cpp': SPDX
    + '#include "optimizer/terms/term.hpp"\nconstexpr double kGrain = 1.0;\n',
    'optimizer/factor/simplicial_ldlt.cpp': SPDX + '#include <cholmod.h>\n',
    'plugin/trajectory.hpp': SPDX,
    'plugin/pd_playback.hpp': SPDX
    + '#include <mujoco/mujoco.h>\n#include "plugin/trajectory.hpp"\n',
    'mjcf/read/read_robot.hpp': SPDX
    + '#include <mujoco/mujoco.h>\n#include "optimizer/design/design.hpp"\n',
    'tools/task/files.hpp': SPDX
    + '#include "mjcf/read/read_robot.hpp"\n#include <toml++/toml.h>\n',
    'tools/legwright.cpp': SPDX,
    'tools/verbs/CMakeLists.txt': '# SPDX-License-Identifier: Apache-2.0\n'
    'add_executable(l ../legwright.cpp) # check.cpp\n',
    'tools/test': '#!/usr/bin/env bash\n# SPDX-License-Identifier: Apache-2.0\n',
}
# What is wrong, file, text appended to it (or the whole file when it is new), part of the finding.
VIOLATIONS = (
    (
        'design includes terms',
        'optimizer/design/design.hpp',
        '#include "optimizer/terms/term.hpp"\n',
        'optimizer/design must not include optimizer/terms',
    ),
    (
        'two constants of a library with one name',
        'optimizer/design/design.cpp',
        'constexpr double kFirst = 1.0, kGrain = 2.0;\n',
        'kGrain is in optimizer/design/design.cpp',
    ),
    (
        'optimizer includes mjcf',
        'optimizer/solve/newton.cpp',
        '#include "mjcf/read/read_robot.hpp"\n',
        'optimizer/solve must not include mjcf/read',
    ),
    (
        'optimizer includes MuJoCo',
        'optimizer/design/design.cpp',
        '#include <mujoco/mujoco.h>\n',
        '<mujoco/mujoco.h> belongs to',
    ),
    (
        'optimizer includes tinyxml2',
        'optimizer/design/design.cpp',
        '#include <tinyxml2.h>\n',
        '<tinyxml2.h> belongs to',
    ),
    (
        'a term knows CHOLMOD',
        'optimizer/terms/travel.cpp',
        '#include <cholmod.h>\n',
        '<cholmod.h> belongs to',
    ),
    (
        'plugin includes the optimizer',
        'plugin/pd_playback.hpp',
        '#include "optimizer/design/design.hpp"\n',
        'plugin must not include optimizer/design',
    ),
    (
        "trajectory includes MuJoCo's part",
        'plugin/trajectory.hpp',
        '#include "plugin/pd_playback.hpp"\n',
        'trajectory must not include plugin',
    ),
    (
        "tools include MuJoCo's part",
        'tools/task/files.hpp',
        '#include "plugin/pd_playback.hpp"\n',
        'tools/task must not include plugin',
    ),
    (
        'the file readers include MuJoCo',
        'tools/task/files.hpp',
        '  #  include <mujoco/mujoco.h>\n',
        '<mujoco/mujoco.h> belongs to',
    ),
    (
        'mjcf includes tools',
        'mjcf/read/read_robot.hpp',
        '#include "tools/task/files.hpp"\n',
        'mjcf/read must not include tools/task',
    ),
    (
        'mjcf includes terms',
        'mjcf/read/read_robot.hpp',
        '#include "optimizer/terms/term.hpp"\n',
        'mjcf/read must not include optimizer/terms',
    ),
    (
        'include relative to the file',
        'optimizer/design/design.cpp',
        '#include "design.hpp"\n',
        'is no file below the project root',
    ),
    (
        'gtest outside tests',
        'tools/task/files.hpp',
        '#include <gtest/gtest.h>\n',
        'belongs to tests alone',
    ),
    (
        'a term includes a term',
        'optimizer/terms/turning.hpp',
        SPDX + '#include "optimizer/terms/slip.hpp"\n',
        'terms never include each other',
    ),
    ('a forgotten term', 'optimizer/terms/turning.cpp', SPDX, 'turning.cpp:1: not in the table'),
    (
        'a term without file',
        'optimizer/terms/registry.cpp',
        'More more{{"turning", "(9)", 1, make}};\n',
        'there is no turning.cpp',
    ),
    (
        'a term named twice',
        'optimizer/terms/registry.cpp',
        'More more{{"travel", "(9)", 1, make}};\n',
        'names "travel" twice',
    ),
    (
        'a source that nothing builds',
        'optimizer/design/inertia.cpp',
        SPDX,
        'inertia.cpp:1: named by no CMakeLists.txt',
    ),
    (
        'a source that is commented out',
        'tools/verbs/check.cpp',
        SPDX,
        'check.cpp:1: named by no CMakeLists.txt',
    ),
    ('a long file', 'optimizer/design/design.hpp', '\n' * 400, '402 lines, at most 400'),
    ('no licence', 'mjcf/text/xml.hpp', '#pragma once\n', 'xml.hpp:1: no SPDX line'),
    ('no licence in a script', 'tools/quickstart', '#!/bin/bash\n', 'quickstart:1: no SPDX line'),
    (
        'a lax number',
        'tools/task/files.hpp',
        'double a = std::stod (text);\n',
        'files.hpp:4: reads a number laxly',
    ),
    (
        "tinyxml2's defaulting getter",
        'mjcf/read/read_robot.hpp',
        'e->QueryDoubleAttribute("a", &a);\n',
        'reads a number laxly',
    ),
    (
        'an arrow up within mjcf',
        'mjcf/read/read_robot.hpp',
        '#include "mjcf/write/rewrite.hpp"\n',
        'mjcf/read must not include mjcf/write',
    ),
    (
        'an arrow sideways within tools',
        'tools/report/page.hpp',
        SPDX + '#include "tools/render/strip.hpp"\n',
        'tools/report must not include tools/render',
    ),
    (
        'a folder that nobody knows',
        'tools/misc/odds.hpp',
        SPDX,
        'odds.hpp:1: stands in no folder that LAYERS',
    ),
    (
        'two headers of one name',
        'tools/task/read_robot.hpp',
        SPDX,
        'a header of this name is there already',
    ),
    (
        'a library that prints',
        'optimizer/design/design.cpp',
        'std::cout << 1;\n',
        'design.cpp:3: a library prints',
    ),
)
HARMLESS = (
    (
        'optimizer/design/design.cpp',
        '// #include <mujoco/mujoco.h>\n/* std::cout\n#include <tinyxml2.h>\n*/\n',
    ),
    (
        'optimizer/design/design.cpp',
        'auto text = "std::cout is not \\" used; atof(1)";\nvoid snapstod(int);\n',
    ),
    (
        'optimizer/solve/newton.cpp',
        '#include "optimizer/design/design.hpp"  // transitively allowed\n',
    ),
)


def findings(changes):
    with tempfile.TemporaryDirectory() as root:
        for name, text in {**SOUND, **changes}.items():
            path = pathlib.Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding='utf-8')
        return Check(root).run()


class PlantedViolations(unittest.TestCase):
    def test_sound_project_passes(self):
        self.assertEqual(findings({}), [])

    def test_each_is_found_and_alone(self):
        for what, name, text, expected in VIOLATIONS:
            with self.subTest(what):
                changes = {name: SOUND.get(name, '') + text}
                for included in (
                    'optimizer/terms/slip.hpp',
                    'mjcf/write/rewrite.hpp',
                    'tools/render/strip.hpp',
                ):
                    if included in text:
                        changes[included] = SPDX
                found = findings(changes)
                self.assertEqual(len(found), 1, found)
                self.assertIn(expected, found[0])

    def test_comments_and_strings_do_not_count(self):
        for name, text in HARMLESS:
            with self.subTest(text):
                self.assertEqual(findings({name: SOUND[name] + text}), [])

    def test_empty_folder_fails(self):
        with tempfile.TemporaryDirectory() as root:
            self.assertTrue(Check(root).run())


if __name__ == '__main__':
    unittest.main()
