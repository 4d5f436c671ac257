"""Automatic rigging: how far vertices are from where the artist's weights put them, and the time for a large
mesh.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "support"))

import statwalk
from artist_weights import skinned, vertex_error
from paths import GLTF

WALKS = {
    "CesiumMan": "clip 0",
    "M2M_fox": "Walk",
    "M2M_snake": "Side winding",
    "Quaternius_Fox": "AnimalArmature|Walk",
    "RobotExpressive": "Walking",
    "Khronos_Fox": "Walk",
    "KayKit_Knight": "Walking_A",
    "Quaternius_PlatformerCharacter": "CharacterArmature|Walk",
}


def main() -> None:
    """Prints the table of docs/rigging.md."""
    print("| model (vertices, joints) | nearest bone, mean | largest | bone heat, mean | largest |")
    print("|---|---|---|---|---|")
    for name, clip in WALKS.items():
        character = skinned(statwalk.load(GLTF / f"{name}.glb"))
        count = sum(len(part.positions) for part in character.parts)
        joints = len({joint for skin in character.skins for joint in skin.joints.tolist()})
        cells = []
        for weights in ("nearest", "heat"):
            error = vertex_error(character, clip, weights)
            cells += [f"{error.mean:.2%}", f"{error.worst:.1%}"]
        print(f"| {name} ({count:,}, {joints}) | {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
