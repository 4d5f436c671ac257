"""Builds a tree of values with their lines from PyYAML's events; anything that is not strict ends the
reading.

The events are libyaml's if it is installed, which is twenty times as fast. Composing a deep document with
libyaml crashes, because its composer recurses; here a list of open collections replaces the recursion, and
the depth is checked before the next event.
"""

from __future__ import annotations

import re
from typing import Any

import yaml

from statwalk.errors import ContentError
from statwalk.files.yaml.yaml_node import Node

DEEPEST = 32
MOST_VALUES = 6_000

SURROGATES = re.compile("[\ud800-\udfff]")

# PyYAML's event classes have no types.
Event = Any


class PureParser(yaml.SafeLoader):
    """PyYAML's own scanner and parser with a limit on depth: without one they look ahead through any number
    of brackets.
    """

    def fetch_flow_collection_start(self, TokenClass: Any) -> None:  # noqa: N803
        """Reads one more `[` or `{`."""
        if self.flow_level >= DEEPEST:
            raise yaml.MarkedYAMLError(
                problem=f"brackets are nested more than {DEEPEST} deep", problem_mark=self.get_mark()
            )
        super().fetch_flow_collection_start(TokenClass)


Parser: Any = getattr(yaml.cyaml, "CParser", PureParser) if yaml.__with_libyaml__ else PureParser


class OpenCollection:
    """A list or a mapping that is still being read."""

    __slots__ = ("allowed", "entries", "key", "node", "values")

    def __init__(self, node: Node, allowed: tuple[str, ...] = ()) -> None:
        self.node, self.allowed = node, allowed
        self.values = node.value if isinstance(node.value, list) else None
        self.entries = node.value if isinstance(node.value, dict) else {}
        self.key: str | None = None

    def take(self, node: Node) -> None:
        """Adds the next value of a list; in a mapping the next key, or the value of the last key."""
        if self.values is not None:
            self.values.append(node)
        elif self.key is None:
            self.key = self.checked_key(node)
        else:
            self.entries[self.key] = node
            self.key = None

    def checked_key(self, node: Node) -> str:
        """Returns a key, whose value comes next.

        :raises ContentError: when the key is repeated or not allowed.
        """
        key, lines = node.text(), self.node.key_lines
        if self.allowed and key not in self.allowed:
            raise node.unknown("key", key, self.allowed)
        if key in lines:
            raise node.refuse(f"the key {key[:40]!r} was already given in line {lines[key]}")
        lines[key] = node.line
        self.node.key_spans[key] = node.start, node.end
        return key


class Tree:
    """Builds the nodes from the parser's events, with a list of open collections instead of recursion."""

    def __init__(self, file: str, error: type[ContentError], allowed: tuple[str, ...] = ()) -> None:
        self.file, self.error, self.allowed = file, error, allowed
        self.open: list[OpenCollection] = []
        self.root: Node | None = None
        self.count = 0

    def build(self, parser: Any) -> Node:
        """Returns the root of the document that a parser reads.

        :raises ContentError: when a value is not strict; `error` is the class of the error.
        :raises yaml.YAMLError: when the text is not YAML.
        """
        try:
            while (event := parser.get_event()) is not None:
                self.take(event)
        except (
            ValueError,
            OverflowError,
        ):  # from the pure parser, for \U escapes and %YAML versions that are too large
            raise self.error_at(
                "a number here is too large: a character code or a YAML version", parser.line + 1
            ) from None
        finally:
            parser.dispose()
        return self.root or Node({}, 1, self.file, self.error)

    def take(self, event: Event) -> None:
        """Handles one event: a value, the beginning or end of a collection, or the beginning of a
        document.
        """
        kind = type(event)
        if kind is yaml.ScalarEvent:
            self.put(event, self.text(event), event.style or None)
        elif kind is yaml.MappingStartEvent:
            node = self.put(event, {}, "{" if event.flow_style else None)
            self.open.append(OpenCollection(node, () if self.open else self.allowed))
        elif kind is yaml.SequenceStartEvent:
            self.open.append(OpenCollection(self.put(event, [], "{" if event.flow_style else None)))
        elif isinstance(event, yaml.CollectionEndEvent):
            node, mark = self.open.pop().node, event.end_mark
            node.end = mark.index if node.style and mark else 0
        elif kind is yaml.AliasEvent:
            raise self.error_at("aliases (*) are not read", event.start_mark.line + 1)
        elif kind is yaml.DocumentStartEvent and self.root is not None:
            raise self.error_at("a second document (---) begins here", event.start_mark.line + 1)

    def error_at(self, message: str, line: int) -> ContentError:
        """Returns the error about a line that has no value."""
        return Node("", line, self.file, self.error).refuse(message)

    def text(self, event: Event) -> str:
        """Returns the text of a scalar."""
        text: str = event.value
        if not text.isascii() and SURROGATES.search(text):
            raise self.error_at("a lone surrogate is no character", event.start_mark.line + 1)
        return text

    def put(self, event: Event, value: str | list[Node] | dict[str, Node], style: str | None = None) -> Node:
        """Adds a new value to the open collection and returns its node.

        :raises ContentError: when the value is not strict.
        """
        mark = event.start_mark
        node = Node(value, mark.line + 1, self.file, self.error, style, {}, mark.index, event.end_mark.index)
        self.count += 1
        if event.anchor is not None:
            raise node.refuse("anchors (&) are not read")
        if event.tag is not None:
            raise node.refuse(f"tags ({str(event.tag)[:40]}) are not read")
        if len(self.open) >= DEEPEST:
            raise node.refuse(f"the value is nested more than {DEEPEST} deep")
        if self.count > MOST_VALUES:
            raise node.refuse(f"more than {MOST_VALUES:,} values")
        if self.open:
            self.open[-1].take(node)
        elif self.allowed and not node.is_mapping:
            raise node.refuse("a mapping is needed here (key: value)")
        else:
            self.root = node
        return node
