"""Answers the messages that read a stage: short queries at the playhead, long queries on a copy that may seek
to the past.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.recorder import recorded
from statwalk.services.hosting.stage_replies import (
    ActorFacts,
    ActorPose,
    EffectsSince,
    StageSnapshot,
    StateHistory,
)
from statwalk.services.hosting.state_history import MOST_CHANGES, state_changes
from statwalk.services.publish.gltf_frames import whole
from statwalk.stage.explain.why import Why, why
from statwalk.stage.explain.whynot import WhyNot, whynot
from statwalk.stage.history.state_codec import to_bytes
from statwalk.stage.stage import Actor, Stage
from statwalk.stage.state.commands import Add


def actor_facts(actor: Actor) -> ActorFacts:
    """Returns the facts of an actor."""
    (x, y, z), heading = actor.root
    return ActorFacts(
        id=actor.id,
        name=actor.name,
        machine=actor.role.name,
        state=actor.state,
        states=tuple(actor.states),
        time=float(actor.time),
        position=(float(x), float(y), float(z)),
        heading=float(heading),
        hash=actor.hash,
    )


def _actors(stage: Stage, message: ask.DescribeActors) -> tuple[ActorFacts, ...]:
    actors = stage.actors if message.actor is None else [stage.actor(message.actor)]
    return tuple(actor_facts(actor) for actor in actors)


def _pose(stage: Stage, message: ask.PoseOf) -> ActorPose:
    actor = stage.actor(message.actor)
    position, heading = actor.root
    joints = tuple(actor.role.character.skeleton.names)
    return ActorPose(stage.tick, actor.state, joints, actor.pose, actor.world, position, float(heading))


def _effects(stage: Stage, message: ask.Effects) -> EffectsSince:
    actions = tuple(action for action in stage.actions if action.tick > message.since)
    return EffectsSince(
        stage.head, actions, tuple(verdict for verdict in stage.verdicts if verdict.tick > message.since)
    )


def _history(stage: Stage, _: ask.History) -> StateHistory:
    return StateHistory(stage.head, tuple(state_changes(stage)[-MOST_CHANGES:]))


def _log(stage: Stage, _: ask.Log) -> tuple[str, ...]:
    return tuple(stage.dump())


def _snapshot(stage: Stage, _: ask.Snapshot) -> StageSnapshot:
    return StageSnapshot(stage.tick, stage.hash, to_bytes(stage.state))


def _machines(stage: Stage, _: ask.Machines) -> tuple[str, ...]:
    return tuple(dict.fromkeys(role.name for role in stage.roles.values()))


def _frame_file(stage: Stage, message: ask.FrameFile) -> bytes:
    if message.tick is not None:
        stage.seek(message.tick)
    return whole(stage.frame)


def _recording(stage: Stage, message: ask.Recording) -> bytes:
    return recorded(stage, message.first, stage.tick if message.last is None else message.last)


def _why(stage: Stage, message: ask.Why) -> Why:
    _check_actor(stage, message.actor)
    return why(stage, message.actor, message.tick)


def _whynot(stage: Stage, message: ask.WhyNot) -> WhyNot:
    _check_actor(stage, message.actor)
    return whynot(stage, message.actor, message.event, message.tick)


def _check_actor(stage: Stage, actor: int) -> None:
    """Accepts a removed actor too: the log still has its arrival.

    :raises UnknownNameError: when the stage never had this actor.
    """
    if all(entry.actor != actor for entry in stage.log if isinstance(entry.command, Add)):
        stage.actor(actor)


Query = Callable[[Stage, Any], Any]
AT_PLAYHEAD: Mapping[type[ask.Message[Any]], Query] = {
    ask.DescribeActors: _actors,
    ask.PoseOf: _pose,
    ask.Effects: _effects,
    ask.History: _history,
    ask.Log: _log,
    ask.Snapshot: _snapshot,
    ask.Machines: _machines,
}
"""run while the host holds the lock: each query takes a few milliseconds"""
ON_A_COPY: Mapping[type[ask.Message[Any]], Query] = {
    ask.FrameFile: _frame_file,
    ask.Recording: _recording,
    ask.Why: _why,
    ask.WhyNot: _whynot,
}
"""run on a copy, while the stage keeps running"""
