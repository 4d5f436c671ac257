"""Reads `digital_skin` of a character file (DS7): the name of a text file in its folder, or the text itself
as a `|` block.

    digital_skin: arm.skin.txt

`skin_text` makes the text of a character's digital skin.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from statwalk.character.character import Character
from statwalk.character.digital_skin import DigitalSkin, is_digital, with_digital_skin
from statwalk.errors import ContentError, TextError, UnknownNameError
from statwalk.files.faq.digital_skin_text import MOST_VERTICES, PLAIN, SkinText, read_digital_skin
from statwalk.files.faq.skeleton_text import read_text
from statwalk.files.yaml.yaml_text import Node
from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.primitive import Primitive
from statwalk.skin.shading import triangles

GAMMA = 2.2
"""of a colour as on a screen, as in the models that statwalk's scripts make"""


def with_skin_of(
    node: Node, character: Character, path_of: Callable[[Node], Path], scale: float = 1.0
) -> Character:
    """Returns the character with the digital skin that `node` names or holds, without a model.

    `path_of` finds the file that a value names; `scale`: metres for each unit of the text.

    :raises TextError: when the text is wrong, or a bone is none of the character's.
    """
    if "\n" in node.text():
        file, first_line = node.file, node.first_line - 1
        text = node.text()
    else:
        path = path_of(node)
        file, first_line, text = str(path), 0, read_text(path)
    try:
        return with_digital_skin(character, _skin(read_digital_skin(text), character, scale))
    except TextError as error:
        raise _moved(error, file, first_line) from None


def _moved(error: TextError, file: str, lines: int) -> TextError:
    """Returns the error with its file, and its place some lines further on."""
    number = error.place.removeprefix("line ")
    place = f"line {int(number) + lines}" if number.isdigit() else error.place
    return TextError(error.message, file=file, place=place)


def _skin(text: SkinText, character: Character, scale: float) -> DigitalSkin:
    joints: list[int] = []
    for name, place in zip(text.bones, text.places, strict=True):
        try:
            joints.append(character.skeleton.index(name))
        except UnknownNameError as error:
            raise TextError(str(error), place=place) from None
    light = {colour: _light(colour) for colour in set(text.colours)}
    colours = np.array([light[colour] for colour in text.colours])
    return DigitalSkin(joints, text.bone, text.positions * scale, colours, text.polygons)


def _light(colour: str) -> list[float]:
    """Returns red, green, blue as light of a colour #rrggbb as on a screen."""
    return [(int(colour[at : at + 2], 16) / 255) ** GAMMA for at in (1, 3, 5)]


def skin_text(character: Character, names: Sequence[str]) -> SkinText | None:
    """Returns the digital skin of a character as a text has it, for bones with the axes of the character at
    rest; `names` are the bones of its joints. None without a digital skin.

    :raises ContentError: when it has too many vertices.
    """
    shown = zip(character.parts, character.vertices(character.bind_pose), strict=True)
    pairs = [(part, posed.positions) for part, posed in shown if is_digital(character, part)]
    if not pairs:
        return None
    joints = np.concatenate([_joints(character, part) for part, _ in pairs])
    if len(joints) > MOST_VERTICES:
        raise ContentError(f"a digital skin may have at most {MOST_VERTICES:,} vertices, not {len(joints):,}")
    starts = character.world(character.bind_pose)[joints, :3, 3]
    used, bone = np.unique(joints, return_inverse=True)
    firsts = np.cumsum([0, *(len(positions) for _, positions in pairs)])
    polygons = [
        tuple(corner + first for corner in face)
        for (part, _), first in zip(pairs, firsts.tolist(), strict=False)
        for face in _faces(part)
    ]
    return SkinText(
        tuple(names[joint] for joint in used.tolist()),
        bone.reshape(-1),
        _short(np.concatenate([positions for _, positions in pairs]) - starts),
        tuple(colour for part, _ in pairs for colour in _colours(part)),
        tuple(polygons),
    )


def _short(numbers: Floats) -> Floats:
    """Returns the numbers with as few digits as 32-bit floats need."""
    return numbers.astype(np.float32).astype(str).astype(np.float64)


def _joints(character: Character, part: Primitive) -> Ints:
    """Returns (V,) the joint of each vertex."""
    assert part.skin is not None
    assert part.joints is not None
    assert part.weights is not None
    heaviest = part.weights.argmax(1)[:, None]
    return character.skins[part.skin].joints[np.take_along_axis(part.joints, heaviest, 1)[:, 0]]


def _faces(part: Primitive) -> list[list[int]]:
    order = np.arange(len(part.positions)) if part.indices is None else part.indices
    faces: list[list[int]] = triangles(order.astype(np.int64), part.mode).tolist()
    return [face for face in faces if len(set(face)) == len(face)]


def _colours(part: Primitive) -> list[str]:
    """Returns (V,) the colours as on a screen, #rrggbb."""
    if "COLOR_0" not in part.attributes:
        return [PLAIN] * len(part.positions)
    light: Floats = np.clip(part.attributes["COLOR_0"][:, :3].astype(np.float64), 0, 1)
    rows = np.rint(light ** (1 / GAMMA) * 255).astype(np.int64).tolist()
    return [f"#{red:02x}{green:02x}{blue:02x}" for red, green, blue in rows]
