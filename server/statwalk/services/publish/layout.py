"""Describes a frame for viewers: the joints, states and events that its numbers mean, and the actors of its
rows.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from statwalk.character.role import Role
from statwalk.skin.skinning import Skinning
from statwalk.stage.state.frame import CastFrame

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class ColliderLayout:
    """A collider of a machine in metres, in the space of joint number `joint` (-1: the root's)."""

    name: str
    kind: str
    joint: int
    center: Vector
    radius: float
    normal: Vector


@dataclass(frozen=True)
class NamedActor:
    """An actor of a cast."""

    id: int
    name: str


@dataclass(frozen=True)
class CastLayout:
    """A cast: `character` is the catalogue's name, `version` counts the versions of machines on
    this stage, `joints` and `weights` are numbers of joints and morph weights, `state_layers`
    holds the layer of each state.
    """

    role: str
    character: str
    version: int
    joints: int
    weights: int
    names: tuple[str, ...]
    nodes: tuple[int, ...]
    parents: tuple[int, ...]
    layers: tuple[str, ...]
    states: tuple[str, ...]
    state_layers: tuple[int, ...]
    events: tuple[str, ...]
    colliders: tuple[ColliderLayout, ...]
    actors: tuple[NamedActor, ...]
    skinning: Skinning
    muscle_bones: tuple[int, ...] = ()


@dataclass(frozen=True)
class FrameLayout:
    """The layout of a frame; `epoch` numbers the layouts of a stage."""

    epoch: int
    casts: tuple[CastLayout, ...]


def cast_layout(
    cast: CastFrame, character: str, version: int, actor_name: Callable[[int], str]
) -> CastLayout:
    """Returns the layout of one cast of a frame."""
    role, machine = cast.role, cast.role.machine
    skeleton = role.character.skeleton
    return CastLayout(
        role=role.name,
        character=character,
        version=version,
        joints=len(skeleton.names),
        weights=int(cast.pose.weights.shape[-1]),
        names=tuple(skeleton.names),
        nodes=tuple(int(node) for node in role.character.node_index),
        parents=tuple(int(parent) for parent in skeleton.parent),
        layers=tuple(layer.name for layer in machine.layers),
        states=tuple(machine.states),
        state_layers=tuple(int(layer) for layer in machine.layer_of),
        events=tuple(machine.events),
        colliders=_collider_layouts(role),
        actors=tuple(NamedActor(int(actor), actor_name(int(actor))) for actor in cast.ids),
        skinning=role.character.skinning,
        muscle_bones=tuple(sorted(skeleton.index(name) for name in skeleton.muscle_bones)),
    )


def _collider_layouts(role: Role) -> tuple[ColliderLayout, ...]:
    skeleton = role.character.skeleton
    return tuple(
        ColliderLayout(
            name=collider.name,
            kind=collider.kind,
            joint=skeleton.index(collider.joint) if collider.joint else -1,
            center=collider.center,
            radius=collider.radius,
            normal=collider.normal,
        )
        for collider in role.machine.colliders
    )
