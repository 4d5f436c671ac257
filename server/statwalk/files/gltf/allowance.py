"""Limits on the resources that a model may use.

A file can refer to the same data many times, so that its size alone does not limit its use of memory.
"""

from __future__ import annotations

from dataclasses import dataclass

from statwalk.errors import ModelError


@dataclass
class Allowance:
    """A limit: a model has at most `most` of `what`; `taken` is the number counted so far."""

    what: str
    most: int
    taken: int = 0

    def take(self, count: int, place: str) -> None:
        """Counts resources before they are used.

        :raises ModelError: when the limit is exceeded.
        """
        self.taken += count
        if self.taken > self.most:
            raise ModelError(
                f"the model has {self.taken} {self.what}; at most {self.most} are allowed", place=place
            )


def accessor_bytes() -> Allowance:
    """Returns the limit on bytes of accessors; accessors without data (all zeros) count as well."""
    return Allowance("bytes in accessors", 256 << 20)


def blank_bytes() -> Allowance:
    """Returns the limit on bytes of a .gltf's buffers without a URI."""
    return Allowance("bytes in buffers without a uri", 64 << 20)


def mesh_vertices() -> Allowance:
    """Returns the limit on vertices, counted once for each attribute, and once more for each four morph
    targets and each three indices.
    """
    return Allowance("vertices (counted for each attribute, four morph targets, three indices)", 2_500_000)


def drawn_vertices() -> Allowance:
    """Returns the limit on vertices of all meshes, counted on every node that carries the mesh."""
    return Allowance("vertices on its nodes", 2_000_000)


def key_times() -> Allowance:
    """Returns the limit on key times of all accessors of key times."""
    return Allowance("key times", 4_000_000)


def key_numbers() -> Allowance:
    """Returns the limit on numbers in the keys of all channels of all animations."""
    return Allowance("numbers in its keys", 8_000_000)
