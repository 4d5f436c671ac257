"""Makes the models of the scenes: `python machines/make [folder]` (needs the package)."""

import sys
from pathlib import Path

import anchor_chain
import bee
import biceps
import cannon
import car_face
import coin
import digital_arm
import door
import elbow
import face
import face_detail
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
    "car-face/car.glb": car_face,
    "face/face.glb": face,
    "gearbox/gearbox.glb": gearbox,
    "elbow/elbow.glb": elbow,
    "tree/tree.glb": tree,
    "tentacle/tentacle.glb": tentacle,
    "hand/hand.glb": hand,
    "biceps/arms.glb": biceps,
    "principles/principles.glb": principles,
    "anchor-chain/anchor-chain.glb": anchor_chain,
    "geese/goose/goose.glb": goose,
    "swarm/bee/bee.glb": bee,
}

if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[1]
    for path, maker in PLACES.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        maker.make().write(folder / path)
    face_detail.store(folder / "face")
    digital_arm.write(folder / "biceps" / "right-arm.skin.txt")
    joints.make_all(folder)
