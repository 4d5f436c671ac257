"""Feet that stay where they stand, counted in full: the measure of slides counts points above the floor less
and less, down to nothing at 6 mm; here every point below 6 mm counts wholly. No cell of faq-walker comes over
its budget then, either.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from paths import MACHINES
from statwalk.character.feet import Foot
from statwalk.services.library.load import load_role
from statwalk.stage.measure import measure
from statwalk.stage.measure.measure import measure_cells
from statwalk.stage.measure.slide import soles
from statwalk.stage.measure.subject import Subject
from statwalk.stage.measure.trials import Recording

SUBJECT = Subject(load_role(MACHINES / "faq-walker"))
NEAR, MOST = 0.006, 0.015
CELLS = [SUBJECT.name(cell) for cell in SUBJECT.cells]


def ways(
    recording: Recording, feet: Sequence[Foot], watched: np.ndarray, ground: Sequence[object]
) -> np.ndarray:
    """(N,) the farthest that a sole point moves over the floor, below NEAR, in one contact of its foot."""
    assert not ground
    farthest = np.zeros(recording.heading.shape[1])
    for foot in feet:
        points = soles(recording, foot)
        is_near = (points[..., 1] < NEAR) & watched[..., None]
        way = np.zeros(points.shape[1:3])
        for tick in range(1, len(points)):
            moved = points[tick] - points[tick - 1]
            way += np.hypot(moved[..., 0], moved[..., 2]) * (is_near[tick] & is_near[tick - 1])
            way[~is_near[tick].any(-1)] = 0.0
            farthest = np.maximum(farthest, way.max(-1))
    return farthest


@pytest.mark.parametrize("cell", CELLS)
def test_no_sole_point_slides_far_below_six_millimetres(cell: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measure, "slides", ways)
    (found,) = measure_cells(SUBJECT, [SUBJECT.cell(cell)])
    assert found.figures["slide"].worst <= MOST
