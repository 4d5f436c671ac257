"""Reads and writes chosen vertices as a character file has them: numbers and ranges, `[3, 4, 10-20]`."""

from __future__ import annotations

from statwalk.files.yaml.yaml_text import Node

MOST_VERTICES = 1_000_000


def read_vertices(node: Node) -> frozenset[int]:
    """Reads numbers and ranges of numbers.

    :raises ContentError: when one is neither, or too large.
    """
    chosen: set[int] = set()
    for item in node.items():
        first, dash, last = item.text().partition("-")
        if not all(part.isascii() and part.isdigit() and len(part) < 8 for part in (first, last or "0")):
            raise item.refuse(f"a vertex is a number or a range like 10-20, not {item.text()[:40]!r}")
        end = int(last) if dash and last else int(first)
        if end < int(first) or end >= MOST_VERTICES:
            raise item.refuse(f"vertices are numbers from 0 to {MOST_VERTICES - 1:,}, the smaller first")
        chosen.update(range(int(first), end + 1))
    return frozenset(chosen)


def vertices_in_words(vertices: frozenset[int]) -> list[int | str]:
    """Returns the numbers as `read_vertices` reads them, in order; consecutive numbers are a range."""
    spans: list[tuple[int, int]] = []
    for number in sorted(vertices):
        if spans and spans[-1][1] == number - 1:
            spans[-1] = spans[-1][0], number
        else:
            spans.append((number, number))
    return [first if first == last else f"{first}-{last}" for first, last in spans]
