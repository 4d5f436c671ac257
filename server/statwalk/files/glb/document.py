"""The JSON of a glTF file, with the collections that other objects point into."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import orjson

from statwalk.errors import ModelError
from statwalk.files.glb import check
from statwalk.files.glb.check import Json

COLLECTIONS = (
    "accessors",
    "animations",
    "buffers",
    "bufferViews",
    "cameras",
    "images",
    "materials",
    "meshes",
    "nodes",
    "samplers",
    "scenes",
    "skins",
    "textures",
)
# These may be required: what they add is passed through untouched, or (quantisation) read.
READABLE_EXTENSIONS = ("KHR_mesh_quantization", "KHR_lights_punctual", "KHR_xmp_json_ld")
PASSED_THROUGH = ("KHR_materials_", "KHR_texture_", "EXT_texture_", "EXT_materials_")


@dataclass(frozen=True)
class Document:
    """The JSON of a file: `root`, its collections as lists of objects, and notes on what had to be repaired."""

    root: Json
    notes: list[str] = field(default_factory=list)

    def __getitem__(self, collection: str) -> list[Json]:
        return self.collections[collection]

    @cached_property
    def collections(self) -> dict[str, list[Json]]:
        """Every collection of the file, its members checked to be objects."""
        return {name: check.objects(self.root, name, "") for name in COLLECTIONS}

    def note(self, text: str) -> None:
        """Keep what was repaired, each remark once."""
        if text not in self.notes:
            self.notes.append(text)


def parse(text: bytes | memoryview) -> Document:
    """The document of a JSON text. Raises ModelError for what is no JSON, no glTF 2.x, or needs an extension that is not understood."""
    try:
        root = orjson.loads(text)
    except orjson.JSONDecodeError as error:
        raise ModelError(f"this is not JSON: {error}", place=f"byte {error.pos} of the JSON") from None
    if not isinstance(root, dict):
        raise ModelError("the JSON must be an object", place="/")
    document = Document(root)
    check_version(document)
    check_extensions(root)
    for name, value in check.mapping(root, "extensions", "").items():
        check.as_object(value, f"/extensions/{name[:60]}")
    return document


def check_version(document: Document) -> None:
    """The file must say that a glTF 2.0 reader can read it. One that holds nothing may ask for any 2.x: nothing in it can be read wrong."""
    asset = check.as_object(document.root.get("asset"), "/asset")
    version = check.text(asset, "version", "/asset")
    if not version.startswith("2."):
        raise ModelError(f"this is glTF {version[:20]}; it must be 2.0", place="/asset/version")
    lowest = check.text(asset, "minVersion", "/asset", "2.0")
    if lowest.startswith("2.") and set(document.root) == {"asset"}:
        document.note(f"it asks for a reader of glTF {lowest[:20]} and holds nothing")
    elif lowest != "2.0":
        raise ModelError(f"this needs a reader of glTF {lowest[:20]}; this one reads 2.0", place="/asset/minVersion")


def check_extensions(root: Json) -> None:
    """Extensions that are required must be among those that are understood."""
    for key in ("extensionsUsed", "extensionsRequired"):
        for row, name in enumerate(check.items(root, key, "")):
            if not isinstance(name, str):
                raise ModelError(f"this is {check.shown(name)}; it must be a string", place=f"/{key}/{row}")
            if key == "extensionsRequired" and not understood(name):
                known = ", ".join((*READABLE_EXTENSIONS, *(f"{prefix}*" for prefix in PASSED_THROUGH)))
                raise ModelError(f"the file needs {name[:60]}, which is not understood; these are: {known}", place=f"/{key}/{row}")


def understood(extension: str) -> bool:
    """Whether a file that needs this extension is read right."""
    return extension in READABLE_EXTENSIONS or extension.startswith(PASSED_THROUGH)
