#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks how the sources hang together. Usage: check_structure.py [PROJECT_ROOT]

- #include lines form no edge besides those in LAYERS and LIBRARIES; quoted includes name files
from the root
- every source stands in a folder that LAYERS names; no two headers have one name
- each source has an SPDX line, at most 400 lines, and (if .cpp) is named by a CMakeLists.txt
- optimizer/terms/ and the table in its registry.cpp name the same terms
- numbers are never read by functions that depend on the locale or stop at the first odd character
- libraries do not print, and their constants have names of their own
Prints one line per finding (file:line: what, and what would be right) and exits 1 if there is any.
"""

import os
import pathlib
import re
import sys

LINE_LIMIT = 400
NAMED = re.compile(r'\b(k[A-Z]\w*)(?:\[[^]]*\])?\s*[={]')  # a constant, where it is defined
FOLDERS = (
    'optimizer',
    'mjcf',
    'plugin',
    'tools',
    'python',
    'tests',
    'examples',
    'benchmarks',
    'cmake',
    '.ci',
)

# Folders from the bottom up. A folder may include itself and those that its row names.
OPTIMIZER = (
    'optimizer/base',
    'optimizer/factor',
    'optimizer/design',
    'optimizer/motion',
    'optimizer/terms',
    'optimizer/objective',
    'optimizer/solve',
)
MJCF = (
    'mjcf/text',
    'mjcf/shape',
    'mjcf/read',
    'mjcf/write',
    'mjcf/scene',
    'mjcf/propose',
    'mjcf/urdf',
    'mjcf/assembly',
)
TOOLS = (
    'tools/files',
    'tools/task',
    'tools/simulate',
    'tools/run',
    'tools/image',
    'tools/validate',
    'tools/choose',
    'tools/session',
    'tools/render',
    'tools/report',
    'tools/viewer',
    'tools/studio',
    'tools/verbs',
)
DRAWN = ('tools/drawables', 'tools/studio/page')  # for pages in a browser
LAYERS = {
    'optimizer/base': (),
    'optimizer/factor': (),
    'optimizer/design': (),
    'optimizer/motion': OPTIMIZER[2:3],
    'optimizer/terms': OPTIMIZER[2:4],
    'optimizer/objective': OPTIMIZER[2:5],
    'optimizer/solve': OPTIMIZER[:6],
    'mjcf/text': ('optimizer/design',),
    'mjcf/shape': ('optimizer/design', 'mjcf/text'),
    'mjcf/read': ('optimizer/design', 'optimizer/motion') + MJCF[:2],
    'mjcf/write': ('optimizer/design', 'optimizer/motion') + MJCF[:3],
    'mjcf/scene': ('optimizer/design', 'optimizer/motion') + MJCF[:4],
    'mjcf/propose': ('optimizer/design', 'optimizer/motion') + MJCF[:5],
    'mjcf/urdf': ('optimizer/design',) + MJCF[:3] + MJCF[5:6],
    'mjcf/assembly': ('optimizer/design', 'optimizer/motion') + MJCF[:6],
    'trajectory': (),
    'plugin': ('trajectory',),
    'tools/files': ('mjcf/text',),
    'tools/task': OPTIMIZER + MJCF + TOOLS[:1],
    'tools/simulate': OPTIMIZER + MJCF + ('trajectory', 'tools/files'),
    'tools/run': OPTIMIZER + MJCF + ('trajectory',) + TOOLS[:3],
    'tools/modules': MJCF + ('optimizer/motion', 'tools/files', 'tools/task', 'tools/run'),
    'tools/assemble': MJCF + ('optimizer/motion', 'tools/files', 'tools/task', 'tools/modules'),
    'tools/adopt': ('optimizer/design', 'tools/files', 'tools/run') + MJCF,
    'tools/drawables': ('trajectory', 'tools/files', 'tools/simulate') + OPTIMIZER + MJCF,
    'tools/image': ('tools/files',),
    'tools/studio/page': (),
    'tools/validate': OPTIMIZER + MJCF + ('trajectory',) + TOOLS[:4],
    'tools/choose': OPTIMIZER + MJCF + TOOLS[:4] + TOOLS[5:6],
    'tools/session': OPTIMIZER + MJCF + TOOLS[:2] + TOOLS[3:4],
    'tools/render': ('trajectory', 'mjcf/text', 'mjcf/scene') + TOOLS[:5],
    'tools/report': (
        'trajectory',
        'mjcf/text',
        'tools/files',
        'tools/task',
        'tools/run',
        'tools/image',
    )
    + OPTIMIZER
    + DRAWN,
    'tools/viewer': ('mjcf/text', 'tools/files', 'tools/run', 'tools/simulate'),
    'tools/studio': OPTIMIZER
    + MJCF
    + ('trajectory', 'tools/modules', 'tools/assemble', 'tools/adopt')
    + TOOLS[:6]
    + TOOLS[7:8]
    + DRAWN,
    'tools/verbs': OPTIMIZER
    + MJCF
    + ('trajectory', 'tools/modules', 'tools/adopt')
    + TOOLS[:10]
    + TOOLS[11:12],
    'program': OPTIMIZER + MJCF + TOOLS + DRAWN,
    'python/core': OPTIMIZER + MJCF + ('tools/modules', 'tools/adopt') + TOOLS + DRAWN,
    'tests': OPTIMIZER
    + MJCF
    + ('tools/modules', 'tools/assemble', 'tools/adopt')
    + TOOLS
    + DRAWN
    + ('trajectory', 'plugin'),
}
# Files whose layer is not their folder: the trajectory's format serves the plugin and the program.
EXCEPTIONS = (
    ('tools/studio/page/', 'tools/studio/page'),
    ('plugin/trajectory.', 'trajectory'),
    ('plugin/spline.', 'trajectory'),
    ('plugin/number_text.', 'trajectory'),
    ('plugin/planned_motion.', 'trajectory'),
    ('plugin/', 'plugin'),
    ('tools/legwright.cpp', 'program'),
    ('tests/', 'tests'),
    ('benchmarks/', 'tests'),
)
LIBRARIES = (  # include path: paths that may use it; tests and benchmarks may use all
    (
        r'mujoco/',
        (
            'mjcf/',
            'plugin/',
            'tools/simulate/',
            'tools/validate/',
            'tools/render/',
            'tools/viewer/',
            'tools/drawables/',
            'tools/studio/',
            'python/core/',
        ),
    ),
    (
        r'tinyxml2\.h',
        (
            'mjcf/text/',
            'mjcf/read/',
            'mjcf/write/',
            'mjcf/scene/',
            'mjcf/propose/',
            'mjcf/urdf/',
            'tools/simulate/',
        ),
    ),
    (r'cholmod\.h|suitesparse/', ('optimizer/factor/',)),
    (r'Eigen/|unsupported/Eigen/', ('optimizer/', 'mjcf/', 'tools/', 'python/core/')),
    (r'fmt/', ('mjcf/', 'plugin/', 'tools/')),
    (r'toml\+\+/|nlohmann/|CLI/', ('tools/',)),
    (r'nanobind/|Python\.h', ('python/core/',)),
    (r'httplib\.h', ('tools/studio/',)),
    (r'simulate\.h|glfw_adapter\.h', ('tools/viewer/',)),
    (r'X11/', ()),
    (r'GL/|EGL/', ('tools/render/',)),
    (r'lodepng\.h|webp/', ('tools/image/',)),
    (r'gtest/|gmock/|benchmark/', ()),
)
NOT_TERMS = {
    'registry',
    'term',
    'penalty',
    'linear_term',
    'factories',
}  # files of terms/ that are no summand

LAX_NUMBERS = re.compile(
    r'\b(?:strto(?:d|f|ld|l|ul|ll|ull)|ato[fil]|sto(?:d|f|ld|i|l|ul|ll|ull)|[fs]?scanf|setlocale'
    r'|(?:Query)?(?:Double|Float|Int|Unsigned)(?:Attribute|Text|Value))\s*\('
)
PRINTING = re.compile(
    r'\bstd::(?:cout|cerr|clog|print|printf|puts)\b|(?<![\w:])(?:printf|puts)\s*\(|\bfmt::print\b'
    r'|\bf(?:printf|puts)\s*\('
)
MAY_PRINT = (
    'tools/verbs/',
    'tools/viewer/main.cpp',
    'tools/legwright.cpp',
    'tests/',
    'benchmarks/',
)


def layer_of(path):
    for prefix, layer in EXCEPTIONS:
        if path.startswith(prefix):
            return layer
    folder = '/'.join(path.split('/')[:2])
    return folder if folder in LAYERS else None


def uncommented(text):
    """The text with comments and strings blanked, line numbers kept. #include lines keep their
    quotes."""

    def blank(match):
        found = match.group(0)
        if found.lstrip().startswith('#'):
            return found
        return re.sub(r'[^\n]', ' ', found)

    return re.sub(
        r'^[ \t]*#[ \t]*include[^\n/]*|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"',
        blank,
        text,
        flags=re.DOTALL | re.MULTILINE,
    )


def is_source(path):
    if (
        path.suffix in ('.cpp', '.hpp', '.h', '.py', '.sh', '.cmake')
        or path.name == 'CMakeLists.txt'
    ):
        return True
    if path.suffix or path.name.startswith('.'):
        return False
    with path.open('rb') as file:
        return file.read(2) == b'#!'


class Check:
    def __init__(self, root):
        self.root, self.findings = pathlib.Path(root).resolve(), []

    def report(self, path, line, what):
        self.findings.append(f'{path}:{line}: {what}')

    def run(self):
        files = [
            p
            for folder in FOLDERS
            for p in sorted((self.root / folder).rglob('*'))
            if p.is_file() and '__pycache__' not in p.parts
        ]
        files += [p for p in (self.root / 'CMakeLists.txt',) if p.is_file()]
        self.lists = {
            p.parent: p.read_text(encoding='utf-8') for p in files if p.name == 'CMakeLists.txt'
        }
        self.built = self.listed_sources()
        sources = [p for p in files if is_source(p)]
        if not any(p.suffix == '.cpp' for p in sources):
            self.report('.', 0, f'no C++ source found in {self.root}')
        for path in sources:
            self.source(path, path.relative_to(self.root).as_posix())
        self.terms()
        self.header_names([p for p in sources if p.suffix == '.hpp'])
        self.constants([p for p in sources if p.suffix == '.cpp'])
        return self.findings

    def header_names(self, headers):
        """No two headers outside tests/ share a name: whoever searches for one finds one."""
        seen = {}
        for path in headers:
            name = path.relative_to(self.root).as_posix()
            if name.startswith('tests/'):
                continue
            if path.name in seen:
                self.report(name, 1, f'a header of this name is there already: {seen[path.name]}')
            seen.setdefault(path.name, name)

    def constants(self, sources):
        """Files of a library, kernels aside, are compiled sixteen at a time, by chance."""
        seen = {}
        for path in sources:
            name = path.relative_to(self.root).as_posix()
            if not name.startswith(('optimizer/', 'mjcf/', 'tools/')) or '/kernels_' in name:
                continue
            library = name[: name.rfind('/')] if name.startswith('tools/') else name.split('/')[0]
            for number, line in enumerate(path.read_text(encoding='utf-8').splitlines(), 1):
                for constant in NAMED.findall(line) if line.startswith('constexpr ') else ():
                    first = seen.setdefault((library, constant), name)
                    if first != name:
                        self.report(name, number, f'{constant} is in {first}: name it otherwise')

    def source(self, path, name):
        text = path.read_text(encoding='utf-8')
        lines = text.splitlines()
        if not any('SPDX-License-Identifier: Apache-2.0' in line for line in lines[:3]):
            self.report(name, 1, 'no SPDX line among the first three')
        if len(lines) > LINE_LIMIT:
            self.report(
                name, len(lines), f'{len(lines)} lines, at most {LINE_LIMIT}: split it by concept'
            )
        if path.suffix not in ('.cpp', '.hpp', '.h'):
            return
        if layer_of(name) is None:
            self.report(name, 1, 'stands in no folder that LAYERS of check_structure.py names')
        for number, line in enumerate(uncommented(text).splitlines(), 1):
            include = re.match(r'\s*#\s*include\s*(["<])([^">]+)[">]', line)
            if include:
                self.include(name, number, include.group(1) == '"', include.group(2))
            if LAX_NUMBERS.search(line) and not name.startswith('tests/'):
                self.report(
                    name, number, 'reads a number laxly: use the strict std::from_chars readers'
                )
            if PRINTING.search(line) and not name.startswith(MAY_PRINT):
                self.report(name, number, 'a library prints: return the text or throw')
        if path.suffix == '.cpp' and path not in self.built:
            self.report(
                name, 1, 'named by no CMakeLists.txt: list it among the sources of its target'
            )

    def listed_sources(self):
        """Every .cpp that a CMakeLists.txt names, as resolved paths."""
        found = set()
        for folder, text in self.lists.items():
            text = re.sub(r'#.*', '', text)
            up = os.path.relpath(self.root, folder)  # relative: the root's own path may hold blanks
            for variable, value in (
                ('PROJECT_SOURCE_DIR', up),
                ('CMAKE_SOURCE_DIR', up),
                ('CMAKE_CURRENT_SOURCE_DIR', '.'),
                ('CMAKE_CURRENT_LIST_DIR', '.'),
            ):
                text = text.replace('${' + variable + '}', value)
            found |= {(folder / name).resolve() for name in re.findall(r'[\w./+-]+\.cpp\b', text)}
        return found

    def include(self, name, number, quoted, target):
        if not quoted:
            for pattern, users in LIBRARIES:
                if re.match(pattern, target) and not name.startswith(
                    users + ('tests/', 'benchmarks/')
                ):
                    where = ', '.join(users) or 'tests'
                    self.report(name, number, f'<{target}> belongs to {where} alone')
            return
        if not (self.root / target).is_file():
            self.report(name, number, f'"{target}" is no file below the project root')
            return
        user, used = layer_of(name), layer_of(target)
        if used != user and used not in LAYERS.get(user, ()):
            allowed = ', '.join([*LAYERS.get(user, ()), str(user)])
            self.report(
                name,
                number,
                f'{user} must not include {used} ("{target}"); it may include {allowed}',
            )
        if user == used == 'optimizer/terms':
            stem = pathlib.PurePosixPath(target).stem
            if stem not in NOT_TERMS and stem != pathlib.PurePosixPath(name).stem:
                self.report(name, number, f'terms never include each other ("{target}")')

    def terms(self):
        folder = self.root / 'optimizer/terms'
        if not (folder / 'registry.cpp').is_file():
            self.report('optimizer/terms/registry.cpp', 0, 'missing')
            return
        # The table's rows start with the name: {"travel", "(9)", 1e3, make_travel}.
        table = re.findall(
            r'\{\s*"(\w+)"\s*,', (folder / 'registry.cpp').read_text(encoding='utf-8')
        )
        stems = {p.stem for p in folder.glob('*.cpp')} - NOT_TERMS
        for stem in sorted(stems - set(table)):
            self.report(f'optimizer/terms/{stem}.cpp', 1, 'not in the table of registry.cpp')
        for name in sorted(set(table) - stems):
            self.report(
                'optimizer/terms/registry.cpp', 1, f'names "{name}", but there is no {name}.cpp'
            )
        for name in sorted({n for n in table if table.count(n) > 1}):
            self.report('optimizer/terms/registry.cpp', 1, f'names "{name}" twice')


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2]
    findings = Check(root).run()
    print('\n'.join(findings) if findings else 'structure: ok')
    return 1 if findings else 0


if __name__ == '__main__':
    sys.exit(main())
