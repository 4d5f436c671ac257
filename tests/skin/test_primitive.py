import locked_arrays
import numpy as np
from statwalk.skin.primitive import Skin


def test_the_arrays_of_a_skin_cannot_be_written():
    locked_arrays.check(Skin("skin", np.arange(2, dtype=np.int32), np.zeros((2, 3, 4), np.float32)))
