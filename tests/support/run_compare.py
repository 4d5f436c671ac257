"""Compares a recorded run with a played one: states, times, verdicts (their reasons as codes), actions."""

from itertools import zip_longest
from typing import NamedTuple

from run_codes import codes
from run_player import Tick, Verdict

CLOSE = 1e-9
"""seconds between a recorded time and a played one"""
NAMES: dict[str, str] = {}
"""old and new words of verdicts and events, where they differ (EDIT stands in the place of an event)"""

OF_ANOTHER = {"QUEUE_LIMIT", "RELEASED", "HELD_ALREADY"}
"""verdicts that told, when the runs were recorded, the sense and the values of the event before theirs; they
tell nothing of it now
"""

MARKERS = {"left", "right"}
"""the markers of the machines; where nothing in their cells was true, verdicts were recorded that are gone
now: "Alternatives that are all false act like blank without a default", and in a blank cell a marker "neither
waits nor leaves a verdict"
"""


class Difference(NamedTuple):
    """The first tick in which two runs part, and how."""

    tick: int
    text: str


def first_difference(recorded: list[Tick], played: list[Tick]) -> Difference | None:
    """Where two runs part; None where they do not."""
    for number, (was, now) in enumerate(zip_longest(recorded, played), 1):
        for what, is_same in SAME.items():
            if not is_same(getattr(was, what), getattr(now, what)):
                return Difference(
                    number, f"{what}: {_parting(getattr(was, what), getattr(now, what), is_same)}"
                )
    return None


def _parting(was, now, is_same) -> str:
    """The first entries that differ, in words."""
    pairs = zip_longest(_singles(was), _singles(now), fillvalue=type(was)())
    before, after = next((pair for pair in pairs if not is_same(*pair)), (was, now))
    return f"recorded {before}, played {after}"


def _singles(entries):
    """Each entry of a list or of a dictionary on its own."""
    return (
        [{key: one} for key, one in entries.items()]
        if isinstance(entries, dict)
        else [[one] for one in entries]
    )


def is_shifted(recorded: list[Tick], played: list[Tick]) -> bool:
    """Whether each actor and layer has the same states, verdicts and actions, each at most one tick apart."""
    was, now = _timelines(recorded), _timelines(played)
    last = len(recorded) - 1
    return was.keys() == now.keys() and all(_are_near(was[key], now[key], last) for key in was)


def _are_near(was: list[tuple[int, object]], now: list[tuple[int, object]], last: int) -> bool:
    """What only one of the two contains lies in the last two ticks."""
    short = min(len(was), len(now))
    pairs = zip(was, now, strict=False)
    return all(tick >= last - 1 for tick, _ in was[short:] + now[short:]) and all(
        one == other and abs(first - second) <= 1 for (first, one), (second, other) in pairs
    )


def _timelines(ticks: list[Tick]) -> dict[object, list[tuple[int, object]]]:
    """Verdicts and new states of each actor and layer, actions of each actor; each with its tick."""
    found: dict[object, list[tuple[int, object]]] = {}
    before: dict[tuple[int, int], str] = {}
    for number, tick in enumerate(ticks):
        for one in filter(_is_lasting, tick.verdicts):
            found.setdefault(("verdicts", one.actor, one.layer), []).append((number, _outline(one)))
        for action in tick.actions:
            found.setdefault(("actions", action.split()[0]), []).append((number, action))
        for key, (state, _) in tick.where.items():
            if before.get(key) != state:
                found.setdefault(("states", *key), []).append((number, state))
        before = {key: state for key, (state, _) in tick.where.items()}
    return found


def _outline(one: Verdict) -> Verdict:
    """A verdict without numbers, its reason as codes."""
    return one._replace(verdict=_now(one.verdict), event=_now(one.event), values=(), reason=_own_codes(one))


def _own_codes(one: Verdict) -> tuple[str, ...]:
    found = codes(one.reason)
    return found[-1:] if OF_ANOTHER.intersection(found[-1:]) else found


def _now(word: str) -> str:
    return NAMES.get(word, word)


def _is_same_where(was, now) -> bool:
    return was.keys() == now.keys() and all(
        state == now[key][0] and abs(time - now[key][1]) < CLOSE for key, (state, time) in was.items()
    )


def _are_same_verdicts(was: list[Verdict], now: list[Verdict]) -> bool:
    outlines = list(map(_outline, now))
    was = [one for one in was if _is_lasting(one) or _outline(one) in outlines]
    return list(map(_outline, was)) == outlines and all(
        _are_same_values(one.values, other.values) or OF_ANOTHER.intersection(_own_codes(one))
        for one, other in zip(was, now, strict=True)
    )


def _is_lasting(one: Verdict) -> bool:
    """Whether a verdict is none on a marker in whose cell nothing was true."""
    return not (one.event in MARKERS and one.verdict == "dropped" and "NOTHING_TRUE" in codes(one.reason))


def _are_same_values(was, now) -> bool:
    """Values are recorded with nine digits."""
    return [name for name, _ in was] == [name for name, _ in now] and all(
        abs(first - second) <= 1e-8 * max(1.0, abs(first))
        for (_, first), (_, second) in zip(was, now, strict=True)
    )


def _are_same_refusals(was: list[str], now: list[str]) -> bool:
    """The commands are the same; the names of the errors may have changed."""
    return _commands(was) == _commands(now)


def _commands(refused: list[str]) -> list[str]:
    return [line.partition(" (")[0] for line in refused]


SAME = {
    "refused": _are_same_refusals,
    "where": _is_same_where,
    "verdicts": _are_same_verdicts,
    "actions": list.__eq__,
}
"""members of a tick, and when two of them are the same"""
