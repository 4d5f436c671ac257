"""Roles cross-check character and machine once."""

from dataclasses import replace

import pytest
from builders import TABLE, character, role
from playing import STATES, role_of, text_of
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.definition.cell_definition import CellDefinition

BLENDED = STATES.replace(
    "{motion: walk, loop: true, speed: pace, markers: {left-down: 0.5}}",
    "{motion: {over: pace, clips: {walk: 1, hop: 2}}, loop: true}",
)


def test_an_unknown_motion_names_its_line_and_the_nearest():
    with pytest.raises(MachineError, match=r"line 4: .*hopp.*did you mean hop"):
        role(table=TABLE.replace("HOP ", "HOPP"), root=None)


def test_an_unknown_root_joint_names_the_joints():
    with pytest.raises(MachineError, match=r"root: .*'hip'; did you mean hips.*chest"):
        role(root="hip")


def test_clips_stand_in_place_where_there_is_a_root():
    assert not role().motions[1].clip.sample(0.5).translation[0, [0, 2]].any()


def test_an_edit_that_leaves_the_motions_alone_keeps_their_tables():
    first = role_of(text_of())
    definition = replace(first.definition, cells={("STAND", "GO"): CellDefinition("HOP", 1)})
    second = Role.build("tiny", first.character, definition, "hips", before=first)
    assert second.tables is first.tables
    states = {**definition.states, "WALK": replace(definition.states["WALK"], motion="hop")}
    third = Role.build("tiny", first.character, replace(definition, states=states), "hips", before=first)
    assert third.tables is not first.tables
    assert third.tables.durations[1] == third.tables.durations[2] != first.tables.durations[1]


def test_a_blend_whose_clips_have_moved_gets_other_tables():
    first = role_of(text_of(states=BLENDED))
    again = Role.build("tiny", first.character, first.definition, "hips", before=first)
    assert again.tables is first.tables
    moved = read_machine(text_of(states=BLENDED.replace("hop: 2", "hop: 1.5")), "tiny")
    other = Role.build("tiny", first.character, moved, "hips", before=again)
    assert other.tables.bounds[1].tolist() == [1, 1.5, 0, 0]


def test_a_role_knows_whether_it_travels():
    assert role().travels
    assert not role(root=None).travels


def test_a_role_prints_on_one_line():
    assert repr(role()) == f"Role('tiny', 4 states, 5 events, {character()!r})"
