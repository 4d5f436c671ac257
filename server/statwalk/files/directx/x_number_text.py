"""Numbers as the text of a .x file: 32-bit floats in the fewest digits that read back the same, never with an
exponent, which some readers do not know.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from statwalk.maths.arrays import Floats, Ints


def float_words(values: Floats) -> list[str]:
    """Returns the numbers as words, row by row."""
    flat = np.asarray(values, np.float32).reshape(-1) + np.float32(0)
    words: list[str] = flat.astype(str).tolist()
    for row, word in enumerate(words):
        if "e" in word:
            words[row] = np.format_float_positional(flat[row], trim="0")
    return words


def listed(words: Iterable[object]) -> str:
    """Returns an array of numbers: `1,2,3;`."""
    return f"{','.join(str(word) for word in words)};"


def rows_of(values: Floats) -> str:
    """Returns an array of vectors, one a line: `0.0;1.0;0.0;,` … `0.0;1.0;0.0;;`."""
    width = values.shape[1]
    words = iter(float_words(values))
    lines = (";".join(row) for row in zip(*(words,) * width, strict=True))
    return ";,\n".join(lines) + ";;"


def triangles_text(triangles: Ints) -> str:
    """Returns the number of triangles (T, 3), and the triangles: `3;0,1,2;,` … `3;1,2,3;;`."""
    rows = ";,\n".join(f"3;{a},{b},{c}" for a, b, c in triangles.tolist())
    return f"{len(triangles)};\n{rows};;"
