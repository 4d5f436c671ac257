"""A role: a character and the machine that plays it, cross-checked once; after `Role.build` nothing can fail."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from statwalk.character import Character
from statwalk.errors import UnknownNameError
from statwalk.machine.authored.definition import MachineDefinition
from statwalk.machine.built.build import Machine, MotionFacts, build
from statwalk.maths.arrays import Bools, Floats
from statwalk.motion.blendspace import BlendSpace, Motion
from statwalk.motion.layering import Mask
from statwalk.stage.meeting.colliders import Colliders
from statwalk.stage.moving.motions import frame_of, masks_of, motions_of, root_of


@dataclass(frozen=True, eq=False)
class Role:
    """What actors of one kind share. Immutable.

    motions  for each state what it plays, in place where the machine names a root joint; None: nothing
    masks    for each layer what it moves
    root     the joint whose way moves the actor, -1 none
    """

    name: str
    character: Character
    machine: Machine
    definition: MachineDefinition
    motions: tuple[Motion | None, ...]
    masks: tuple[Mask, ...]
    root: int

    @classmethod
    def build(cls, name: str, character: Character, definition: MachineDefinition, root_joint: str | None = None) -> Role:
        """The role that `definition` describes; raises MachineError where it names a clip or joint that the character has not."""
        facts = {key: MotionFacts(clip.duration, clip.loop, clip.markers) for key, clip in character.clips.items()}
        machine = build(definition, facts)
        root = root_of(character, root_joint)
        motions = motions_of(character, machine, definition, root)
        role = cls(name, character, machine, definition, motions, masks_of(character, definition), root)
        role.colliders  # noqa: B018 - worked out now, so that a joint that is not there is said now and not in a tick
        return role

    @cached_property
    def colliders(self) -> Colliders:
        """What of its actors can be touched."""
        return Colliders.of(self.machine, self.character, self.definition)

    @cached_property
    def travels(self) -> bool:
        """Whether any motion of the base moves the root."""
        return any(motion is not None and motion.travels for motion in self.motions[: len(self.machine.rows(0))])

    @cached_property
    def blends(self) -> bool:
        """Whether any of its motions is a blend of clips."""
        return any(isinstance(motion, BlendSpace) for motion in self.motions)

    @cached_property
    def plays(self) -> Bools:
        """(S,) whether a state has a motion."""
        return np.array([motion is not None for motion in self.motions])

    @cached_property
    def moved(self) -> Bools:
        """(L, D) which numbers of an offset of `motion.inertialize` belong to each layer."""
        joints, weights = len(self.character.skeleton), self.character.bind_pose.weights.shape[-1]
        return np.stack([mask.offsets(joints, weights) for mask in self.masks])

    @cached_property
    def root_frame(self) -> Floats | None:
        """(3, 4) where the parent of the root joint stands in the character's space; None where there is none."""
        return None if self.root < 0 else frame_of(self.character, self.root)

    def event(self, name: str) -> int:
        """The column of an event that can be sent; raises UnknownNameError, which lists them."""
        known = self.machine.events[:-1]  # END is no input
        if name not in known:
            raise UnknownNameError("event", name, known)
        return known.index(name)

    def state(self, name: str) -> int:
        """The row of a state of the base; raises UnknownNameError, which lists them."""
        known = [self.machine.states[row] for row in self.machine.rows(0)]
        if name not in known:
            raise UnknownNameError("state", name, known)
        return known.index(name)

    def parameter(self, name: str) -> int:
        """The index of a parameter; raises UnknownNameError."""
        known = [parameter.name for parameter in self.machine.parameters]
        if name not in known:
            raise UnknownNameError("parameter", name, known)
        return known.index(name)
