"""MD2: Quake II's models, whose frames are whole meshes. FF4, DS2."""

from statwalk.files.md2.md2_file import read_md2
from statwalk.files.md2.write_md2 import write_md2

__all__ = ["read_md2", "write_md2"]
