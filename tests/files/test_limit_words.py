"""Limits in words: what the reader of joints and limits makes of them is the same limit."""

import json
from pathlib import Path

import numpy as np
import pytest
from paths import MACHINES
from statwalk.errors import ModelError
from statwalk.files.joint_limits import joint_limits
from statwalk.files.limit_words import limits_in_words
from statwalk.files.yaml.yaml_text import parse

SHIPPED = sorted((MACHINES / "joints").glob("*/machine.yaml"))
MORE = """
joints:
  a: {type: spherical, axis: [0, -1, 0.2], side: [1, 0, 0], swing_x_deg: [-30, 80], swing_z_deg: [-20, 45]}
  b: {type: spherical, shape: range, swing_x_deg: [10, 80], twist_deg: [-5, 5]}
  c: {type: planar, order: RPP, slide_x: [-1, 2], slide_z: [0, 0.5], angle_deg: [-720, 720]}
  d: {type: helical, pitch: 0.02, angle_deg: [0, 3600]}
limits:
  e: {rotation_deg: [[-40, -70, -30], [40, 70, 30]], translation: [[0, -1, 0], [0, 2, 0]]}
  f: {rotation_deg: [[0, 0, 0], [0, 90, 0]]}
"""


def read(text: str):
    entries = parse(text, "", ModelError).entries()
    definitions = joint_limits(entries.get("joints"), entries.get("limits"))
    return {name: definition.limit for name, definition in definitions.items()}


def flat(limit) -> np.ndarray:
    slide = limit.slide or ((np.nan, np.nan),) * 3
    frame = np.array(limit.frame)
    return np.concatenate(
        [np.outer(frame, frame).reshape(-1), *limit.swing, *limit.angles, limit.twist, *slide, [limit.pitch]]
    )


@pytest.mark.parametrize("text", [*(path.read_text() for path in SHIPPED), MORE], ids=lambda text: text[:24])
def test_words_mean_the_same_limits(text: str) -> None:
    limits = read(text)
    again = read(json.dumps(limits_in_words(limits), indent=1))
    assert again.keys() == limits.keys() != set()
    for name, limit in limits.items():
        read_limit = again[name]
        assert (read_limit.kind, read_limit.type, read_limit.form) == (limit.kind, limit.type, limit.form)
        assert read_limit.order == limit.order
        np.testing.assert_allclose(flat(read_limit), flat(limit), atol=1e-12, err_msg=name)


def test_no_limits_are_no_words() -> None:
    assert limits_in_words({}) == {}


def test_the_shipped_joints_are_all_here() -> None:
    assert len(SHIPPED) == 9
    assert all(isinstance(path, Path) for path in SHIPPED)
