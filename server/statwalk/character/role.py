"""A role: a character and its machine, checked against each other once; nothing can fail after
`Role.build`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from statwalk.character.character import Character
from statwalk.character.colliders import Colliders
from statwalk.character.expressions import expressions_of
from statwalk.character.feet import Foot
from statwalk.character.foot_contacts import ClipContacts
from statwalk.character.joint_limits import check_handles, limits_of
from statwalk.character.made_clips import with_clips
from statwalk.character.motions import Stock, clip_facts, frame_of, masks_of, motions_of, root_of
from statwalk.character.packed_role import PackedRole
from statwalk.character.pose_tables import POSES, PoseTables, pose_tables
from statwalk.character.role_feet import check_feet, contacts_in, feet_in
from statwalk.character.solver_memory import SolverMemory
from statwalk.character.solvers import Solvers, solvers_of
from statwalk.errors import UnknownNameError
from statwalk.machine.compile.compile_machine import Machine, MotionFacts, build
from statwalk.machine.compile.program import PROGRAM
from statwalk.machine.compile.resolved_table import ResolvedTable, resolved_tables
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.machine.lint.findings import Finding
from statwalk.machine.model_checker.played import Play
from statwalk.machine.model_checker.work import Checkpoint
from statwalk.machine.verify import verify
from statwalk.maths.arrays import Bools, Floats
from statwalk.maths.clamp_table import CLAMP_TABLE, JointLimit
from statwalk.maths.packed import packed
from statwalk.motion.blend_space import BlendSpace, Motion
from statwalk.motion.layer_lanes import MASKS, LayerMasks
from statwalk.motion.layers import Mask
from statwalk.motion.tables.motion_tables import MotionTables
from statwalk.solve.chains import CHAINS
from statwalk.solve.expression_tables import ExpressionProgram
from statwalk.solve.foot_tables import FEET
from statwalk.solve.hanging import HANGING
from statwalk.solve.reach_tables import REACH


@dataclass(frozen=True, eq=False)
class Role:
    """The data that all actors of one role share. Immutable.

    resolved the table of each layer, with its defaults resolved
    motions  the motion of each state, in place if the machine names a root joint; None: no motion
    masks    what each layer moves
    root     the joint whose root motion moves the actor, -1 none
    stock    the clips in place and their tables, reused by the role after an edit
    """

    name: str
    character: Character
    machine: Machine
    definition: MachineDefinition
    resolved: tuple[ResolvedTable, ...]
    motions: tuple[Motion | None, ...]
    masks: tuple[Mask, ...]
    root: int
    stock: Stock

    def __repr__(self) -> str:
        size = f"{len(self.machine.states)} states, {len(self.machine.events)} events"
        return f"Role({self.name!r}, {size}, {self.character!r})"

    @classmethod
    def build(
        cls,
        name: str,
        character: Character,
        definition: MachineDefinition,
        root_joint: str | None = None,
        before: Role | None = None,
    ) -> Role:
        """Returns the role that `definition` describes; reuses the clips of the role `before` an edit if they
        are the same.

        :raises MachineError: when the definition names a clip or joint that the character does not have, or
            cannot be compiled.
        """
        if before is None or before.character is not character or before.definition.clips != definition.clips:
            character = with_clips(character, definition.clips, definition.refuse)
        facts = facts_of(character)
        resolved = resolved_tables(definition, facts)
        machine = build(definition, facts, resolved)
        root = root_of(character, root_joint)
        check_feet(character, definition)
        check_handles(character, definition)
        is_same = before is not None and before.character is character and before.root == root
        stock = before.stock if before is not None and is_same else Stock(character, root)
        motions = motions_of(stock, machine, definition)
        masks = masks_of(character, definition)
        role = cls(name, character, machine, definition, resolved, motions, masks, root, stock)
        # made now: an unknown joint is an error now and not in a tick
        role.colliders, role.solvers, role.expressions  # noqa: B018
        return role

    def verify(self, checkpoint: Checkpoint, play: Play) -> tuple[Finding, ...]:
        """Returns the verifier's findings about the definition.

        `checkpoint` ends the verification by raising; `play` plays counterexamples on a stage.
        """
        facts = facts_of(self.character)
        return tuple(verify(self.definition, facts, self.resolved, self.machine, checkpoint, play))

    @cached_property
    def tables(self) -> MotionTables:
        """Returns the motions of all states as arrays for compiled code."""
        return self.stock.tables(self.motions).values

    @cached_property
    def pose_tables(self) -> PoseTables:
        """Returns the layers' modes and weights, the frame of the root joint, and the joints of the
        colliders, as arrays.
        """
        joints = self.colliders.joints
        tables = self.expressions.tables
        return pose_tables(
            self.machine.layers, self.plays, self.root, self.root_frame, joints, self.solvers.springs, tables
        )

    @cached_property
    def expressions(self) -> ExpressionProgram:
        """Returns the expressions of the machine and of its states' motions, as the tick reads them."""
        return expressions_of(self.character, self.definition, self.machine)

    @cached_property
    def layer_masks(self) -> LayerMasks:
        """Returns the joints and weights that each layer moves, as arrays."""
        joints, weights = len(self.character.skeleton), self.character.bind_pose.weights.shape[-1]
        return LayerMasks.of(self.masks, joints, weights)

    @cached_property
    def packed(self) -> PackedRole:
        """Returns the arrays of the role as arguments of kernels."""
        program, motions = packed(self.machine.program, PROGRAM), self.stock.tables(self.motions)
        poses, masks = packed(self.pose_tables, POSES), packed(self.layer_masks, MASKS)
        legs, chains = packed(self.solvers.legs, FEET), packed(self.solvers.chains, CHAINS)
        clamps = packed(self.solvers.clamps, CLAMP_TABLE)
        reach = packed(self.solvers.reach, REACH)
        hanging = packed(self.solvers.hanging, HANGING)
        return PackedRole(program, motions, poses, masks, legs, chains, clamps, reach, hanging)

    @cached_property
    def limits(self) -> Mapping[int, JointLimit]:
        """Returns the limits of the character's joints: the machine's, else the character's."""
        return limits_of(self.character, self.definition)

    @cached_property
    def colliders(self) -> Colliders:
        """Returns the colliders of the role's actors."""
        return Colliders.of(self.machine, self.character, self.definition)

    @cached_property
    def feet(self) -> tuple[Foot, ...]:
        """Returns the feet, with the corrections of the machine file; found on first use."""
        return feet_in(self.character, self.definition)

    @cached_property
    def contacts(self) -> dict[str, ClipContacts]:
        """Returns the foot contacts of all clips, corrected by the machine file; found on first use."""
        return contacts_in(self.character, self.definition, self.feet)

    @cached_property
    def looks_at(self) -> frozenset[str]:
        """Returns the names of the colliders, its own and others', that its touches and its flock use."""
        flock = self.definition.flock
        touched = (name for touch in self.machine.touches for name in (touch.own, touch.other))
        return frozenset(touched) | frozenset(flock.avoid if flock else ())

    @cached_property
    def solvers(self) -> Solvers:
        """Returns what the solvers of the role read."""
        return solvers_of(self.character, self.machine, self.definition, self.motions)

    @property
    def solver_memory(self) -> SolverMemory:
        """Returns what the solvers of the role keep from tick to tick."""
        return self.solvers.memory

    @cached_property
    def measures(self) -> bool:
        """Returns whether a tick needs measurements of an actor: for conditions, or for values that states
        keep from their entry.
        """
        program = self.machine.program
        return bool((program.variable_kind >= 0).any() or len(program.entry_state))

    @cached_property
    def travels(self) -> bool:
        """Returns whether any motion of the base moves the root."""
        base = self.motions[: len(self.machine.rows(0))]
        return any(motion is not None and motion.travels for motion in base)

    @cached_property
    def blends(self) -> bool:
        """Returns whether any of its motions is a blend of clips."""
        return any(isinstance(motion, BlendSpace) for motion in self.motions)

    @cached_property
    def plays(self) -> Bools:
        """Returns (S,) whether a state has a motion."""
        return np.array([motion is not None for motion in self.motions])

    @cached_property
    def root_frame(self) -> Floats | None:
        """Returns (3, 4) the transform of the root joint's parent in the character's space; None without a
        root joint or parent.
        """
        return None if self.root < 0 else frame_of(self.character, self.root)

    def event(self, name: str) -> int:
        """Returns the column of an event that can be sent.

        :raises UnknownNameError: when the machine has no event of that name; the error lists the events.
        """
        names = self.machine.events[:-1]  # END is no input
        if name not in names:
            raise UnknownNameError("event", name, names)
        return names.index(name)

    def state(self, name: str) -> int:
        """Returns the row of a state of the base.

        :raises UnknownNameError: when the base has no state of that name; the error lists the states.
        """
        names = [self.machine.states[row] for row in self.machine.rows(0)]
        if name not in names:
            raise UnknownNameError("state", name, names)
        return names.index(name)


def facts_of(character: Character) -> dict[str, MotionFacts]:
    """Returns the facts about a character's clips that a machine needs, by name."""
    return {name: clip_facts(clip) for name, clip in character.clips.items()}
