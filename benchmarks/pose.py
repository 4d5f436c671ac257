"""A pose of 67 joints from a clip, to world matrices, for 1, 100 and 1,000 actors; `python benchmarks/pose.py`.

three.js plays the same clip of the same file: its mixer and updateMatrixWorld, one actor after the other.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from models import figure
from rounds import Three, least, show
from statwalk.files.glb import read_model
from statwalk.rig.evaluate import world_from_local

ROUNDS = 15


def main() -> None:
    """Print the tables."""
    data = figure(100)
    character = read_model(data, "figure")
    clip = character.clip("clip 0")
    with tempfile.TemporaryDirectory() as folder, Three() as three:
        path = Path(folder) / "figure.glb"
        path.write_bytes(data)
        for actors in (1, 100, 1000):
            times = (0.37 * np.arange(actors)) % 1

            def ours(times: np.ndarray = times) -> None:
                world_from_local(character.skeleton, clip.sample(times))

            jobs = {"statwalk": ours, "three.js mixer + world": three.job("pose", path=str(path), actors=actors)}
            seconds = least(jobs, ROUNDS)
            show(f"pose of {actors} actors: ours {seconds['statwalk'] / actors * 1e6:.2f} us each", seconds)


if __name__ == "__main__":
    main()
