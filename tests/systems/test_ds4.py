"""DS4 automatic rigging (RTCA 2.3.1; Baran and Popović 2007): new weights for the artist's joints move the
vertices nearly as the artist's do, and smooth weights are nearer to them than rigid ones where it counts.
"""

import pytest
import statwalk
from artist_weights import vertex_error
from paths import GLTF, needs_assets

WALKS = [
    ("CesiumMan.glb", "clip 0", 0.003, 0.05),
    ("M2M_fox.glb", "Walk", 0.007, 0.05),
    ("M2M_snake.glb", "Side winding", 0.004, 0.03),
    ("Quaternius_Fox.glb", "AnimalArmature|Walk", 0.007, 0.08),
]


@needs_assets
@pytest.mark.parametrize(("name", "clip", "mean", "worst"), WALKS)
def test_bone_heat_is_near_the_artists_weights(name: str, clip: str, mean: float, worst: float) -> None:
    artist = statwalk.load(GLTF / name)
    smooth, rigid = (vertex_error(artist, clip, weights) for weights in ("heat", "nearest"))
    assert smooth.mean < mean
    assert smooth.worst < worst
    assert smooth.worst < rigid.worst
