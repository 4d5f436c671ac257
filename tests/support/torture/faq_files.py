"""Mutations of the FAQ's texts: skeleton table, key frames, digital skin, table of constraints, and the
character file that names them. Each is loaded with the others as they should be.
"""

import re
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from statwalk.files.character_yaml import load_character
from torture.mutator import Mutator
from torture.outcomes import outcome
from torture.text_changes import deepen, rename, text_changes

SKELETON = """\
Bone            Parent            Length        Direction
---------------------------------------------------------
Root            ---               -             -  -  -
# the trunk
Back            Root              5             0  1  0
Upper.arm       Back              3             1  0  0
Lower.arm       Upper.arm         2.5           1  0.5  0
Leg             Root              6             0 -1  0
"""
KEYS = """\
#time 0
#rotate Upper.arm 0 10 0
#translate Root 0 0.3 0
#length Lower.arm 2.5
#matrix Leg
1 0 0 0
0 0 -1 0.5
0 1 0 0
0 0 0 1
#time 0.5
#rotate Upper.arm 0 -30 20.5
#weight Upper.arm 2
#translate Root 0 0.1 0
#length Lower.arm 3
#time 1.25
#rotate Upper.arm 400 10 1e-3
#rotate Leg 45 0 0
"""
SKIN = """\
# a bar: two squares, and the glue between them
#vertices Upper.arm #d9a184
0 -0.1 0
2 -0.1 0
2 0.1 0
0 0.1 0
#vertices Lower.arm
0.1 -0.1 0
3 -0.1 0
3 0.1 0
0.1 0.1 0
#polygons
0 1 2 3
1 4 7 2
4 5 6 7
"""
CONSTRAINTS = """\
#name          rotation min max        translation min max
------------------------------------------------------------------
Upper.arm  -10 -45 0   0 45 0        0 0 0      0 0 0
Leg        -90 -45 -10   60 45 10        0 0 0      0 0.5 0
"""
CHARACTER = """\
name: odd
skeleton: skeleton.txt
scale: 0.08
digital_skin: skin.txt
skinning: dual-quaternion
limits: limits.txt
joints:
  Lower.arm: {type: revolute, form: hinge, axis: [0, 0, 1], angle_deg: [0, 150]}
muscle_bones: [Leg, Leg.end]
clips:
  bend: {keys: keys.txt, interpolation: {rotation: nurbs, translation: linear}, loop: true}
  again: {keys: keys.txt, interpolation: slerp}
expressions: |
  half = Upper.arm.rotate_z / 2
  Lower.arm.rotate_z = half
bulges:
  biceps: {angle: Lower.arm.rotate_z, cubic: [1, 0.001, 0.00002, 0], bone: Upper.arm, point: [0.1, 0, 0],
           axis: [0, 1, 0], radius: [0.2, 0.2, 0.2]}
"""
TEXTS = {
    "skeleton.txt": SKELETON,
    "keys.txt": KEYS,
    "skin.txt": SKIN,
    "limits.txt": CONSTRAINTS,
    "character.yaml": CHARACTER,
}
PIECE, YAML_PIECE = re.compile(rb"[^\s]+"), re.compile(rb"[\w.#]+|[{}\[\]:,|]")
BONES = [b"Root", b"Back", b"Upper.arm", b"Lower.arm", b"Leg", b"Leg.end"]
COMMANDS = b"#time #rotate #translate #length #matrix #weight #vertices #polygons #ff0000 #name".split()
YAML_WORDS = (
    b"clips scale joints limits mammal hand keys.txt linear nurbs slerp bezier rigid true no [] of".split()
)
YAML_WORDS += [
    b"*a",
    b"&a",
    b"!!x",
    b"? ",
    b"- ",
    b"|",
    b">",
    b"'",
    b"../keys.txt",
    b"rotate_x",
    b"Leg.rotate_x",
]
NAME = re.compile(rb"\b(?:Root|Back|Upper\.arm|Lower\.arm|Leg)\b")


@cache
def folder() -> "TemporaryDirectory[str]":
    """A folder with all texts as they should be."""
    made: TemporaryDirectory[str] = TemporaryDirectory()
    for name, text in TEXTS.items():
        (Path(made.name) / name).write_text(text)
    return made


def text_outcome(name: str, data: bytes) -> str:
    """Returns `read` or `refused`; raises where a reader breaks."""
    path = Path(folder().name) / name
    path.write_bytes(data)
    try:
        return outcome(lambda: load_character(path.with_name("character.yaml")), ("line ", "byte ", ""))
    finally:
        path.write_text(TEXTS[name])


def text_mutator(name: str) -> Mutator:
    """The mutator of one of the texts."""
    is_yaml = name.endswith(".yaml")
    piece, words = (YAML_PIECE, YAML_WORDS) if is_yaml else (PIECE, COMMANDS)
    changes = [*text_changes(piece, [*words, *BONES]), rename(NAME, BONES)]
    nest = [deepen(piece, b"[", b"]"), deepen(piece, b"{a: ", b"}")] if is_yaml else []
    return Mutator(
        lambda: [bytearray(TEXTS[name].encode())], [*changes, *nest], lambda data: text_outcome(name, data)
    )


FAQ_SKELETON = text_mutator("skeleton.txt")
FAQ_KEYS = text_mutator("keys.txt")
FAQ_SKIN = text_mutator("skin.txt")
FAQ_CONSTRAINTS = text_mutator("limits.txt")
FAQ_CHARACTER = text_mutator("character.yaml")
