"""What `whynot` costs on the stage `playground`; `python benchmarks/whynot.py`.

Sixty questions about random actors, events and ticks of five seconds in which everyone is sent an event four
times a second. CPU time is measured: an answer runs beside a stage that goes on.
"""

from __future__ import annotations

from time import process_time

import numpy as np
import statwalk
from statwalk.stage.explain.whynot import WhyNot, whynot
from statwalk.stage.stage import Stage

TICKS, EVERY, QUESTIONS, SEED = 300, 15, 60, 7
GOAL = 0.3
"""seconds within which 95 of 100 answers come"""
Asked = tuple[int, str, int]
"""actor, event, tick"""


def lively(chance: np.random.Generator) -> Stage:
    """The playground after five seconds."""
    stage = statwalk.load_scene("playground").open()
    for tick in range(TICKS):
        for actor in stage.actors if tick % EVERY == 0 else ():
            events = actor.role.machine.events[:-1]
            stage.send(actor, events[chance.integers(len(events))])
        stage.step()
    return stage


def questions(stage: Stage, chance: np.random.Generator) -> list[Asked]:
    """Who is asked about, with which event, END among them, and in which tick."""
    found: list[Asked] = []
    for _ in range(QUESTIONS):
        actor = stage.actors[chance.integers(len(stage.actors))]
        events = actor.role.machine.events
        found.append((actor.id, events[chance.integers(len(events))], int(chance.integers(200, TICKS))))
    return found


def answered(stage: Stage, asked: Asked) -> tuple[float, WhyNot]:
    """The seconds of an answer, and the answer."""
    start = process_time()
    answer = whynot(stage, *asked)
    return process_time() - start, answer


def main() -> None:
    """Print the table."""
    chance = np.random.default_rng(SEED)
    stage = lively(chance)
    answers = [answered(stage, asked) for asked in questions(stage, chance)]
    seconds = [taken for taken, _ in answers]
    half, most = np.percentile(seconds, (50, 95))
    cut = sum(bool(answer.cut) for _, answer in answers)
    print(f"{QUESTIONS} times whynot in the playground, CPU")
    print(
        f"  half within {half * 1e3:6.1f} ms, 95 of 100 within {most * 1e3:6.1f} ms   goal {GOAL * 1e3:g} ms"
    )
    print(f"  the longest {max(seconds) * 1e3:6.1f} ms; {cut} answers were cut short")


if __name__ == "__main__":
    main()
