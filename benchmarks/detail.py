"""Measures levels of detail of the walker: `python benchmarks/detail.py`.

A coarser index is measured beside the plain way in NumPy: one collapse after the other in the whole index.
The time to find an order has no peer here: other programs simplify one shape, without poses and errors.
"""

from __future__ import annotations

from pathlib import Path
from time import process_time

import numpy as np
import statwalk
from rounds import least, show
from statwalk.character.character import Character
from statwalk.character.detail.find_detail import find_detail
from statwalk.maths.arrays import Ints
from statwalk.skin.detail.coarser import coarser_faces, faces_of
from statwalk.skin.primitive import Primitive

WALKER = Path(__file__).resolve().parents[1] / "machines" / "faq-walker" / "walker.glb"
ROUNDS, LEVEL = 10, 5


def main() -> None:
    """Prints the table of an index, and the processor time of an order."""
    walker = statwalk.load(WALKER)
    measure_index(walker, walker.levels[LEVEL - 1].steps)
    measure_order(walker)


def measure_index(walker: Character, steps: int) -> None:
    """Prints the time to make the index of one level, all parts together."""
    left = [len(coarser_faces(part, steps)) for part in walker.parts]
    assert [len(one_by_one(part, steps)) for part in walker.parts] == left
    jobs = {
        "statwalk": lambda: [coarser_faces(part, steps) for part in walker.parts] and None,
        "NumPy, one collapse after the other": lambda: (
            [one_by_one(part, steps) for part in walker.parts] and None
        ),
    }
    show(f"Index of level {LEVEL}, {sum(left):,} triangles", least(jobs, ROUNDS))


def one_by_one(part: Primitive, steps: int) -> Ints:
    """Returns the triangles (T,3) that are left when a loop makes each collapse in the whole index."""
    faces, order = faces_of(part).copy(), part.collapses
    assert order is not None
    for vertex, onto in zip(
        order.vertices[order.steps < steps], order.onto[order.steps < steps], strict=True
    ):
        faces[faces == vertex] = onto
    corners = np.unique(part.positions + np.float32(0), axis=0, return_inverse=True)[1].reshape(-1)[faces]
    left: Ints = faces[(corners != np.roll(corners, 1, axis=1)).all(1)]
    return left if len(left) else np.zeros((1, 3), np.int64)


def measure_order(walker: Character) -> None:
    """Prints the processor time to find the order, and to measure the errors of its levels."""
    start, measuring = process_time(), [0.0]

    def note(work: str, _share: float) -> None:
        if work == "measuring errors" and not measuring[0]:
            measuring[0] = process_time()

    found = find_detail(walker, note)
    end = process_time()
    print(
        f"Order of {sum(len(part.positions) for part in found.parts):,} vertices: "
        f"{measuring[0] - start:.1f} s of processor time; errors of {len(found.levels)} levels: "
        f"{end - measuring[0]:.1f} s"
    )


if __name__ == "__main__":
    main()
