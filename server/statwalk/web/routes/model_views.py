"""The API's view of what is in the model of a character."""

from __future__ import annotations

from typing import NamedTuple

from statwalk.character.character import Character
from statwalk.files.model_facts import ImageFacts, ModelFacts, model_facts, target_names, triangles
from statwalk.skin.primitive import Primitive
from statwalk.web.schemas.character import MaterialView, PartView, TextureView


class ModelViews(NamedTuple):
    """The members of a character's view that tell of its model."""

    parts: list[PartView]
    vertices: int
    triangles: int
    materials: list[MaterialView]
    textures: list[TextureView]


def model_views(character: Character) -> ModelViews:
    """Returns the views of the parts, materials and textures of a character's model."""
    facts = model_facts(character)
    parts = [_part(character, part, facts) for part in character.parts]
    return ModelViews(
        parts,
        sum(part.vertices for part in parts),
        sum(part.triangles for part in parts),
        [MaterialView(**material._asdict()) for material in facts.materials],
        [_texture(image) for image in facts.images],
    )


def _part(character: Character, part: Primitive, facts: ModelFacts) -> PartView:
    return PartView(
        node=part.node,
        mesh=part.mesh,
        primitive=part.primitive,
        name=facts.mesh_names.get(part.mesh) or character.skeleton.names[part.joint],
        vertices=len(part.positions),
        triangles=triangles(part),
        material=part.material,
        skinned=part.skin is not None,
        targets=target_names(character, part),
    )


def _texture(image: ImageFacts) -> TextureView:
    width, height = image.size or (None, None)
    return TextureView(name=image.name, type=image.type, bytes=image.bytes, width=width, height=height)
