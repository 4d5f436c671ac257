"""The small model as a zip of a .gltf with its buffer beside it."""

import io
import zipfile

import tiny_model

BINARY = bytes(tiny_model.document()[1])
MODEL = {"robot/robot.gltf": tiny_model.gltf("robot.bin"), "robot/robot.bin": BINARY}


def packed(entries, method=zipfile.ZIP_DEFLATED):
    """The bytes of a zip; a key may be a ZipInfo."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", method) as archive:
        for name, content in entries.items():
            archive.writestr(name, content)
    return data.getvalue()
