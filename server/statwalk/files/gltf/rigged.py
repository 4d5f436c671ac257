"""A rigged character with its model: what Python, the shell, REST and the page write."""

from __future__ import annotations

from dataclasses import replace

from statwalk.character.autorig.autorig import Progress
from statwalk.character.autorig.wish import Facing, SkeletonKind
from statwalk.character.character import Character
from statwalk.files.gltf.add_skin import model_with_skin
from statwalk.skin.binding.bind_surface import Weighting


def rigged(
    character: Character,
    skeleton: SkeletonKind = "parts",
    weights: Weighting = "heat",
    facing: Facing = "+z",
    progress: Progress = lambda _work, _share: None,
) -> Character:
    """Returns the character with a skin that statwalk makes (`Character.autorig`), and with its .glb.

    :raises ContentError: when the model cannot be rigged.
    """
    made = character.autorig(skeleton, weights, facing, progress)
    return replace(made, model_glb=model_with_skin(made))
