"""A parameter that is renamed, wherever the file speaks of it."""

import pytest
from edit_texts import DOOR, came
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import RenameCollider, RenameParameter

POINTED = """initial: A
parameters:
  aim: {kind: point}
  aiming: {default: 0, min: 0, max: 1}
states: {A: {motion: a, speed: aiming}}
table: |
  state | GO
  A     | A
cells: {A/GO: [{if: aim.x > aiming, to: A}]}
solvers: {aim: {solver: look-at, chain: [Head], target: aim, weight: {A: aiming}}}
colliders: {aim: {sphere: 1}}
senses: {GO: {touch: [aim, aim]}}
keys: {a: {change: {A: {aim.y: 1}}}}
"""


def test_conditions_blends_weights_keys_and_expressions_follow():
    assert came(RenameParameter("wind", "gust")) == [
        "  gust: {default: 0, min: 0, max: 1, smooth: 0.2}   # of the draught",
        "      over: gust",
        "    weight: gust",
        "  OPEN/PUSH:  [{if: gust > 0.5, to: SHUT}, {to: OPEN}]",
        "  w:       {change: {OPEN: {gust: 1}}}",
        "  Hinge.rotate_y = gust * 30 + pace",
    ]


def test_the_components_of_a_point_follow_and_other_names_stay():
    assert came(RenameParameter("aim", "gaze"), text=POINTED) == [
        "  gaze: {kind: point}",
        "cells: {A/GO: [{if: gaze.x > aiming, to: A}]}",
        "solvers: {aim: {solver: look-at, chain: [Head], target: gaze, weight: {A: aiming}}}",
        "keys: {a: {change: {A: {gaze.y: 1}}}}",
    ]


def test_the_own_collider_of_a_touch():
    assert came(RenameCollider("aim", "body"), text=POINTED) == [
        "colliders: {body: {sphere: 1}}",
        "senses: {GO: {touch: [body, aim]}}",
    ]


def test_a_name_that_is_taken():
    with pytest.raises(MachineError, match="height is measured"):
        edited(DOOR, [RenameParameter("wind", "height")])
    with pytest.raises(MachineError, match="there is a parameter pace already"):
        edited(DOOR, [RenameParameter("wind", "pace")])
