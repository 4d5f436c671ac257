"""Feet and contacts of a role: corrected in the machine file, wrong names refused with their line."""

import pytest
from paths import MACHINES
from statwalk.errors import MachineError
from statwalk.services.library.load import load_role

FOLDER = MACHINES / "faq-walker"
TEXT = (FOLDER / "machine.yaml").read_text()


def role(more):
    return load_role(FOLDER, text=TEXT + more)


def test_contacts_are_corrected_by_foot_or_by_ankle():
    corrected = role("contacts: {walk: {left: [[0, 0.6]], Right.foot: [[0.5, 1.1]]}}\n")
    left, right = corrected.contacts["walk"].feet
    assert (left.planted, left.heel, right.ball) == (((0, 0.6),), ((0, 0.6),), ((0.5, 1.1),))
    assert corrected.contacts["stand"] == role("").contacts["stand"]


def test_feet_are_corrected():
    feet = role("feet: {left: {ankle: Left.lowerleg, knee: Left.upperleg, hip: Left.butt}}\n").feet
    assert [foot.name for foot in feet] == ["left", "right"]
    assert feet[0].knee + 1 == feet[0].ankle


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ("contacts: {wlk: {left: [[0, 1]]}}\n", "no clip is called 'wlk'; did you mean walk"),
        ("contacts: {walk: {lft: [[0, 1]]}}\n", "no foot is called 'lft'; did you mean left"),
        ("contacts: {walk: {left: [[0.6, 0.5]]}}\n", "a contact ends after it begins"),
        ("feet: {left: {ankle: Left.fot}}\n", "no joint is called 'Left.fot'; did you mean Left.foot"),
        ("feet: {left: {knee: Left.foot}}\n", "`ankle` is missing"),
    ],
)
def test_wrong_names_are_refused_with_their_line(more, words):
    with pytest.raises(MachineError, match=f"line {TEXT.count(chr(10)) + 1}.*{words}"):
        role(more)
