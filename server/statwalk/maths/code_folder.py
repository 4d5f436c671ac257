"""The folder of compiled code: one for each state of the sources, of numba, of Python and of the processor.

The folder's name is a hash of everything that the machine code depends on, so nothing in a folder is ever out
of date: a change in a function that is compiled into others leads to a new folder, in which all of them are
compiled again. Folders are in the user's cache folder, or under STATWALK_CACHE; if neither is writable, under
a temporary folder that child processes find through STATWALK_CACHE.
"""

from __future__ import annotations

import atexit
import hashlib
import os
import platform
import re
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import suppress
from functools import cache
from importlib.metadata import version
from pathlib import Path

VARIABLE = "STATWALK_CACHE"
PACKAGE = next(path for path in Path(__file__).resolve().parents if path.name == "statwalk")
KEPT_FOLDERS, KEPT_SECONDS = 8, 86_400.0
"""a folder is removed if it is not among the latest and was not used within a day"""
MAKES_CODE = re.compile(
    r"^@(?:kernel|inlined|intrinsic)\b|^\s*(?:from|import) (?:numba|llvmlite)\b", re.MULTILINE
)
IMPORT = re.compile(
    r"^\s*(?:from (statwalk[\w.]*) import (\([^)]*\)|.*)|import (statwalk[\w.]*))", re.MULTILINE
)
NAME = re.compile(r"\w+")


@cache
def folder() -> Path:
    """Returns the folder of this process, and makes it if necessary; processes with the same sources,
    libraries and processor share it.
    """
    name = fingerprint(PACKAGE)
    path = _base() / "kernels" / name
    if not _is_usable(path):
        path = _temporary() / "kernels" / name
        path.mkdir(parents=True)
    with suppress(OSError):  # another process removes them too
        _remove_old(path)
    return path


def fingerprint(package: Path) -> str:
    """Returns a hash of the compiled code's sources in a package, the libraries that compile it, Python and
    the processor.
    """
    state = hashlib.sha256()
    for path in compiled_sources(package):
        state.update(f"\0{path.relative_to(package).as_posix()}\0".encode() + path.read_bytes())
    libraries = [f"{name} {version(name)}" for name in ("numba", "llvmlite", "numpy")]
    state.update(repr((sys.version, sys.platform, platform.machine(), *libraries, processor())).encode())
    return state.hexdigest()[:32]


def compiled_sources(package: Path) -> list[Path]:
    """Returns the files of a package with compiled code and all files that they import from the package, as a
    kernel contains the constants that it reads.
    """
    paths = {_module(path.relative_to(package.parent)): path for path in package.rglob("*.py")}
    texts = {name: path.read_text(encoding="utf-8") for name, path in paths.items()}
    sources, waiting = set(), [name for name, text in texts.items() if MAKES_CODE.search(text)]
    while waiting:
        name = waiting.pop()
        if name not in sources:
            sources.add(name)
            waiting.extend(imported for imported in _imported(texts[name]) if imported in texts)
    return sorted(paths[name] for name in sources)


def _module(path: Path) -> str:
    return ".".join(path.with_suffix("").parts).removesuffix(".__init__")


def _imported(text: str) -> Iterator[str]:
    """The names that a module imports from the package: some are modules, some are names in modules."""
    for module, names, whole in IMPORT.findall(text):
        yield whole or module
        yield from (f"{module}.{name}" for name in NAME.findall(names))


def processor() -> tuple[str, str]:
    """Returns name and features of the processor that numba compiles for."""
    from llvmlite import binding
    from numba import config

    name = config.CPU_NAME or binding.get_host_cpu_name()
    features = (
        binding.get_host_cpu_features().flatten() if config.CPU_FEATURES is None else config.CPU_FEATURES
    )
    return str(name), str(features)


def _base() -> Path:
    folder_named = os.environ.get(VARIABLE, "")
    return Path(folder_named).absolute() if folder_named else user_cache_folder() / "statwalk"


def user_cache_folder() -> Path:
    """Returns the folder for files that programs can make again: $XDG_CACHE_HOME, else the platform's cache
    folder.
    """
    named = Path(os.environ.get("XDG_CACHE_HOME", ""))
    if named.is_absolute():
        return named
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or os.path.expanduser("~/AppData/Local"))
    return Path(os.path.expanduser("~/Library/Caches" if sys.platform == "darwin" else "~/.cache"))


def _is_usable(path: Path) -> bool:
    """Whether code can be kept in the folder, or is in it already, written by another user."""
    if not path.is_absolute():  # the user has no home folder
        return False
    try:
        path.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=path).close()
        os.utime(path)
    except OSError:
        return any(path.glob("*.nbi"))
    return True


def _temporary() -> Path:
    """A temporary base folder, for this process and its children, removed when this process ends."""
    base = tempfile.mkdtemp(prefix="statwalk-")
    os.environ[VARIABLE] = base
    atexit.register(shutil.rmtree, base, ignore_errors=True)
    return Path(base)


def _remove_old(current: Path) -> None:
    """Removes the folders of earlier sources, libraries or processors."""
    folders = [(path.stat().st_mtime, path) for path in current.parent.iterdir() if path.is_dir()]
    for used, path in sorted(folders, reverse=True)[KEPT_FOLDERS:]:
        if used < time.time() - KEPT_SECONDS:
            shutil.rmtree(path, ignore_errors=True)
