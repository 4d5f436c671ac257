"""Unpacks a model, or a character file, and the files that it needs from a zip; names and sizes are checked
before any byte is unpacked.
"""

from __future__ import annotations

import stat
import struct
import zipfile
import zlib
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path, PurePath, PurePosixPath

from statwalk.errors import ModelError

SUFFIX = ".zip"
MODELS = (".gltf", ".glb")
SUFFIXES = (*MODELS, ".bin", ".png", ".jpg", ".jpeg", ".webp", ".ktx2")
"""files that a model may need; all other files stay in the archive"""
CHARACTER_FILES = (".yaml", ".yml")
CHARACTER_SUFFIXES = (*SUFFIXES, *CHARACTER_FILES, ".txt", ".md2", ".x", ".chunk", ".bvh", ".trc")
"""files that a character file may name"""
OTHER_TEXTS = ("machine.yaml", "scene.yaml")
"""a zip of a machine holds its model beside them"""
MOST_ENTRIES = 1_000
LARGEST_DIRECTORY_BYTES = 1 << 20
LARGEST_UNPACKED_BYTES = 128 << 20
LONGEST_NAME, DEEPEST = 200, 16
CHUNK_BYTES = 1 << 20

ZIP_START = b"PK"
END, ZIP64_LOCATOR = b"PK\x05\x06", b"PK\x06\x07"
END_RECORD = struct.Struct("<4s4H2LH")
LONGEST_COMMENT = 65_535
LOCATOR_BYTES = 20
ENCRYPTED = 0x1
PLAIN_METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)


def is_zip(start: bytes) -> bool:
    """Returns whether a file with these first bytes claims to be a zip."""
    return start[:2] == ZIP_START


def unpack(archive: Path, folder: Path) -> Path:
    """Unpacks a zip into an empty folder and returns the path of its only character file, or else of its only
    model.

    :raises ModelError: when the zip is damaged, too large or unsafe, or does not hold exactly one model;
        `place` is the entry's name or a byte offset.
    """
    with checked_zip(archive, CHARACTER_SUFFIXES) as (opened, entries):
        has_character_file = any(_is_character_file(PurePosixPath(entry.filename)) for entry in entries)
        suffixes = CHARACTER_SUFFIXES if has_character_file else SUFFIXES
        bytes_left = LARGEST_UNPACKED_BYTES
        for entry in entries:
            if _is_wanted(PurePosixPath(entry.filename), suffixes):
                bytes_left -= extract(opened, entry, folder, bytes_left).stat().st_size
    return _main_file_in(folder)


@contextmanager
def checked_zip(
    archive: Path, suffixes: Sequence[str]
) -> Iterator[tuple[zipfile.ZipFile, list[zipfile.ZipInfo]]]:
    """Opens a zip; yields it with its checked entries of some suffixes.

    :raises ModelError: when the zip is damaged, too large or unsafe.
    """
    _check_directory(archive)
    try:
        with zipfile.ZipFile(archive) as opened:
            yield opened, _checked(opened.infolist(), suffixes)
    except (
        zipfile.BadZipFile,
        zlib.error,
        NotImplementedError,
        EOFError,
        UnicodeError,
        struct.error,
    ) as error:
        raise ModelError(f"the zip cannot be read: {str(error)[:200]}", place="byte 0") from None


def _check_directory(archive: Path) -> None:
    """Refuses a zip whose directory is too large to be read, by the record at the zip's end (APPNOTE
    4.3.16).
    """
    size = archive.stat().st_size
    with archive.open("rb") as file:
        start = max(0, size - END_RECORD.size - LONGEST_COMMENT - LOCATOR_BYTES)
        file.seek(start)
        tail = file.read()
    end_at = tail.rfind(END)
    if end_at < 0 or end_at + END_RECORD.size > len(tail):
        raise ModelError("the zip has no directory at its end; it is cut short", place=f"byte {size}")
    _, _, _, _, entries, directory_bytes, _, _ = END_RECORD.unpack_from(tail, end_at)
    if ZIP64_LOCATOR in tail[max(0, end_at - LOCATOR_BYTES) : end_at]:
        raise ModelError(
            "64-bit zips (ZIP64) are refused; a model's files are smaller", place=f"byte {start + end_at}"
        )
    if entries > MOST_ENTRIES or directory_bytes > LARGEST_DIRECTORY_BYTES:
        raise ModelError(
            f"the zip lists {entries} entries; at most {MOST_ENTRIES} are read",
            place=f"byte {start + end_at}",
        )


def _checked(entries: Sequence[zipfile.ZipInfo], suffixes: Sequence[str]) -> list[zipfile.ZipInfo]:
    """Checks the names, kinds and declared sizes of all entries; returns the entries of some suffixes."""
    if len(entries) > MOST_ENTRIES:
        raise ModelError(f"the zip holds {len(entries)} entries; at most {MOST_ENTRIES} are read")
    total = sum(entry.file_size for entry in entries)
    if total > LARGEST_UNPACKED_BYTES:
        raise ModelError(
            f"the zip would unpack to {total} bytes; at most {LARGEST_UNPACKED_BYTES >> 20} MiB are read"
        )
    for entry in entries:
        _check_entry(entry)
    files = [entry for entry in entries if not entry.is_dir()]
    wanted = [entry for entry in files if _is_wanted(PurePosixPath(entry.filename), suffixes)]
    _check_different(entry.filename for entry in wanted)
    return wanted


def _check_entry(entry: zipfile.ZipInfo) -> None:
    _check_name(entry.filename)
    kind = stat.S_IFMT(entry.external_attr >> 16)
    if kind not in (0, stat.S_IFREG, stat.S_IFDIR):
        raise ModelError(
            "the entry is a link or a device; only plain files are unpacked", place=shown(entry.filename)
        )
    if entry.flag_bits & ENCRYPTED:
        raise ModelError(
            "the entry is encrypted; make the zip without a password", place=shown(entry.filename)
        )
    if entry.compress_type not in PLAIN_METHODS:
        raise ModelError(
            f"compression {entry.compress_type} is not read; only stored and deflated are",
            place=shown(entry.filename),
        )


def _check_name(name: str) -> None:
    path = PurePosixPath(name)
    odd = not name.isprintable() or "\\" in name or ":" in name
    if (
        odd
        or path.is_absolute()
        or ".." in path.parts
        or len(name) > LONGEST_NAME
        or len(path.parts) > DEEPEST
    ):
        raise ModelError("the entry's name must be a plain relative path", place=shown(name))


def shown(name: str) -> str:
    """Returns an entry's name as an error shows it."""
    return ascii(name[:LONGEST_NAME])


def _is_wanted(path: PurePosixPath, suffixes: Sequence[str]) -> bool:
    """Returns whether a file has one of the suffixes; hidden files, which some systems add, are skipped."""
    hidden = any(part.startswith(".") or part == "__MACOSX" for part in path.parts)
    return path.suffix.lower() in suffixes and not hidden


def _is_character_file(path: PurePath) -> bool:
    return path.suffix.lower() in CHARACTER_FILES and path.name not in OTHER_TEXTS


def _check_different(names: Iterable[str]) -> None:
    """Refuses two names that some file systems take for the same name, and a file that has the name of a
    folder.
    """
    seen: set[str] = set()
    folders: set[str] = set()
    for name in names:
        key = str(PurePosixPath(name)).casefold()
        folders.update(str(parent) for parent in PurePosixPath(key).parents)
        if key in seen:
            raise ModelError(
                "the zip holds this name twice; rename or remove one of the two", place=shown(name)
            )
        seen.add(key)
    for name in sorted(seen & folders):
        raise ModelError(
            "the zip has a file and a folder of this name; rename one of the two", place=shown(name)
        )


def extract(
    opened: zipfile.ZipFile, entry: zipfile.ZipInfo, folder: Path, most_bytes: int = LARGEST_UNPACKED_BYTES
) -> Path:
    """Writes an entry below the folder and returns the path of the file.

    :raises ModelError: when the entry is longer than it declares, or than `most_bytes`.
    """
    target = folder / PurePosixPath(entry.filename)
    target.parent.mkdir(parents=True, exist_ok=True)
    written = 0
    with opened.open(entry) as source, target.open("xb") as file:
        while chunk := source.read(CHUNK_BYTES):
            written += len(chunk)
            if written > min(most_bytes, entry.file_size):
                raise ModelError("the entry is longer than its declared size", place=shown(entry.filename))
            file.write(chunk)
    return target


def _main_file_in(folder: Path) -> Path:
    """Returns the only character file of a folder, the one nearest to the top; without one, the model.

    :raises ModelError: when the folder has neither, or several at the same depth.
    """
    files = [path for path in sorted(folder.rglob("*")) if path.is_file()]
    texts = [path for path in files if _is_character_file(path)]
    models = texts or [path for path in files if path.suffix.lower() in MODELS]
    kind = "character file" if texts else "model"
    if not models:
        raise ModelError("the zip holds no model; add one .gltf or .glb file, or a character file (.yaml)")
    depth = min(len(path.parts) for path in models)
    highest = [path for path in models if len(path.parts) == depth]
    if len(highest) > 1:
        names = ", ".join(path.name[:60] for path in highest[:5])
        raise ModelError(f"the zip holds {len(highest)} {kind}s; keep only one: {names}")
    return highest[0]
