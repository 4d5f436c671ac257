"""Cycles by the names of frames, and names of frames that give the cycles back."""

import random
import string

import pytest
from statwalk.files.md2.md2_cycles import LONGEST_NAME, comes_round, cycles_of, frame_names


def counts(names: list[str]) -> dict[str, int]:
    return {cycle: len(frames) for cycle, frames in cycles_of(names).items()}


@pytest.mark.parametrize(
    ("names", "cycles"),
    [
        (["stand01", "stand02", "run1", "run2"], {"stand": 2, "run": 2}),
        (["pain101", "pain102", "pain201"], {"pain1": 2, "pain2": 1}),
        (["attack8", "attack9", "attack10", "pain101"], {"attack": 3, "pain1": 1}),
        ([f"idle{number:02}" for number in range(1, 121)], {"idle": 120}),
        (["walk001", "walk002"], {"walk": 2}),
        (["run1", "run3", "stand1", "run2"], {"run": 3, "stand": 1}),
        (["flag"], {"flag": 1}),
        (["", ""], {"cycle 0": 2}),
        (["run1", "2", "3"], {"run": 1, "cycle 1": 2}),
    ],
)
def test_frames_belong_to_a_cycle_by_the_beginning_of_their_names(names: list[str], cycles: dict) -> None:
    assert counts(names) == cycles


@pytest.mark.parametrize("name", ["stand", "run", "crwalk", "crstnd", "swim", "anything"])
def test_a_cycle_comes_round(name: str) -> None:
    assert comes_round(name)


@pytest.mark.parametrize("name", ["death1", "crdeath", "jump", "Attack", "crattak", "pain3", "wave"])
def test_what_quake_plays_once_ends_in_its_last_frame(name: str) -> None:
    assert not comes_round(name)


@pytest.mark.parametrize(
    "clips",
    [
        {"walk": 9, "run": 12},
        {"pain1": 4, "pain2": 4},
        {"take0": 3, "take": 3, "take 0": 3},
        {"a": 100, "a1": 5},
        {"CharacterArmature|Walk_Shoot": 20, "CharacterArmature|Walk": 20},
        {"": 3, "7": 2, "42": 2, "läuft schnell": 2},
        {"x": 1_024},
    ],
)
def test_names_of_frames_give_the_clips_back(clips: dict[str, int]) -> None:
    names = frame_names(clips)
    assert list(counts(names).values()) == list(clips.values())
    assert len(set(names)) == len(names)
    assert max(map(len, names)) <= LONGEST_NAME


def test_plain_names_stay() -> None:
    assert frame_names({"stand": 2, "pain1": 1}) == ["stand01", "stand02", "pain101"]


def test_names_of_any_clips_give_them_back() -> None:
    chance = random.Random(5)
    for _ in range(200):
        clips = {
            "".join(
                chance.choices("ab1209_" + string.ascii_letters, k=chance.randrange(1, 20))
            ): chance.randrange(1, 130)
            for _ in range(chance.randrange(1, 8))
        }
        assert list(counts(frame_names(clips)).values()) == list(clips.values())
