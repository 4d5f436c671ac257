"""The fixed records of the chunks, little-endian: what docs/chunk.md describes byte by byte."""

from __future__ import annotations

import struct
from typing import Literal, get_args

import numpy as np

from statwalk.motion.keys.channel import Interpolation, Path

MAGIC, VERSION = b"\x89CHUNK\r\n", 1
FILE = struct.Struct("<8sI")
CHUNK = struct.Struct("<4sI")
Tag = Literal[
    "HEAD", "TEXT", "INFO", "IMAG", "MATE", "OBJE", "NAME", "VECT", "BIND", "SKIN", "PIVO", "CONS", "POLY",
    "ATTR", "ANIM", "MARK", "CHAN", "IKCH", "EXPR", "TARG", "MUSC", "FACE", "LODD",
    "BULG",
]  # fmt: skip

OBJE = struct.Struct("<II")
"""the number of joints; the array of the morph weights at rest"""
VECT = struct.Struct("<BBH")
"""the type of the numbers; the number of dimensions; 0. Then each dimension as u32, then the numbers"""
BIND = struct.Struct("<II")
"""the array of the joints, and of the inverse bind matrices"""
PIVO = struct.Struct("<II10f")
"""the joint's row; its node; translation, rotation x y z w and scale at rest"""
CONS = struct.Struct("<II23d16s16s16s")
"""kind; 1 if the translation is limited; frame, twist, swing, angles, slide, pitch; type, form, order"""
POLY = struct.Struct("<IIIIIiiIIIIIIII")
"""row, node, mesh, primitive, mode, material, skin, first weight; the arrays of positions, normals, indices,
joints, weights, displacements of positions and of normals"""
ATTR = struct.Struct("<I")
"""the array of the numbers. Then the name"""
LODD_POLY = struct.Struct("<III")
"""the arrays of the vertices that collapse, of the vertices that they move onto, and of the steps"""
LODD = struct.Struct("<II")
"""the arrays of the steps and of the errors of levels"""
ANIM = struct.Struct("<dI")
"""the duration in seconds; 1 if the clip repeats"""
MARK = struct.Struct("<d")
"""the time in seconds. Then the name"""
CHAN = struct.Struct("<IIIIIII")
"""joint, path, interpolation, first weight; the arrays of times, values and weights of keys"""
IKCH = struct.Struct("<I")
"""the number of joints. Then each joint's row as u32"""
EXPR = struct.Struct("<I")
"""the line in the author's file. Then the text"""
TARG = struct.Struct("<I")
"""the column of the morph weight. Then the name of its target"""

NONE = 0xFFFFFFFF
"""in place of an array: there is none"""
KINDS = tuple(np.dtype(kind) for kind in ("<f4", "<f8", "<u2", "<u4", "<i4"))
"""the types of numbers in a VECT, by their number there"""
PATHS: tuple[Path, ...] = get_args(Path)
INTERPOLATIONS: tuple[Interpolation, ...] = get_args(Interpolation)

DEEPEST = 1_024
"""SKIN chunks inside each other"""
MOST_CHUNKS = 400_000
LARGEST_BYTES = 64 << 20
