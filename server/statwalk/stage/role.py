"""A role: a character and the machine that plays it, cross-checked once; after `Role.build` nothing can fail."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from statwalk.character import Character
from statwalk.errors import MachineError, UnknownNameError
from statwalk.machine.build import Machine, MotionFacts, build
from statwalk.machine.definition import MachineDefinition
from statwalk.motion.clip import Clip
from statwalk.motion.root import STANDING, RootTrack, extract
from statwalk.rig.evaluate import world_from_local
from statwalk.stage.colliders import Colliders


@dataclass(frozen=True, eq=False)
class Role:
    """What actors of one kind share. Immutable.

    clips   for each state, in place where the machine names a root joint
    roots   for each state, the way its motion goes
    """

    name: str
    character: Character
    machine: Machine
    definition: MachineDefinition
    clips: tuple[Clip, ...]
    roots: tuple[RootTrack, ...]

    @classmethod
    def build(cls, name: str, character: Character, definition: MachineDefinition, root_joint: str | None = None) -> Role:
        """The role that `definition` describes; raises MachineError where it names a clip or joint that the character has not."""
        motions = {key: MotionFacts(clip.duration, clip.loop, clip.markers) for key, clip in character.clips.items()}
        machine = build(definition, motions)
        joint = _root(character, root_joint)
        rooted = [_rooted(character, machine, state, joint) for state in range(len(machine.states))]
        role = cls(name, character, machine, definition, tuple(clip for clip, _ in rooted), tuple(root for _, root in rooted))
        role.colliders  # noqa: B018 - worked out now, so that a joint that is not there is said now and not in a tick
        return role

    @cached_property
    def colliders(self) -> Colliders:
        """What of its actors can be touched."""
        return Colliders.of(self.machine, self.character, self.definition)

    @cached_property
    def travels(self) -> bool:
        """Whether any of its motions moves the root."""
        return any(len(root.times) > 1 for root in self.roots)

    def event(self, name: str) -> int:
        """The column of an event that can be sent; raises UnknownNameError, which lists them."""
        known = self.machine.events[:-1]  # END is no input
        if name not in known:
            raise UnknownNameError("event", name, known)
        return known.index(name)

    def parameter(self, name: str) -> int:
        """The index of a parameter; raises UnknownNameError."""
        known = [parameter.name for parameter in self.machine.parameters]
        if name not in known:
            raise UnknownNameError("parameter", name, known)
        return known.index(name)


def _root(character: Character, root_joint: str | None) -> int | None:
    if root_joint is None:
        return None
    try:
        return character.skeleton.index(root_joint)
    except UnknownNameError as error:
        raise MachineError(f"root: {error}") from None


def _rooted(character: Character, machine: Machine, state: int, joint: int | None) -> tuple[Clip, RootTrack]:
    """A state's clip without its root motion, and that motion."""
    clip = replace(character.clips[machine.motions[machine.motion[state]]], loop=bool(machine.loop[state]))
    if joint is None:
        return _packed(clip), STANDING
    parent = int(character.skeleton.parent[joint])
    frame = None if parent < 0 else world_from_local(character.skeleton, character.bind_pose)[parent].astype(np.float64)
    in_place, root = extract(clip, joint, clip.loop, frame)
    return _packed(in_place), root


def _packed(clip: Clip) -> Clip:
    """The clip with its tracks made, so that what is wrong with its keys is said now and not in a tick."""
    clip.sample(0.0)
    return clip
