"""A machine as one .zip file, and back: `machine.yaml`, its .csv tables, captures, and `character.glb`.

`statwalk serve` plays the unpacked folder.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path, PurePosixPath

from statwalk.errors import MachineError
from statwalk.files.archive import MODELS, checked_zip, extract, shown
from statwalk.files.captures import SUFFIXES as CAPTURES
from statwalk.files.machine_yaml.machine_file import FILE_NAME
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import with_value

CHARACTER = "character.glb"
TEXTS = (".yaml", ".csv")
LARGEST_TEXT = 1 << 20
FIRST_DAY = (1980, 1, 1, 0, 0, 0)
"""in every entry, so that the same machine gives the same bytes"""


def machine_zip(text: MachineText, model_glb: bytes, captures: Mapping[str, bytes]) -> bytes:
    """Returns the zip of a machine; `captures`: the files that it names, by their paths."""
    yaml = with_value(text.yaml, ("character",), CHARACTER)
    files = {FILE_NAME: yaml.encode(), **{name: table.encode() for name, table in text.tables.items()}}
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in {**files, CHARACTER: model_glb, **captures}.items():
            archive.writestr(zipfile.ZipInfo(name, FIRST_DAY), data, zipfile.ZIP_DEFLATED)
    return packed.getvalue()


def read_machine_zip(path: Path, folder: Path) -> tuple[MachineText, dict[str, Path], bool]:
    """Returns the text of the machine in a zip, with all .csv files beside it; the captures beside it and in
    folders there, unpacked into `folder`, by their paths from it; and whether the zip holds a model.

    :raises ContentError: when the zip is damaged, too large or unsafe, or holds no machine file.
    """
    with checked_zip(path, (*TEXTS, *MODELS, *CAPTURES)) as (archive, entries):
        paths = {PurePosixPath(entry.filename): entry for entry in entries}
        found = sorted((file for file in paths if file.name == FILE_NAME), key=lambda file: len(file.parts))
        if not found:
            raise MachineError(f"the zip holds no {FILE_NAME}")
        beside = {file.name: entry for file, entry in paths.items() if file.parent == found[0].parent}
        tables = {name: _text(archive, entry) for name, entry in beside.items() if _is(name, (".csv",))}
        captures = {
            file.relative_to(found[0].parent).as_posix(): extract(archive, entry, folder)
            for file, entry in paths.items()
            if file.is_relative_to(found[0].parent) and _is(file.name, CAPTURES)
        }
        has_model = any(_is(file.name, MODELS) for file in paths)
        return MachineText(_text(archive, paths[found[0]]), tables), captures, has_model


def _is(name: str, suffixes: Sequence[str]) -> bool:
    return PurePosixPath(name).suffix.lower() in suffixes


def _text(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> str:
    with archive.open(entry) as file:
        data = file.read(LARGEST_TEXT + 1)
    if len(data) > LARGEST_TEXT:
        raise MachineError("the file is larger than 1 MiB", file=shown(entry.filename))
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        place = f"byte {problem.start}"
        raise MachineError("this is not UTF-8", file=shown(entry.filename), place=place) from None
