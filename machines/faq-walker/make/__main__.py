"""Makes walker.glb: `python machines/faq-walker/make [target]` (needs the package and the development tools,
for SciPy).
"""

import sys
from pathlib import Path

from bake import write_glb
from mesh.body import make_body
from moves.motions import MOTIONS

if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[1] / "walker.glb"
    write_glb(target, make_body(), MOTIONS)
    print(f"{target.name}: {target.stat().st_size // 1024} KiB, {len(MOTIONS)} motions")
