"""Faults planted into the tick, which the checks of R-05 and R-06 must find."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np
from statwalk.stage.history import timeline
from statwalk.stage.state.stage_state import StageState

NAMES = ("left", "right", "hip", "knee", "ankle", "toe", "heel", "gaze")


def nudge(state: StageState) -> None:
    """Every actor goes a thousandth of a millimetre, as if a constant had changed."""
    for cast in state.casts.values():
        cast.position[:, 2] += 1e-6


def exp(state: StageState) -> None:
    """NumPy's exponential function: its last bits depend on the instructions of the processor."""
    values = np.exp(np.linspace(0.1, 9.7, 997))
    for cast in state.casts.values():
        cast.position[:, 0] = values[7 * state.tick % 997]


def order_of_a_set(state: StageState) -> None:
    """A sum in the order of a set of texts, which depends on PYTHONHASHSEED."""
    for cast in state.casts.values():
        for name in set(NAMES):
            cast.position[:, 0] = cast.position[:, 0] * 1.0001 + 1e-6 * len(name)


FAULTS: dict[str, Callable[[StageState], None]] = {
    "nudge": nudge,
    "exp": exp,
    "set": order_of_a_set,
}


@contextmanager
def planted(fault: str, until: int = 1 << 62) -> Iterator[None]:
    """Ends each tick up to `until` with a fault; "" plants none."""
    advance = timeline.advance

    def advance_wrongly(*arguments):
        state, effects = advance(*arguments)
        if fault and state.tick <= until:
            FAULTS[fault](state)
        return state, effects

    timeline.advance = advance_wrongly
    try:
        yield
    finally:
        timeline.advance = advance
