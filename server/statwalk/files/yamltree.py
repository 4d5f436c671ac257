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
MOST_VALUES = 10_000

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
            while parser.check_event():
                self.take(parser.get_event())
        except (ValueError, OverflowError):  # the pure parser's, for \U escapes and %YAML versions beyond all bounds
            raise self.refused("there is a number here that is too large for what it stands for", parser.line + 1) from None
        finally:
            parser.dispose()
        return self.root or Node({}, 1, self.file, self.error)

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
        return Node("", line, self.file, self.error).refuse(message)

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
        if is_text and HALVES.search(event.value):
            raise self.refused("half a character (a lone surrogate) is no text", line)
        value = event.value if is_text else {} if isinstance(event, yaml.MappingStartEvent) else []
        node = Node(value, line, self.file, self.error, (event.style if is_text else None) or None)
        if self.open:
            self.open[-1].take(node)
        elif self.known and not node.is_mapping:
            raise node.refuse("a mapping is wanted here (key: value)")
        else:
            self.root = node
        if not is_text:
            self.open.append(Growing(node, () if self.open else self.known))
