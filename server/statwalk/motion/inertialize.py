"""Inertialization (SM4): the difference between the shown pose and the new motion becomes an offset that
fades out.

After Bollo, *Inertialization* (GDC 2018): only the new motion is evaluated, and the offset is taken from the
poses that were *shown*, so an interrupted transition is no special case. An offset is a row of D = 9J + W
numbers for each actor: translations (metres), rotations (rotation vectors in the parent's space, radians),
scales, morph weights.

The offset keeps its velocity and comes to rest after `duration` seconds along a cubic, the curve with the
least acceleration (∫a² dt). Measured over every transition of faq-walker it changes position and velocity
less from tick to tick than Bollo's quintic (whose peak speed is 1.875 x₀/T, against 1.5) and than the curve
with the least peak acceleration (full one way, then the other). The quintic is an option: it comes to rest
without force, and is nearly gone by half its time.
"""

from __future__ import annotations

import numpy as np

from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose


def difference(to: Pose, of: Pose) -> Floats:
    """Returns the offsets (N, D), along the shorter arc, that lead from poses `of` (N, …) to poses `to`."""
    turn = quat.to_rotation_vector(quat.mul(to.rotation, quat.conjugate(of.rotation)))
    return _flat(to.translation - of.translation, turn, to.scale - of.scale, to.weights - of.weights)


def _flat(translation: Floats, turn: Floats, scale: Floats, weights: Floats) -> Floats:
    """The parts (N, J, 3) ×3 and (N, W) as one row for each actor."""
    rows = len(translation)
    return np.concatenate(
        [translation.reshape(rows, -1), turn.reshape(rows, -1), scale.reshape(rows, -1), weights], -1
    )
