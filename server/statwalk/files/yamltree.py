"""From PyYAML's events to a tree of values with their lines; what is not strict ends the reading.

The events are libyaml's where there is one, which is twenty times as fast. What crashes with libyaml is composing a deep document, which
recurses; here the values are put together in a list of what is open, and the depth is looked at before the next event.
"""

from __future__ import annotations

import re
from typing import Any

import yaml

from statwalk.errors import ContentError
from statwalk.files.yamlnode import Node

DEEPEST = 32
MOST_VALUES = 6_000

HALVES = re.compile("[\ud800-\udfff]")

# What PyYAML's untyped event classes are to us.
Event = Any


class PureParser(yaml.SafeLoader):
    """PyYAML's own scanner and parser, which stop at our depth: left alone they look ahead through any number of brackets."""

    def fetch_flow_collection_start(self, TokenClass: Any) -> None:  # noqa: N803
        """One more `[` or `{`."""
        if self.flow_level >= DEEPEST:
            raise yaml.MarkedYAMLError(problem=f"brackets within brackets, more than {DEEPEST} deep", problem_mark=self.get_mark())
        super().fetch_flow_collection_start(TokenClass)


Parser: Any = getattr(yaml.cyaml, "CParser", PureParser) if yaml.__with_libyaml__ else PureParser


class Growing:
    """A list or mapping of which some values have been read."""

    __slots__ = ("entries", "key", "known", "node", "values")

    def __init__(self, node: Node, known: tuple[str, ...] = ()) -> None:
        self.node, self.known = node, known
        self.values = node.value if isinstance(node.value, list) else None
        self.entries = node.value if isinstance(node.value, dict) else {}
        self.key: str | None = None

    def take(self, node: Node) -> None:
        """The next value of a list; a mapping's next key, or the value of the last."""
        if self.values is not None:
            self.values.append(node)
        elif self.key is None:
            self.key = self.checked(node)
        else:
            self.entries[self.key] = node
            self.key = None

    def checked(self, node: Node) -> str:
        """A key, which now waits for its value; raises `error` for one that was there, or is not known."""
        key, lines = node.text(), self.node.key_lines
        if self.known and key not in self.known:
            raise node.unknown("key", key, self.known)
        if key in lines:
            raise node.refuse(f"the key {key[:40]!r} was already given in line {lines[key]}")
        lines[key] = node.line
        return key


class Tree:
    """Builds the nodes from the parser's events, with a list where others recurse."""

    def __init__(self, file: str, error: type[ContentError], known: tuple[str, ...] = ()) -> None:
        self.file, self.error, self.known = file, error, known
        self.open: list[Growing] = []
        self.root: Node | None = None
        self.count = 0

    def built(self, parser: Any) -> Node:
        """The root, from a parser of events; raises `error` or yaml.YAMLError."""
        try:
            while (event := parser.get_event()) is not None:
                self.take(event)
        except (ValueError, OverflowError):  # the pure parser's, for \U escapes and %YAML versions beyond all bounds
            raise self.refused("there is a number here that is too large for what it stands for", parser.line + 1) from None
        finally:
            parser.dispose()
        return self.root or Node({}, 1, self.file, self.error)

    def take(self, event: Event) -> None:
        """One event: a value, the beginning or end of a list or mapping, or the outside of the document."""
        kind = type(event)
        if kind is yaml.ScalarEvent:
            self.put(event, self.text(event), event.style or None)
        elif kind is yaml.MappingStartEvent:
            self.open.append(Growing(self.put(event, {}), () if self.open else self.known))
        elif kind is yaml.SequenceStartEvent:
            self.open.append(Growing(self.put(event, [])))
        elif isinstance(event, yaml.CollectionEndEvent):
            self.open.pop()
        elif kind is yaml.AliasEvent:
            raise self.refused("aliases (*) are not read", event.start_mark.line + 1)
        elif kind is yaml.DocumentStartEvent and self.root is not None:
            raise self.refused("a second document (---) begins here", event.start_mark.line + 1)

    def refused(self, message: str, line: int) -> ContentError:
        """The error about a place that has no value."""
        return Node("", line, self.file, self.error).refuse(message)

    def text(self, event: Event) -> str:
        """What a scalar says."""
        text: str = event.value
        if not text.isascii() and HALVES.search(text):
            raise self.refused("half a character (a lone surrogate) is no text", event.start_mark.line + 1)
        return text

    def put(self, event: Event, value: str | list[Node] | dict[str, Node], style: str | None = None) -> Node:
        """A new value where it belongs; raises `error` for what is not strict."""
        node = Node(value, event.start_mark.line + 1, self.file, self.error, style)
        self.count += 1
        if event.anchor is not None:
            raise node.refuse("anchors (&) are not read")
        if event.tag is not None:
            raise node.refuse(f"tags ({str(event.tag)[:40]}) are not read")
        if len(self.open) >= DEEPEST:
            raise node.refuse(f"more than {DEEPEST} deep")
        if self.count > MOST_VALUES:
            raise node.refuse(f"more than {MOST_VALUES:,} values")
        if self.open:
            self.open[-1].take(node)
        elif self.known and not node.is_mapping:
            raise node.refuse("a mapping is wanted here (key: value)")
        else:
            self.root = node
        return node
