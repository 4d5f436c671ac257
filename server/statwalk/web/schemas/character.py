"""The bodies about characters: lists, descriptions, uploads, and mappings from clips to states."""

from __future__ import annotations

from typing import Literal

from statwalk.skin.skinning import Skinning
from statwalk.web.schemas.base import ResponseModel


class ShippedCharacterView(ResponseModel):
    """A character of a machine folder in the list."""

    name: str
    machine: str
    uploaded: Literal[False] = False


class UploadedCharacterView(ResponseModel):
    """An uploaded character in the list; `machines` are the machines that use this model, `machine` is the
    first of them.
    """

    name: str
    machine: str | None
    uploaded: Literal[True] = True
    sha256: str
    bytes: int
    machines: list[str]


class JointView(ResponseModel):
    """A joint; `parent` -1: a root; `node` is its node in the model."""

    name: str
    parent: int
    node: int


class ClipView(ResponseModel):
    """A clip; `duration` in seconds."""

    name: str
    duration: float


class PartView(ResponseModel):
    """A mesh primitive of the model, with its numbers of vertices and triangles."""

    node: int
    mesh: int
    primitive: int
    name: str
    """of its mesh, or of its node"""
    vertices: int
    triangles: int
    material: int | None
    """an index into the character's materials"""
    skinned: bool
    """joints bend it"""
    targets: list[str]
    """the names of its morph targets"""


class MaterialView(ResponseModel):
    """A material of the model."""

    name: str
    textures: dict[str, int]
    """by their places in glTF (`baseColorTexture`, …), indices into the character's textures"""
    alpha: str
    """`OPAQUE`, `MASK` or `BLEND`"""
    double_sided: bool


class TextureView(ResponseModel):
    """An image of the model."""

    name: str
    type: str
    bytes: int
    width: int | None
    """pixels; null: neither PNG nor JPEG"""
    height: int | None


class CharacterView(ResponseModel):
    """A character: its joints (parents first), clips and skins, notes on what the server repaired in the
    file, and the address of its model.
    """

    name: str
    joints: list[JointView]
    clips: list[ClipView]
    skins: int
    parts: list[PartView]
    vertices: int
    triangles: int
    materials: list[MaterialView]
    textures: list[TextureView]
    notes: list[str]
    """what the server repaired or left out when it read the file"""
    targets: list[str]
    """the names of its morph targets, which expressions set: `NAME.weight`"""
    expressions: list[str]
    """what moves with what, whichever machine plays it"""
    muscle_bones: list[str]
    """the joints that only deform the skin"""
    skinning: Skinning
    """what its vertices follow, unless a viewer chooses another way"""
    model: str


class UploadView(ResponseModel):
    """An uploaded character: its numbers of joints, clips, skins and vertices, and the address of
    its model.
    """

    name: str
    uploaded: Literal[True] = True
    sha256: str
    bytes: int
    model: str
    joints: int
    clips: int
    skins: int
    vertices: int
    notes: list[str]


class MappingView(ResponseModel):
    """A proposed state for each clip of a character; `meanings` explains the states with a
    special meaning.
    """

    character: str
    mapping: dict[str, str]
    meanings: dict[str, str]
