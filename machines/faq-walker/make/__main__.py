"""Makes walker.glb: `python machines/faq-walker/make` (with the package and SciPy installed)."""

from pathlib import Path

from bake import write_glb
from mesh.body import make_body
from moves.motions import MOTIONS

if __name__ == "__main__":
    target = Path(__file__).resolve().parents[1] / "walker.glb"
    write_glb(target, make_body(), MOTIONS)
    print(f"{target.name}: {target.stat().st_size // 1024} KiB, {len(MOTIONS)} motions")
