"""The table of formats that hold a whole character in a file: suffix -> reader, writer, what it holds.

A format is plugged in by a row: `FORMATS` is where `statwalk.load`, `statwalk convert`, uploads and the
downloads of the page find it.
"""

from __future__ import annotations

from pathlib import Path

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files import archive, captures
from statwalk.files.bvh.write_bvh import write_bvh
from statwalk.files.chunk import read_chunk_file, write_chunk_file
from statwalk.files.chunk.records import MAGIC
from statwalk.files.directx import read_directx, write_directx
from statwalk.files.file_format import FileFormat
from statwalk.files.gltf.read import read_model
from statwalk.files.gltf.write_files import write_glb, write_gltf, write_zip
from statwalk.files.held_parts import EVERY_PART, TURNED_LIMITS
from statwalk.files.md2 import read_md2, write_md2
from statwalk.files.md2.md2_file import SUFFIX as MD2_SUFFIX
from statwalk.files.md2.md2_header import START as MD2_START
from statwalk.files.write_faq_text import write_faq_files

_GLTF_INSTEAD = {"B-splines and NURBS": "as linear keys, 60 a second"}
_GLTF_PARTS = EVERY_PART - _GLTF_INSTEAD.keys()
_BVH_INSTEAD = {
    "keys with tangents": "as frames",
    "stepped keys": "as frames",
    "B-splines and NURBS": "as frames",
    "scales of joints": "their joints are where they were",
    "own axes of joints": "the axes of the character",
    "further roots": "on one root more",
}
_ODD_NAMES = "names of other characters than letters, digits and _"
_DIRECTX_LOST = {
    *("lines and points", "further texture coordinates and colours", "textures", "markers"),
    *("further attributes of vertices", "metal and further properties of materials", "limits", "expressions"),
    *("muscle bones", "muscles", "bulges", "level of detail"),
}
_DIRECTX_INSTEAD = {
    "keys with tangents": "as linear keys, 60 a second",
    "B-splines and NURBS": "as linear keys, 60 a second",
    "stepped keys": "as two linear keys, one tick apart",
    _ODD_NAMES: "with _ in their place",
    "morph targets": "their meshes are as they rest",
}
_FRAMES = "as frames, ten a second"
_MD2_INSTEAD = {
    "meshes": "one mesh: places in 255ths of each frame's bounds",
    "skins": _FRAMES,
    "digital skin": _FRAMES,
    "morph targets": _FRAMES,
    "normals": "the nearest of 162 directions",
    "texture coordinates": "whole pixels of a skin",
    "clips": _FRAMES,
    "stepped keys": _FRAMES,
    "keys with tangents": _FRAMES,
    "B-splines and NURBS": _FRAMES,
    "scales of joints": _FRAMES,
}


def _load_gltf(path: Path) -> Character:
    return read_model(path.read_bytes(), path.stem, path.parent)


FORMATS: tuple[FileFormat, ...] = (
    FileFormat(
        "glTF binary",
        (".glb",),
        read_model,
        write_glb,
        _GLTF_PARTS,
        _GLTF_INSTEAD,
        (b"GLTF",),
        "model/gltf-binary",
        _load_gltf,
    ),
    FileFormat("VRM", (".vrm",), read_model, media_type="model/gltf-binary", load=_load_gltf),
    FileFormat(
        "glTF",
        (".gltf",),
        read_model,
        write_gltf,
        _GLTF_PARTS,
        _GLTF_INSTEAD,
        (b"{",),
        "model/gltf+json",
        _load_gltf,
    ),
    FileFormat(
        "zip of a glTF",
        (archive.SUFFIX,),
        None,
        write_zip,
        _GLTF_PARTS,
        _GLTF_INSTEAD,
        (archive.ZIP_START,),
        "application/zip",
    ),
    FileFormat(
        "BVH",
        (".bvh",),
        lambda data, name: captures.read_capture(data, ".bvh", name),
        write_bvh,
        frozenset({"clips", _ODD_NAMES, TURNED_LIMITS}),
        _BVH_INSTEAD,
        (b"HIERARCHY",),
        "model/bvh",
    ),
    FileFormat(
        "DirectX .x",
        (".x",),
        read_directx,
        write_directx,
        EVERY_PART - _DIRECTX_LOST - _DIRECTX_INSTEAD.keys(),
        _DIRECTX_INSTEAD,
        (b"XOF ",),
        "model/x-directx",
    ),
    FileFormat(
        "MD2",
        (MD2_SUFFIX,),
        read_md2,
        write_md2,
        frozenset({"clips after the first", "own axes of joints", "further roots", TURNED_LIMITS}),
        _MD2_INSTEAD,
        (MD2_START,),
    ),
    FileFormat(
        "TRC",
        (".trc",),
        lambda data, name: captures.read_capture(data, ".trc", name),
        begins=(b"PATHFILETYPE",),
    ),
    FileFormat(
        "chunk",
        (".chunk",),
        read_chunk_file,
        write_chunk_file,
        EVERY_PART - {"further attributes of vertices"},
        begins=(MAGIC,),
        media_type="model/x-chunk",
    ),
)
CHARACTER_TEXT = FileFormat(
    "the FAQ's text",
    archive.CHARACTER_FILES,
    holds=frozenset(
        {"digital skin", "clips", "clips after the first", "loops", "limits", "further roots", _ODD_NAMES}
    ),
    instead={part: what for part, what in _BVH_INSTEAD.items() if part != "further roots"},
    write_many=write_faq_files,
)
"""read by `character_yaml`, whose `model:` may name a file of any other format; a zip is read by
`character_file`
"""
SUFFIXES = tuple(suffix for row in FORMATS for suffix in row.suffixes)
WRITTEN = (
    *(suffix for row in FORMATS if row.is_written for suffix in row.suffixes),
    CHARACTER_TEXT.suffixes[0],
)
MODEL_SUFFIXES = tuple(suffix for suffix in SUFFIXES if suffix != ".zip")


def format_of(path: Path) -> FileFormat:
    """Returns the format of a file by its suffix.

    :raises ContentError: when no format has the suffix.
    """
    suffix = path.suffix.lower()
    found = next((row for row in (*FORMATS, CHARACTER_TEXT) if suffix in row.suffixes), None)
    if found is None:
        raise ContentError(
            f"no format has the suffix {suffix[:20]!r}; there are: {', '.join(SUFFIXES)} (Blender and other "
            "programs write .glb)",
            file=str(path),
        )
    return found


def format_that_starts(start: bytes) -> FileFormat:
    """Returns the format of a file with these first bytes (64 are enough); glTF, which says what is wrong,
    for unknown bytes.
    """
    return next((row for row in FORMATS if row.starts(start)), FORMATS[0])
