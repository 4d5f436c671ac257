"""A value of a YAML file and its place: what readers ask for text, numbers, lists and mappings, and what makes the error about it."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from statwalk.errors import ContentError, nearest


@dataclass(eq=False, slots=True)  # frozen, it would take twice as long to read a file
class Node:
    """A value of the file: text, a list or a mapping; `line` counts from 1 (for a `|` block: of the line with the `|`)."""

    value: str | list[Node] | dict[str, Node]
    line: int
    file: str
    error: type[ContentError]
    style: str | None = None
    key_lines: dict[str, int] = field(default_factory=dict)
    """the line of each key, where the value is a mapping"""

    @property
    def is_text(self) -> bool:
        """Whether this is one value rather than a list or a mapping."""
        return isinstance(self.value, str)

    @property
    def is_mapping(self) -> bool:
        """Whether this has keys."""
        return isinstance(self.value, dict)

    @property
    def first_line(self) -> int:
        """The line on which the text itself begins: the one after the `|` of a block."""
        return self.line + 1 if self.style in ("|", ">") else self.line

    def refuse(self, message: str, line: int | None = None) -> ContentError:
        """The error to raise about this value, with file and line."""
        return self.error(message, file=self.file, place=f"line {line or self.line}")

    def text(self) -> str:
        """The value as it is written; raises `error` where it is a list or a mapping."""
        if not isinstance(self.value, str):
            raise self.refuse("one value is wanted here, not a list or a mapping")
        return self.value

    def number(self, lowest: float = -math.inf, highest: float = math.inf) -> float:
        """The value as a finite number within its limits; raises `error` otherwise."""
        text = self.text()
        try:
            value = float(text)
        except ValueError:
            raise self.refuse(f"{text[:40]!r} is no number") from None
        if not (math.isfinite(value) and lowest <= value <= highest and "_" not in text):
            limits = "" if lowest == -math.inf and highest == math.inf else f" from {lowest:g} to {highest:g}"
            raise self.refuse(f"{text[:40]!r} is not a finite number{limits}")
        return value

    def truth(self) -> bool:
        """The value as `true` or `false`; raises `error` otherwise."""
        text = self.text()
        if text not in ("true", "false"):
            raise self.refuse(f"{text[:40]!r} is neither true nor false")
        return text == "true"

    def items(self) -> list[Node]:
        """The values of a list; raises `error` where it is none."""
        if not isinstance(self.value, list):
            raise self.refuse("a list is wanted here")
        return self.value

    def entries(self, *known: str) -> dict[str, Node]:
        """Key and value in the order of the file; raises `error` where it is no mapping, or has a key not among the `known`."""
        if not isinstance(self.value, dict):
            raise self.refuse("a mapping is wanted here (key: value)")
        if known:
            for key in self.value:
                if key not in known:
                    raise self.unknown("key", key, known, self.key_lines[key])
        return self.value

    def unknown(self, kind: str, name: str, known: Iterable[str], line: int | None = None) -> ContentError:
        """The error about a name that does not exist, with the nearest that does."""
        names = list(known)
        there = f"{', '.join(names[:40]) or 'none'}{', …' * (len(names) > 40)}"
        return self.refuse(f"no {kind} is called {name[:40]!r}{nearest(name, names) or '.'} There are: {there}", line)

    def plain(self) -> Any:
        """The same as str, list and dict, without lines."""
        if isinstance(self.value, dict):
            return {key: node.plain() for key, node in self.value.items()}
        return self.value if isinstance(self.value, str) else [node.plain() for node in self.value]
