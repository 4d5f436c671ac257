"""Strict YAML: plain trees of text with line numbers, for files that come from anywhere (PyYAML's pure parser; its C one can be crashed).

    root = parse(text, "machine.yaml", MachineError)
    root.entries("initial", "states")["initial"].text()

No aliases, anchors or tags; a repeated key is an error; `no`, `on`, `12:30` and `1e3` stay text until somebody asks for a number.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from statwalk.errors import ContentError, nearest

LARGEST_BYTES = 1 << 20
DEEPEST = 32
MOST_VALUES = 50_000

# What PyYAML's untyped event classes are to us.
Event = Any


@dataclass(frozen=True, eq=False)
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


class Loader(yaml.SafeLoader):
    """PyYAML's scanner and parser, which stop at our depth: left alone they look ahead through any number of brackets."""

    def fetch_flow_collection_start(self, TokenClass: Any) -> None:  # noqa: N803
        """One more `[` or `{`."""
        if self.flow_level >= DEEPEST:
            raise yaml.MarkedYAMLError(problem=f"brackets within brackets, more than {DEEPEST} deep", problem_mark=self.get_mark())
        super().fetch_flow_collection_start(TokenClass)


class Growing:
    """A list or mapping of which some values have been read."""

    def __init__(self, node: Node, known: tuple[str, ...] = ()) -> None:
        self.node, self.known, self.key = node, known, None if node.is_mapping else ""

    def take(self, node: Node) -> None:
        """The next value of a list; a mapping's next key, or the value of the last."""
        value = self.node.value
        if isinstance(value, list):
            value.append(node)
        elif isinstance(value, dict):
            self.key = self.put(value, node)

    def put(self, value: dict[str, Node], node: Node) -> str | None:
        """The key that now waits for its value, if one does."""
        if self.key is not None:
            value[self.key] = node
            return None
        key = node.text()
        if self.known and key not in self.known:
            raise node.unknown("key", key, self.known)
        if key in self.node.key_lines:
            raise node.refuse(f"the key {key[:40]!r} was already given in line {self.node.key_lines[key]}")
        self.node.key_lines[key] = node.line
        return key


def read_text(path: Path, error: type[ContentError]) -> str:
    """A text file of at most 1 MiB; raises `error` where it is missing, larger or not UTF-8."""
    if not path.is_file():
        raise error("there is no such file", file=str(path))
    if path.stat().st_size > LARGEST_BYTES:
        raise error("the file is larger than 1 MiB", file=str(path))
    try:
        return path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise error("this is not UTF-8", file=str(path), place=f"byte {problem.start}") from None


def parse(text: str, file: str, error: type[ContentError], known: tuple[str, ...] = ()) -> Node:
    """The tree of a YAML document; raises `error` with file and line for whatever is not strict.

    With `known` the first key of the document that is not among them ends the reading.
    """
    if len(text.encode("utf-8", "surrogatepass")) > LARGEST_BYTES:
        raise error("the text is larger than 1 MiB", file=file)
    try:
        return Tree(file, error, known).built(text)
    except yaml.MarkedYAMLError as problem:
        mark = problem.problem_mark or problem.context_mark
        place = f"line {mark.line + 1}" if mark else ""
        raise error(f"this is not YAML: {problem.problem or problem.context}", file=file, place=place) from None
    except yaml.reader.ReaderError as problem:
        line = text.count("\n", 0, int(problem.position)) + 1
        raise error("there is a character that no text file has", file=file, place=f"line {line}") from None


class Tree:
    """Builds the nodes from the parser's events, with a list where others recurse."""

    def __init__(self, file: str, error: type[ContentError], known: tuple[str, ...] = ()) -> None:
        self.file, self.error, self.known = file, error, known
        self.open: list[Growing] = []
        self.root: Node | None = None
        self.count = 0

    def built(self, text: str) -> Node:
        """The root; raises `error` or yaml.YAMLError."""
        loader = Loader(text)
        try:
            while loader.check_event():
                self.take(loader.get_event())  # type: ignore[no-untyped-call]
        except (ValueError, OverflowError):  # PyYAML's, for \U escapes and %YAML versions beyond all bounds
            raise self.refused("there is a number here that is too large for what it stands for", loader.line + 1) from None
        finally:
            loader.dispose()
        return self.root or self.node({}, 1)

    def node(self, value: str | list[Node] | dict[str, Node], line: int, style: str | None = None) -> Node:
        """A value with its place."""
        return Node(value, line, self.file, self.error, style)

    def take(self, event: Event) -> None:
        """One event: a value, the beginning or end of a list or mapping, or the outside of the document."""
        line = event.start_mark.line + 1
        if isinstance(event, yaml.CollectionEndEvent):
            self.open.pop()
        elif isinstance(event, yaml.AliasEvent):
            raise self.refused("aliases (*) are not read", line)
        elif isinstance(event, yaml.NodeEvent):
            self.value(event, line)
        elif isinstance(event, yaml.DocumentStartEvent) and self.root is not None:
            raise self.refused("a second document (---) begins here", line)

    def refused(self, message: str, line: int) -> ContentError:
        """The error about a place that has no value."""
        return self.node("", line).refuse(message)

    def value(self, event: Event, line: int) -> None:
        """A new value, put where it belongs; a list or mapping stays open."""
        if event.anchor is not None:
            raise self.refused("anchors (&) are not read", line)
        if event.tag is not None:
            raise self.refused(f"tags ({str(event.tag)[:40]}) are not read", line)
        self.count += 1
        if len(self.open) >= DEEPEST or self.count > MOST_VALUES:
            raise self.refused(f"more than {DEEPEST} deep" if len(self.open) >= DEEPEST else f"more than {MOST_VALUES:,} values", line)
        is_text = isinstance(event, yaml.ScalarEvent)
        if is_text and any("\ud800" <= letter <= "\udfff" for letter in event.value):
            raise self.refused("half a character (a lone surrogate) is no text", line)
        node = self.node(
            event.value if is_text else {} if isinstance(event, yaml.MappingStartEvent) else [], line, getattr(event, "style", None)
        )
        if self.open:
            self.open[-1].take(node)
        else:
            self.root = node
        if not is_text:
            self.open.append(Growing(node, () if self.open else self.known))
