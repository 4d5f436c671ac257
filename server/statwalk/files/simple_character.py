"""A character for machines that have none yet: the FAQ's mammal at rest, each bone a tetrahedron."""

from __future__ import annotations

from dataclasses import replace

from statwalk.character.character import Character
from statwalk.files.bone_character import bone_character
from statwalk.files.faq.skeleton_text import shipped_skeleton
from statwalk.files.gltf import write

NAME = "mammal"
METRES = 0.08
"""for each unit of the skeleton: 22 units from sole to crown"""


def simple_character() -> Character:
    """Returns the mammal, without clips; it stands on the ground."""
    character, _ = bone_character(NAME, shipped_skeleton(NAME), METRES, ())
    soles = min(part.positions[:, 1].min() for part in character.vertices(character.bind_pose))
    standing = character.bind_pose.copy()
    standing.translation[0, 1] -= soles
    character = replace(character, bind_pose=standing)
    return replace(character, model_glb=write.model_glb(character))
