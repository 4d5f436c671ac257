"""What the states of a machine play on a character: clips in place, the way they go, blends of them, and what a layer moves."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from statwalk.character import Character
from statwalk.errors import ContentError, MachineError, UnknownNameError
from statwalk.machine.authored.definition import BlendDefinition, LayerDefinition, MachineDefinition, StateDefinition
from statwalk.machine.built.build import Machine
from statwalk.maths.arrays import Floats
from statwalk.maths.phases import Marks
from statwalk.motion.blendspace import BlendSpace, Motion, check_places
from statwalk.motion.clip import Clip
from statwalk.motion.layering import Mask, below
from statwalk.motion.root import STANDING, extract
from statwalk.motion.single import Single
from statwalk.rig.evaluate import world_from_local


def motions_of(character: Character, machine: Machine, definition: MachineDefinition, root: int) -> tuple[Motion | None, ...]:
    """(S,) the motion of each state, None where a layer's state has none; `root` is the joint whose way is taken out, -1 none.

    Raises MachineError with the line of a blend that cannot be.
    """
    states = [state for table in definition.tables().values() for state in table.states.values()]
    stock = Stock(character, root)
    return tuple(_motion(stock, machine, definition, row, state) for row, state in enumerate(states))


def _motion(stock: Stock, machine: Machine, definition: MachineDefinition, row: int, state: StateDefinition) -> Motion | None:
    loop = bool(machine.loop[row])
    if not state.motion:
        if machine.layer_of[row] == 0:
            raise definition.refuse(f"the state {machine.states[row]} needs a motion: there is nothing below the base", state.line)
        return None
    if not isinstance(state.motion, BlendDefinition):
        return stock.single(state.motion, loop)
    blend = state.motion
    places = np.array(list(blend.clips.values()), np.float64)
    try:
        check_places(places, tuple(blend.clips))
    except ContentError as error:
        raise definition.refuse(str(error), blend.line) from None
    parameters = [one.name for one in machine.parameters]
    return BlendSpace(
        motions=tuple(stock.single(clip, loop) for clip in blend.clips),
        places=places,
        columns=tuple(parameters.index(name) for name in blend.over),
        marks=(machine.markers[row], *(marks_of(stock.character.clips[clip], blend) for clip in list(blend.clips)[1:])),
        loop=loop,
    )


def marks_of(clip: Clip, blend: BlendDefinition) -> Marks:
    """Name and phase of each marker of a clip in a blend: those that the blend gives it, and its own."""
    given = blend.markers.get(clip.name, {})
    own = [(name, time / clip.duration) for name, time in clip.markers if name not in given and clip.duration > 0]
    return (*given.items(), *own)


@dataclass(frozen=True, eq=False)
class Stock:
    """The clips of a character in place, each made once."""

    character: Character
    root: int
    """the joint whose way is taken out, -1 none"""
    made: dict[tuple[str, bool], Single] = field(default_factory=dict)

    def single(self, name: str, loop: bool) -> Single:
        """A clip without its root motion, and that motion; the tracks are made now, so that a tick finds nothing wrong with the keys."""
        if (name, loop) not in self.made:
            clip = replace(self.character.clips[name], loop=loop)
            in_place, root = (clip, STANDING) if self.root < 0 else extract(clip, self.root, loop, frame_of(self.character, self.root))
            in_place.sample(0.0)
            self.made[name, loop] = Single(in_place, root)
        return self.made[name, loop]


def root_of(character: Character, root_joint: str | None) -> int:
    """The row of the root joint, -1 where the machine names none; raises MachineError."""
    if root_joint is None:
        return -1
    try:
        return character.skeleton.index(root_joint)
    except UnknownNameError as error:
        raise MachineError(f"root: {error}") from None


def frame_of(character: Character, joint: int) -> Floats | None:
    """(3, 4) float64: where the joint's parent stands in the character's space; None where it has none."""
    parent = int(character.skeleton.parent[joint])
    if parent < 0:
        return None
    frame: Floats = world_from_local(character.skeleton, character.bind_pose)[parent].astype(np.float64)
    return frame


def masks_of(character: Character, definition: MachineDefinition) -> tuple[Mask, ...]:
    """(L,) what each layer moves, the base everything; raises MachineError with line and nearest name for a joint that is not there."""
    everything = Mask(np.arange(len(character.skeleton)), np.arange(character.bind_pose.weights.shape[-1]))
    return (everything, *(_mask(character, definition, layer, everything) for layer in definition.layers.values()))


def _mask(character: Character, definition: MachineDefinition, layer: LayerDefinition, everything: Mask) -> Mask:
    if not layer.mask:
        return everything
    try:
        roots = [character.skeleton.index(name) for name in layer.mask]
    except UnknownNameError as error:
        raise definition.refuse(f"mask: {error}", layer.line) from None
    moved = below(character.skeleton.parent, roots)
    spans = [(part.weight_first, part.target_positions) for part in character.parts if moved[part.joint]]
    columns = {first + k for first, targets in spans if targets is not None for k in range(len(targets))}
    return Mask(np.flatnonzero(moved), np.array(sorted(columns), np.int64))
