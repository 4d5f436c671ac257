"""The accessors that most of a file consists of: 32-bit floats, tightly packed. All of them opened in one pass, nothing copied.

Whatever is not plain, or not right, is left to `accessors`, which looks closer and says what is wrong.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from statwalk.files.glb import check
from statwalk.files.glb.check import Json
from statwalk.files.glb.document import Document
from statwalk.files.glb.formats import FLOAT
from statwalk.files.glb.views import Views

WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
Floats32 = NDArray[np.float32]
Span = tuple[int, int]


def plain_floats(document: Document, views: Views) -> dict[int, Floats32]:
    """The arrays (count,) or (count, n) of all plain accessors with usable numbers only, by their index."""
    by_view: dict[int, list[tuple[int, Json]]] = {}
    for row, entry in enumerate(document["accessors"]):
        view = entry.get("bufferView")
        if entry.get("componentType") == FLOAT and type(view) is int and "sparse" not in entry:
            by_view.setdefault(view, []).append((row, entry))
    found: dict[int, Floats32] = {}
    spans: dict[int, dict[int, Span]] = {}
    for view, entries in by_view.items():
        if 0 <= view < len(document["bufferViews"]):
            open_view(views, document["bufferViews"][view], entries, spans)
    for buffer, placed in spans.items():
        data = views.buffer(buffer)
        whole = np.frombuffer(data, "<f4", len(data) // 4)
        found |= {row: whole[start:end] for row, (start, end) in usable(whole, placed).items()}
    return {row: shaped(values, document["accessors"][row]) for row, values in found.items()}


def open_view(views: Views, view: Json, entries: list[tuple[int, Json]], spans: dict[int, dict[int, Span]]) -> None:
    """Where the accessors of one view lie, in floats from the start of the buffer."""
    buffer, start, length = view.get("buffer"), view.get("byteOffset", 0), view.get("byteLength")
    if not (type(buffer) is int and type(start) is int and type(length) is int) or "byteStride" in view or min(start, length) < 0:
        return
    if not 0 <= buffer < len(views.document["buffers"]) or start + length > len(views.buffer(buffer)):
        return
    placed = spans.setdefault(buffer, {})
    for row, entry in entries:
        kind, count, offset = entry.get("type"), entry.get("count"), entry.get("byteOffset", 0)
        if type(kind) is str and kind in WIDTHS and type(count) is int and type(offset) is int and count > 0 <= offset:
            first, numbers = start + offset, count * WIDTHS[kind]
            if first % 4 == 0 and offset + 4 * numbers <= length:
                placed[row] = (first // 4, first // 4 + numbers)


def usable(whole: Floats32, placed: Mapping[int, Span]) -> dict[int, Span]:
    """Those spans that are there and whose numbers can be computed with. Neighbours are looked at together."""
    good: dict[int, Span] = {}
    run: dict[int, Span] = {}
    first = last = 0
    for row, (start, end) in sorted(placed.items(), key=lambda item: item[1]):
        if run and start > last:
            good |= run if is_usable(whole[first:last]) else {}
            run = {}
        first = start if not run else first
        last = max(last, end) if run else end
        if end <= len(whole):
            run[row] = (start, end)
    return good | (run if is_usable(whole[first:last]) else {})


def is_usable(numbers: Floats32) -> bool:
    """Whether all are finite and none is beyond 1e24: then, in most files, the sum of their squares is finite too."""
    return math.isfinite(np.dot(numbers, numbers)) or bool(len(numbers) and np.abs(numbers).max() <= check.LARGEST)


def shaped(values: Floats32, entry: Json) -> Floats32:
    """Scalars as (count,), all else as (count, n)."""
    return values if entry["type"] == "SCALAR" else values.reshape(entry["count"], -1)
