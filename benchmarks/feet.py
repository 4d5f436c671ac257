"""Measures what the lock of planted feet adds to a tick: `python benchmarks/feet.py`.

1,000 actors of faq-walker walk, at different places of their cycle, with `foot_lock: true` and
`foot_lock: false`.
"""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

from rounds import least, show
from statwalk.character.role import Role
from statwalk.services.library.load import load_role
from statwalk.stage.stage import Stage

ROUNDS, ACTORS, GROUPS = 20, 1000, 20
WALKER = Path(__file__).resolve().parent.parent / "machines" / "faq-walker"
LOCKED = "foot_lock: true\n"


def role_with(folder: Path, lock: str) -> Role:
    """Returns the walker's role with another line for `foot_lock`."""
    text = (WALKER / "machine.yaml").read_text(encoding="utf-8")
    if LOCKED not in text:
        raise SystemExit(f"{WALKER / 'machine.yaml'} has no line {LOCKED!r}")
    (folder / "machine.yaml").write_text(text.replace(LOCKED, lock), encoding="utf-8")
    return load_role(folder)


def walking(role: Role) -> Stage:
    """Returns a stage of walkers that set out at different times, some seconds later."""
    stage = Stage()
    places = [((float(number % 32) * 2, 0.0, float(number // 32) * 2), 0.0) for number in range(ACTORS)]
    actors = stage.add_many(role, places)
    for group in range(GROUPS):
        for actor in actors[group::GROUPS]:
            stage.hold(actor, "FORWARD")
        stage.step(5)
    stage.step(120)
    return stage


def main() -> None:
    """Prints the table."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "walker"
        shutil.copytree(WALKER, folder)
        roles = {"statwalk": role_with(folder, "foot_lock: false\n"), "foot lock": role_with(folder, LOCKED)}
        stages = {name: walking(role) for name, role in roles.items()}
        states = {actor.state for stage in stages.values() for actor in stage.actors}
        if states != {"WALK"}:
            raise SystemExit(f"not all actors walk: {sorted(states)}")
        seconds = least({name: stage.step for name, stage in stages.items()}, ROUNDS)
        added = seconds["foot lock"] - seconds["statwalk"]
        print(
            f"foot lock: {added / seconds['statwalk'] * 100:+.0f} % of a tick, "
            f"{added / ACTORS * 1e9:.0f} ns an actor with two feet"
        )
        joints = len(roles["statwalk"].character.skeleton)
        show(f"tick of {ACTORS} walkers of {joints} joints", seconds)


if __name__ == "__main__":
    main()
