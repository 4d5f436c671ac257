"""Models that carry Draco's data beside plain data, and do not require them."""

from __future__ import annotations

from statwalk.errors import ModelError
from statwalk.files.gltf import check
from statwalk.files.gltf.document import DRACO, Document, compressed


def drop_draco(document: Document) -> bool:
    """Removes Draco's data from a document that does not require them; returns whether it had some. Viewers
    without a Draco decoder may refuse even a file that also has plain data.

    :raises ModelError: when a compressed primitive has no plain positions.
    """
    used = check.items(document.root, "extensionsUsed", "")
    if DRACO not in used:
        return False
    used.remove(DRACO)
    for row, mesh in enumerate(document["meshes"]):
        place = f"/meshes/{row}"
        for k, primitive in enumerate(check.objects(mesh, "primitives", place)):
            _drop_from(document, primitive, f"{place}/primitives/{k}")
    if not used:
        del document.root["extensionsUsed"]
    return True


def _drop_from(document: Document, primitive: check.Json, place: str) -> None:
    extensions = check.mapping(primitive, "extensions", place)
    if DRACO not in extensions:
        return
    del extensions[DRACO]
    if not extensions:
        del primitive["extensions"]
    attributes = check.mapping(primitive, "attributes", place)
    positions = check.reference(
        attributes, "POSITION", f"{place}/attributes", document["accessors"], "accessor"
    )
    if positions is not None and not {"bufferView", "sparse"} & document["accessors"][positions].keys():
        raise ModelError(compressed(DRACO), place=f"{place}/extensions/{DRACO}")
