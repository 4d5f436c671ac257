"""The system calls of a trace that strace wrote, in the order in which they count for a disk."""

import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

WRITING = "-y", "-xx", "-s", "33554432", "-e", "signal=none"
"""the options with which strace writes what is read here"""
# a number of less than five digits is filled up with spaces
WHOLE = re.compile(rb"(\d+) +(\w+)\((.*)\) += (-?\d+|\?)")
BEGUN = re.compile(rb"(\d+) +(\w+)\((.*) <unfinished \.\.\.>")
ENDED = re.compile(rb"(\d+) +<\.\.\. (\w+) resumed>.*\) += (-?\d+|\?)")
OF_A_FILE = re.compile(rb"\d+<([^>]*)>(\(deleted\))?(?:, )?(.*)")
FLUSHES = "fsync", "fdatasync"
KINDS = {"pwrite64": "write", "write": "append", "ftruncate": "truncate"}


class Call(NamedTuple):
    """A call that changes a disk, or answers.

    `order`: a write counts from its beginning on, and a flush from its end; `begun`: where it began.
    `place`: the first byte of a write, or the new size. `failed`: it changed nothing.
    """

    order: int
    begun: int
    kind: str
    path: str
    data: bytes = b""
    place: int = 0
    failed: bool = False


def calls(traces: Iterable[Path]) -> list[Call]:
    """Returns the calls of processes that followed each other."""
    found: list[Call] = []
    for trace in traces:
        first = found[-1].order + 1 if found else 0
        found += sorted(_calls(trace, first), key=lambda call: call.order)
    return found


def _calls(trace: Path, first: int) -> Iterator[Call]:
    begun: dict[bytes, tuple[int, bytes, bytes]] = {}
    with trace.open("rb") as lines:
        for order, line in enumerate(lines, first):
            if match := WHOLE.match(line):
                thread, name, arguments, result = match.groups()
                yield from _call(order, order, name, arguments, result)
            elif match := BEGUN.match(line):
                thread, name, arguments = match.groups()
                begun[thread] = order, name, arguments
            elif match := ENDED.match(line):
                thread, _, result = match.groups()
                began, name, arguments = begun.pop(thread)
                yield from _call(began, order, name, arguments, result)
    for began, name, arguments in begun.values():  # the end of the process was first
        if name.decode() not in FLUSHES:
            yield from _call(began, began, name, arguments, b"0")


def _call(began: int, ended: int, called: bytes, arguments: bytes, result: bytes) -> Iterator[Call]:
    name, failed = called.decode(), result.startswith(b"-")
    if name in FLUSHES:
        path, _ = _of_a_file(arguments)
        yield Call(ended, began, "flush", path, failed=failed)
    elif name in KINDS:
        path, rest = _of_a_file(arguments)
        parts = rest.split(b", ")
        data = _text(parts[0]) if name != "ftruncate" else b""
        place = int(parts[-1]) if name != "write" else 0
        yield Call(began, began, KINDS[name], path, data, place, failed)
    elif name in ("openat", "unlink"):
        path = next(_text(part).decode() for part in arguments.split(b", ") if part.startswith(b'"'))
        if name == "unlink" or b"O_CREAT" in arguments:
            kind = "unlink" if name == "unlink" else "make"
            yield Call(began, began, kind, path, failed=failed)
    else:
        raise ValueError(f"the model of the disk does not know {name}")


def _of_a_file(arguments: bytes) -> tuple[str, bytes]:
    """The path of a file that is open, empty if it was deleted; and the other arguments."""
    match = OF_A_FILE.match(arguments)
    assert match is not None, arguments[:100]
    path, deleted, rest = match.groups()
    return "" if deleted else _text(path).decode(), rest


def _text(quoted: bytes) -> bytes:
    return bytes.fromhex(quoted.strip(b'"').replace(b"\\x", b"").decode())
