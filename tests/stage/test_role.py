"""Roles cross-check character and machine once."""

import pytest
from builders import TABLE, role
from statwalk.errors import MachineError


def test_an_unknown_motion_names_its_line_and_the_nearest():
    with pytest.raises(MachineError, match=r"line 4: .*hopp.*did you mean hop"):
        role(table=TABLE.replace("HOP ", "HOPP"), root=None)


def test_an_unknown_root_joint_names_the_joints():
    with pytest.raises(MachineError, match=r"root: .*'hip'; did you mean hips.*chest"):
        role(root="hip")


def test_clips_stand_in_place_where_there_is_a_root():
    assert not role().motions[1].clip.sample(0.5).translation[0, [0, 2]].any()


def test_a_role_knows_whether_it_travels():
    assert role().travels
    assert not role(root=None).travels
