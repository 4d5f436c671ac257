"""three.js as an independent reader of what statwalk writes."""

import json
import subprocess
from pathlib import Path

import numpy as np
from khronos import node
from where import ROOT

THREE = ROOT / "static" / "node_modules" / "three"
SCRIPT = Path(__file__).with_suffix(".mjs")


def vertices(*models: bytes, seconds: float = 0.0) -> list[np.ndarray]:
    """For each GLB the positions (V, 3) in the world of all its vertices, in three.js's order, that long into its first animation."""
    assert THREE.is_dir(), f"{THREE} is missing: `npm ci` in static/ brings it"
    framed = b"".join(len(model).to_bytes(4, "little") + model for model in models)
    result = subprocess.run([node(), str(SCRIPT), str(THREE), str(seconds)], input=framed, capture_output=True, check=True)
    return [np.array(found).reshape(-1, 3) for found in json.loads(result.stdout)]
