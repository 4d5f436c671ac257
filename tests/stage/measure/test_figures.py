"""Means over the phases, the worst of all trials, and their words."""

import numpy as np
import pytest
from statwalk.stage.measure.figures import Played, worded
from statwalk.stage.measure.measured_ground import Spot

ORIGIN, STAIR = Spot(), Spot(0, 1.65, np.pi)
PLAIN = Played({"slide": np.array([0.01, 0.03])}, ["", ""], [0.0, 0.1], ["", ""], [0, 0], [ORIGIN, ORIGIN])
TWICE = Played({"slide": np.array([0.2])}, [""], [0.1], ["STOP"], [5], [STAIR])


def test_the_mean_is_of_the_phases_and_the_worst_of_all():
    figure = PLAIN.append(TWICE).figures()["slide"]
    assert figure.mean == pytest.approx(0.02)
    assert (figure.worst, figure.phase, figure.then, figure.ticks) == (0.2, 0.1, "STOP", 5)
    assert figure.place is STAIR


def test_what_was_not_measured_of_the_interrupted_does_not_count():
    plain = Played({**PLAIN.values, "half": np.array([0.1, 0.3])}, *list(vars(PLAIN).values())[1:])
    assert plain.append(TWICE).figures()["half"].worst == 0.3


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("slide", 0.8264, "826 mm"),
        ("jump", 1.2, "1.20 ×"),
        ("hand", 60.4, "60 m/s²"),
        ("half", 0.25, "0.25 s"),
        ("arrived", np.inf, "never"),
    ],
)
def test_figures_in_words(name, value, words):
    assert worded(name, value) == words
