"""Answers the messages that read a stage's past: at once, or in a worker if many ticks must be computed."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, TypeVar

from statwalk.machine.model_checker.work import Checkpoint
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.stage_queries import ON_A_COPY
from statwalk.services.hosting.stage_services import StageServices
from statwalk.services.library.catalogue import Catalogue
from statwalk.stage.excerpt import Excerpt, excerpt, stage_of, work_of
from statwalk.stage.stage import Stage

Reply = TypeVar("Reply")
LONG = 600
"""the most ticks of single actors that the server computes for one answer; a worker computes more"""


def answer_on_a_copy(
    stage: Stage, message: ask.Message[Reply], home: StageServices, token: CancelToken
) -> Reply:
    """Returns the reply to a message of ON_A_COPY; `stage` is a copy; `home.work` does what takes long.

    :raises CancelledError: when the token is cancelled before the work is done.
    """
    question: ask.Message[Any] = message
    if isinstance(message, ask.Recording) and message.last is None:
        question = replace(message, last=stage.tick)
    reply: Reply
    if part := _part_for_worker(stage, question, home.catalogue):
        about = min(role.name for role in part.roles.values())
        reply = home.work(about, answer_from, part, question, token=token)
    else:
        reply = _answer(stage, question, token.check)
    return reply


def answer_from(part: Excerpt, message: ask.Message[Reply], checkpoint: Checkpoint) -> Reply:
    """Returns the reply to a message about ticks of an excerpt: the job of a worker."""
    return _answer(stage_of(part), message, checkpoint)


def _answer(stage: Stage, message: ask.Message[Reply], checkpoint: Checkpoint) -> Reply:
    """Answers here; the checkpoint is called before each tick."""
    stage.before_tick = checkpoint
    reply: Reply = ON_A_COPY[type(message)](stage, message)
    return reply


def _part_for_worker(stage: Stage, message: ask.Message[Any], catalogue: Catalogue) -> Excerpt | None:
    """What a worker needs to answer; None: the server answers, for that is short or a machine was deleted."""
    span = _span(message)
    if span is None or work_of(stage, *span) <= LONG:
        return None
    part = excerpt(stage, *span)
    return part if all(map(catalogue.can_load, part.roles.values())) else None


def _span(message: ask.Message[Any]) -> tuple[int, int] | None:
    """The first and the last tick that a message reads; None: it reads more than ticks, or the playhead."""
    match message:
        case ask.Recording(first, int(last)) | ask.Joints(first, last) if first <= last:
            return first, last
        case ask.FrameFile(int(tick)):
            return tick, tick
        case ask.StickFigures(ticks=ticks) if ticks:
            return min(ticks), max(ticks)
    return None
