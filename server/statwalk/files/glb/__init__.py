"""glTF 2.0: read and checked, written, and posed frames from a prepared template."""

from statwalk.files.glb.read import read_model

__all__ = ["read_model"]
