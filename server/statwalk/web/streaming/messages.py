"""The text messages of the stream, server to viewer, as JSON bytes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import orjson

from statwalk.stage.frame import Action, CastFrame, Verdict
from statwalk.web.streaming.mailbox import FrameKind, Layout

VERSION = "statwalk.v1"
ActorName = Callable[[int], str]


def describe_cast(cast: CastFrame, character: str, version: int, actor_name: ActorName) -> dict[str, Any]:
    """The hello's part about one cast: joints, states and events by name, and who is in it; `version` of its machine on this stage."""
    role, machine = cast.role, cast.role.machine
    skeleton = role.character.skeleton
    return {
        "role": role.name,
        "character": character,
        "model": f"/api/characters/{character}/model.glb",
        "machine": role.name,
        "joints": len(skeleton.names),
        "weights": int(cast.pose.weights.shape[-1]),
        "names": list(skeleton.names),
        "nodes": [int(node) for node in role.character.node_index],
        "parents": [int(parent) for parent in skeleton.parent],
        "version": version,
        "layers": [layer.name for layer in machine.layers],
        "states": list(machine.states),
        "state_layers": [int(layer) for layer in machine.layer_of],
        "events": list(machine.events),
        "colliders": [
            {
                "name": one.name,
                "kind": one.kind,
                "joint": skeleton.index(one.joint) if one.joint else -1,
                "center": list(one.center),
                "radius": one.radius,
                "normal": list(one.normal),
            }
            for one in machine.colliders
        ],
        "actors": [{"id": int(actor), "name": actor_name(int(actor))} for actor in cast.ids],
    }


def hello(stage: dict[str, Any], layout: Layout, frames: FrameKind) -> bytes:
    """What a viewer must know before the first frame of a layout; `stage` as in `status`, with id, rate and clock."""
    return orjson.dumps(
        {"type": "hello", "version": VERSION, "epoch": layout.epoch, "frames": frames, **stage, "casts": list(layout.casts)}
    )


def status(stage: dict[str, Any]) -> bytes:
    """Where the stage is; on change and once a second."""
    return orjson.dumps({"type": "status", **stage})


def action(done: Action) -> bytes:
    """An action that a cell brought out."""
    return orjson.dumps({"type": "action", **done._asdict()})


def verdict(given: Verdict) -> bytes:
    """What became of an event, and why."""
    members = given._asdict()
    members["from"], members["to"] = members.pop("from_state"), members.pop("to_state")
    members["values"] = dict(given.values)
    return orjson.dumps({"type": "verdict", **members})


def reply(kind: str, **members: Any) -> bytes:
    """An answer to one viewer's message."""
    return orjson.dumps(members | {"type": kind})
