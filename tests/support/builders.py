"""A tiny character and machines over it, whose answers can be worked out by hand."""

import numpy as np
from scipy.spatial.transform import Rotation
from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.machine.definition.cell_definition import CellDefinition, Defaults
from statwalk.machine.definition.machine_definition import (
    EventDefinition,
    MachineDefinition,
    StateDefinition,
)
from statwalk.machine.definition.parameter_definition import ParameterDefinition
from statwalk.machine.definition.state_table import read_table
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton

REST = rest(3, weights=1)
REST.translation[:] = [[0, 1, 0], [0, 0.5, 0], [0.3, 0, 0]]

TABLE = """
state | GO   | HOP  | TURN | STOP | END
STAND | WALK | HOP  | TURN | -    |
WALK  | WALK | HOP  | TURN | STAND |
HOP   |      | HOP! |      |      | STAND
TURN  |      |      |      | STAND | STAND
"""


def clip_of(name, seconds, arm_deg, way=0.0, turn=0.0, keys=31):
    """`arm_deg` and weight swing once; the root goes `way` metres along +Z and turns `turn` radians to the
    left.
    """
    part = np.linspace(0, 1, keys)
    times = (part * seconds).astype(np.float32)
    swing = np.sin(2 * np.pi * part)
    yaw = turn * part
    if turn:
        along = np.stack([way / turn * (1 - np.cos(yaw)), 1 + 0 * yaw, way / turn * np.sin(yaw)], -1)
    else:
        along = np.stack([0 * part, 1 + 0 * part, way * part], -1)
    channels = (
        Channel(0, "translation", times, along.astype(np.float32)),
        Channel(0, "rotation", times, Rotation.from_euler("y", yaw[:, None]).as_quat().astype(np.float32)),
        Channel(
            2,
            "rotation",
            times,
            Rotation.from_euler("x", arm_deg * swing[:, None], degrees=True).as_quat().astype(np.float32),
            "BSPLINE_THROUGH",
        ),
        Channel(0, "weights", times, ((1 + swing) / 2)[:, None].astype(np.float32)),
    )
    return Clip(name, channels, seconds, REST)


CLIPS = {
    clip.name: clip
    for clip in (
        clip_of("stand", 2.0, 5),
        clip_of("walk", 1.0, 40, 1.5),
        clip_of("hop", 0.5, 90, 0.4),
        clip_of("turn", 1.0, 20, 0.0, np.pi / 2),
    )
}


def character():
    skeleton, _ = Skeleton.sorted(["hips", "chest", "arm"], [None, "hips", "chest"])
    return Character("tiny", skeleton, np.arange(3, dtype=np.int32), REST, CLIPS)


def definition(table=TABLE, cells=None, **options):
    read = read_table(table.strip(), "table")
    states = {
        name: StateDefinition(
            name.lower(), line, loop=name in ("STAND", "WALK"), speed="pace" if name == "WALK" else 1.0
        )
        for name, line in read.states.items()
    }
    options = {
        "initial": "STAND",
        "defaults": Defaults(blend=0.2, buffer=0.3),
        "parameters": {"pace": ParameterDefinition(1.0, 0.5, 2.0, 1)},
    } | options
    return MachineDefinition(
        name="tiny",
        states=states,
        events={name: EventDefinition(line) for name, line in read.events.items() if name != "END"},
        cells=read.cells | (cells or {}),
        **options,
    )


def role(root="hips", name="tiny", **options):
    return Role.build(name, character(), definition(**options), root)


__all__ = ["CLIPS", "REST", "CellDefinition", "character", "definition", "role"]
