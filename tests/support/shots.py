"""What the staging camera of the package does for some boxes and paths: the page's camera must do the same
(`static/src/view/camera/followCamera.test.ts`). `python tests/support/shots.py` writes it again.
"""

import json
from typing import Any

import numpy as np
import statwalk
from builders import character
from paths import ROOT
from statwalk.character.staging import FRAMINGS
from statwalk.maths import quat

FILE = ROOT / "static/src/view/camera/shots.json"
ASPECTS = 16 / 9, 0.5


def shots() -> dict[str, Any]:
    """The box of a character, its shots in each framing, and the way of the camera along a path."""
    actor = character()
    joints = actor.world(actor.bind_pose)[:, :3, 3].astype(float)
    low, high = joints.min(0), joints.max(0)
    path = [[0.0, 0.0, 1.4 * tick / 60] for tick in range(20)]
    return {
        "box": [low.tolist(), high.tolist()],
        "shots": [_shot(actor, name, aspect) for name in FRAMINGS for aspect in ASPECTS],
        "path": path,
        "places": statwalk.staging(actor, actor.bind_pose, path).position.tolist(),
    }


def _shot(actor: statwalk.Character, framing: Any, aspect: float) -> dict[str, Any]:
    shot = statwalk.staging(actor, actor.bind_pose, framing=framing, aspect=aspect)
    sight = quat.rotate(shot.rotation, np.array([0.0, 0.0, -1.0]))
    return {
        "framing": framing,
        "aspect": aspect,
        "position": shot.position[0].tolist(),
        "sight": sight.tolist(),
        "field_deg": np.rad2deg(shot.field),
        "near": shot.near,
        "far": shot.far,
    }


if __name__ == "__main__":
    FILE.write_text(json.dumps(shots(), indent=1) + "\n")
