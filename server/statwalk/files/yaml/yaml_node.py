"""A value of a YAML file with its line: readers get text, numbers, lists and mappings from it, and the errors
about it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from statwalk.errors import ContentError, nearest


@dataclass(eq=False, slots=True)  # frozen, it would take twice as long to read a file
class Node:
    """A value of the file: text, a list or a mapping; `line` counts from 1 (for a `|` block: the line of the
    `|`).
    """

    value: str | list[Node] | dict[str, Node]
    line: int
    file: str
    error: type[ContentError]
    style: str | None = None
    """`|`, `>` or the quotes of a text; `{` of a list or mapping in brackets"""
    key_lines: dict[str, int] = field(default_factory=dict)
    """the line of each key, if the value is a mapping"""
    start: int = 0
    end: int = 0
    """where it is written: from letter `start` up to `end`; of a list or mapping without brackets 0"""
    key_spans: dict[str, tuple[int, int]] = field(default_factory=dict)
    """where each key is written, if the value is a mapping"""

    @property
    def is_text(self) -> bool:
        """True if the value is text, rather than a list or a mapping."""
        return isinstance(self.value, str)

    @property
    def is_mapping(self) -> bool:
        """True if the value has keys."""
        return isinstance(self.value, dict)

    @property
    def first_line(self) -> int:
        """The line on which the text itself begins: for a `|` block the line after the `|`."""
        return self.line + 1 if self.style in ("|", ">") else self.line

    def refuse(self, message: str, line: int | None = None) -> ContentError:
        """Returns the error to raise about this value, with file and line."""
        return self.error(message, file=self.file, place=f"line {line or self.line}")

    def text(self) -> str:
        """Returns the value as it is written.

        :raises ContentError: when the value is a list or a mapping; `error` is the class of the error, here
            and below.
        """
        if not isinstance(self.value, str):
            raise self.refuse("one value is needed here, not a list or a mapping")
        return self.value

    def number(self, lowest: float = -math.inf, highest: float = math.inf) -> float:
        """Returns the value as a finite number within its limits.

        :raises ContentError: when the value is no such number.
        """
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
        """Returns the value of `true` or `false`.

        :raises ContentError: when the value is neither.
        """
        text = self.text()
        if text not in ("true", "false"):
            raise self.refuse(f"{text[:40]!r} is neither true nor false")
        return text == "true"

    def items(self) -> list[Node]:
        """Returns the values of a list.

        :raises ContentError: when the value is no list.
        """
        if not isinstance(self.value, list):
            raise self.refuse("a list is needed here")
        return self.value

    def entries(self, *allowed: str) -> dict[str, Node]:
        """Returns keys and values in the order of the file.

        :raises ContentError: when the value is no mapping, or has a key that is not in `allowed` (empty: any
            key).
        """
        if not isinstance(self.value, dict):
            raise self.refuse("a mapping is needed here (key: value)")
        if allowed:
            for key in self.value:
                if key not in allowed:
                    raise self.unknown("key", key, allowed, self.key_lines[key])
        return self.value

    def unknown(self, kind: str, name: str, existing: Iterable[str], line: int | None = None) -> ContentError:
        """Returns the error about a name that does not exist; the message has the most similar
        existing name.
        """
        names = list(existing)
        listed = f"{', '.join(names[:40]) or 'none'}{', …' * (len(names) > 40)}"
        return self.refuse(
            f"no {kind} is called {name[:40]!r}{nearest(name, names) or '.'} There are: {listed}", line
        )

    def plain(self) -> Any:
        """Returns the value as str, list and dict, without lines."""
        if isinstance(self.value, dict):
            return {key: node.plain() for key, node in self.value.items()}
        return self.value if isinstance(self.value, str) else [node.plain() for node in self.value]
