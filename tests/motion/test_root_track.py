import locked_arrays
import numpy as np
from statwalk.motion.root_track import STANDING, RootTrack, moving

TURN = RootTrack(np.array([0.0, 0.5, 2.0]), np.array([[0, 0, 0], [1, 0, 0.5], [1, 2, 1.0]]))


def test_its_arrays_cannot_be_written():
    locked_arrays.check(STANDING)


def test_a_motion_that_stood_goes_straight_on():
    assert moving(STANDING, 4.0, (0.5, -1)).at(np.array([1.0, 4.0])).tolist() == [[0.5, -1, 0], [2, -4, 0]]


def test_a_way_is_added_and_no_turn():
    more = moving(TURN, 2.0, (3, 1)).at(TURN.times) - TURN.places
    assert more.tolist() == [[0, 0, 0], [1.5, 0.5, 0], [6, 2, 0]]
