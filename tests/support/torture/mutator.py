"""Seeded mutations of the valid files of any format."""

import pickle
import random
import struct
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

Change = Callable[[random.Random, Any], None]
"""changes a file that is held in memory, in place"""
UNFIT = (KeyError, IndexError, ValueError, TypeError, AttributeError, ZeroDivisionError, struct.error)
"""a change raises one of these when an earlier change took away what it needs"""


class Mutator:
    """A format under torture.

    sources   gives the valid files: each a bytearray, or whatever `changes` take and `finish` makes bytes of
    changes   one of them is chosen, with equal chances; a change may be listed several times
    outcome   `read`, `refused` or another word for what came of a file; raises where the reader breaks
    """

    def __init__(
        self,
        sources: Callable[[], list[Any]],
        changes: Sequence[Change],
        outcome: Callable[[bytes], str],
        finish: Callable[[random.Random | None, Any], bytes] = lambda _chance, file: bytes(file),
    ) -> None:
        self._sources, self._changes = sources, changes
        self.outcome, self.finish = outcome, finish

    @cached_property
    def sources(self) -> list[bytes]:
        """The valid files, pickled: each mutation gets its own."""
        return [pickle.dumps(source) for source in self._sources()]

    def valid(self) -> list[bytes]:
        """The valid files as they are."""
        return [self.finish(None, pickle.loads(source)) for source in self.sources]

    def mutated(self, seed: int) -> bytes:
        """The file of a seed: one of the valid files with one to four changes."""
        chance = random.Random(seed)
        file = pickle.loads(chance.choice(self.sources))
        for _ in range(chance.choice([1, 1, 2, 4])):
            try:
                chance.choice(self._changes)(chance, file)
            except UNFIT:
                continue
        return self.finish(chance, file)
