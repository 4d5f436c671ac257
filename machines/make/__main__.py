"""Makes the models of the scenes: `python machines/make [folder]` (needs the package)."""

import sys
from pathlib import Path

import anchor_chain
import bee
import cannon
import coin
import door
import gearbox
import goose
import hand
import joints
import principles
import tentacle
import tree

PLACES = {
    "playground/door/door.glb": door,
    "playground/coin/coin.glb": coin,
    "playground/cannon/cannon.glb": cannon,
    "gearbox/gearbox.glb": gearbox,
    "tree/tree.glb": tree,
    "tentacle/tentacle.glb": tentacle,
    "hand/hand.glb": hand,
    "principles/principles.glb": principles,
    "anchor-chain/anchor-chain.glb": anchor_chain,
    "geese/goose/goose.glb": goose,
    "swarm/bee/bee.glb": bee,
}

if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[1]
    for path, maker in PLACES.items():
        maker.make().write(folder / path)
    joints.make_all(folder)
