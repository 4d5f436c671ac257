"""The principles of animation that play in a tick (FAQ Q1): roles of a character that show them (KF9).

Each writes the machine file that a hand would write, and reads it: springs, layers and tables have one path.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import ContentError, MachineError
from statwalk.files.machine_yaml.machine_file import read_machine

STATE = "MOVE"
TABLE = f"state | END\n{STATE} | -"
"""of one state, which nothing leaves"""


def follow_through(
    character: Character,
    clip: str,
    springs: Mapping[str, Mapping[str, float | bool]],
    loop: bool | None = None,
    root: str | None = None,
) -> Role:
    """Returns the role that plays a clip while joints lag behind it, and settle: follow-through and
    overlapping action.

    springs: by joint, as in a machine file: {"tail": {"half_life": 0.15, "frequency": 2, "below": True}}.
    loop: whether the clip repeats; None: as its file says. root: the joint that moves the actor.

    :raises UnknownNameError: when the character has no clip of a name.
    :raises ContentError: when it has no joint of a name, or a spring is wrong.
    """
    machine = {"states": _state(clip, loop), "table": TABLE, "springs": springs}
    return _role(character, "follow-through", [clip], machine, root)


def secondary(
    character: Character,
    clip: str,
    over: str,
    joints: Sequence[str] = (),
    weight: float = 1.0,
    loop: bool | None = None,
    root: str | None = None,
) -> Role:
    """Returns the role that plays a clip, and adds another motion to it: secondary action.

    What is added is the way from the first pose of the clip `over`, times `weight` (0…1), on `joints` and
    all below them; without `joints`, on all. loop: whether the clips repeat; None: as their file says. root:
    the joint that moves the actor.

    :raises UnknownNameError: when the character has no clip of a name.
    :raises ContentError: when it has no joint of a name, or the weight is not 0 to 1.
    """
    layer = {"mode": "additive", "weight": weight, "initial": STATE, "states": _state(over, loop)}
    layer |= {"table": TABLE} | ({"mask": list(joints)} if joints else {})
    machine = {"states": _state(clip, loop), "table": TABLE, "layers": {"secondary": layer}}
    return _role(character, "secondary", [clip, over], machine, root)


def straight_ahead(
    character: Character,
    clips: Sequence[str],
    blend: float = 0.0,
    repeat: bool = False,
    root: str | None = None,
) -> Role:
    """Returns the role that plays clips one after another: straight-ahead action. With clips of one pose
    each, and a `blend` between them (seconds), it is pose to pose.

    The last pose stays, unless the row of clips repeats. root: the joint that moves the actor.

    :raises UnknownNameError: when the character has no clip of a name.
    :raises ContentError: when there are no clips, or the blend is not 0 to 60.
    """
    if isinstance(clips, str) or not clips:
        raise ContentError("straight ahead needs a list of clips, with at least one clip")
    names = [f"AHEAD-{number + 1}" for number in range(len(clips))]
    following = [*names[1:], f"{names[0]}!" if repeat else "-"]
    states = {name: {"motion": clip, "loop": False} for name, clip in zip(names, clips, strict=True)}
    rows = [f"{name} | {then}" for name, then in zip(names, following, strict=True)]
    machine = {"states": states, "table": "\n".join(["state | END", *rows]), "defaults": {"blend": blend}}
    return _role(character, "straight-ahead", clips, machine, root)


def _state(clip: str, loop: bool | None) -> dict[str, Any]:
    return {STATE: {"motion": clip} | ({} if loop is None else {"loop": loop})}


def _role(
    character: Character, name: str, clips: Sequence[str], machine: Mapping[str, Any], root: str | None
) -> Role:
    """The role of a machine file with these keys, which plays these clips. A mistake in it has no line."""
    for motion in clips:
        character.clip(motion)
    whole = {"initial": next(iter(machine["states"])), **machine}
    text = json.dumps(whole, ensure_ascii=False, default=float)
    try:
        return Role.build(f"{character.name} {name}", character, read_machine(text, name), root)
    except MachineError as error:
        raise ContentError(error.message, file=name) from None
