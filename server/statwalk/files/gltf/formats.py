"""Component types and element types of glTF accessors (glTF 2.0, 3.6.2)."""

from __future__ import annotations

import numpy as np

BYTE, UNSIGNED_BYTE, SHORT, UNSIGNED_SHORT, UNSIGNED_INT, FLOAT = 5120, 5121, 5122, 5123, 5125, 5126

COMPONENTS: dict[int, np.dtype[np.generic]] = {
    BYTE: np.dtype("<i1"),
    UNSIGNED_BYTE: np.dtype("<u1"),
    SHORT: np.dtype("<i2"),
    UNSIGNED_SHORT: np.dtype("<u2"),
    UNSIGNED_INT: np.dtype("<u4"),
    FLOAT: np.dtype("<f4"),
}
COMPONENT_BYTES = {kind: dtype.itemsize for kind, dtype in COMPONENTS.items()}
FLOAT_BYTES = COMPONENT_BYTES[FLOAT]
COMPONENT_OF_DTYPE = {dtype: kind for kind, dtype in COMPONENTS.items()}
ELEMENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
ELEMENT_OF_WIDTH = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
MATRIX_ROWS = {"MAT2": 2, "MAT3": 3, "MAT4": 4}
LARGEST_INTEGER = {BYTE: 127, UNSIGNED_BYTE: 255, SHORT: 32767, UNSIGNED_SHORT: 65535}

# The formats that an accessor may have for a purpose: (element types, component types).
Allowed = tuple[tuple[str, ...], tuple[int, ...]]
SIGNED_OR_FLOAT = (BYTE, UNSIGNED_BYTE, SHORT, UNSIGNED_SHORT, FLOAT)
TIMES: Allowed = (("SCALAR",), (FLOAT,))
VECTORS: Allowed = (("VEC3",), SIGNED_OR_FLOAT)
ROTATIONS: Allowed = (("VEC4",), SIGNED_OR_FLOAT)
MORPH_WEIGHTS: Allowed = (("SCALAR",), SIGNED_OR_FLOAT)
TRANSLATIONS: Allowed = (("VEC3",), (FLOAT,))
MATRICES: Allowed = (("MAT4",), (FLOAT,))
INDICES: Allowed = (("SCALAR",), (UNSIGNED_BYTE, UNSIGNED_SHORT, UNSIGNED_INT))
JOINTS: Allowed = (("VEC4",), (UNSIGNED_BYTE, UNSIGNED_SHORT))
WEIGHTS: Allowed = (("VEC4",), (UNSIGNED_BYTE, UNSIGNED_SHORT, FLOAT))
TEXCOORDS: Allowed = (("VEC2",), SIGNED_OR_FLOAT)
COLORS: Allowed = (("VEC3", "VEC4"), (UNSIGNED_BYTE, UNSIGNED_SHORT, FLOAT))


def element_bytes(element_type: str, component: int) -> int:
    """Returns the size of one element in bytes; columns of matrices start at multiples of 4 bytes."""
    size = COMPONENT_BYTES[component]
    if element_type not in MATRIX_ROWS:
        return ELEMENTS[element_type] * size
    rows = MATRIX_ROWS[element_type]
    return rows * (-(-rows * size // 4) * 4)
