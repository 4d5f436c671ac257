"""glTF 2.0: models read, checked and written, and posed frames from a prepared template."""

from statwalk.files.gltf.read import read_model

__all__ = ["read_model"]
