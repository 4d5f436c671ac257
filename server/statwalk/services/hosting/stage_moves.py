"""The messages that move a stage through time, or set its clock."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.live_stage import LiveStage


def _step(live: LiveStage, message: ask.Step) -> Iterator[int]:
    return live.stepping(message.ticks)


def _step_to(live: LiveStage, message: ask.StepTo) -> Iterator[int]:
    return live.stepping_to(message.tick)


def _seek(live: LiveStage, message: ask.Seek) -> Iterator[int]:
    return live.seeking(message.tick)


def _pause(live: LiveStage, message: ask.Pause) -> None:
    live.pause(message.paused)


def _set_speed(live: LiveStage, message: ask.SetSpeed) -> None:
    live.set_speed(message.speed)


IN_SLICES: dict[type[ask.Message[Any]], Callable[[LiveStage, Any], Iterator[int]]] = {
    ask.Step: _step,
    ask.StepTo: _step_to,
    ask.Seek: _seek,
}
"""long work, in slices of a tick"""
OF_THE_CLOCK: dict[type[ask.Message[Any]], Callable[[LiveStage, Any], None]] = {
    ask.Pause: _pause,
    ask.SetSpeed: _set_speed,
}
