"""Which joints of a clip a principle changes: by their rows, for a clip knows no names."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from statwalk.errors import ContentError
from statwalk.motion.clip import Clip


def check_joints(clip: Clip, joints: Iterable[object]) -> None:
    """Checks that each of `joints` is the row of a joint.

    :raises ContentError: when one is not, as a name is not.
    """
    count = len(clip.rest.scale)
    for joint in joints:
        if not isinstance(joint, int | np.integer) or not 0 <= joint < count:
            raise ContentError(
                f"the clip {clip.name} has {count} joints, from 0; none is {joint!r:.40}. The row of a name "
                "is character.skeleton.index(name)"
            )
