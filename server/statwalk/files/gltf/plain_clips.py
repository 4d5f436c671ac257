"""Reads plain animations, as most files have them: straight keys of joints in plain accessors.

All animations of a file are checked at once, in columns.

Every other animation, and every wrong one, is left to `animations`, which checks it channel by channel and
reports what is wrong.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, pairwise
from typing import Any, NamedTuple

import numpy as np

from statwalk.files.gltf.accessors import Accessors
from statwalk.files.gltf.allowance import Allowance
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.columns import BROKEN, Codes, Column, all_of, codes, field, whole_numbers
from statwalk.files.gltf.key_times import TimeTable
from statwalk.files.gltf.nodes import MOST_NODES
from statwalk.files.gltf.plain import PlainFloats
from statwalk.maths.arrays import Bools, Ints
from statwalk.motion.keys.channel_table import INTERPOLATIONS, PATH_WIDTHS, PATHS, ChannelTable, ClipChannels
from statwalk.motion.keys.key_times import KeyTimes

PATH_CODES, INTERPOLATION_CODES = Codes(PATHS), Codes(INTERPOLATIONS)
LARGEST_TABLE = 1 << 20
"""most numbers in the keys of animations that share a table"""

Lists = tuple[list[Json], list[Json], list[Json]]


class Columns(NamedTuple):
    """Channels of animations, a column (C,) for each field; BROKEN marks invalid values."""

    animation: Column
    node: Column
    path: Column
    interpolation: Column
    input: Column
    output: Column

    def taken(self, rows: Any) -> Columns:
        """Returns some of the channels."""
        return Columns(*(column[rows] for column in self))


def plain_tables(
    animations: Sequence[Json], accessors: Accessors, times: TimeTable, joint_of: Ints, allowed: Allowance
) -> dict[int, ClipChannels]:
    """Returns the channels of the plain animations, by the animation's index; `joint_of` (N,) is the joint of
    each node.
    """
    lists_of_animation = {row: lists for row, entry in enumerate(animations) if (lists := _lists_of(entry))}
    if not lists_of_animation:
        return {}
    columns = _columns_of(lists_of_animation)
    is_plain = _are_plain(columns, accessors.plain, len(joint_of)) & _are_single(columns)
    is_plain[is_plain] = _keep_all_keys(columns.input[is_plain], times)
    if not is_plain.all():
        columns = columns.taken(~np.isin(columns.animation, columns.animation[~is_plain]))
    size = accessors.plain.count[columns.output] * PATH_WIDTHS[columns.path]
    if not len(size) or allowed.taken + size.sum() > allowed.most:
        return {}
    allowed.take(int(size.sum()), "/animations")
    return dict(_clip_channels(columns, size, accessors.plain, times, joint_of))


def _lists_of(entry: Json) -> Lists | None:
    """Returns an animation's channels, their targets and its samplers; None if one of them is empty or no
    list of objects.
    """
    channels, samplers = _objects(entry.get("channels")), _objects(entry.get("samplers"))
    targets = _objects(field(channels, "target", None))
    return (channels, targets, samplers) if channels and targets and samplers else None


def _objects(value: Any) -> list[Json]:
    """Returns the value if it is a list of objects, otherwise an empty list."""
    return value if isinstance(value, list) and all_of(value, dict) else []


def _columns_of(lists_of_animation: dict[int, Lists]) -> Columns:
    """Returns the fields of all channels of some animations, by the animation's index."""
    channels, targets, samplers = (
        list(chain.from_iterable(lists)) for lists in zip(*lists_of_animation.values(), strict=True)
    )
    counts = [len(lists[0]) for lists in lists_of_animation.values()]
    sampler_counts = np.array([len(lists[2]) for lists in lists_of_animation.values()])
    sampler = whole_numbers(channels, "sampler")
    has_sampler = (sampler >= 0) & (sampler < sampler_counts.repeat(counts))
    rows = np.where(has_sampler, sampler + (sampler_counts.cumsum() - sampler_counts).repeat(counts), 0)
    sampler_columns = (
        codes(samplers, "interpolation", INTERPOLATION_CODES, "LINEAR"),
        whole_numbers(samplers, "input"),
        whole_numbers(samplers, "output"),
    )
    return Columns(
        np.repeat(list(lists_of_animation), counts),
        whole_numbers(targets, "node"),
        codes(targets, "path", PATH_CODES),
        *(np.where(has_sampler, column[rows], BROKEN) for column in sampler_columns),
    )


def _are_plain(columns: Columns, plain: PlainFloats, nodes: int) -> Bools:
    """Returns (C,): whether a channel moves a joint by usable numbers, as many as it has keys, in the same
    buffer as the first valid channel.
    """
    accessors = len(plain.usable)
    valid = (columns.node >= 0) & (columns.node < nodes) & (columns.path >= 0) & (columns.interpolation >= 0)
    valid &= (
        (columns.input >= 0)
        & (columns.input < accessors)
        & (columns.output >= 0)
        & (columns.output < accessors)
    )
    keys, values = np.where(valid, columns.input, 0), np.where(valid, columns.output, 0)
    if not accessors:
        return valid
    valid &= plain.usable[keys] & plain.usable[values] & (plain.count[keys] == plain.count[values])
    valid &= (plain.width[keys] == 1) & (plain.width[values] == PATH_WIDTHS[columns.path])
    return np.asarray(valid & (plain.buffer[values] == plain.buffer[values[valid.argmax()]]))


def _are_single(columns: Columns) -> Bools:
    """Returns (C,): whether no other channel of the animation moves the same property."""
    property_of_channel = (columns.animation * MOST_NODES + np.minimum(columns.node, MOST_NODES)) * len(
        PATHS
    ) + columns.path
    sorted_properties = np.sort(property_of_channel)
    if (sorted_properties[1:] != sorted_properties[:-1]).all():
        return np.ones(len(property_of_channel), bool)
    _, group, count = np.unique(property_of_channel, return_inverse=True, return_counts=True)
    return np.asarray(count[group] == 1)


def _keep_all_keys(inputs: Column, times: TimeTable) -> Bools:
    """Returns (C,): whether no key is left out because a later key has the same time.

    :raises ModelError: when times do not rise.
    """
    with_repeats = [
        row for row in sorted(set(inputs.tolist())) if times.read(row, f"/accessors/{row}").keys is not None
    ]
    return ~np.isin(inputs, with_repeats) if with_repeats else np.ones(len(inputs), bool)


def _clip_channels(
    columns: Columns, sizes: Column, plain: PlainFloats, times: TimeTable, joint_of: Ints
) -> Iterator[tuple[int, ClipChannels]]:
    """Yields the channels of whole animations, by the animation's index; neighbours share a table up to
    LARGEST_TABLE numbers.

    sizes    (C,) the numbers in each channel's keys
    """
    starts = np.flatnonzero(columns.animation != np.append(-1, columns.animation[:-1]))
    ends = np.append(starts[1:], len(sizes))
    table_number = np.add.reduceat(sizes, starts).cumsum() // LARGEST_TABLE
    for first, last in pairwise(np.flatnonzero(np.diff(table_number, prepend=-1, append=-1))):
        table_columns = columns.taken(slice(starts[first], ends[last - 1]))
        table = _channel_table(table_columns, plain, times, joint_of)
        for start, end in zip(starts[first:last], ends[first:last], strict=True):
            yield (
                int(columns.animation[start]),
                ClipChannels(table, int(start - starts[first]), int(end - starts[first])),
            )


def _channel_table(columns: Columns, plain: PlainFloats, times: TimeTable, joint_of: Ints) -> ChannelTable:
    """Returns the channels as a packed table."""
    rows, timing = np.unique(columns.input, return_inverse=True)
    return ChannelTable(
        joint=joint_of[columns.node],
        path=columns.path,
        interpolation=columns.interpolation,
        times=KeyTimes([times.read(row, f"/accessors/{row}").times for row in rows.tolist()]),
        timing=timing,
        numbers=plain.numbers[int(plain.buffer[columns.output[0]])],
        first=plain.first[columns.output],
    )
