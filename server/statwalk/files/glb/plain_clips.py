"""Animations as most files have them: straight keys of joints in plain accessors. All of a file's are checked at once, in columns.

Whatever is not plain, or not right, is left to `animations`, which looks at it channel by channel and says what is wrong.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, pairwise
from typing import Any, NamedTuple

import numpy as np

from statwalk.files.glb.accessors import Accessors
from statwalk.files.glb.allowance import Allowance
from statwalk.files.glb.check import Json
from statwalk.files.glb.columns import BROKEN, Codes, Column, all_of, codes, field, whole_numbers
from statwalk.files.glb.keytimes import TimeTable
from statwalk.files.glb.nodes import MOST_NODES
from statwalk.files.glb.plain import PlainFloats
from statwalk.maths.arrays import Bools, Ints
from statwalk.motion.keytable import INTERPOLATIONS, PATH_WIDTHS, PATHS, KeyTable, Shelf
from statwalk.motion.timing import KeyTimes

PATH_CODES, INTERPOLATION_CODES = Codes(PATHS), Codes(INTERPOLATIONS)
LARGEST_SHELF = 1 << 20
"""numbers in the keys of animations that are packed together"""

Lists = tuple[list[Json], list[Json], list[Json]]


class Columns(NamedTuple):
    """Channels of animations, a column (C,) for each field; BROKEN where it is not right."""

    animation: Column
    node: Column
    path: Column
    interpolation: Column
    input: Column
    output: Column

    def taken(self, rows: Any) -> Columns:
        """Some of the channels."""
        return Columns(*(column[rows] for column in self))


def plain_tables(
    animations: Sequence[Json], accessors: Accessors, times: TimeTable, joint_of: Ints, allowed: Allowance
) -> dict[int, KeyTable]:
    """The channels of those animations that are plain, by their index; `joint_of` (N,) is the joint of each node."""
    listed = {row: lists for row, entry in enumerate(animations) if (lists := lists_of(entry))}
    if not listed:
        return {}
    columns = columns_of(listed)
    good = are_plain(columns, accessors.plain, len(joint_of)) & are_single(columns)
    good[good] = keep_all_keys(columns.input[good], times)
    if not good.all():
        columns = columns.taken(~np.isin(columns.animation, columns.animation[~good]))
    size = accessors.plain.count[columns.output] * PATH_WIDTHS[columns.path]
    if not len(size) or allowed.taken + size.sum() > allowed.most:
        return {}
    allowed.take(int(size.sum()), "/animations")
    return dict(put_on_shelves(columns, size, accessors.plain, times, joint_of))


def lists_of(entry: Json) -> Lists | None:
    """An animation's channels, their targets and its samplers; None where there are none, or they are no lists of objects."""
    channels, samplers = objects(entry.get("channels")), objects(entry.get("samplers"))
    targets = objects(field(channels, "target", None))
    return (channels, targets, samplers) if channels and targets and samplers else None


def objects(value: Any) -> list[Json]:
    """The value where it is a list of objects, else none."""
    return value if isinstance(value, list) and all_of(value, dict) else []


def columns_of(listed: dict[int, Lists]) -> Columns:
    """The fields of all channels of some animations, by their index."""
    channels, targets, samplers = (list(chain.from_iterable(lists)) for lists in zip(*listed.values(), strict=True))
    counts = [len(lists[0]) for lists in listed.values()]
    sampler_counts = np.array([len(lists[2]) for lists in listed.values()])
    sampler = whole_numbers(channels, "sampler")
    is_there = (sampler >= 0) & (sampler < sampler_counts.repeat(counts))
    rows = np.where(is_there, sampler + (sampler_counts.cumsum() - sampler_counts).repeat(counts), 0)
    found = (
        codes(samplers, "interpolation", INTERPOLATION_CODES, "LINEAR"),
        whole_numbers(samplers, "input"),
        whole_numbers(samplers, "output"),
    )
    return Columns(
        np.repeat(list(listed), counts),
        whole_numbers(targets, "node"),
        codes(targets, "path", PATH_CODES),
        *(np.where(is_there, column[rows], BROKEN) for column in found),
    )


def are_plain(columns: Columns, plain: PlainFloats, nodes: int) -> Bools:
    """(C,) whether a channel moves a joint by usable numbers, as many as it has keys, and in the same buffer as the first that does."""
    accessors = len(plain.usable)
    right = (columns.node >= 0) & (columns.node < nodes) & (columns.path >= 0) & (columns.interpolation >= 0)
    right &= (columns.input >= 0) & (columns.input < accessors) & (columns.output >= 0) & (columns.output < accessors)
    keys, values = np.where(right, columns.input, 0), np.where(right, columns.output, 0)
    if not accessors:
        return right
    right &= plain.usable[keys] & plain.usable[values] & (plain.count[keys] == plain.count[values])
    right &= (plain.width[keys] == 1) & (plain.width[values] == PATH_WIDTHS[columns.path])
    return np.asarray(right & (plain.buffer[values] == plain.buffer[values[right.argmax()]]))


def are_single(columns: Columns) -> Bools:
    """(C,) whether no other channel of the animation moves the same property."""
    moved = (columns.animation * MOST_NODES + np.minimum(columns.node, MOST_NODES)) * len(PATHS) + columns.path
    ordered = np.sort(moved)
    if (ordered[1:] != ordered[:-1]).all():
        return np.ones(len(moved), bool)
    _, which, count = np.unique(moved, return_inverse=True, return_counts=True)
    return np.asarray(count[which] == 1)


def keep_all_keys(inputs: Column, times: TimeTable) -> Bools:
    """(C,) whether none of the keys at these times is left out. Raises ModelError where times do not rise."""
    short = [row for row in sorted(set(inputs.tolist())) if times.read(row, f"/accessors/{row}").keys is not None]
    return ~np.isin(inputs, short) if short else np.ones(len(inputs), bool)


def put_on_shelves(columns: Columns, sizes: Column, plain: PlainFloats, times: TimeTable, joint_of: Ints) -> Iterator[tuple[int, KeyTable]]:
    """The tables of whole animations, by their index; neighbours are packed together as long as they are not too large.

    sizes    (C,) the numbers in each channel's keys
    """
    starts = np.flatnonzero(columns.animation != np.append(-1, columns.animation[:-1]))
    ends = np.append(starts[1:], len(sizes))
    together = np.add.reduceat(sizes, starts).cumsum() // LARGEST_SHELF
    for first, last in pairwise(np.flatnonzero(np.diff(together, prepend=-1, append=-1))):
        part = columns.taken(slice(starts[first], ends[last - 1]))
        shelf = shelf_of(part, plain, times, joint_of)
        for start, end in zip(starts[first:last], ends[first:last], strict=True):
            yield int(columns.animation[start]), KeyTable(shelf, int(start - starts[first]), int(end - starts[first]))


def shelf_of(columns: Columns, plain: PlainFloats, times: TimeTable, joint_of: Ints) -> Shelf:
    """The channels in the form that is packed."""
    rows, timing = np.unique(columns.input, return_inverse=True)
    return Shelf(
        joint=joint_of[columns.node],
        path=columns.path,
        interpolation=columns.interpolation,
        times=KeyTimes([times.read(row, f"/accessors/{row}").times for row in rows.tolist()]),
        timing=timing,
        numbers=plain.numbers[int(plain.buffer[columns.output[0]])],
        first=plain.first[columns.output],
    )
