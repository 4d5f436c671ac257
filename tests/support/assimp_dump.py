"""What assimp, an independent reader, finds in a model file: the corners of its first mesh."""

import re
import subprocess
from pathlib import Path
from typing import NamedTuple

import numpy as np


class Corners(NamedTuple):
    """Positions (T, 3, 3), normals (T, 3, 3) and texture coordinates (T, 3, n) of the triangles' corners."""

    positions: np.ndarray
    normals: np.ndarray
    coordinates: np.ndarray


def corners(file: Path, folder: Path) -> Corners:
    """The triangles of a file, in the file's axes; `folder` is for the dump."""
    out = folder / f"{file.name}.assxml"
    subprocess.run(["assimp", "dump", str(file), str(out)], check=True, capture_output=True, timeout=60)
    text = out.read_text()
    faces = np.array(
        [
            [int(word) for word in face.split()]
            for face in re.findall(r'<Face num="3">(.*?)</Face>', text, re.S)
        ]
    )
    return Corners(*(_rows(text, tag)[faces] for tag in ("Positions", "Normals", "TextureCoords")))


def _rows(text: str, tag: str) -> np.ndarray:
    match = re.search(rf'<{tag} num="(\d+)"[^>]*>(.*?)</{tag}>', text, re.S)
    assert match, f"assimp found no {tag}"
    return np.array([float(word) for word in match[2].split()]).reshape(int(match[1]), -1)
