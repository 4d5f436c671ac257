"""The kinds of parts that a character may have, and the names of the parts that it has: what a file format
holds or loses.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from statwalk.character.character import Character
from statwalk.character.digital_skin import MATERIAL, is_digital
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.clamp_kinds import EULER
from statwalk.motion.clip import Channel, Clip
from statwalk.skin.primitive import TRIANGLES, Primitive

Names = tuple[str, ...]
UNIT = 1e-5
"""how far a scale may be from 1, or a rotation from none, and count as that"""
PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
BASIC = {"name", "emissiveFactor", "alphaMode", "baseColorFactor", "roughnessFactor"}
"""properties of a material that every format with materials holds; further ones are of glTF"""
TURNED_LIMITS = "limits of each axis of joints that are turned at rest"
SHAPED = ("POSITION", "NORMAL", "TEXCOORD_", "COLOR_")


def parts_of(character: Character) -> dict[str, Names]:
    """Returns the names of the parts that a character has, by the kinds of PARTS that it has."""
    parts = {kind: tuple(names_of(character)) for kind, names_of in PARTS.items()}
    return {kind: names for kind, names in parts.items() if names}


def _every(part: object) -> bool:  # noqa: ARG001 - the choice that leaves nothing out
    return True


def _meshes(character: Character, has: Callable[[Primitive], object] = _every) -> Names:
    """Returns the names of the joints that carry a primitive other than a digital skin, each once."""
    return _carrying(character, lambda part: has(part) and not is_digital(character, part))


def _carrying(character: Character, has: Callable[[Primitive], object]) -> Names:
    return tuple(dict.fromkeys(character.skeleton.names[part.joint] for part in character.parts if has(part)))


def _digital(character: Character) -> Names:
    """Returns the names of the bones with vertices of a digital skin."""
    skins = (
        character.skins[part.skin]
        for part in character.parts
        if part.skin is not None and is_digital(character, part)
    )
    joints = (joint for skin in skins for joint in skin.joints.tolist())
    return tuple(dict.fromkeys(character.skeleton.names[joint] for joint in joints))


def _skins(character: Character) -> Names:
    digital = {part.skin for part in character.parts if is_digital(character, part)}
    return tuple(skin.name or f"skin {row}" for row, skin in enumerate(character.skins) if row not in digital)


def _clips(character: Character, has: Callable[[Clip], object]) -> Names:
    return tuple(name for name, clip in character.clips.items() if has(clip))


def _keyed(character: Character, has: Callable[[Channel], object]) -> Names:
    """Returns the names of the clips that have a channel of a kind."""
    return _clips(character, lambda clip: any(has(channel) for channel in clip.channels))


def _materials(character: Character, has: Callable[[object], bool] = _every) -> Names:
    return tuple(
        str(material.get("name") or f"material {row}")
        for row, material in enumerate(character.materials)
        if has(material)
    )


def _has_texture(value: object) -> bool:
    if not isinstance(value, dict):
        return False
    return any(key.endswith("Texture") or _has_texture(below) for key, below in value.items())


def _has_further(material: Any) -> bool:
    factors = material.get("pbrMetallicRoughness", {})
    further = (material.keys() | factors.keys()) - BASIC - {"pbrMetallicRoughness"}
    if factors.get("metallicFactor", 1) == 0:
        further.discard("metallicFactor")
    return any(not _has_texture({key: {**material, **factors}[key]}) for key in further)


def _further_coordinates(character: Character) -> Names:
    return _meshes(character, lambda part: {"TEXCOORD_1", "COLOR_1"} & part.attributes.keys())


def _odd_names(character: Character) -> Iterable[str]:
    names = (*character.skeleton.names, *character.clips, *character.chains)
    return (name for name in names if not PLAIN.fullmatch(name))


def _with_attribute(character: Character, beginning: str) -> Names:
    return _meshes(character, lambda part: any(name.startswith(beginning) for name in part.attributes))


def _further_attributes(character: Character) -> Names:
    names = (name for part in character.parts for name in part.attributes if not name.startswith(SHAPED))
    return tuple(dict.fromkeys(names))


def _scaled(character: Character) -> Names:
    """Returns the names of the joints whose scale is not 1, at rest or in a clip."""
    names = character.skeleton.names
    scaled = set(np.flatnonzero((np.abs(character.bind_pose.scale - 1) > UNIT).any(-1)).tolist())
    for clip in character.clips.values():
        scaled |= {
            channel.joint
            for channel in clip.channels
            if channel.path == "scale" and _differs_from_one(channel)
        }
    return tuple(names[joint] for joint in sorted(scaled))


def _differs_from_one(channel: Channel) -> bool:
    keys = channel.values[:, 1] if channel.interpolation == "CUBICSPLINE" else channel.values
    return bool((np.abs(keys - 1) > UNIT).any())


def carriers(character: Character) -> frozenset[int]:
    """Returns the joints that only carry skinned meshes: they have no children and bend nothing, and
    their own transforms do not count.
    """
    bending = {int(joint) for skin in character.skins for joint in skin.joints}
    bare = {part.joint for part in character.parts if part.skin is None}
    skinned = {part.joint for part in character.parts if part.skin is not None}
    return frozenset(skinned - bare - bending - set(character.skeleton.parent.tolist()))


def _turned(character: Character) -> Names:
    """Returns the names of the joints that are turned at rest."""
    turned = np.flatnonzero(np.abs(character.bind_pose.rotation[:, 3]) < 1 - UNIT).tolist()
    left_out = carriers(character)
    return tuple(character.skeleton.names[joint] for joint in turned if joint not in left_out)


def axes_at_rest(character: Character) -> Floats:
    """Returns the rotations (J, 4) from the axes of the joints at rest to the axes of the character."""
    turns: Floats = np.zeros((len(character.skeleton), 4))
    for joint, parent in enumerate(character.skeleton.parent.tolist()):
        own = character.bind_pose.rotation[joint].astype(np.float64)
        turns[joint] = own if parent < 0 else quat.mul(turns[parent], own)
    return turns


def limits_about_turned_axes(character: Character) -> Names:
    """Returns the names of the joints with limits of each axis, whose axes are turned at rest."""
    turned = np.abs(axes_at_rest(character)[:, 3]) < 1 - UNIT
    return tuple(
        name
        for name, limit in character.limits.items()
        if limit.kind == EULER and turned[character.skeleton.index(name)]
    )


def _further_roots(character: Character) -> Names:
    left_out = carriers(character)
    roots = [
        joint for joint in np.flatnonzero(character.skeleton.parent < 0).tolist() if joint not in left_out
    ]
    return tuple(character.skeleton.names[joint] for joint in roots[1:])


def _marked(character: Character) -> Iterable[str]:
    return (marker.name for clip in character.clips.values() for marker in clip.markers)


PARTS: dict[str, Callable[[Character], Iterable[str]]] = {
    "meshes": _meshes,
    "lines and points": lambda character: _meshes(character, lambda part: part.mode != TRIANGLES),
    "skins": _skins,
    "digital skin": _digital,
    "morph targets": lambda character: _carrying(character, lambda part: part.target_positions is not None),
    "normals": lambda character: _meshes(character, lambda part: part.normals is not None),
    "texture coordinates": lambda character: _with_attribute(character, "TEXCOORD_"),
    "vertex colours": lambda character: _with_attribute(character, "COLOR_"),
    "further texture coordinates and colours": _further_coordinates,
    "further attributes of vertices": _further_attributes,
    "materials": lambda character: _materials(character, lambda material: material != MATERIAL),
    "textures": lambda character: _materials(character, _has_texture),
    "metal and further properties of materials": lambda character: _materials(character, _has_further),
    "clips": lambda character: character.clips,
    "clips after the first": lambda character: tuple(character.clips)[1:],
    "stepped keys": lambda character: _keyed(character, lambda channel: channel.interpolation == "STEP"),
    "keys with tangents": lambda character: _keyed(
        character, lambda channel: channel.interpolation == "CUBICSPLINE"
    ),
    "B-splines and NURBS": lambda character: _keyed(
        character, lambda channel: channel.interpolation.startswith(("BSPLINE", "NURBS"))
    ),
    "markers": _marked,
    "loops": lambda character: _clips(character, lambda clip: clip.loop),
    "scales of joints": _scaled,
    "own axes of joints": _turned,
    "further roots": _further_roots,
    "limits": lambda character: character.limits,
    TURNED_LIMITS: limits_about_turned_axes,
    "muscle bones": lambda character: sorted(character.skeleton.muscle_bones),
    "chains": lambda character: character.chains,
    "names of other characters than letters, digits and _": _odd_names,
    "bulges": lambda character: character.bulges,
    "muscles": lambda character: (*character.muscles, *character.faces),
    "expressions": lambda character: (line.text for line in character.expressions),
    "level of detail": lambda character: (f"{1000 * level.error:.3g} mm" for level in character.levels),
}
"""kind of part -> the names of the parts of that kind"""
EVERY_PART = frozenset(PARTS)
