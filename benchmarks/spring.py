"""Measures what springs add to a tick: `python benchmarks/spring.py`.

The same crowd plays the same motion without springs, with springs on six joints, and with springs on all
joints that have a bone.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from models import figure
from rounds import least, show
from statwalk.character.role import Role
from statwalk.services.library.load import load_role
from statwalk.stage.stage import Stage

ROUNDS = 12
ACTORS = 1000
MACHINE = """
character: figure.glb
initial: STAND
states:
  STAND: {motion: clip 0, loop: true}
table: |
  state | GO
  STAND | -
"""


def role_with(folder: Path, springs: str) -> Role:
    """Returns the role of the figure with some springs."""
    (folder / "machine.yaml").write_text(MACHINE + springs)
    return load_role(folder)


def crowd(role: Role) -> Stage:
    """Returns a stage of actors after two seconds."""
    stage = Stage()
    for number in range(ACTORS):
        stage.add(role, position=(number % 32, 0, number // 32))
    stage.step(120)
    return stage


def main() -> None:
    """Prints the table."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        (folder / "figure.glb").write_bytes(figure(100))
        plain = role_with(folder, "")
        moved = plain.character.bind_pose.translation.any(-1)
        names = [name for name, has in zip(plain.character.skeleton.names, moved, strict=True) if has]
        roles = {
            "statwalk": plain,
            "6 springs": role_with(folder, springs_on(names[-6:])),
            f"{len(names)} springs": role_with(folder, springs_on(names)),
        }
        seconds = least({name: crowd(role).step for name, role in roles.items()}, ROUNDS)
        for name, role in roles.items():
            added = (seconds[name] / seconds["statwalk"] - 1) * 100
            springs = ACTORS * max(len(role.solvers.springs.column), 1)
            each = (seconds[name] - seconds["statwalk"]) / springs * 1e9
            print(f"{name}: {added:+.0f} % of a tick, {each:.0f} ns a spring")
        show(f"tick of {ACTORS} actors of {len(plain.character.skeleton)} joints", seconds)


def springs_on(names: list[str]) -> str:
    """Returns the springs of a machine file."""
    lines = [f"  {name!r}: {{half_life: 0.1, frequency: 2}}" for name in names]
    return "springs:\n" + "\n".join(lines) + "\n"


if __name__ == "__main__":
    main()
