"""A leg that is nearly straight does not bend at once when another motion begins: the other turn interrupts
at the end of a curve, while the right leg pushes off.
"""

import numpy as np
import pytest
from paths import MACHINES
from statwalk.services.library.load import load_role
from statwalk.stage.measure.subject import Subject
from statwalk.stage.measure.trials import RATE, CellTrial, record

SUBJECT = Subject(load_role(MACHINES / "faq-walker"))
ROLE = SUBJECT.role
KNEE = ROLE.character.skeleton.index("Right.lowerleg")


@pytest.mark.parametrize(("phase", "later"), [(0.2, 65), (0.5, 43), (0.7, 30)])
def test_the_knee_goes_on_as_it_went(phase: float, later: int) -> None:
    row, column = SUBJECT.cell("WALK/LEFT")
    right = ROLE.machine.events.index("RIGHT")
    trial = CellTrial(row, phase, column, second=right, second_tick=later - 1)
    recording = record(ROLE, [trial], 140, SUBJECT.checkpoint)
    turn = ROLE.machine.states.index("TRGT")
    began = int(np.flatnonzero(recording.state[:, 0, 0] == turn)[0])
    knee = recording.joints[began - 4 : began + 4, 0, KNEE]
    most = np.linalg.norm(np.diff(knee, 2, axis=0), axis=-1).max() * RATE**2
    assert most < 45  # m/s²; 107 and more when the offset's leg was softened once more
