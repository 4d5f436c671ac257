"""The tree grows by the lengths of its bones (FAQ Q12): ends worked out by hand through the growth."""

import numpy as np
import pytest
import statwalk

ROLE = statwalk.load("tree")
TREE = ROLE.character
NAMES = list(TREE.skeleton.names)
PARENT = [NAMES[row] if row >= 0 else "" for row in TREE.skeleton.parent]
GROW = TREE.clips["grow"]
BONES = [name for name in NAMES if f"{name}.girth" in NAMES]
TIPS = [name.removesuffix(".end") for name in NAMES if name.endswith(".end")]
TRUNK = {"trunk1": (0.0, 0.5), "trunk2": (0.84, 0.46), "trunk3": (1.68, 0.4)}
"""when each begins, seconds: after 0.7 of the 1.2 s in which its parent grows; and its length, metres"""


def places(clip: str, time: float) -> dict[str, np.ndarray]:
    worlds = TREE.world(TREE.clips[clip].sample(time))
    return dict(zip(NAMES, worlds[:, :3, 3], strict=True))


def length(bone: str, at: dict[str, np.ndarray]) -> float:
    ends = [name for name, above in zip(NAMES, PARENT, strict=True) if above == bone and ".girth" not in name]
    return float(np.linalg.norm(at[ends[0]] - at[bone]))


@pytest.mark.parametrize("time", [0.0, 0.6, 1.2, 1.5, 2.0, 2.9])
def test_the_trunk_is_as_long_as_worked_out_by_hand(time):
    at, end = places("grow", time), np.array([0.0, 0.04, 0.0])
    for name, (begin, full) in TRUNK.items():
        np.testing.assert_allclose(at[name], end, atol=0.002)  # keys ten times a second
        x = min(max((time - begin) / 1.2, 0.0), 1.0)
        lean = {"trunk1": (0.03, 1, 0.0), "trunk2": (-0.06, 1, 0.05), "trunk3": (0.05, 1, -0.07)}[name]
        end = end + np.array(lean) / np.linalg.norm(lean) * full * x * x * (3 - 2 * x)
        assert length(name, at) == pytest.approx(full * x * x * (3 - 2 * x), abs=0.002)


def test_a_seed_has_no_length_and_the_grown_tree_all():
    seed, grown = places("grow", 0.0), places("grow", GROW.duration)
    rest = dict(zip(NAMES, TREE.world(TREE.bind_pose)[:, :3, 3], strict=True))
    for bone in BONES:
        assert length(bone, seed) == 0
        np.testing.assert_allclose(grown[bone], rest[bone], atol=1e-6)
    assert 2.0 < max(grown[f"{tip}.end"][1] for tip in TIPS) < 3.2


def test_branches_wait_for_their_parent_and_leaves_for_their_twig():
    for time in np.linspace(0, GROW.duration, 40):
        at, sizes = places("grow", time), GROW.sample(float(time)).scale
        for bone in BONES:
            above = PARENT[NAMES.index(bone)]
            if bone.startswith("bough") and "." not in bone and length(bone, at) > 0.01:
                assert length(above, at) == pytest.approx(length(above, places("grow", 7.76)), abs=1e-5)
        for tip in TIPS:
            if length(tip, at) == 0:
                assert sizes[NAMES.index(f"{tip}.leaves")].max() < 0.01


def test_bones_only_grow():
    lengths = np.array(
        [[length(bone, places("grow", time)) for bone in BONES] for time in np.linspace(0, GROW.duration, 40)]
    )
    assert np.diff(lengths, axis=0).min() > -1e-6


def test_the_life_of_the_tree_on_the_stage():
    stage = statwalk.Stage(seed=1)
    actor = stage.add(ROLE)
    stage.set(actor, "wind", 0.0)
    stage.step(90)
    end = NAMES.index("top1.end")
    seen, heights = [actor.state], [actor.world[end, 1, 3]]
    stage.send(actor, "GROW")
    for tick in range(1100):
        if tick == 600:
            stage.send(actor, "WITHER")
        stage.step(1)
        heights.append(actor.world[end, 1, 3])
        if actor.state != seen[-1]:
            seen.append(actor.state)
    assert seen == ["SEED", "GROWING", "GROWN", "WITHER", "SEED"]
    rest = TREE.world(TREE.bind_pose)[end, 1, 3]
    assert (heights[0], heights[590], heights[-1]) == pytest.approx((0.04, rest, 0.04), abs=1e-3)
    assert np.abs(np.diff(heights)).max() < 0.03  # no jump: 1.8 m a second


def test_the_wind_moves_the_grown_tree_and_no_length():
    stage = statwalk.Stage(seed=1)
    actor = stage.add(ROLE)
    stage.set(actor, "wind", 1.0)
    stage.send(actor, "GROW")
    stage.step(560)
    before = actor.world[:, :3, 3]
    stage.step(40)
    after = actor.world[:, :3, 3]
    assert np.linalg.norm(after - before, axis=1).max() > 0.02
    for bone in BONES:
        one, two = (length(bone, dict(zip(NAMES, places, strict=True))) for places in (before, after))
        assert one == pytest.approx(two, abs=1e-5)
