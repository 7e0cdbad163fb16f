# SPDX-License-Identifier: Apache-2.0
"""Solids as files for slicers: STL and 3MF, in millimetres. The same solid gives the same bytes."""

import io
import struct
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from xml.sax.saxutils import escape, quoteattr

import numpy as np
from manifold3d import Manifold
from manifold3d import Mesh as ManifoldMesh
from numpy.typing import NDArray

_DIGITS = 5  # of a millimetre: readers take nearer corners for one
_STL_HEAD = b'legwright parts, millimetres'.ljust(80, b' ')
_ROW = np.dtype([('normal', '<f4', 3), ('corners', '<f4', (3, 3)), ('attribute', '<u2')])
_CORE = 'http://schemas.microsoft.com/3dmanufacturing/core/2015/02'
_PACKAGE = 'http://schemas.openxmlformats.org/package/2006'
_MODEL_TYPE = 'application/vnd.ms-package.3dmanufacturing-3dmodel+xml'
_TYPES = (
    '<?xml version="1.0" encoding="UTF-8"?>\n'
    f'<Types xmlns="{_PACKAGE}/content-types">\n'
    ' <Default Extension="rels" '
    'ContentType="application/vnd.openxmlformats-package.relationships+xml"/>\n'
    f' <Default Extension="model" ContentType="{_MODEL_TYPE}"/>\n'
    '</Types>\n'
)
_RELATIONS = (
    '<?xml version="1.0" encoding="UTF-8"?>\n'
    f'<Relationships xmlns="{_PACKAGE}/relationships">\n'
    ' <Relationship Target="/3D/3dmodel.model" Id="rel0" '
    'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>\n'
    '</Relationships>\n'
)
_OLDEST = (1980, 1, 1, 0, 0, 0)  # that a zip can tell: the same bytes at any time


@dataclass(frozen=True)
class Mesh:
    """Triangles of a solid, seen from outside counter-clockwise [mm]."""

    vertices: NDArray[np.float32]
    triangles: NDArray[np.int64]


def mesh_of(solid: Manifold) -> Mesh:
    """The triangles of a solid, to 1e-5 mm and with the single precision that STL has.

    What falls together is one corner.
    """
    mesh = solid.to_mesh64()
    fine = np.round(np.asarray(mesh.vert_properties)[:, :3], _DIGITS)
    corners = fine.astype(np.float32) + np.float32(0)
    vertices, number = np.unique(corners, axis=0, return_inverse=True)
    triangles = number.reshape(-1)[np.asarray(mesh.tri_verts).astype(np.int64)]
    a, b, c = triangles.T
    return Mesh(vertices, triangles[(a != b) & (b != c) & (c != a)])


def as_printed(solid: Manifold) -> Manifold:
    """A solid as its files have it; its status tells whether it still is one."""
    mesh = mesh_of(solid)
    return Manifold(ManifoldMesh(mesh.vertices, mesh.triangles.astype(np.uint32)))


def stl_bytes(mesh: Mesh) -> bytes:
    """A binary STL."""
    corners = mesh.vertices[mesh.triangles]
    edges = corners.astype(float)
    normals = np.cross(edges[:, 1] - edges[:, 0], edges[:, 2] - edges[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    rows = np.zeros(len(corners), _ROW)
    rows['normal'] = normals / np.where(lengths > 0, lengths, 1)
    rows['corners'] = corners
    return _STL_HEAD + struct.pack('<I', len(rows)) + rows.tobytes()


def _object(number: int, name: str, mesh: Mesh) -> str:
    vertices = ''.join(
        f'     <vertex x="{x:.9g}" y="{y:.9g}" z="{z:.9g}"/>\n'
        for x, y, z in mesh.vertices.tolist()
    )
    triangles = ''.join(
        f'     <triangle v1="{a}" v2="{b}" v3="{c}"/>\n' for a, b, c in mesh.triangles.tolist()
    )
    return (
        f'  <object id="{number}" type="model" name={quoteattr(name)}>\n   <mesh>\n'
        f'    <vertices>\n{vertices}    </vertices>\n'
        f'    <triangles>\n{triangles}    </triangles>\n   </mesh>\n  </object>\n'
    )


@dataclass(frozen=True)
class Place:
    """Where the origin of a part lies on a plate [mm], perhaps turned left by a quarter."""

    x: float
    y: float
    z: float
    turned: bool = False


@dataclass(frozen=True)
class Item:
    """A part of a 3MF: its mesh, and where each of its copies lies on the plate."""

    name: str
    mesh: Mesh
    places: Sequence[Place]


def threemf_bytes(title: str, items: Sequence[Item]) -> bytes:
    """A 3MF with an object for each part, and an item of the build for each copy."""
    objects, build = [], []
    for number, item in enumerate(items, 1):
        objects.append(_object(number, item.name, item.mesh))
        for at in item.places:
            turn = '0 1 0 -1 0 0 0 0 1' if at.turned else '1 0 0 0 1 0 0 0 1'
            place = f'{turn} {at.x:.7g} {at.y:.7g} {at.z:.7g}'
            build.append(f'  <item objectid="{number}" transform="{place}"/>\n')
    model = (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<model unit="millimeter" xml:lang="en-US" xmlns="{_CORE}">\n'
        f' <metadata name="Title">{escape(title)}</metadata>\n'
        f' <resources>\n{"".join(objects)} </resources>\n'
        f' <build>\n{"".join(build)} </build>\n</model>\n'
    )
    out = io.BytesIO()
    with zipfile.ZipFile(out, 'w') as archive:
        for name, text in (
            ('[Content_Types].xml', _TYPES),
            ('_rels/.rels', _RELATIONS),
            ('3D/3dmodel.model', model),
        ):
            entry = zipfile.ZipInfo(name, _OLDEST)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, text.encode(), compresslevel=9)
    return out.getvalue()
