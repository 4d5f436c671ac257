"""Scene files: who stands where."""

import numpy as np
import pytest
from statwalk.errors import MachineError
from statwalk.files.scene import MOST_ACTORS, read_scene, strewn


def actors(text):
    return read_scene(f"actors:\n{text}").actors


def test_a_scene():
    scene = read_scene(
        "title: T\ndescription: D\nseed: 7\nactors:\n"
        "  - {machine: walker, position: [1, 2, 3], heading_deg: 90, name: Bob}",
        "park",
    )
    assert (scene.name, scene.title, scene.description, scene.seed) == ("park", "T", "D", 7)
    (bob,) = scene.actors
    assert (bob.machine, bob.heading_deg, bob.line) == ("walker", 90, 5)
    assert list(bob.places()) == [("Bob", (1, 2, 3))]


def test_several_are_strewn_evenly_within_the_spread():
    (bees,) = actors("  - {machine: bee, position: [10, 5, 0], count: 200, spread: [3, 1, 2]}")
    names, places = zip(*bees.places(), strict=True)
    assert (names[0], names[-1]) == ("bee 1", "bee 200")
    offsets = (np.array(places) - (10, 5, 0)) / (3, 1, 2)
    assert (np.abs(offsets) <= 1).all()
    assert np.abs(offsets.mean(0)).max() < 0.05
    octants = np.unique((offsets > 0) @ [1, 2, 4], return_counts=True)[1]
    assert octants.min() > 20


def test_a_single_number_spreads_on_the_level():
    (coins,) = actors("  - {machine: coin, count: 2, spread: 2}")
    assert [y for _, (_, y, _) in coins.places()] == [0, 0]


def test_the_first_of_many_stands_in_the_middle():
    assert strewn(0) == (0, 0, 0)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("  - {machin: walker}", "line 2: no key is called 'machin'; did you mean machine?"),
        ("  - {name: Bob}", "line 2: the key `machine` is missing"),
        ("  - {machine: ../../secret}", "line 2: '../../secret' is no name for the machine"),
        ("  - {machine: walker, count: 1.5}", "line 2: '1.5' is no whole number"),
        ("  - {machine: walker, count: -1}", "line 2: '-1' is not a finite number from 1"),
        ("  - {machine: walker, position: [0, 0]}", "line 2: three numbers are needed"),
        ("  - {machine: walker, position: [0, 0, inf]}", "line 2: 'inf' is not a finite number"),
        (
            "  - {machine: bee, count: 9999}\n  - {machine: bee, count: 9999}",
            f"the scene has 19,998 actors; at most {MOST_ACTORS:,} are allowed",
        ),
    ],
)
def test_what_is_wrong_is_said_with_its_line(text, message):
    with pytest.raises(MachineError, match=r"scene\.yaml") as error:
        actors(text)
    assert message in str(error.value)
