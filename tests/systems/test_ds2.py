"""DS2 inbetweening (RTCA 2.2, Listings 1 and 2): whole meshes with equal vertex counts are blended, forwards
in time, or switched; an event comes at the end of a cycle.
"""

from pathlib import Path

import numpy as np
import pytest
from md2_models import FACES, md2, units
from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.files.machine_yaml.new_machine import write_machine
from statwalk.files.md2 import read_md2
from statwalk.services.library.load import load
from statwalk.skin.morph import inbetween
from statwalk.stage.stage import Stage
from tiny_model import LIFTED, POSITIONS, document, glb


@pytest.fixture
def face(tmp_path: Path) -> Character:
    """A triangle with a target one metre along z, whose weight goes from 0 to 1 in a second."""
    root, binary = document()
    del root["skins"]
    root["nodes"] = [{"name": "face", "mesh": 0}]
    root["scenes"] = [{"nodes": [0]}]
    root["animations"][0]["channels"] = [{"sampler": 0, "target": {"node": 0, "path": "weights"}}]
    root["animations"][0]["samplers"] = [{"input": 7, "output": 7}]
    (tmp_path / "face.glb").write_bytes(glb(root, binary))
    return load(tmp_path / "face.glb")


@pytest.mark.parametrize("time", [0.0, 0.25, 0.5, 1.0])
def test_the_mesh_goes_from_one_shape_to_the_next(face: Character, time: float) -> None:
    start, end = POSITIONS, POSITIONS + LIFTED
    shown = face.vertices(face.clips["Bend"].sample(time))[0].positions
    assert shown == pytest.approx(start + time * (end - start))


@pytest.mark.parametrize("time", [0.0, 0.25, 1.0])
def test_the_listing_as_corrected_says_the_same(face: Character, time: float) -> None:
    shown = face.vertices(face.clips["Bend"].sample(time))[0].positions
    assert shown == pytest.approx(inbetween(POSITIONS, POSITIONS + LIFTED, time))


def test_without_weight_it_is_the_base(face: Character) -> None:
    pose = face.bind_pose._replace(weights=np.zeros(1, np.float32))
    assert np.array_equal(face.vertices(pose)[0].positions, POSITIONS)


INCH, STAND = 0.0254, (0, 1, 2, 0)
"""an inch in metres; the frames of the cycle stand, which comes round"""


def heights(frame: int) -> np.ndarray:
    """How far the corners (12,) of a frame of the hand-made MD2 are above the ground, in metres."""
    lowest = min(up for *_, up in units(0))
    return np.array([(units(frame)[corner][2] - lowest) * INCH for face in FACES for corner in face[::-1]])


def shown_heights(tetra: Character, pose) -> np.ndarray:
    return tetra.vertices(pose)[0].positions[tetra.parts[0].indices, 1]


@pytest.mark.parametrize("time", [0.0, 0.03, 0.05, 0.1, 0.17, 0.25, 0.3])
def test_the_frames_of_an_md2_are_blended_forwards(time: float) -> None:
    """Listing 1, with the fraction the right way round; the last frame leads to the first."""
    tetra = read_md2(md2(), "tetra")
    k, t = min(int(time * 10), 2), time * 10 - min(int(time * 10), 2)
    start, end = heights(STAND[k]), heights(STAND[k + 1])
    pose = tetra.clips["stand"].sample(time)
    assert shown_heights(tetra, pose) == pytest.approx(start + t * (end - start), abs=1e-6)


@pytest.mark.parametrize("time", [0.0, 0.03, 0.049, 0.051, 0.1, 0.149, 0.151, 0.24, 0.26, 0.3])
def test_the_frames_of_an_md2_are_switched_on_request(time: float) -> None:
    """Listing 2: the next frame if t > 0.5."""
    tetra = read_md2(md2(), "tetra", inbetween="switched")
    k = min(int(time * 10), 2)
    frame = STAND[k + 1] if time * 10 - k > 0.5 else STAND[k]
    pose = tetra.clips["stand"].sample(time)
    assert shown_heights(tetra, pose) == pytest.approx(heights(frame), abs=1e-6)


ACTION = "\ncells:\n  STAT/END: {to: STAT, action: lap}\n"
SWITCHED = "\nclips:\n  stiff: {of: stand, inbetween: switched}\n"


@pytest.fixture(params=["stand", "stiff"])
def machine(request: pytest.FixtureRequest, tmp_path: Path) -> Role:
    """What `statwalk new` makes of an MD2, with an action at the END of STAT; its cycle may be switched."""
    source = tmp_path / "tetra.md2"
    source.write_bytes(md2())
    tetra = load(source)
    assert isinstance(tetra, Character)
    file = write_machine(tetra, source, tmp_path / "tetra", copy=False) / "machine.yaml"
    text = file.read_text().replace("motion: stand,", f"motion: {request.param},")
    file.write_text(text + ACTION + SWITCHED)
    role = load(file.parent)
    assert isinstance(role, Role)
    return role


def test_an_event_comes_at_the_end_of_a_cycle(machine: Role) -> None:
    """A cycle of 0.3 s ends every 18 ticks; a jump of 0.1 s ends after 6, and END leads back to STAT."""
    stage = Stage(seed=1)
    actor = stage.add(machine)
    laps = []
    for tick in range(1, 61):
        stage.step(1)
        laps += [tick for action in stage.frame.actions if action.name == "lap"]
    assert np.diff(laps).tolist() == [18, 18]
    assert laps[0] in (18, 19)
    stage.send(actor, "JUMP")
    states = []
    for _ in range(10):
        stage.step(1)
        states.append(actor.state)
    assert states == ["JUMP"] * 6 + ["STAT"] * 4


def test_a_switched_cycle_of_a_machine_shows_frames_only(machine: Role) -> None:
    stage = Stage(seed=1)
    actor = stage.add(machine)
    shown = []
    for _ in range(36):
        stage.step(1)
        shown.append(shown_heights(machine.character, actor.pose))
    frames = np.array([heights(frame) for frame in range(3)])
    away = np.abs(np.array(shown)[:, None] - frames).max(-1).min(-1)
    assert machine.motions[0] is not None
    motion = machine.motions[0].members[0].clip.name
    assert (away < 1e-6).all() == (motion == "stiff")
