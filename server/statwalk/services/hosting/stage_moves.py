"""The messages that move a stage through time, set its clock, or give it a name."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.live_stage import LiveStage


def _step(live: LiveStage, message: ask.Step) -> Iterator[int]:
    live.note_change("stepped", message.by)
    return live.stepping(message.ticks)


def _step_to(live: LiveStage, message: ask.StepTo) -> Iterator[int]:
    live.note_change("stepped", message.by)
    return live.stepping_to(message.tick)


def _seek(live: LiveStage, message: ask.Seek) -> Iterator[int]:
    live.note_change("moved", message.by)
    return live.seeking(message.tick)


def _pause(live: LiveStage, message: ask.Pause) -> None:
    live.note_change("paused" if message.paused else "resumed", message.by)
    live.pause(message.paused)


def _set_speed(live: LiveStage, message: ask.SetSpeed) -> None:
    live.note_change("speed", message.by)
    live.set_speed(message.speed)


def _rename(live: LiveStage, message: ask.Rename) -> None:
    live.rename(message.name)


IN_SLICES: dict[type[ask.Message[Any]], Callable[[LiveStage, Any], Iterator[int]]] = {
    ask.Step: _step,
    ask.StepTo: _step_to,
    ask.Seek: _seek,
}
"""long work, in slices of a tick"""
AT_ONCE: dict[type[ask.Message[Any]], Callable[[LiveStage, Any], None]] = {
    ask.Pause: _pause,
    ask.SetSpeed: _set_speed,
    ask.Rename: _rename,
}
