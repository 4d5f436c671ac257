"""The effects of a tick. Effects are returned, and are not part of the state of a stage."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from statwalk.machine.runtime.result import Changes
from statwalk.stage.state.frame import Action, Verdict


@dataclass(frozen=True, eq=False)
class Effects:
    """The effects of one tick, each kind in the order in which they came about."""

    actions: tuple[Action, ...] = ()
    verdicts: Sequence[Verdict] = ()
    changes: Mapping[str, Changes] = field(default_factory=dict)
    """changes of state by role key; `actor` holds ids"""
