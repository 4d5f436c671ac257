"""DirectX .x files in text form: frames, meshes, skin weights, animation sets, IK chains (RTCA 3.2). FF3."""

from statwalk.files.directx.x_file import read_directx
from statwalk.files.directx.x_writer import write_directx

__all__ = ["read_directx", "write_directx"]
