"""Time of a tick for 1, 100 and 1,000 actors, beside a plain loop over joints; `python benchmarks/tick.py`.

The peer does for one actor what most first versions do: for each joint find the keys, slerp, multiply into the parent (float64, NumPy a
joint at a time), and nothing else: no state table, no transitions, no root motion, no hash. Both are measured in turn in the same run; the
least time of all rounds counts, and the ratio is what carries over to another machine.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from time import perf_counter

import numpy as np
from statwalk.loading import load_role
from statwalk.maths import quat
from statwalk.motion.clip import Clip
from statwalk.stage.role import Role
from statwalk.stage.stage import Stage

ROUNDS = 60
WALKER = Path(__file__).resolve().parents[1] / "machines" / "faq-walker"


def peer(role: Role, clip: Clip) -> Callable[[], None]:
    """One tick of one actor, a joint at a time."""
    turns = {channel.joint: channel for channel in clip.channels if channel.path == "rotation"}
    parents, time = role.character.skeleton.parent, 0.0

    def tick() -> None:
        nonlocal time
        time = (time + 1 / 60) % clip.duration
        worlds = []
        for joint, parent in enumerate(parents):
            local = np.eye(4)
            local[:3, 3] = clip.rest.translation[joint]
            if joint in turns:
                times, values = turns[joint].times, turns[joint].values
                key = min(int(np.searchsorted(times, time, "right")) - 1, len(times) - 2)
                part = (time - times[key]) / (times[key + 1] - times[key])
                local[:3, :3] = quat.to_matrix(quat.slerp(values[key].astype(float), values[key + 1].astype(float), part))
            worlds.append(local if parent < 0 else worlds[parent] @ local)

    return tick


def crowd(role: Role, actors: int) -> Stage:
    """A stage on which half the actors walk, each at a phase of its own."""
    stage = Stage()
    for number in range(actors):
        actor = stage.add(role, position=(number % 32, 0, number // 32))
        if number % 2 == 0:
            stage.send(actor, "FORWARD")
        if number % 50 == 0:
            stage.step()
    stage.step(120)
    return stage


def main() -> None:
    """Print the table."""
    role = load_role(WALKER)
    stages = {actors: crowd(role, actors) for actors in (1, 100, 1000)}
    ticks: dict[str, Callable[[], None]] = {str(actors): stage.step for actors, stage in stages.items()}
    ticks["peer"] = peer(role, role.motions[role.machine.states.index("WALK")].clip)
    least = dict.fromkeys(ticks, np.inf)
    for _ in range(ROUNDS):
        for name, tick in ticks.items():
            start = perf_counter()
            tick()
            least[name] = min(least[name], perf_counter() - start)
    joints = len(role.character.skeleton.names)
    print(f"{joints} joints; the peer takes {least['peer'] * 1e3:.3f} ms for one actor")
    for actors in stages:
        seconds = least[str(actors)]
        each = seconds / actors
        print(
            f"{actors:5} actors: {seconds * 1e3:7.3f} ms a tick, {each * 1e6:8.2f} us each, {least['peer'] / each:7.1f} x the peer's speed"
        )


if __name__ == "__main__":
    main()
