"""Writes and reads recorded runs as one compressed text: machine files, then runs, each a list of ticks.

    machine 3
      character: c.glb                      the file, indented by two
    run 12 seed 5 rate 60 ticks 60 machines 3 7
    tick 1
    > press 1 GO                            a command that counts in this tick
    x press 1 FROWN (UnknownNameError)      a command that was refused
    = 1.0 A 0.25 +0.016666666667            actor 1, layer 0: in state A, at 0.25 s, and 1/60 s later in each
    tick
    ? 1.0 GO taken A > B [A/GO] other=2 {pace=1.2} since pace > 1    a verdict, with cell, values and reason
    ! 1 nod(3) other=2                      an action

A line `=` stands where the state changes or time departs from its course; `= 1.0 gone` where the actor has
left. Ticks in which nothing is written are left out. Numbers are exact to 1e-9.
"""

import lzma
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from run_player import Tick, Verdict

FOLDER = Path(__file__).parent / "recordings"
CLOSE = 2e-10
"""seconds by which time may depart from its course before a line says so"""
VERDICT = re.compile(r"(\d+)\.(\d+) (\S+) (\S+) (\S+) > (\S+) \[(.*?)\] other=(-?\d+) \{(.*?)\} ?(.*)")
WHERE = re.compile(r"(\d+)\.(\d+) (\S+)(?: (\S+) \+(\S+))?")


Piece = tuple[int, str, float, float]
"""of a line `=`: tick, state, seconds, seconds more in each tick"""


class Run(NamedTuple):
    """What is played: commands by tick, over machine files by number."""

    number: int
    seed: int
    rate: int
    ticks: int
    machines: tuple[int, ...]
    commands: dict[int, list[str]]


class Recording(NamedTuple):
    """Machine files, runs and what came of them."""

    machines: dict[int, str]
    runs: list[Run]
    played: dict[int, list[Tick]]


def save(path: Path, head: str, recording: Recording) -> int:
    """Writes a recording and returns its size in bytes; the same recording gives the same bytes."""
    data = lzma.compress(
        "\n".join([f"# {head}", *_lines(recording), ""]).encode(), preset=9 | lzma.PRESET_EXTREME
    )
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(data)
    return len(data)


def load(path: Path) -> Recording:
    """A recording as `save` has written it."""
    machines: dict[int, list[str]] = {}
    runs: list[Run] = []
    written: dict[int, list[str]] = {}
    for line in lzma.decompress(path.read_bytes()).decode().splitlines()[1:]:
        kind, _, rest = line.partition(" ")
        if kind == "machine":
            texts = machines.setdefault(int(rest), [])
        elif not kind:
            texts.append(line[2:])
        elif kind == "run":
            runs.append(_run(rest.split()))
            lines = written.setdefault(runs[-1].number, [])
        else:
            lines.append(line)
    played = {run.number: _ticks(run, written[run.number]) for run in runs}
    return Recording({number: "\n".join(texts) + "\n" for number, texts in machines.items()}, runs, played)


# written


def _lines(recording: Recording) -> Iterator[str]:
    for number, text in recording.machines.items():
        yield f"machine {number}"
        yield from (f"  {line}" for line in text.splitlines())
    for run in recording.runs:
        machines = " ".join(map(str, run.machines))
        yield f"run {run.number} seed {run.seed} rate {run.rate} ticks {run.ticks} machines {machines}"
        yield from _run_lines(run, recording.played[run.number])


def _run_lines(run: Run, ticks: list[Tick]) -> Iterator[str]:
    courses = _courses(ticks)
    for number, tick in enumerate(ticks, 1):
        lines = [f"> {line}" for line in run.commands.get(number, ())]
        lines += [f"x {line}" for line in tick.refused]
        lines += [
            *courses.get(number, []),
            *map(_verdict_line, tick.verdicts),
            *(f"! {one}" for one in tick.actions),
        ]
        if lines:
            yield from (f"tick {number}", *lines)


def _courses(ticks: list[Tick]) -> dict[int, list[str]]:
    """The lines `=` by tick."""
    found: dict[int, list[str]] = {}
    for actor, layer in sorted({key for tick in ticks for key in tick.where}):
        for tick, line in _course([tick.where.get((actor, layer)) for tick in ticks]):
            found.setdefault(tick, []).append(f"= {actor}.{layer} {line}")
    return found


def _course(places: list[tuple[str, float] | None]) -> Iterator[tuple[int, str]]:
    """Of one actor and layer, each straight piece of its time, with the tick in which it begins."""
    at, expected = 0, None
    while at < len(places):
        if places[at] is None:
            if at and places[at - 1] is not None:
                yield at + 1, "gone"
            at += 1
            continue
        state, time = places[at]
        expected = places[at + 1] if at + 1 < len(places) else None
        pace = (
            round(expected[1] - time, 12)
            if expected and expected[0] == state and expected[1] >= time
            else 0.0
        )
        yield at + 1, f"{state} {_number(round(time, 10))} +{_number(pace)}"
        begin = at
        while at < len(places) and _is_on(places[at], state, time + (at - begin) * pace):
            at += 1


def _is_on(place: tuple[str, float] | None, state: str, time: float) -> bool:
    return place is not None and place[0] == state and abs(time - place[1]) < CLOSE


def _verdict_line(one: Verdict) -> str:
    values = ", ".join(f"{name}={value:.9g}" for name, value in one.values)
    return (
        f"? {one.actor}.{one.layer} {one.event} {one.verdict} {one.from_state} > {one.to_state or '-'} "
        f"[{one.cell}] "
        f"other={one.other} {{{values}}} {one.reason}"
    )


def _number(value: float) -> str:
    return f"{value:.12f}".rstrip("0").rstrip(".")


# read


def _run(words: list[str]) -> Run:
    number, _, seed, _, rate, _, ticks, _, *machines = words
    return Run(int(number), int(seed), int(rate), int(ticks), tuple(map(int, machines)), {})


def _ticks(run: Run, lines: Iterable[str]) -> list[Tick]:
    """The ticks of a run; its commands go into `run`."""
    ticks = [Tick([], {}, [], []) for _ in range(run.ticks)]
    courses: dict[tuple[int, int], list[Piece]] = {}
    for line in lines:
        kind, _, rest = line.partition(" ")
        match kind:
            case "tick":
                number = int(rest)
            case ">":
                run.commands.setdefault(number, []).append(rest)
            case "x":
                ticks[number - 1].refused.append(rest)
            case "=":
                actor, layer, state, time, pace = WHERE.fullmatch(rest).groups()
                piece = number, state, float(time or 0), float(pace or 0)
                courses.setdefault((int(actor), int(layer)), []).append(piece)
            case "?":
                ticks[number - 1].verdicts.append(_verdict(rest))
            case "!":
                ticks[number - 1].actions.append(rest)
    for key, pieces in courses.items():
        _follow(ticks, key, pieces)
    return ticks


def _follow(ticks: list[Tick], key: tuple[int, int], pieces: list[Piece]) -> None:
    ends = [piece[0] for piece in pieces[1:]] + [len(ticks) + 1]
    for (begin, state, time, pace), end in zip(pieces, ends, strict=True):
        for tick in range(begin, end if state != "gone" else begin):
            ticks[tick - 1].where[key] = state, time + (tick - begin) * pace


def _verdict(text: str) -> Verdict:
    actor, layer, event, verdict, here, to, cell, other, values, reason = VERDICT.fullmatch(text).groups()
    parts = [part.split("=") for part in values.split(", ") if part]
    pairs = tuple((name, float(value)) for name, value in parts)
    to = "" if to == "-" else to
    return Verdict(int(actor), int(layer), event, verdict, here, to, cell, int(other), pairs, reason)
