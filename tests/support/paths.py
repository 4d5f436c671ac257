"""Where things are: the checkout, and the shared models with their ground truth (absent in a user's
clone).
"""

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
ASSETS = ROOT.parent / "shared" / "assets"
GLTF, GROUND_TRUTH = ASSETS / "gltf", ASSETS / "gt"
MACHINES = ROOT / "machines"

needs_assets = pytest.mark.skipif(
    not ASSETS.is_dir(), reason="the shared models are not beside this checkout"
)
