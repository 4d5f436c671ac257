"""A part of a stage's past, which can be sent to another process: the states of its ticks follow from it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from statwalk.character.role import Role
from statwalk.stage.history.log import MemoryLog
from statwalk.stage.history.log_codec import Beginning
from statwalk.stage.history.state_codec import from_bytes, to_bytes
from statwalk.stage.stage import Stage
from statwalk.stage.state.commands import Add, Edit, LogEntry


class Excerpt(NamedTuple):
    """What leads to some ticks of a stage, the newest of them `last`: an earlier state, and the commands
    since.
    """

    seed: int
    rate: int
    last: int
    state: bytes
    entries: tuple[LogEntry, ...]
    roles: Mapping[str, Role]
    """the roles that play, by their keys in the log"""


def work_of(stage: Stage, first: int, last: int) -> int:
    """Returns how many ticks of single actors must be computed for the ticks `first` to `last` of a stage;
    an actor that is added on the way counts from the start.

    :raises StageError: when the stage does not have the ticks.
    """
    stage.check(first)
    stage.check(last)
    start = stage.state_before(first)
    added = sum(isinstance(entry.command, Add) for entry in stage.entries(start.tick + 1, last))
    return (last - start.tick) * (len(start.ids) + added)


def excerpt(stage: Stage, first: int, last: int) -> Excerpt:
    """Returns what leads to the ticks `first` to `last` of a stage, which the stage must have."""
    start = stage.state_before(first)
    entries = tuple(stage.entries(start.tick + 1, last))
    keys = {*start.casts, *start.versions.values()}
    keys |= {entry.command.role for entry in entries if isinstance(entry.command, Add | Edit)}
    keys |= {stage.roles[key].name for key in keys}
    roles = {key: stage.roles[key] for key in stage.roles if key in keys}
    return Excerpt(stage.seed, stage.rate, last, to_bytes(start), entries, roles)


def stage_of(part: Excerpt) -> Stage:
    """Returns a stage that has the ticks of an excerpt, and no other tick after them; its playhead is at the
    state from which the excerpt starts.
    """
    start = from_bytes(part.state, part.roles)
    log, beginning = MemoryLog(part.entries), Beginning(part.state, {}, 0)
    stage = Stage.of(log, part.roles, start, part.seed, part.rate, beginning)
    stage.head = part.last
    return stage
