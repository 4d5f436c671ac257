"""The walker in layers: a run that stands on its feet, feet in step between walk and run, and an arm that
waves whatever the legs do.
"""

import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from paths import MACHINES
from sole_points import part_of, sides_of, slides, soles_of
from statwalk.files.gltf import read_model
from statwalk.services.library.load import load_role
from statwalk.stage.stage import Stage

FOLDER = MACHINES / "walker-layers"
ROLE = load_role(FOLDER)
WALKER = ROLE.character
JOINT = {name: row for row, name in enumerate(WALKER.skeleton.names)}
ARM = [JOINT[f"Right.{bone}"] for bone in ("shoulder", "upperarm", "lowerarm", "hand")]
SPEEDS = (1.28, 1.6, 2.04, 2.4, 2.8)


@cache
def moving(speed: float) -> tuple[dict[str, np.ndarray], list[set[str]], float]:
    """A hundred ticks at a speed: the soles on the stage (F, V, 3), the steps that are heard, metres a
    second.
    """
    stage = Stage()
    actor = stage.add(ROLE)
    stage.hold(actor, "GO")
    stage.set(actor, "speed", speed)
    stage.step(150)
    points, heard, begin = [], [], actor.root.position[2]
    for _ in range(100):
        stage.step()
        points.append(actor.vertices()[part_of(WALKER)].positions)
        heard.append({str(one.arguments[0]) for one in stage.frame.actions})
    return sides_of(WALKER, np.array(points, float)), heard, float(actor.root.position[2] - begin) * 0.6


def test_a_run_has_two_flights() -> None:
    soles = soles_of(WALKER, WALKER.clips["run"])
    flies = np.min([points[..., 1].min(1) for points in soles.values()], 0) > 0.01
    assert np.count_nonzero(np.diff(flies.astype(int)) == 1) == 2


@pytest.mark.parametrize("name", ["run", "wave", "nod"])
def test_planted_feet_do_not_slide(name: str) -> None:
    soles = soles_of(WALKER, WALKER.clips[name])
    assert max(slide for points in soles.values() for slide in slides(points)) < 0.010
    assert min(points[..., 1].min() for points in soles.values()) > -0.005


@pytest.mark.parametrize("name", ["run", "wave", "nod"])
def test_no_joint_jerks(name: str) -> None:
    clip = WALKER.clips[name]
    path = np.array(
        [WALKER.world(clip.sample(time))[:, :3, 3] for time in np.arange(0, clip.duration, 1 / 60)], float
    )
    assert np.linalg.norm(np.diff(path, 2, axis=0), axis=-1).max() * 3600 < 125


@pytest.mark.parametrize("speed", SPEEDS)
def test_between_walk_and_run_feet_stay_as_well_as_they_can_without_a_solver(speed: float) -> None:
    soles, _, _ = moving(speed)
    assert max(slide for points in soles.values() for slide in slides(points)) < 0.030
    assert min(points[..., 1].min() for points in soles.values()) > -0.022


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("side", ["Left", "Right"])
def test_a_step_is_heard_when_the_foot_comes_down(speed: float, side: str) -> None:
    """The sole comes within 6 mm of the ground at most two ticks before."""
    soles, heard, _ = moving(speed)
    low = soles[side][..., 1].min(1) < 0.006
    touches = np.flatnonzero(low[1:-2] & ~low[:-3]) + 1
    assert len(touches)
    for tick in touches:
        assert any(side.lower() in heard[later] for later in (tick, tick + 1, tick + 2))


@pytest.mark.parametrize(
    ("speed", "expected"), [(1.28, 1.34 / 1.05), (2.04, 1.68 / 0.885), (2.8, 2.02 / 0.72)]
)
def test_it_goes_its_mean_stride_in_its_mean_lap(speed: float, expected: float) -> None:
    assert moving(speed)[2] == pytest.approx(expected, rel=0.01)


def test_waving_moves_the_right_arm_and_nothing_else() -> None:
    stage = Stage()
    waving, other = stage.add(ROLE), stage.add(ROLE)
    for actor in (waving, other):
        stage.hold(actor, "GO")
    stage.step(90)
    stage.send(waving, "WAVE")
    stage.step(60)
    differs = np.flatnonzero((waving.pose.rotation != other.pose.rotation).any(1))
    assert differs.tolist() == ARM


def test_the_hand_is_up_while_he_runs() -> None:
    stage = Stage()
    actor = stage.add(ROLE)
    stage.hold(actor, "GO")
    stage.set(actor, "speed", 2.8)
    stage.step(90)
    stage.send(actor, "WAVE")
    stage.step(60)
    assert actor.states == ("MOVE", "WAVE", "CALM", "NEUTRAL")
    assert actor.world[JOINT["Right.hand"], 1, 3] > actor.world[JOINT["Head"], 1, 3] + 0.1


def test_from_the_walk_to_the_run_the_same_foot_goes_on() -> None:
    stage = Stage()
    actor = stage.add(ROLE)
    stage.hold(actor, "GO")
    stage.step(100)
    phase = stage.frame.casts[0].phase[0, 0]
    stage.send(actor, "HURRY")
    stage.step()
    assert actor.state == "RUN"
    assert stage.frame.casts[0].phase[0, 0] == pytest.approx(phase + 1 / 63, abs=1e-6)


def test_the_kept_script_makes_the_shipped_file(tmp_path: Path) -> None:
    target = tmp_path / "walker.glb"
    subprocess.run([sys.executable, FOLDER / "make", target], check=True, capture_output=True)
    made = read_model(target.read_bytes(), "walker", None)
    for name, clip in made.clips.items():
        for time in np.linspace(0.0, clip.duration, 5):
            assert made.world(clip.sample(float(time))) == pytest.approx(
                WALKER.world(WALKER.clips[name].sample(float(time))), abs=1e-4
            )


def test_the_walker_smiles_while_walking():
    smiling, calm = Stage(), Stage()
    walkers = [stage.add(ROLE) for stage in (smiling, calm)]
    for stage, walker in zip((smiling, calm), walkers, strict=True):
        stage.hold(walker, "GO")
        stage.step(60)
    smiling.send(walkers[0], "SMILE")
    for stage in (smiling, calm):
        stage.step(40)
    first, second = (walker.pose for walker in walkers)
    (corner,) = WALKER.targets["corner.left"]
    assert first.weights[corner] == pytest.approx(WALKER.faces["smile"]["corner.left"], abs=1e-5)
    assert not second.weights.any()
    np.testing.assert_array_equal(first.rotation, second.rotation)
