"""Answers the messages that read a stage: at the playhead, or on a copy that may seek to the past."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Mapping
from functools import partial
from itertools import islice
from typing import Any, TypeVar

from statwalk.errors import StageError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.actor_facts import ActorColumns, columns_of, facts_in
from statwalk.services.hosting.joint_tracks import joint_tracks
from statwalk.services.hosting.live_stage import LiveStage
from statwalk.services.hosting.place_in_tree import place_of
from statwalk.services.hosting.recorder import recorded
from statwalk.services.hosting.stage_replies import (
    ActorFacts,
    ActorPose,
    EffectsSince,
    JointTracks,
    StageFacts,
    StageSnapshot,
    StateHistory,
)
from statwalk.services.hosting.state_history import MOST_CHANGES, oldest_facts, state_changes
from statwalk.services.hosting.stick_figures import stick_figures
from statwalk.services.publish.gltf_frames import whole
from statwalk.stage.explain.why import Why, why
from statwalk.stage.explain.whynot import WhyNot, whynot
from statwalk.stage.history.state_codec import to_bytes
from statwalk.stage.stage import Stage

Reply = TypeVar("Reply")
Item = TypeVar("Item")
Pieces = Generator[None, None, Reply]
"""work that yields every few milliseconds, and returns a reply"""
PIECE = 256
"""items that take one or two milliseconds together"""


def finished(work: Pieces[Reply], check: Callable[[], None]) -> Reply:
    """Runs the rest of a query, and returns its reply; `check` is called between pieces, and raises to cancel
    the query.
    """
    while True:
        check()
        try:
            next(work)
        except StopIteration as end:
            reply: Reply = end.value
            return reply


def _listed(items: Iterable[Item]) -> Pieces[tuple[Item, ...]]:
    """Makes items, a piece of them at a time."""
    made: list[Item] = []
    left = iter(items)
    while piece := tuple(islice(left, PIECE)):
        made.extend(piece)
        yield
    return tuple(made)


def _describe(live: LiveStage, _: ask.Describe) -> Pieces[StageFacts]:
    stage, columns = live.stage, columns_of(live.stage)
    facts = partial(
        StageFacts,
        live.id,
        live.clock_kind,
        stage.rate,
        stage.seed,
        stage.seconds,
        stage.hash,
        live.status(),
        place_of(live),
    )
    asleep = live.asleep
    yield
    return facts((yield from _by_id(columns)), asleep)


def _actors(live: LiveStage, message: ask.DescribeActors) -> Pieces[tuple[ActorFacts, ...]]:
    columns = columns_of(live.stage, None if message.actor is None else [message.actor])
    yield
    return (yield from _by_id(columns))


def _by_id(columns: list[ActorColumns]) -> Pieces[tuple[ActorFacts, ...]]:
    actors = yield from _listed(facts_in(columns))
    return tuple(sorted(actors, key=lambda actor: actor.id))


def _pose(live: LiveStage, message: ask.PoseOf) -> Pieces[ActorPose]:
    stage, actor = live.stage, live.stage.actor(message.actor)
    position, heading = actor.root
    joints = tuple(actor.role.character.skeleton.names)
    pose = ActorPose(stage.tick, actor.state, joints, actor.pose, actor.world, position, float(heading))
    yield
    return pose


def _effects(live: LiveStage, message: ask.Effects) -> Pieces[EffectsSince]:
    """:raises StageError: when the stage has forgotten some of them.

    :raises StorageError: when the disk refuses to keep how far the stage is.
    """
    stage, head, oldest = live.stage, live.stage.head, oldest_facts(live.stage)
    if message.since < oldest:
        raise StageError(f"the stage holds the actions and verdicts after tick {oldest}; ask since {oldest}")
    actions, verdicts = stage.actions.copy(), stage.verdicts.after(message.since)
    live.save()
    yield
    recent = tuple(action for action in actions if action.tick > message.since)
    effects = EffectsSince(head, recent, (yield from _listed(verdicts)))
    live.services.flush()
    return effects


def _log(live: LiveStage, _: ask.Log) -> Pieces[tuple[str, ...]]:
    lines = live.stage.dumping()
    yield
    return (yield from _listed(lines))


def _snapshot(live: LiveStage, _: ask.Snapshot) -> Pieces[StageSnapshot]:
    stage = live.stage
    snapshot = StageSnapshot(stage.tick, stage.hash, to_bytes(stage.state))
    yield
    return snapshot


def _machines(live: LiveStage, _: ask.Machines) -> Pieces[tuple[str, ...]]:
    names = tuple(dict.fromkeys(role.name for role in live.stage.roles.values()))
    yield
    return names


def _history(stage: Stage, _: ask.History) -> StateHistory:
    return StateHistory(stage.head, tuple(state_changes(stage)[-MOST_CHANGES:]))


def _frame_file(stage: Stage, message: ask.FrameFile) -> bytes:
    if message.tick is not None:
        stage.seek(message.tick)
    return whole(stage.frame, message.skinning)


def _stick_figures(stage: Stage, message: ask.StickFigures) -> str:
    return stick_figures(stage, message.actor, message.ticks or (stage.tick,), message.side)


def _recording(stage: Stage, message: ask.Recording) -> bytes:
    assert message.last is not None  # `answer_on_a_copy` put the playhead there
    return recorded(stage, message.first, message.last, message.camera)


def _joints(stage: Stage, message: ask.Joints) -> JointTracks:
    return JointTracks(tuple(joint_tracks(stage, message.first, message.last)))


def _why(stage: Stage, message: ask.Why) -> Why:
    _check_actor(stage, message.actor)
    return why(stage, message.actor, message.tick)


def _whynot(stage: Stage, message: ask.WhyNot) -> WhyNot:
    _check_actor(stage, message.actor)
    return whynot(stage, message.actor, message.event, message.tick)


def _check_actor(stage: Stage, actor: int) -> None:
    """Accepts a removed actor too.

    :raises UnknownNameError: when the stage never had this actor, or has forgotten it.
    """
    if actor not in stage.arrivals():
        stage.actor(actor)


AT_PLAYHEAD: Mapping[type[ask.Message[Any]], Callable[[LiveStage, Any], Pieces[Any]]] = {
    ask.Describe: _describe,
    ask.DescribeActors: _actors,
    ask.PoseOf: _pose,
    ask.Effects: _effects,
    ask.Log: _log,
    ask.Snapshot: _snapshot,
    ask.Machines: _machines,
}
"""while the host holds the lock, a query takes from the live stage what no tick changes, up to its first
`yield`; then it makes the reply, in pieces of a few milliseconds
"""
ON_A_COPY: Mapping[type[ask.Message[Any]], Callable[[Stage, Any], Any]] = {
    ask.History: _history,
    ask.FrameFile: _frame_file,
    ask.Recording: _recording,
    ask.StickFigures: _stick_figures,
    ask.Joints: _joints,
    ask.Why: _why,
    ask.WhyNot: _whynot,
}
"""run on a copy, while the stage keeps running"""
