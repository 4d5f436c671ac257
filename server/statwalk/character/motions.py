"""The motions of a machine's states on a character: clips in place, their root motion, blends of clips, and
layer masks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from statwalk.character.character import Character
from statwalk.character.ground_speed import STANDS, GroundSpeed, ground_speeds
from statwalk.errors import ContentError, MachineError, UnknownNameError
from statwalk.machine.compile.compile_machine import Machine
from statwalk.machine.compile.compile_states import MotionFacts, marks_of
from statwalk.machine.definition.expression_definition import WEIGHT, ExpressionMotion
from statwalk.machine.definition.machine_definition import (
    BlendDefinition,
    LayerDefinition,
    MachineDefinition,
    StateDefinition,
)
from statwalk.maths.arrays import Floats
from statwalk.maths.packed import PackedColumns, packed
from statwalk.motion.blend_space import BlendSpace, Motion, check_places
from statwalk.motion.clip import Clip
from statwalk.motion.layers import Mask, below
from statwalk.motion.root import STANDING, extract
from statwalk.motion.root_track import moving
from statwalk.motion.single import Single
from statwalk.motion.tables.build import tables_of
from statwalk.motion.tables.motion_tables import MOTIONS, MotionTables
from statwalk.rig.evaluate import world_from_local
from statwalk.skin.face_muscles import contractions_of

MUSCLES = "muscles"
"""in a mask: all muscles of the character's face"""


def motions_of(stock: Stock, machine: Machine, definition: MachineDefinition) -> tuple[Motion | None, ...]:
    """Returns (S,) the motion of each state, None for a layer's state without motion.

    :raises MachineError: when a blend is impossible, or a state of the base has no motion; with the line.
    """
    states = [state for table in definition.tables().values() for state in table.states.values()]
    return tuple(_motion(stock, machine, definition, row, state) for row, state in enumerate(states))


def _motion(
    stock: Stock, machine: Machine, definition: MachineDefinition, row: int, state: StateDefinition
) -> Motion | None:
    loop = bool(machine.loop[row])
    if not state.motion:
        if machine.layer_of[row] == 0:
            raise definition.refuse(
                f"the state {machine.states[row]} needs a motion: there is nothing below the base", state.line
            )
        return None
    if machine.layer_of[row] != 0 and state.ground_speed is not None:
        raise definition.refuse("ground_speed: the states of a layer move no actor", state.line)
    speeds = ground_speeds(stock.character, definition, state)
    if isinstance(state.motion, ExpressionMotion):
        return stock.at_rest
    if not isinstance(state.motion, BlendDefinition):
        return stock.single(state.motion, loop, speeds.get(state.motion, STANDS))
    blend = state.motion
    places, clips = np.array(list(blend.clips.values()), np.float64), stock.character.clips
    try:
        check_places(places, tuple(blend.clips))
    except ContentError as error:
        raise definition.refuse(str(error), blend.line) from None
    return BlendSpace(
        motions=tuple(stock.single(clip, loop, speeds.get(clip, STANDS)) for clip in blend.clips),
        places=places,
        columns=tuple(machine.axis(row, name) for name in blend.over),
        marks=(
            machine.markers[row],
            *(marks_of(clip, clip_facts(clips[clip]), blend) for clip in list(blend.clips)[1:]),
        ),
        loop=loop,
    )


def clip_facts(clip: Clip) -> MotionFacts:
    """Returns the facts about a clip that a machine needs."""
    return MotionFacts(clip.duration, clip.loop, clip.markers)


MotionKey = tuple[object, ...]
"""what the tables of a motion depend on"""


@dataclass(frozen=True, eq=False)
class Stock:
    """The clips of a character in place, each made once, and the tables of the latest motions."""

    character: Character
    root: int
    """the joint whose root motion is extracted, -1 none"""
    made: dict[tuple[str, bool, GroundSpeed], Single] = field(default_factory=dict)
    packed: dict[tuple[MotionKey, ...], PackedColumns[MotionTables]] = field(default_factory=dict)
    """at most one entry"""

    def tables(self, motions: Sequence[Motion | None]) -> PackedColumns[MotionTables]:
        """Returns the motions of all states as arrays for compiled code; cached while the motions stay the
        same.
        """
        keys = tuple(_key(motion) for motion in motions)
        tables = self.packed.get(keys)
        if tables is None:
            tables = packed(tables_of(motions, self.character.bind_pose), MOTIONS)
            self.packed.clear()
            self.packed[keys] = tables
        return tables

    @cached_property
    def at_rest(self) -> Single:
        """Returns the pose at rest as a motion, which expressions then change."""
        return Single(Clip("", (), 0.0, self.character.bind_pose), STANDING)

    def single(self, name: str, loop: bool, ground_speed: GroundSpeed) -> Single:
        """Returns a clip without its root motion, together with that root motion and what `ground_speed`,
        x and z (m/s), adds to it.
        """
        if (name, loop, ground_speed) not in self.made:
            clip = replace(self.character.clips[name], loop=loop)
            in_place, root = (
                (clip, STANDING)
                if self.root < 0
                else extract(clip, self.root, loop, frame_of(self.character, self.root))
            )
            in_place.tracks  # noqa: B018 - made now, so that no tick meets an error in the keys
            moved = moving(root, clip.duration, ground_speed) if any(ground_speed) else root
            self.made[name, loop, ground_speed] = Single(in_place, moved, ground_speed)
        return self.made[name, loop, ground_speed]


def _key(motion: Motion | None) -> MotionKey:
    if isinstance(motion, BlendSpace):
        return motion.motions, motion.places.tobytes(), motion.columns, motion.marks, motion.loop
    return (motion,)


def root_of(character: Character, root_joint: str | None) -> int:
    """Returns the row of the root joint, -1 if the machine names none.

    :raises MachineError: when the character has no joint of that name.
    """
    if root_joint is None:
        return -1
    try:
        return character.skeleton.index(root_joint)
    except UnknownNameError as error:
        raise MachineError(f"root: {error}") from None


def frame_of(character: Character, joint: int) -> Floats | None:
    """Returns (3, 4) float64: the transform of the joint's parent in the character's space; None for a joint
    without parent.
    """
    parent = int(character.skeleton.parent[joint])
    if parent < 0:
        return None
    frame: Floats = world_from_local(character.skeleton, character.bind_pose)[parent].astype(np.float64)
    return frame


def masks_of(character: Character, definition: MachineDefinition) -> tuple[Mask, ...]:
    """Returns (L,) what each layer moves; the base moves everything.

    :raises MachineError: when a mask names a joint that the character does not have; with line and nearest
        name.
    """
    everything = Mask(np.arange(len(character.skeleton)), np.arange(character.bind_pose.weights.shape[-1]))
    return (
        everything,
        *(_mask(character, definition, layer, everything) for layer in definition.layers.values()),
    )


def _mask(
    character: Character, definition: MachineDefinition, layer: LayerDefinition, everything: Mask
) -> Mask:
    if not layer.mask:
        return everything
    skeleton = character.skeleton
    weights = {
        column for name in layer.mask if name not in skeleton.names for column in _columns(character, name)
    }
    names = [name for name in layer.mask if name in skeleton.names or not _columns(character, name)]
    try:
        roots = [skeleton.index(name) for name in names]
    except UnknownNameError as error:
        raise definition.refuse(f"mask: {error}", layer.line) from None
    moved = below(character.skeleton.parent, roots)
    spans = [(part.weight_first, part.target_positions) for part in character.parts if moved[part.joint]]
    columns = {first + k for first, targets in spans if targets is not None for k in range(len(targets))}
    return Mask(np.flatnonzero(moved), np.array(sorted(columns | weights), np.int64))


def _columns(character: Character, name: str) -> tuple[int, ...]:
    """The columns of a pose's weights that a name in a mask stands for: `muscles`, or `TARGET.weight`."""
    if name == MUSCLES and character.muscles:
        rows = contractions_of(character.muscles, character.targets)
        return tuple(column for row in rows for column in row if column >= 0)
    target, dot, channel = name.rpartition(".")
    return character.targets.get(target, ()) if dot and channel == WEIGHT else ()
