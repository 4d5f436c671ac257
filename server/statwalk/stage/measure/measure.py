"""Measures a machine: every cell of its table from ten phases of the old motion and through interruptions,
and every motion by itself.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from statwalk.machine.compile.alternatives import NOW
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.stage.measure.figures import Figure, Played
from statwalk.stage.measure.hover import hovers
from statwalk.stage.measure.jump import Jump, jump_of
from statwalk.stage.measure.limbs import hand_accelerations, knees
from statwalk.stage.measure.response import arrivals, visible
from statwalk.stage.measure.slide import sinks, slides
from statwalk.stage.measure.subject import Cell, Subject
from statwalk.stage.measure.trials import RATE, WARM_UP, CellTrial, Recording, record
from statwalk.stage.measure.windows import change_ticks, end_of_blend, span

PHASES = np.linspace(0, 0.9, 10)
LATER = (1, 5, 11)
"""ticks after the change of state at which it is interrupted"""
LONGEST_WAIT, LONGEST_LOOK = 10.0, 1.5
"""seconds: the longest motion whose end is waited for, and how long a new motion is looked at"""
AROUND = 3
"""ticks before a change that belong to it, and ticks after the end of a blend"""
MOST_JOINTS = 2_000_000
"""joints times ticks of the interrupted trials that are recorded at once"""


@dataclass(frozen=True)
class Measured:
    """The figures of a cell, or of a state's motion by itself (`event` empty)."""

    state: str
    event: str
    layer: str
    line: int
    """of the cell or the state in the machine file"""
    trials: int
    """trials in which the cell was taken"""
    figures: Mapping[str, Figure]

    @property
    def name(self) -> str:
        """Returns `WALK/STOP`, or `WALK` for a motion by itself."""
        return f"{self.state}/{self.event}" if self.event else self.state


def measure_cells(subject: Subject, cells: Sequence[Cell]) -> Iterator[Measured]:
    """Yields the figures of cells."""
    machine = subject.role.machine
    for row, column in cells:
        played = _play_cell(subject, row, column)
        yield _measured(subject, row, machine.events[column], played)


def measure_motions(subject: Subject, rows: Sequence[int]) -> Iterator[Measured]:
    """Yields the figures of motions by themselves: of a motion that loops two laps, of the others all but
    their ends.
    """
    for row in rows:
        yield _measured(subject, row, "", _play_motion(subject, row))


def _measured(subject: Subject, row: int, event: str, played: Played) -> Measured:
    machine = subject.role.machine
    layer = machine.layers[machine.layer_of[row]].name if machine.layer_of[row] else ""
    line = subject.line(row, event)
    return Measured(machine.states[row], event, layer, line, len(played.phase), played.figures())


def _play_motion(subject: Subject, row: int) -> Played:
    """The figures of a state's motion by itself, except jump and response."""
    machine = subject.role.machine
    duration = min(_seconds(subject, row), LONGEST_WAIT)
    ticks = round(duration * RATE) * (1 + bool(machine.loop[row]))
    trials = [CellTrial(row, 0.0, place=place) for place in subject.places]
    recording = record(subject.role, trials, max(ticks, 3), subject.checkpoint)
    watched = np.ones(recording.left.shape, bool)
    watched[0] = False  # the pose at 0 was put there, not shown
    values, count = _held(subject, recording, watched), len(trials)
    return Played(values, [""] * count, [0.0] * count, [""] * count, [0] * count, subject.places)


def _held(subject: Subject, recording: Recording, watched: Bools) -> dict[str, Floats]:
    """The figures of feet, knees and hands in the ticks that are watched (T, N)."""
    return {
        "slide": slides(recording, subject.feet, watched, subject.ground),
        "sink": sinks(recording, subject.skin, watched, subject.ground),
        "hover": hovers(recording, subject.feet, watched, subject.ground),
        "knee": knees(recording, subject.feet, watched),
        "hand": hand_accelerations(recording, subject.hands, watched),
    }


def _play_cell(subject: Subject, row: int, column: int) -> Played:
    """The figures of all trials of a cell that were taken."""
    layer = int(subject.role.machine.layer_of[row])
    phases = _phases(subject, row, column)
    begins = list(product(subject.places, phases))
    plain = [CellTrial(row, phase, column, place=place) for place, phase in begins]
    twins = [CellTrial(row, phase, place=place) for place, phase in begins]
    every = record(subject.role, [*plain, *twins], _ticks(subject, row, column), subject.checkpoint)
    changed = change_ticks(every, layer, column)[: len(plain)]
    taken = np.flatnonzero(changed >= 0)
    recording, changed = every.take(taken), changed[taken]
    if column == subject.role.machine.end:  # comes by itself
        recording = replace(recording, sent=changed - 1)
    began = [plain[k] for k in taken.tolist()]
    played = _played(subject, recording, began, (changed, changed))
    shown = visible(every, np.tile(np.arange(len(plain), 2 * len(plain)), 2))[taken]
    of_one_place = plain[: len(phases)]  # without foot lock nothing finds the ground: all places are alike
    free = record(subject.unlocked, of_one_place, len(every.left), subject.checkpoint)
    free = free.take(taken % len(phases))
    half, arrived = arrivals(replace(free, sent=recording.sent), changed)
    response = {"half": half, "arrived": arrived}
    if column != subject.role.machine.end:
        response["visible"] = shown
    played = replace(played, values={**played.values, **response})
    waits = (changed - recording.sent).tolist()
    return _play_interruptions(subject, (row, column), played, list(zip(began, waits, strict=True)))


def _play_interruptions(
    subject: Subject, cell: Cell, plain: Played, began: Sequence[tuple[CellTrial, int]]
) -> Played:
    """The figures of a cell's trials, and after them the figures of trials that another event interrupts.

    The interrupted trials begin at the places in turn. `began`: the trials, each with the ticks for which it
    waited for its event.
    """
    row, column = cell
    turns = len(subject.places)
    trials = [
        trial._replace(second=second, second_tick=wait + later - 1)
        for number, (second, later) in enumerate(product(subject.interruptions(row, column), LATER))
        for trial, wait in began[number % turns :: turns]
    ]
    ticks = _ticks(subject, row, column) + max(LATER)
    at_once = max(MOST_JOINTS // (ticks * len(subject.role.character.skeleton)), 1)
    for first in range(0, len(trials), at_once):
        plain = plain.append(_play_interrupted(subject, column, trials[first : first + at_once], ticks))
    return plain


def _play_interrupted(subject: Subject, column: int, trials: Sequence[CellTrial], ticks: int) -> Played:
    """The figures of interrupted trials of a cell in which both events were taken."""
    recording = record(subject.role, trials, ticks, subject.checkpoint)
    layer = int(subject.role.machine.layer_of[trials[0].state])
    first = change_ticks(recording, layer, column)
    last = recording.sent + np.array([trial.second_tick for trial in trials]) + 1
    cause = recording.event[np.minimum(last, len(recording.event) - 1), np.arange(len(trials)), layer]
    taken = np.flatnonzero((first >= 0) & (cause == np.array([trial.second for trial in trials])))
    changes = first[taken], last[taken]
    return _played(subject, recording.take(taken), [trials[k] for k in taken.tolist()], changes)


def _played(
    subject: Subject, recording: Recording, trials: Sequence[CellTrial], changes: tuple[Ints, Ints]
) -> Played:
    """The figures of trials whose state changed first and last in the ticks `changes`."""
    first, last = changes
    until = end_of_blend(recording, last)
    look = np.array([_look(subject, recording, n, int(last[n])) for n in range(len(trials))], np.int64)
    watched = span(recording, recording.sent, np.maximum(until, last + look))
    jumps = [_jump(subject, recording, n, (int(first[n]), int(until[n]))) for n in range(len(trials))]
    values = {
        "jump": np.array([jump.body for jump in jumps]),
        "joint": np.array([jump.joint for jump in jumps]),
        **_held(subject, recording, watched),
    }
    events = subject.role.machine.events
    return Played(
        values,
        [f"{jump.name} {jump.what}" for jump in jumps],
        [trial.phase for trial in trials],
        [events[trial.second] if trial.second >= 0 else "" for trial in trials],
        [int(last[n] - first[n]) for n in range(len(trials))],
        [trial.place for trial in trials],
    )


def _jump(subject: Subject, recording: Recording, number: int, ticks: tuple[int, int]) -> Jump:
    """The jump of one trial between two ticks and around them."""
    first, past = max(ticks[0] - AROUND, 1), ticks[1] + AROUND  # the pose at 0 was put there, not shown
    track = recording.joints[first:past, number][:, subject.joints]
    states = np.unique(recording.state[first:past, number, :])
    return jump_of(track, [subject.most(int(state)) for state in states], subject.names)


def _look(subject: Subject, recording: Recording, number: int, tick: int) -> int:
    """The ticks for which the new motion of a trial is looked at."""
    state = int(recording.state[tick, number, 0])
    return round(min(_seconds(subject, state), LONGEST_LOOK) * RATE)


def _seconds(subject: Subject, row: int) -> float:
    """The duration of a state's motion; 1 second for a state without motion."""
    duration = float(subject.role.machine.duration[row])
    return duration if np.isfinite(duration) else 1.0


def _phases(subject: Subject, row: int, column: int) -> list[float]:
    """The phases of the old motion from which a cell is played; END comes at its end alone."""
    if column != subject.role.machine.end:
        return [float(phase) for phase in PHASES]
    return [max(1 - WARM_UP / RATE / max(_seconds(subject, row), 1 / RATE), 0.0)]


def _ticks(subject: Subject, row: int, column: int) -> int:
    """The ticks that a trial of a cell needs."""
    machine = subject.role.machine
    wait = 0.0 if machine.when[row, column] == NOW else min(_seconds(subject, row), LONGEST_WAIT)
    wait = 2 * WARM_UP / RATE if column == machine.end else wait
    blend = max(option.blend for option in machine.alternatives[row, column])
    return WARM_UP + round((wait + max(blend, LONGEST_LOOK)) * RATE) + 2 * AROUND + 2
