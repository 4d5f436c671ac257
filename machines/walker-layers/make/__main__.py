"""Makes walker.glb, the FAQ's walker with a run, gestures, and the muscles of machines/face:
`python machines/walker-layers/make [target]` (as faq-walker's).
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parents[1] / "faq-walker" / "make"))

from bake import write_glb  # noqa: E402
from gestures import GESTURES  # noqa: E402
from mesh.body import make_body  # noqa: E402
from moves.stand import STAND  # noqa: E402
from moves.start import START_WALK  # noqa: E402
from moves.stop import NOT_GONE, SHORT_STOPS, STOPS  # noqa: E402
from moves.walk import WALK  # noqa: E402
from muscles import with_the_face  # noqa: E402
from run import RUN  # noqa: E402

MOTIONS = [STAND, START_WALK, WALK, RUN, *STOPS, *SHORT_STOPS, NOT_GONE, *GESTURES]

if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE.parent / "walker.glb"
    write_glb(target, make_body(), MOTIONS)
    with_the_face(target)
    print(f"{target.name}: {target.stat().st_size // 1024} KiB, {len(MOTIONS)} motions")
