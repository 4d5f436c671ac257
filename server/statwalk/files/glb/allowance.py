"""How much a model may ask for. Files can name the same data again and again, so that their size alone does not bound what they take."""

from __future__ import annotations

from dataclasses import dataclass

from statwalk.errors import ModelError


@dataclass
class Allowance:
    """At most so many of something in one model; `taken` so far."""

    what: str
    most: int
    taken: int = 0

    def take(self, count: int, place: str) -> None:
        """Count what is about to be taken; raises ModelError where it is too much."""
        self.taken += count
        if self.taken > self.most:
            raise ModelError(f"with it the model has {self.taken} {self.what}; {self.most} are allowed", place=place)


def accessor_bytes() -> Allowance:
    """What accessors may take, those without data (all zeros) included."""
    return Allowance("bytes in accessors", 256 << 20)


def blank_bytes() -> Allowance:
    """What a .gltf's buffers may take that have no address."""
    return Allowance("bytes in buffers without a uri", 64 << 20)


def mesh_vertices() -> Allowance:
    """Vertices, counted once for each attribute, and once more for each four morph targets and each three indices."""
    return Allowance("vertices (counted for each attribute, four morph targets, three indices)", 2_500_000)


def drawn_vertices() -> Allowance:
    """Vertices of all meshes on all nodes that carry them."""
    return Allowance("vertices on its nodes", 2_000_000)


def key_times() -> Allowance:
    """Key times of all accessors that hold any."""
    return Allowance("key times", 4_000_000)


def key_numbers() -> Allowance:
    """Numbers in the keys of all channels of all animations."""
    return Allowance("numbers in its keys", 8_000_000)
