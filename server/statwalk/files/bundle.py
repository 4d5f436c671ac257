"""A model with the files it needs, in a zip or a folder: names and sizes are checked before a byte is unpacked."""

from __future__ import annotations

import stat
import struct
import zipfile
import zlib
from collections.abc import Iterable, Sequence
from pathlib import Path, PurePosixPath

from statwalk.errors import ModelError

MODELS = (".gltf", ".glb")
SUFFIXES = (*MODELS, ".bin", ".png", ".jpg", ".jpeg", ".webp", ".ktx2")
"""what a model may need; other files are left in the archive"""
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
    """Whether a file that starts like this says that it is a zip."""
    return start[:2] == ZIP_START


def unpack(archive: Path, folder: Path) -> Path:
    """Unpacks a zip into an empty folder; the path of the one model in it. Raises ModelError, its place the entry's name or a byte."""
    check_directory(archive)
    try:
        with zipfile.ZipFile(archive) as opened:
            wanted = checked(opened.infolist())
            left = LARGEST_UNPACKED_BYTES
            for entry in wanted:
                left -= extract(opened, entry, folder, left)
    except (zipfile.BadZipFile, zlib.error, NotImplementedError, EOFError, UnicodeError, struct.error) as error:
        raise ModelError(f"the zip cannot be read: {str(error)[:200]}", place="byte 0") from None
    return model_in(folder)


def check_directory(archive: Path) -> None:
    """Refuses a zip whose directory is too large to be read, from the record at its end (APPNOTE 4.3.16)."""
    size = archive.stat().st_size
    with archive.open("rb") as file:
        start = max(0, size - END_RECORD.size - LONGEST_COMMENT - LOCATOR_BYTES)
        file.seek(start)
        tail = file.read()
    at = tail.rfind(END)
    if at < 0 or at + END_RECORD.size > len(tail):
        raise ModelError("the zip has no directory at its end; it is cut short", place=f"byte {size}")
    _, _, _, _, entries, directory_bytes, _, _ = END_RECORD.unpack_from(tail, at)
    if ZIP64_LOCATOR in tail[max(0, at - LOCATOR_BYTES) : at]:
        raise ModelError("zips of the 64-bit kind are refused; a model's files are smaller", place=f"byte {start + at}")
    if entries > MOST_ENTRIES or directory_bytes > LARGEST_DIRECTORY_BYTES:
        raise ModelError(f"the zip lists {entries} entries; at most {MOST_ENTRIES} are read", place=f"byte {start + at}")


def checked(entries: Sequence[zipfile.ZipInfo]) -> list[zipfile.ZipInfo]:
    """The entries that a model may need, after all of them were checked: names, kinds, sizes as they say."""
    if len(entries) > MOST_ENTRIES:
        raise ModelError(f"the zip holds {len(entries)} entries; at most {MOST_ENTRIES} are read")
    total = sum(entry.file_size for entry in entries)
    if total > LARGEST_UNPACKED_BYTES:
        raise ModelError(f"unpacked the zip would have {total} bytes; at most {LARGEST_UNPACKED_BYTES >> 20} MiB are read")
    for entry in entries:
        check_entry(entry)
    wanted = [entry for entry in entries if not entry.is_dir() and is_wanted(PurePosixPath(entry.filename))]
    check_different(entry.filename for entry in wanted)
    return wanted


def check_entry(entry: zipfile.ZipInfo) -> None:
    """Refuses an entry that leads out of the archive, is no plain file, or cannot be read."""
    check_name(entry.filename)
    kind = stat.S_IFMT(entry.external_attr >> 16)
    if kind not in (0, stat.S_IFREG, stat.S_IFDIR):
        raise ModelError("the entry is a link or a device; only plain files are unpacked", place=shown(entry.filename))
    if entry.flag_bits & ENCRYPTED:
        raise ModelError("the entry is encrypted", place=shown(entry.filename))
    if entry.compress_type not in PLAIN_METHODS:
        raise ModelError(f"compression {entry.compress_type} is not read; only stored and deflated are", place=shown(entry.filename))


def check_name(name: str) -> None:
    """Refuses a name that is no relative path below the archive."""
    path = PurePosixPath(name)
    odd = not name.isprintable() or "\\" in name or ":" in name
    if odd or path.is_absolute() or ".." in path.parts or len(name) > LONGEST_NAME or len(path.parts) > DEEPEST:
        raise ModelError("the entry's name must be a plain relative path", place=shown(name))


def shown(name: str) -> str:
    """An entry's name as an error's place."""
    return ascii(name[:LONGEST_NAME])


def is_wanted(path: PurePosixPath) -> bool:
    """Whether a model may need the file; hidden ones, which some systems add, are none."""
    hidden = any(part.startswith(".") or part == "__MACOSX" for part in path.parts)
    return path.suffix.lower() in SUFFIXES and not hidden


def check_different(names: Iterable[str]) -> None:
    """Refuses names that some file systems take for one, and a file where another needs a folder."""
    seen: set[str] = set()
    folders: set[str] = set()
    for name in names:
        key = str(PurePosixPath(name)).casefold()
        folders.update(str(parent) for parent in PurePosixPath(key).parents)
        if key in seen:
            raise ModelError("the zip holds this name twice", place=shown(name))
        seen.add(key)
    for name in sorted(seen & folders):
        raise ModelError("the zip has a file and a folder of this name", place=shown(name))


def extract(opened: zipfile.ZipFile, entry: zipfile.ZipInfo, folder: Path, most: int) -> int:
    """Writes an entry below the folder, counting its bytes; their number."""
    target = folder / PurePosixPath(entry.filename)
    target.parent.mkdir(parents=True, exist_ok=True)
    written = 0
    with opened.open(entry) as source, target.open("xb") as file:
        while chunk := source.read(CHUNK_BYTES):
            written += len(chunk)
            if written > min(most, entry.file_size):
                raise ModelError("the entry is longer than it says", place=shown(entry.filename))
            file.write(chunk)
    return written


def model_in(folder: Path) -> Path:
    """The one model of a folder: the .gltf or .glb that lies highest. Raises ModelError where there is none, or more than one."""
    found = [path for path in sorted(folder.rglob("*")) if path.suffix.lower() in MODELS and path.is_file()]
    if not found:
        raise ModelError("there is no .gltf or .glb in it")
    depth = min(len(path.parts) for path in found)
    highest = [path for path in found if len(path.parts) == depth]
    if len(highest) > 1:
        names = ", ".join(path.name[:60] for path in highest[:5])
        raise ModelError(f"it holds {len(highest)} models, and only one is wanted: {names}")
    return highest[0]
