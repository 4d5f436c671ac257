"""The JSON of a glTF file, with the collections that its objects refer to."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import orjson

from statwalk.errors import ModelError
from statwalk.files.gltf import check
from statwalk.files.gltf.check import Json

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
# A file may require these: their data are passed through untouched, or (quantisation) read.
READABLE_EXTENSIONS = ("KHR_mesh_quantization", "KHR_lights_punctual", "KHR_xmp_json_ld")
DRACO = "KHR_draco_mesh_compression"
COMPRESSIONS = {DRACO: "Draco", "EXT_meshopt_compression": "meshopt", "KHR_meshopt_compression": "meshopt"}
"""extensions that compress the data, and the names that people know them by"""
PASSED_THROUGH = ("KHR_materials_", "KHR_texture_", "EXT_texture_", "EXT_materials_")


@dataclass(frozen=True)
class Document:
    """The JSON of a file: `root`, its collections as lists of objects, and notes about repairs."""

    root: Json
    notes: list[str] = field(default_factory=list)

    def __getitem__(self, collection: str) -> list[Json]:
        return self.collections[collection]

    @cached_property
    def collections(self) -> dict[str, list[Json]]:
        """Every collection of the file, its members checked to be objects."""
        return {name: check.objects(self.root, name, "") for name in COLLECTIONS}

    def note(self, text: str) -> None:
        """Adds a note about a repair; each note is kept once."""
        if text not in self.notes:
            self.notes.append(text)


def parse(text: bytes | memoryview) -> Document:
    """Returns the document of a JSON text.

    :raises ModelError: when the text is no JSON or no glTF 2.x, or requires an extension that is not
        supported.
    """
    try:
        root = orjson.loads(text)
    except orjson.JSONDecodeError as error:
        raise ModelError(f"this is not JSON: {error}", place=f"byte {error.pos} of the JSON") from None
    if not isinstance(root, dict):
        raise ModelError("the JSON must be an object", place="/")
    document = Document(root)
    _check_version(document)
    _check_extensions(root)
    for name, value in check.mapping(root, "extensions", "").items():
        check.as_object(value, f"/extensions/{name[:60]}")
    return document


def _check_version(document: Document) -> None:
    """Checks that a glTF 2.0 reader can read the file.

    An empty file may require any 2.x: it has no content that could be misread.
    """
    asset = check.as_object(document.root.get("asset"), "/asset")
    version = check.text(asset, "version", "/asset")
    if not version.startswith("2."):
        raise ModelError(f"this is glTF {version[:20]}; it must be 2.0", place="/asset/version")
    lowest = check.text(asset, "minVersion", "/asset", "2.0")
    if lowest.startswith("2.") and set(document.root) == {"asset"}:
        document.note(f"the file requires glTF {lowest[:20]} and is empty")
    elif lowest != "2.0":
        raise ModelError(
            f"the file requires glTF {lowest[:20]}; statwalk reads glTF 2.0", place="/asset/minVersion"
        )


def _check_extensions(root: Json) -> None:
    """Checks that all required extensions are supported."""
    for key in ("extensionsUsed", "extensionsRequired"):
        for row, name in enumerate(check.items(root, key, "")):
            if not isinstance(name, str):
                raise ModelError(f"this is {check.shown(name)}; it must be a string", place=f"/{key}/{row}")
            if key == "extensionsRequired" and name in COMPRESSIONS:
                raise ModelError(compressed(name), place=f"/{key}/{row}")
            if key == "extensionsRequired" and not _is_supported(name):
                supported = ", ".join((*READABLE_EXTENSIONS, *(f"{prefix}*" for prefix in PASSED_THROUGH)))
                raise ModelError(
                    f"the file requires {name[:60]}, which is not supported; supported are: {supported}",
                    place=f"/{key}/{row}",
                )


def compressed(extension: str) -> str:
    """Returns why a model with one of COMPRESSIONS is refused, and what to do."""
    return (
        f"the model is compressed with {COMPRESSIONS[extension]} ({extension}), which statwalk does not "
        "read. Decompress it first: npx @gltf-transform/cli copy model.glb plain.glb; or export it plain"
    )


def _is_supported(extension: str) -> bool:
    return extension in READABLE_EXTENSIONS or extension.startswith(PASSED_THROUGH)
