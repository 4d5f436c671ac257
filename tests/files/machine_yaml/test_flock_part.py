"""The `flock:` of a machine file."""

import pytest
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.flock_part import MOST_OBSTACLES, flock
from statwalk.files.yaml.yaml_text import parse
from statwalk.machine.definition.flock_definition import FlockDefinition, GoalDefinition, ObstacleDefinition

PARAMETERS = ("pace", "climb")


def read(text):
    return flock(parse(text, "machine.yaml", MachineError), PARAMETERS)


def test_nothing_said_is_no_flock():
    assert flock(None, PARAMETERS) is None


def test_all_that_can_be_said():
    assert read(
        "{distance: 2, reach: 15, sight_deg: 270, nearest: 6, strength: 3, min_speed: 1, max_speed: 14, "
        "max_acceleration: 12,"
        " max_turn_deg: 90, wander: 0.5, follow: 0.2, formation: {beside: 1.2, behind: 1.5},"
        " goal: {at: [0, 8, 0], radius: 25, seconds: 40},"
        " obstacles: [{sphere: 3, at: [5, 6, 0]}, {plane: [0, 2, 0], at: [0, 1, 0]}], avoid: [tower], "
        "speed_parameter: pace}"
    ) == FlockDefinition(
        line=1,
        distance=2,
        reach=15,
        sight_deg=270,
        nearest=6,
        strength=3,
        min_speed=1,
        max_speed=14,
        max_acceleration=12,
        max_turn_deg=90,
        wander=0.5,
        follow=0.2,
        formation=(1.2, 1.5),
        goal=GoalDefinition((0, 8, 0), 25, 40),
        obstacles=(
            ObstacleDefinition("sphere", (5, 6, 0), 3),
            ObstacleDefinition("plane", (0, 1, 0), normal=(0, 1, 0)),
        ),
        avoid=("tower",),
        sets={"speed": "pace"},
    )


def test_what_is_not_said_has_a_default():
    assert read("{distance: 2}") == FlockDefinition(line=1, distance=2)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{distanc: 2}", "no key is called 'distanc'; did you mean distance?"),
        ("{distance: 0}", "'0' is not a finite number from 0.001"),
        ("{nearest: 2.5}", "'2.5' is no whole number"),
        ("{nearest: 1000}", "from 1 to 32"),
        ("{speed_parameter: pase}", "no parameter is called 'pase'; did you mean pace?"),
        ("{min_speed: 7}", "min_speed is more than max_speed"),
        ("{max_speed: nan}", "'nan' is not a finite number"),
        ("{goal: {radius: 2}}", "the key `at` is missing"),
        (
            "{obstacles: [{at: [0, 0, 0]}]}",
            "an obstacle is either a `sphere: RADIUS` or a `plane: [x, y, z]`",
        ),
        ("{obstacles: [{plane: [0, 0, 0]}]}", "a plane needs a normal"),
        (
            f"{{obstacles: [{', '.join(['{sphere: 1}'] * 65)}]}}",
            f"a flock has at most {MOST_OBSTACLES} obstacles, not 65",
        ),
    ],
)
def test_what_is_wrong_is_said_with_its_line(text, message):
    with pytest.raises(MachineError, match=r"machine\.yaml, line 1") as error:
        read(text)
    assert message in str(error.value)
