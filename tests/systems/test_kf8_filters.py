"""KF8 noise and spikes taken out of any clip: without a delay, across the seam of a loop, in every file."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import statwalk
from playing import role_of, text_of
from scipy.signal import butter, sosfiltfilt
from statwalk.errors import MachineError
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from text_character import from_text


def test_a_filter_is_scipys_without_delay_and_takes_spikes_out() -> None:
    times = np.arange(200) / 100
    calm = np.sin(2 * np.pi * times)
    noisy = calm + 0.2 * np.sin(2 * np.pi * 30 * times)
    values = np.stack([noisy, np.zeros(200), np.zeros(200)], -1)
    clip = Clip("c", (Channel(0, "translation", times, values),), times[-1], rest(2))
    found = statwalk.filtered(clip, low_pass=6).channels[0].values[:, 0]
    answer = sosfiltfilt(butter(2, 6, fs=100, output="sos"), noisy, padlen=50)
    assert np.abs(found - answer)[30:-30].max() < 1e-3
    assert np.abs(found - calm)[30:-30].max() < 0.03
    wild = values.copy()
    wild[57] += 5
    tame = statwalk.filtered(Clip("c", (Channel(0, "translation", times, wild),), 1.99, rest(2)), spikes=True)
    assert np.abs(tame.channels[0].values[57, 0] - noisy[57]) < 0.5


JITTER = """
clips:
  calm: {of: walk, loop: true, filter: {low_pass: 2}}
  tame: {of: walk, filter: {spikes: true}}
"""


def shaken(rate: int = 60) -> Clip:
    """A cycle of two seconds, once a second to and fro, with a tremor of 12 Hz."""
    times = np.arange(2 * rate + 1) / rate
    x = np.sin(np.pi * times) + 0.05 * np.sin(24 * np.pi * times)
    channel = Channel(0, "translation", times.astype(np.float32), np.stack([x, 0 * x, 0 * x], -1))
    return Clip("shaken", (channel,), 2.0, rest(2), loop=True)


def test_a_loop_is_filtered_across_its_seam() -> None:
    calm = statwalk.filtered(shaken(), low_pass=4)
    moments = np.arange(240) / 120
    x = calm.sample(moments, loop=True).translation[:, 0, 0]
    assert np.abs(x - np.sin(np.pi * moments)).max() < 0.01  # the tremor of 0.05 is gone, nothing is late
    around = np.concatenate([x, x[:2]])
    assert np.abs(np.diff(around, 2)).max() < 3 * (np.pi / 120) ** 2  # no corner, also not at the seam


def test_a_curve_is_filtered_and_a_held_key_stays() -> None:
    times = np.array([0, 0.5, 1, 1.5, 2], np.float32)
    values = np.array([[0, 0, 0], [1, 0, 0], [-1, 0, 0], [1, 0, 0], [0, 0, 0]], np.float32)
    curve = Channel(0, "translation", times, values, "BSPLINE_THROUGH")
    held = Channel(1, "scale", times, np.abs(values) + 1, "STEP")
    clip = Clip("c", (curve, held), 2.0, rest(2))
    calm = statwalk.filtered(clip, low_pass=0.5)
    moments = np.linspace(0, 2, 81)
    before, after = clip.sample(moments), calm.sample(moments)
    assert np.ptp(after.translation[:, 0, 0]) < 0.7 * np.ptp(before.translation[:, 0, 0])
    np.testing.assert_array_equal(after.scale[:, 1], before.scale[:, 1])


def test_any_clip_of_a_machine_is_filtered_by_its_file() -> None:
    role = role_of(text_of("state | GO\nSTAND | -", JITTER, "\nstates:\n  STAND: {motion: calm}\n"))
    source = role.character.clip("walk")
    wanted = statwalk.filtered(replace(source, loop=True), low_pass=2)
    moments = np.linspace(0, source.duration, 50)
    for made, own in zip(role.character.clip("calm").sample(moments), wanted.sample(moments), strict=True):
        np.testing.assert_array_equal(made, own)
    assert role.character.clip("tame").duration == source.duration


def test_a_character_file_filters_its_clips(tmp_path: Path) -> None:
    keys = "".join(f"#time {k / 30}\n#rotate Arm 0 0 {20 * (k % 2)}\n" for k in range(31))
    character = from_text(
        tmp_path,
        "Root --- - - - -\nArm Root 2 1 0 0\n",
        move=(keys, "filter: {low_pass: 3}}\n  raw: {of: move, filter: {spikes: false}"),
    )
    turns = character.clip("move").sample(np.linspace(0.2, 0.8, 60)).rotation[:, 1]
    angles = np.degrees(2 * np.arctan2(turns[:, 2], turns[:, 3]))
    assert np.abs(angles - 10).max() < 1


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("walks: {of: walk, filter: {low_pass: -1}}", "line 21: .*from 0 to 1000"),
        ("walks: {of: walk, filter: {low: 6}}", "line 21: .*low_pass"),
        ("walks: {of: walk, filter: {spikes: perhaps}}", "line 21: "),
    ],
)
def test_a_wrong_filter_is_refused_with_its_line(line: str, words: str) -> None:
    with pytest.raises(MachineError, match=words):
        role_of(text_of(more=f"clips:\n  {line}"))
