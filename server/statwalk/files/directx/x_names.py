"""Names that a .x file allows: letters, digits and _, no digit first; each once."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field

_FORBIDDEN = re.compile(r"[^A-Za-z0-9_]")
_LONGEST = 120


@dataclass
class XNames:
    """The names given so far."""

    taken: set[str] = field(default_factory=set)

    def all_of(self, names: Iterable[str], kind: str) -> list[str]:
        """Returns an allowed name for each name, in order."""
        return [self.one(name, kind) for name in names]

    def one(self, name: str, kind: str) -> str:
        """Returns an allowed name that no other object has; `kind` is for an empty name."""
        plain = _FORBIDDEN.sub("_", name)[:_LONGEST] or kind
        plain = f"_{plain}" if plain[0].isdigit() or plain == "template" else plain
        allowed, count = plain, 1
        while allowed in self.taken:
            count += 1
            allowed = f"{plain}_{count}"
        self.taken.add(allowed)
        return allowed
