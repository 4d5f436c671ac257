"""Trials: actors of one role that are put into a state at a phase, get an event, and perhaps a second one,
and are recorded side by side as one cast.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from statwalk.character.role import Role
from statwalk.machine.model_checker.work import Checkpoint, go_on
from statwalk.machine.runtime.result import Changes
from statwalk.machine.runtime.state import MachineState, fresh
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.maths.simd.pose_layout import JOINT_CHANNELS, ROTATION_CHANNEL, SCALE_CHANNEL
from statwalk.rig.evaluate import world_from_local
from statwalk.stage.advance import advance
from statwalk.stage.effects.effects import Effects
from statwalk.stage.measure.measured_ground import Spot, mean_heights
from statwalk.stage.state.cast import Cast, CastState
from statwalk.stage.state.commands import Press
from statwalk.stage.state.stage_state import StageState
from statwalk.stage.steps.enter import enter
from statwalk.stage.steps.sample import poses_ahead
from statwalk.stage.steps.stand import stand

RATE = 60
WARM_UP = 12
"""ticks before the event, for what a tick remembers of the ticks before it; less where a motion begins"""
LEAST = 2
"""ticks before the event at least: they give the pose its velocity"""
NEVER = -1


class CellTrial(NamedTuple):
    """An actor in a state of the machine at a phase, and the events that it gets."""

    state: int
    phase: float
    """0…1 of the state's motion when the event comes"""
    event: int = NEVER
    """column of the table; NEVER: none, the motion goes on"""
    second_tick: int = NEVER
    """ticks after the first event"""
    second: int = NEVER
    place: Spot = Spot()
    """where it begins"""


@dataclass(frozen=True, eq=False)
class Recording:
    """What T ticks of N trials showed."""

    role: Role
    sent: Ints
    """(N,) the last tick before the event counts"""
    state: Ints
    """(T, N, L)"""
    event: Ints
    """(T, N, L) the event whose cell changed the state or restarted it in a tick, NEVER none"""
    position: Floats
    """(T, N, 3)"""
    heading: Floats
    """(T, N)"""
    left: Floats
    """(T, N) the share of the transition that is left, 1…0"""
    world: Floats
    """(T, N, J, 3, 4) float32: the joints in the actor's space"""
    target: Floats
    """(T, N, J, 3) float32: where the joints would be in the new motion alone, in the actor's space"""
    low: Floats
    """(T, N) the height of the lowest sole in the new motion alone, in the actor's space; infinite without
    feet
    """

    def take(self, rows: Ints) -> Recording:
        """Returns the recording of some trials."""
        of_ticks = {
            name: getattr(self, name)[:, rows]
            for name in ("state", "event", "position", "heading", "left", "world", "target", "low")
        }
        return replace(self, sent=self.sent[rows], **of_ticks)

    @cached_property
    def joints(self) -> Floats:
        """Returns where the joints are on the stage, (T, N, J, 3)."""
        return placed(self.world[..., 3].astype(np.float64), self.position, self.heading)


def placed(points: Floats, position: Floats, heading: Floats) -> Floats:
    """Returns points (…, K, 3) of actors on the stage; position (…, 3), heading (…,)."""
    sine, cosine = np.sin(heading)[..., None], np.cos(heading)[..., None]
    x, z = points[..., 0], points[..., 2]
    turned = np.stack([x * cosine + z * sine, points[..., 1], z * cosine - x * sine], -1)
    return turned + position[..., None, :]


def record(role: Role, trials: Sequence[CellTrial], ticks: int, checkpoint: Checkpoint = go_on) -> Recording:
    """Plays trials side by side for `ticks` ticks at 60 Hz; calls `checkpoint` before each."""
    start, sent = _beginnings(role, trials)
    state = StageState(
        casts={role.name: _cast(role, trials, start)},
        next_id=len(trials) + 1,
        names={number: str(number) for number in range(1, len(trials) + 1)},
        versions={role.name: role.name},
    )
    due = _commands(role, trials, sent)
    roles, shots = {role.name: role}, [_shot(role, state, Effects())]
    for tick in range(1, ticks):
        checkpoint()
        state, effects = advance(roles, state, due.get(tick - 1, []), 1 / RATE, 0)
        shots.append(_shot(role, state, effects))
    rows, targets, *shown = (np.stack(column) for column in zip(*shots, strict=True))
    machine, event, position, heading, left = shown
    world, target = world_of(role, rows), world_of(role, targets)
    joints = target[..., 3].copy()
    return Recording(
        role, sent, machine, event, position, heading, left, world, joints, _lowest(role, target)
    )


def _lowest(role: Role, world: Floats) -> Floats:
    """(T, N) the height of the lowest sole of joints (T, N, J, 3, 4)."""
    heights = [foot.skin.heights(world).min(-1) for foot in role.feet]
    lowest: Floats = np.min([np.full(world.shape[:2], np.inf), *heights], 0)
    return lowest


def _beginnings(role: Role, trials: Sequence[CellTrial]) -> tuple[Floats, Ints]:
    """For each trial the seconds into its motion at which it is put on the stage, and the tick of its
    event.
    """
    machine = role.machine
    states = np.array([trial.state for trial in trials])
    duration = np.where(np.isfinite(machine.duration), machine.duration, 0)[states]
    at = np.array([trial.phase for trial in trials]) * duration
    ticks = np.where(machine.loop[states], WARM_UP, np.clip(np.floor(at * RATE), LEAST, WARM_UP))
    start = np.maximum(at - ticks / RATE, np.where(machine.loop[states], -np.inf, 0))
    laps = np.where(duration > 0, duration, 1)
    return np.where(machine.loop[states], np.mod(start, laps), start), ticks.astype(np.int64)


def _commands(role: Role, trials: Sequence[CellTrial], sent: Ints) -> dict[int, list[Press]]:
    """The inputs by the tick before they count; END is no input."""
    due: dict[int, list[Press]] = {}
    events = role.machine.events
    for number, trial in enumerate(trials):
        planned = ((trial.event, 0), (trial.second, trial.second_tick))
        for event, later in planned:
            if event not in (NEVER, role.machine.end):
                due.setdefault(int(sent[number]) + later, []).append(Press(number + 1, events[event]))
    return due


def machines_at(role: Role, states: Ints, times: Floats) -> MachineState:
    """Returns N machines in `states` (N,), `times` (N,) seconds into their motions; other layers as they
    begin.
    """
    machine = fresh(role.machine.program, len(states))
    layer, rows = role.machine.layer_of[states], np.arange(len(states))
    machine.state[rows, layer], machine.time[rows, layer] = states, times
    machine.passed[rows, layer] = times
    return machine


def _cast(role: Role, trials: Sequence[CellTrial], start: Floats) -> CastState:
    """The actors where they begin: in the pose of their motion, which moves as the motion moves."""
    places = [trial.place for trial in trials]
    height = mean_heights(role.definition.ground, places, float(role.solvers.legs.unit[0]))
    x, z, heading = np.array(places).T
    cast = enter(role, range(1, len(trials) + 1), np.stack([x, height, z], -1), heading)
    states = np.array([trial.state for trial in trials])
    before = np.maximum(start - 1 / RATE, 0)
    shown, previous = (poses_ahead(role, machines_at(role, states, times)) for times in (start, before))
    delta = np.stack([_way(role, *trip) for trip in zip(states, before, start, strict=True)])
    machine = machines_at(role, states, start)
    kept = role.solver_memory.fresh(len(trials))
    cast = replace(
        cast, machine=machine, shown=shown, previous=previous, root_delta=delta, solver_memory=kept
    )
    cast.position[:, 1] = height  # `enter` has moved them for the feet of another motion
    begins = (states == role.machine.initial) | (role.machine.layer_of[states] > 0)
    if begins.all():  # the legs play the motion in which new actors stand
        stand(Cast.of(role, cast))
    return cast


def _way(role: Role, state: int, start: float, end: float) -> Floats:
    """The root motion (3,) of a state's motion between two times of one lap."""
    motion = role.motions[state]
    if motion is None or role.machine.layer_of[state]:
        return np.zeros(3)
    times, axes = (np.array([start]), np.array([end])), fresh(role.machine.program, 1).smoothed
    delta: Floats = motion.way(*times, np.zeros(1, np.int64), axes)[0]
    return delta


def _shot(role: Role, state: StageState, effects: Effects) -> tuple[Any, ...]:
    """Copies of what the stage shows."""
    cast = state.casts[role.name]
    target = poses_ahead(role, cast.machine)
    machine = cast.machine.state.copy(), _events(cast, effects.changes.get(role.name))
    return cast.shown.rows(), target.rows(), *machine, cast.position.copy(), cast.heading.copy(), _left(cast)


def _events(cast: CastState, changes: Changes | None) -> Ints:
    """(N, L) the event of the last change of each layer in a tick."""
    events = np.full(cast.machine.state.shape, NEVER)
    if changes is not None and len(changes.actor):
        events[cast.ids.searchsorted(changes.actor), changes.layer] = changes.event
    return events


def _left(cast: CastState) -> Floats:
    """(N,) the share of the transition that is left."""
    left: Floats = cast.offsets.left.max(1)
    return left


def world_of(role: Role, rows: Floats) -> Floats:
    """Returns the joints' matrices (…, J, 3, 4) of poses as rows of channels (…, 10·J + W)."""
    joints = len(role.character.skeleton)
    parts = rows[..., : JOINT_CHANNELS * joints].reshape(*rows.shape[:-1], joints, JOINT_CHANNELS)
    move, turn, scale = np.split(parts, [ROTATION_CHANNEL, SCALE_CHANNEL], axis=-1)
    return world_from_local(role.character.skeleton, Pose(move, turn, scale, rows[..., :0]))
