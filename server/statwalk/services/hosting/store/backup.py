"""A data folder as one .zip file, and back."""

from __future__ import annotations

import re
import shutil
import tempfile
import zipfile
from collections.abc import Iterator
from pathlib import Path

from statwalk.errors import ConflictError, ContentError, StorageError
from statwalk.services.hosting.store.database import FILE_NAME
from statwalk.services.hosting.store.folder_lock import FolderLock
from statwalk.services.hosting.store.read_records import KeptRecords

PRIVATE = "access.json"
"""has hashes of tokens: readable by its owner only"""
MEMBER = re.compile(
    rf"{re.escape(FILE_NAME)}|{re.escape(PRIVATE)}|characters/[0-9a-f]{{64}}\.(?:glb|npz)"
    r"|names/[A-Za-z0-9_-]{1,64}\.json"
    r"|machines/[A-Za-z0-9_-]{1,64}/(?:\.keys|[^./\\:\x00-\x1f][^/\\:\x00-\x1f]{0,199}"
    r"(?:/[^./\\:\x00-\x1f][^/\\:\x00-\x1f]{0,199}){0,9})"
)
"""the files of a data folder, by path; nothing else goes into a backup or comes out of one. Tables and
captures have names that people gave them; `.keys` says which requests made a machine (`library/made_keys`)
"""


def back_up(folder: Path, target: Path) -> list[str]:
    """Writes the backup `target`, and returns the paths in it; a server may use the folder meanwhile.

    The database is copied first: what its stages play is not deleted while they play it.

    :raises ConflictError: when the target exists.
    :raises StorageError: when the folder cannot be read, or the target cannot be written.
    """
    if target.exists():
        raise ConflictError(f"{target} exists already; name another file")
    try:
        with tempfile.TemporaryDirectory(dir=target.parent) as name, target.open("xb") as file:
            copy = Path(name) / FILE_NAME
            with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
                if (folder / FILE_NAME).is_file():
                    KeptRecords(folder / FILE_NAME).copy(copy)
                    archive.write(copy, FILE_NAME)
                for path in _files(folder):
                    archive.write(folder / path, path)
                return archive.namelist()
    except OSError as error:
        raise StorageError.of(error, str(target)) from None


def _files(folder: Path) -> Iterator[str]:
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.is_file() and name != FILE_NAME and MEMBER.fullmatch(name):
            yield name


def bring_back(source: Path, folder: Path) -> list[str]:
    """Unpacks a backup into a folder that holds no data yet, and returns the paths.

    :raises ContentError: when the file is no backup.
    :raises ConflictError: when the folder holds data, or a server uses it.
    :raises StorageError: when the folder cannot be written.
    """
    held = [name for name in (FILE_NAME, "names", "machines", "characters") if (folder / name).exists()]
    if held:
        raise ConflictError(
            f"{folder} holds data already ({', '.join(held)}); move it away, or name another folder"
        )
    lock = FolderLock(folder)
    try:
        with zipfile.ZipFile(source) as archive:
            return [_unpacked(archive, member, folder) for member in _checked(archive, source, folder)]
    except zipfile.BadZipFile as error:
        raise ContentError(f"this is no backup: {error}", file=str(source)) from None
    except OSError as error:
        raise StorageError.of(error, str(folder)) from None
    finally:
        lock.release()


def _checked(archive: zipfile.ZipFile, source: Path, folder: Path) -> list[zipfile.ZipInfo]:
    """The members, all of which are files of a data folder; room is looked for before it is taken."""
    members = archive.infolist()
    for member in members:
        if not MEMBER.fullmatch(member.filename):
            raise ContentError(f"this is no backup: it holds {member.filename[:80]!r}", file=str(source))
    needed, free = sum(member.file_size for member in members), shutil.disk_usage(folder).free
    if needed > free:
        raise StorageError(f"it needs {needed:,} bytes, and the disk has {free:,}", is_full=True)
    return members


def _unpacked(archive: zipfile.ZipFile, member: zipfile.ZipInfo, folder: Path) -> str:
    path = folder / member.filename
    path.parent.mkdir(parents=True, exist_ok=True)
    with archive.open(member) as packed, path.open("xb") as file:
        shutil.copyfileobj(packed, file)
    if member.filename == PRIVATE:
        path.chmod(0o600)
    return member.filename
