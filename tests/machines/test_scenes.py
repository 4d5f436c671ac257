"""The shipped scenes, played: what touches what, and what comes of it."""

import subprocess
import sys

import khronos
import numpy as np
import pytest
from paths import MACHINES
from statwalk.errors import MachineError, UnknownNameError
from statwalk.files.gltf import read_model
from statwalk.machine.verify import verify
from statwalk.services.library.load import load, shipped_machines
from statwalk.services.library.load_scene import load_scene, shipped_scenes
from statwalk.stage.replay import replay

MADE = (
    "anchor-chain/anchor-chain.glb",
    "tree/tree.glb",
    "tentacle/tentacle.glb",
    "hand/hand.glb",
    "gearbox/gearbox.glb",
    "elbow/elbow.glb",
    "biceps/arms.glb",
    "face/face.glb",
    "car-face/car.glb",
    "principles/principles.glb",
    "playground/door/door.glb",
    "playground/coin/coin.glb",
    "playground/cannon/cannon.glb",
    "geese/goose/goose.glb",
    "swarm/bee/bee.glb",
)


class Played:
    """The playground with its actors by name, and the actions of each tick."""

    def __init__(self) -> None:
        self.stage = load_scene("playground").open()
        self.actor = {one.name: one for one in self.stage.actors}

    def until(self, action, most=1200):
        """The tick of the next action of that name."""
        for _ in range(most):
            self.stage.step()
            if any(one.name == action for one in self.stage.effects.actions):
                return self.stage.tick
        raise AssertionError(f"no {action} in {most} ticks")


@pytest.mark.parametrize("path", MADE)
def test_the_models_are_valid(path):
    assert khronos.errors((MACHINES / path).read_bytes()) == []


def test_there_are_five():
    assert shipped_scenes() == ["geese", "joints", "playground", "street", "swarm"]


def test_scenes_are_no_machines_but_their_machines_can_be_loaded():
    assert not {"playground", "geese", "joints", "street", "swarm"} & set(shipped_machines())
    assert load("playground.door").name == "playground.door"


def test_a_name_is_no_path():
    with pytest.raises(UnknownNameError):
        load("playground.door/../../faq-walker/machine")
    with pytest.raises(UnknownNameError):
        load_scene("../playground")


@pytest.mark.parametrize(
    "name",
    [
        "playground.walker",
        "playground.door",
        "playground.coin",
        "playground.cannon",
        "geese.goose",
        "street.walker",
        "street.stroller",
        "swarm.bee",
    ],
)
def test_the_verifier_finds_no_error_in_a_machine(name):
    role = load(name)
    assert [finding.message for finding in verify(role.definition) if finding.severity == "error"] == []


def test_the_door_opens_at_the_wire_and_closes_when_everybody_has_gone():
    played = Played()
    walker, door = played.actor["walker"], played.actor["door"]
    played.stage.hold(walker, "FORWARD")
    played.until("open")
    assert door.root.position[2] - walker.root.position[2] == pytest.approx(
        1.1 + 0.4, abs=0.1
    )  # the wire, and the walker's sphere
    assert door.state == "OPENING"
    played.stage.step(60)
    assert door.state == "OPEN"
    assert walker.root.position[2] < 4.2
    played.until("shut")
    assert walker.root.position[2] - 4.2 > 1.9 + 0.4  # beyond the sphere around the door
    assert door.state == "SHUT"


def test_a_coin_is_collected_once_and_comes_back():
    played = Played()
    coin = played.actor["coin 1"]
    played.stage.hold(played.actor["walker"], "FORWARD")
    tick = played.until("collect")
    assert coin.state == "TAKEN"
    played.stage.step(60)
    assert coin.state == "AWAY"
    assert not coin.pose.scale[1].any()
    played.stage.step(630 - (played.stage.tick - tick))
    assert coin.state == "BACK"
    played.stage.step(30)
    assert coin.state == "SPIN"


def test_the_ball_hits_between_two_ticks_and_the_walker_goes_down():
    played = Played()
    walker = load_scene("playground").lines[0][0]
    victim = played.stage.add(played.stage.role(walker.name), (0, 0, 8), 0.0, "victim")
    cannon = played.actor["cannon"]
    played.stage.send(played.actor["walker"], "CALL")
    assert played.until("fire") == 2
    tick = played.until("ouch")
    # 30 m/s from 0.55 m before the cannon at x = -5.5 to 0.53 m before the victim's middle: 4.42 m, in tick
    # 8.8, heard in the next
    assert tick == 2 + 10
    assert victim.state == "CRCH"
    assert cannon.states == ("HIT", "BURST")
    ball = cannon.world[cannon.role.character.skeleton.index("Ball")]
    assert abs(ball[0, 3]) < 0.5
    played.stage.step(60)
    assert cannon.states == ("LOAD", "WHOLE")


@pytest.mark.parametrize("z", [7.8, 8.0, 8.35])
def test_a_ball_that_has_burst_hits_nobody_on_its_way_back(z):
    """It is in the cannon again from one tick to the next; who stands between is not in its way."""
    played = Played()
    victim = played.stage.add(
        played.stage.role(load_scene("playground").lines[0][0].name), (0, 0, z), 0.0, "victim"
    )
    played.stage.send(played.actor["walker"], "CALL")
    played.until("ouch")
    for _ in range(150):
        played.stage.step()
        assert not [action for action in played.stage.frame.actions if action.name == "ouch"]
    assert victim.state == "STAT"


def test_a_ball_that_meets_nobody_flies_on():
    played = Played()
    played.until("fire")
    played.stage.step(30)
    assert played.actor["cannon"].state == "MISS"


def test_a_scene_is_replayed_bit_for_bit():
    played = Played()
    played.stage.hold(played.actor["walker"], "FORWARD")
    played.stage.step(130)
    assert replay(played.stage.dump(), lambda name, *_: load(name)).hash == played.stage.hash


def test_bees_stay_together_and_do_not_collide():
    stage = load_scene("swarm").open()
    stage.step(120)
    places = stage.casts[0].position
    away = np.linalg.norm(places[:, None] - places, axis=-1) + np.eye(len(places)) * 9
    assert np.ptp(places, axis=0).max() < 4
    assert away.min() > 0.05


def test_a_scene_of_ones_own(tmp_path):
    (tmp_path / "scene.yaml").write_text(
        "actors:\n  - {machine: faq-walker}\n  - {machine: faq-walker, position: [2, 0, 0]}\n"
    )
    stage = load_scene(tmp_path).open()
    assert [actor.role.name for actor in stage.actors] == ["faq-walker", "faq-walker"]


def test_a_machine_that_is_not_there_is_an_error_with_its_line(tmp_path):
    (tmp_path / "scene.yaml").write_text("actors:\n  - {machine: faq-woker}\n")
    with pytest.raises(
        MachineError, match=r"line 2: no machine is called 'faq-woker'; did you mean faq-walker"
    ):
        load_scene(tmp_path)


def test_a_character_of_a_machine_that_is_not_shipped(tmp_path):
    text = (MACHINES / "playground" / "walker" / "machine.yaml").read_text()
    (tmp_path / "machine.yaml").write_text(text.replace("character: faq-walker", "character: faq-wolker"))
    with pytest.raises(Exception, match="no shipped machine is called 'faq-wolker'; did you mean faq-walker"):
        load(tmp_path)


def arrays_of(path):
    """All numbers of a model: places at rest, and the values of its clips."""
    model = read_model(path.read_bytes(), "model", None)
    parts = [array for part in model.parts for array in (part.positions, part.normals, part.indices)]
    return [
        *model.bind_pose,
        *parts,
        *(channel.values for clip in model.clips.values() for channel in clip.channels),
    ]


def test_the_models_are_those_that_the_makers_make(tmp_path):
    subprocess.run([sys.executable, MACHINES / "make", tmp_path], check=True, capture_output=True)
    for path in MADE:
        for made, shipped in zip(arrays_of(tmp_path / path), arrays_of(MACHINES / path), strict=True):
            np.testing.assert_allclose(
                made, shipped, atol=1e-5
            )  # another processor's sine has other last bits
