"""Measures eight morph targets of 10,000 vertices, and the in-between of two meshes: `python
benchmarks/morph.py`.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from models import figure
from rounds import Three, least, show
from statwalk.files.gltf import read_model
from statwalk.skin.morph import inbetween

ROUNDS, VERTICES, TARGETS = 40, 10_000, 8


def main() -> None:
    """Prints the tables."""
    data = figure(VERTICES, TARGETS)
    character = read_model(data, "figure")
    part, surface = character.parts[0], character.surface
    assert part.target_positions is not None
    weights = np.linspace(0.1, 0.8, TARGETS).astype(np.float32)
    flat, base = part.target_positions.reshape(TARGETS, -1), part.positions.reshape(-1)
    end = base + flat[0]

    def statwalk_job(weights: np.ndarray) -> None:
        surface.blocks.vertices[0].posed(weights)

    out = np.empty_like(base)

    def lerp() -> None:
        np.subtract(end, base, out=out)
        np.multiply(out, np.float32(0.3), out=out)
        np.add(out, base, out=out)

    with tempfile.TemporaryDirectory() as folder, Three() as three:
        path = Path(folder) / "figure.glb"
        path.write_bytes(data)
        seconds = least(
            {
                "statwalk": lambda: statwalk_job(weights),
                "NumPy w @ D": lambda: (base + weights @ flat) is None or None,
                "three.js getVertexPosition + skin": three.job("morph", path=str(path)),
            },
            ROUNDS,
        )
    show(
        f"morph {TARGETS} x {VERTICES}: {seconds['statwalk'] / VERTICES * 1e9:.2f} ns a vertex",
        seconds,
        {"NumPy w @ D": 1.2},
    )
    seconds = least(
        {"statwalk": lambda: inbetween(base, end, 0.3, out) is None or None, "NumPy, in place": lerp},
        10 * ROUNDS,
    )
    show(f"in-between of {VERTICES} vertices", seconds, {"NumPy, in place": 2.5})


if __name__ == "__main__":
    main()
