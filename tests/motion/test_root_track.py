import locked_arrays
from statwalk.motion.root_track import STANDING


def test_its_arrays_cannot_be_written():
    locked_arrays.check(STANDING)
