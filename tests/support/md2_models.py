"""Small MD2 files, made by hand with struct: a tetrahedron that moves, and changes of it that nobody should
send.
"""

import struct
from collections.abc import Sequence

CORNERS = ((0, 0, 0), (200, 0, 0), (0, 200, 0), (0, 0, 200))
FACES = ((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2))
"""clockwise seen from outside, as Quake II has them"""
PIXELS = ((0, 0), (31, 0), (0, 15), (31, 15), (16, 8))
SCALE, ORIGIN = (0.1, 0.2, 0.05), (-3.0, 1.5, -24.0)
NAMES = ("stand01", "stand02", "stand03", "pain101", "pain102", "jump1", "jump2")
FRAME_BYTES = 40 + 4 * len(CORNERS)
SKINS_AT = 68
PIXELS_AT = SKINS_AT + 64
FACES_AT = PIXELS_AT + 4 * len(PIXELS)
FRAMES_AT = FACES_AT + 12 * len(FACES)
HEAD = [
    "skin_width",
    "skin_height",
    "frame_bytes",
    *("skins", "vertices", "coordinates", "triangles", "commands", "frames"),
    *("skins_at", "coordinates_at", "triangles_at", "frames_at", "commands_at", "end"),
]


def points(frame: int) -> list[tuple[int, int, int]]:
    """The bytes of the vertices in a frame: the corners, moved by the frame."""
    return [(x + 5 * frame, y, z + 3 * frame * row) for row, (x, y, z) in enumerate(CORNERS)]


def units(frame: int) -> list[list[float]]:
    """The places of the vertices in a frame, in the file's units."""
    return [
        [number * step + start for number, step, start in zip(point, SCALE, ORIGIN, strict=True)]
        for point in points(frame)
    ]


def md2(names: Sequence[str] = NAMES, normals: Sequence[int] = (0, 32, 52, 104)) -> bytes:
    """A file with a frame for each name."""
    parts = [b"players/tetra.pcx".ljust(64, b"\0")]
    parts += [struct.pack("<2h", *pixel) for pixel in PIXELS]
    parts += [
        struct.pack("<6H", *face, *(corner + (row == 3) for corner in face)) for row, face in enumerate(FACES)
    ]
    for frame, name in enumerate(names):
        parts.append(struct.pack("<6f16s", *SCALE, *ORIGIN, name.encode()))
        parts += [
            struct.pack("<4B", *point, normal) for point, normal in zip(points(frame), normals, strict=True)
        ]
    parts.append(struct.pack("<i", 0))
    body = b"".join(parts)
    commands_at = FRAMES_AT + FRAME_BYTES * len(names)
    counts = 32, 16, FRAME_BYTES, 1, len(CORNERS), len(PIXELS), len(FACES), 1, len(names)
    places = SKINS_AT, PIXELS_AT, FACES_AT, FRAMES_AT, commands_at, commands_at + 4
    return struct.pack("<4s16i", b"IDP2", 8, *counts, *places) + body


def with_field(field: str, value: int) -> bytes:
    """The file with another number in its head."""
    data = bytearray(md2())
    struct.pack_into("<i", data, 8 + 4 * HEAD.index(field), value)
    return bytes(data)


def with_bytes(first: int, form: str, *values: float) -> bytes:
    """The file with other values from a byte on."""
    data = bytearray(md2())
    struct.pack_into(form, data, first, *values)
    return bytes(data)


NAN, ENDLESS = float("nan"), float("inf")
HOSTILE_MD2 = {
    "another beginning": (b"IDP3" + md2()[4:], "byte 0: this is no MD2"),
    "the beginning alone": (b"IDP2", "byte 4: the head has 68 bytes"),
    "another version": (with_bytes(4, "<i", 7), "byte 4: the version is 8, not 7"),
    "a thousand million frames": (with_field("frames", 10**9), "byte 40: a model has 1 to 1,024 frames"),
    "no frame": (with_field("frames", 0), "byte 40: .* not 0"),
    "minus one vertex": (with_field("vertices", -1), "byte 24: a model has 1 to 65,535 vertices, not -1"),
    "no vertex": (with_field("vertices", 0), "byte 24"),
    "too many triangles": (with_field("triangles", 1 << 30), "byte 32: a model has 1 to 65,535 triangles"),
    "too many skins": (with_field("skins", 1 << 20), "byte 20"),
    "a skin without width": (with_field("skin_width", 0), "byte 8: a skin is 1 to 65,536 pixels"),
    "a frame too short": (with_field("frame_bytes", 8), "byte 16: a frame of 4 vertices has 56"),
    "frames past the end": (with_field("frames_at", 1 << 30), "byte 56: the frames should lie"),
    "frames in the head": (with_field("frames_at", 4), "byte 56"),
    "triangles before the file": (with_field("triangles_at", -8), "byte 52"),
    "pixels past the end": (with_field("coordinates", 60_000), "byte 48"),
    "skins past the end": (with_field("skins_at", len(md2()) - 8), "byte 44"),
    "a longer file": (with_field("end", len(md2()) + 1), "byte 64: the file should have"),
    "cut in half": (md2()[: len(md2()) // 2], "byte 56: the frames"),
    "a vertex too high": (
        with_bytes(FACES_AT + 14, "<H", 4),
        f"byte {FACES_AT + 14}: triangle 1 names vertex 4; there are 4",
    ),
    "a pixel too high": (
        with_bytes(FACES_AT + 10, "<h", -1),
        f"byte {FACES_AT + 10}: triangle 0 names texture coordinate 65535",
    ),
    "a scale that is no number": (
        with_bytes(FRAMES_AT + 4, "<f", NAN),
        rf"byte {FRAMES_AT + 4}: frame 0 \(stand01\): the scale along y is nan",
    ),
    "an origin without end": (
        with_bytes(FRAMES_AT + FRAME_BYTES + 20, "<f", ENDLESS),
        rf"byte {FRAMES_AT + FRAME_BYTES + 20}: frame 1 \(stand02\): the origin along z is inf",
    ),
    "a scale of 1e30": (with_bytes(FRAMES_AT, "<f", 1e30), "within 1,000,000"),
}
"""by what is wrong: the file, and a pattern of the refusal"""
