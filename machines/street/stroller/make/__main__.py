"""Makes stroller.glb, a woman on the walker's bones: `python machines/street/stroller/make [target]` (as
faq-walker's).
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parents[2] / "faq-walker" / "make"))

from bake import write_glb  # noqa: E402
from mesh.body import make_body  # noqa: E402
from mesh.build import STROLLER  # noqa: E402
from moves.curve import CURVE_LEFT, CURVE_RIGHT  # noqa: E402
from moves.stand import STAND  # noqa: E402
from moves.start import START_WALK  # noqa: E402
from moves.stop import NOT_GONE, SHORT_STOPS, STOPS  # noqa: E402
from moves.turn import TURN_LEFT, TURN_RIGHT  # noqa: E402
from moves.walk import WALK  # noqa: E402

TURNS = [TURN_LEFT, TURN_RIGHT, CURVE_LEFT, CURVE_RIGHT]
MOTIONS = [STAND, START_WALK, WALK, *STOPS, *SHORT_STOPS, NOT_GONE, *TURNS]

if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE.parent / "stroller.glb"
    write_glb(target, make_body(STROLLER), MOTIONS)
    print(f"{target.name}: {target.stat().st_size // 1024} KiB, {len(MOTIONS)} motions")
