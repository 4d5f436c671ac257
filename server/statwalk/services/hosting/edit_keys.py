"""The idempotency keys of edits: an edit that is sent again, for want of an answer, counts once.

A key is on the disk before its edit, with the number and a hash of the text of the version to be made: if the
server ends between the two, the machine's versions say whether the edit counted.
"""

from __future__ import annotations

import hashlib
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import NamedTuple

from statwalk.errors import BusyError, ConflictError
from statwalk.services.hosting.store.records import KeptKey, MachineVersion
from statwalk.services.hosting.store.store import Store

FIELD = "Idempotency-Key"
FindVersion = Callable[[int], MachineVersion | None]


class EditKey(NamedTuple):
    """A key, and a hash of the request that bears it."""

    key: str
    request: bytes

    @classmethod
    def of(cls, key: str, *request: object) -> EditKey | None:
        """Returns the key of a request; None without a key."""
        return cls(key, _digest(repr(request))) if key else None

    def answer(self, version: MachineVersion) -> KeptKey:
        """Returns what is kept of the answer: the version that the edit makes."""
        return KeptKey(self.request, version.number, 0, _digest(version.text).hex())


class EditKeys:
    """The keys of the edits of all machines, in the store. Thread-safe."""

    def __init__(self, store: Store | None) -> None:
        self._store = store
        self._under_way: set[tuple[str, str]] = set()
        self._lock = threading.Lock()

    @contextmanager
    def reserved(self, machine: str, key: EditKey | None) -> Iterator[None]:
        """Reserves a key until the end of the context.

        :raises BusyError: when an edit with this key is under way.
        """
        if key is None:
            yield
            return
        name = machine, key.key
        with self._lock:
            if name in self._under_way:
                raise BusyError(f"an edit with the key {key.key} is under way; wait for it, or try again")
            self._under_way.add(name)
        try:
            yield
        finally:
            self._under_way.discard(name)

    def earlier(
        self, machine: str, key: EditKey | None, versions: list[MachineVersion]
    ) -> MachineVersion | None:
        """Returns the version that an edit with the same key made; None if it made none.

        :raises ConflictError: when that was another edit, or its version is too old to be kept.
        :raises StorageError: when what is kept of it is damaged.
        """
        if key is None or self._store is None:
            return None
        kept = self._store.records.edit_key(machine, key.key)
        if kept is None:
            return None
        if kept.request != key.request:
            raise ConflictError(
                f"the idempotency key {key.key} belongs to another edit; use a new key for a new edit",
                field=FIELD,
            )
        if kept.tick < versions[0].number:
            raise ConflictError(
                f"the edit with the key {key.key} made version {kept.tick}, which is not kept any more",
                field=FIELD,
            )
        return next((version for version in versions if key.answer(version) == kept), None)

    def keep(self, machine: str, key: EditKey | None, version: MachineVersion) -> None:
        """Keeps a key, and waits until that is durable; the edit comes next.

        :raises StorageError: when the disk refuses.
        """
        if key is not None and self._store is not None:
            self._store.keep_edit_key(machine, key.key, key.answer(version))


def _digest(text: str) -> bytes:
    return hashlib.blake2b(text.encode(), digest_size=16).digest()
