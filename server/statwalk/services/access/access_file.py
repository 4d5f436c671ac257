"""The file of the people who may use a server: names, roles, and the hashes of their tokens.

`access.json` in the data folder; only its owner may read it. `statwalk access` writes it while a server runs,
and the server reads it again as soon as it changes.
"""

from __future__ import annotations

import fcntl
import json
import logging
import os
import re
import stat
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from statwalk.errors import ConflictError, ContentError, LimitError, existing
from statwalk.services.access.roles import ACCESS_ROLES, AccessRole, digest_of, new_token

FILE = "access.json"
PERSON = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.@-]{0,63}")
DIGEST = re.compile(r"[0-9a-f]{64}")
MOST_PEOPLE = 200
log = logging.getLogger("statwalk.access")


@dataclass(frozen=True)
class Person:
    """One line of the file."""

    name: str
    role: AccessRole
    digest: str


class AccessFile:
    """The access list of a data folder; without the file nobody has access. Thread-safe."""

    def __init__(self, folder: Path) -> None:
        self.path = folder / FILE
        self._stamp: tuple[int, ...] = ()
        self._people: tuple[Person, ...] = ()
        self._fault = ""

    def people(self) -> tuple[Person, ...]:
        """Returns the people of the file as it is now.

        :raises ContentError: when the file is no list of people, or others may read it.
        """
        try:
            status = self.path.stat()
        except FileNotFoundError:
            return ()
        stamp = (status.st_mtime_ns, status.st_ino, status.st_size, status.st_mode)
        if stamp != self._stamp:
            self._people = _read(self.path, status.st_mode)
            self._stamp = stamp
        return self._people

    def people_or_nobody(self) -> tuple[Person, ...]:
        """Returns the people of the file, and nobody while it cannot be read; the log says so."""
        people: tuple[Person, ...] = ()
        fault = ""
        try:
            people = self.people()
        except (ContentError, OSError) as error:
            fault = str(error)
        if fault and fault != self._fault:
            log.error("nobody of the file has access: %s", fault)
        self._fault = fault
        return people

    def add(self, name: str, role: AccessRole) -> str:
        """Adds a person, and returns the token, which is kept nowhere.

        :raises ContentError: when the name has other characters than letters, digits and `_.@-`.
        :raises ConflictError: when the name is taken.
        :raises LimitError: when the file has the most people that it may have.
        """
        if not PERSON.fullmatch(name):
            raise ContentError(f"{name[:80]!r} is no name: use 1 to 64 letters, digits and _ . @ -")
        with self._changing() as people:
            if any(person.name == name for person in people):
                raise ConflictError(f"{name} has access already; revoke it first for a new token or role")
            if len(people) >= MOST_PEOPLE:
                raise LimitError(f"{MOST_PEOPLE} people have access, and no more; revoke some first")
            token = new_token()
            self._write([*people, Person(name, role, digest_of(token))])
        return token

    def revoke(self, name: str) -> None:
        """Removes a person; a running server closes the person's connections.

        :raises UnknownNameError: when nobody has the name.
        """
        with self._changing() as people:
            existing("name", name, {person.name: person for person in people})
            self._write([person for person in people if person.name != name])

    @contextmanager
    def _changing(self) -> Iterator[tuple[Person, ...]]:
        """Yields the people while no other process changes them."""
        self.path.parent.mkdir(parents=True, exist_ok=True)
        handle = os.open(self.path.with_suffix(".lock"), os.O_RDWR | os.O_CREAT, 0o600)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX)
            yield self.people()
        finally:
            os.close(handle)

    def _write(self, people: Sequence[Person]) -> None:
        """Replaces the file by one that was flushed to the disk; nobody else may read it at any time."""
        unfinished = self.path.with_suffix(".new")
        text = json.dumps({"version": 1, "people": [asdict(person) for person in people]}, indent=1)
        unfinished.unlink(missing_ok=True)
        with os.fdopen(os.open(unfinished, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as file:
            file.write(text + "\n")
            file.flush()
            os.fsync(file.fileno())
        unfinished.replace(self.path)


def _read(path: Path, mode: int) -> tuple[Person, ...]:
    if stat.S_IMODE(mode) & 0o077:
        raise ContentError("others may read this file: chmod 600", file=str(path))
    try:
        lines = json.loads(path.read_bytes())["people"]
        return tuple(_person(line) for line in lines)
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise ContentError(f"this is no list of people: {error}", file=str(path)) from None


def _person(line: Any) -> Person:
    person = Person(**line)
    if person.role not in ACCESS_ROLES:
        raise ValueError(f"no role is called {person.role!r}")
    if not PERSON.fullmatch(person.name) or not DIGEST.fullmatch(person.digest):
        raise ValueError(f"{person.name!r} has no hash of a token")
    return person
