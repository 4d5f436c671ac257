"""BVH: a hierarchy of joints, and a table of frames (Biovision, as the 1990s left it). FF5, KF8."""

from statwalk.files.bvh.bvh_file import read_bvh

__all__ = ["read_bvh"]
