"""FF2 the chunk format: exact to the bit, nested as Anderson's Listing 6, read by a program of its own."""

import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import statwalk
from reference_poses import MODELS, character
from statwalk.character.character import Character
from statwalk.files.chunk import read_chunk_file, write_chunk_file
from statwalk.files.gltf import read_model
from whole_character import PIXEL, difference, textures_in, whole

Tree = tuple[str, bytes, list["Tree"]]
RECORDS = {"HEAD": 0, "TEXT": 0, "OBJE": 8, "SKIN": 0, "POLY": 60, "BIND": 8, "ANIM": 12}
"""bytes before the first chunk inside, as docs/chunk.md says"""


def tree(data: bytes) -> list[Tree]:
    """The chunks of some bytes, by a reader of twelve lines that knows docs/chunk.md and nothing else."""
    chunks: list[Tree] = []
    while data:
        tag, length = data[:4].decode(), struct.unpack("<I", data[4:8])[0]
        content = data[8 : 8 + length]
        start = RECORDS.get(tag)
        chunks.append((tag, content, [] if start is None else tree(content[start:])))
        data = data[8 + length + -length % 4 :]
    return chunks


def inside(chunks: list[Tree], tag: str) -> list[Tree]:
    return [chunk for chunk in chunks if chunk[0] == tag]


@pytest.mark.parametrize("name", MODELS)
def test_a_model_comes_back_to_the_last_bit(name: str) -> None:
    source = character(name)
    data = write_chunk_file(source)
    back = read_chunk_file(data, source.name)
    assert difference(source, back) == ""
    assert write_chunk_file(back) == data
    assert back.notes == ()


@pytest.mark.parametrize("name", statwalk.shipped_machines())
def test_the_character_of_a_machine_comes_back_to_the_last_bit(name: str) -> None:
    role = statwalk.load(name)
    assert isinstance(role, statwalk.Role)
    assert difference(role.character, read_chunk_file(write_chunk_file(role.character), "back")) == ""


def test_every_kind_of_part_comes_back() -> None:
    source = whole()
    back = read_chunk_file(write_chunk_file(source), "whole")
    assert difference(source, back) == ""
    assert [line.text for line in back.expressions] == [line.text for line in source.expressions]
    assert textures_in(back.model_glb)[0]["name"] == "pixel"
    assert PIXEL in back.model_glb


def test_joints_are_nested_below_their_parents() -> None:
    (_, _, head), = tree(write_chunk_file(whole())[12:])  # fmt: skip
    (_, _, body), = inside(head, "OBJE")  # fmt: skip
    hip, skin = inside(body, "SKIN")
    (knee,) = inside(hip[2], "SKIN")
    assert [inside(joint[2], "NAME")[0][1] for joint in (hip, knee, skin)] == [b"hip", b"knee", b"skin"]
    assert [len(inside(joint[2], "CONS")) for joint in (hip, knee, skin)] == [1, 1, 0]
    assert [len(inside(joint[2], "POLY")) for joint in (hip, knee, skin)] == [0, 0, 1]
    row, node, *rest = struct.unpack("<II10f", inside(knee[2], "PIVO")[0][1])
    assert (row, node, rest) == (1, 1, [0, 1, 0, 0, 0, 0, 1, 1, 1, 1])


def test_positions_are_where_the_document_says() -> None:
    source = whole()
    (_, _, head), = tree(write_chunk_file(source)[12:])  # fmt: skip
    (_, _, body), = inside(head, "OBJE")  # fmt: skip
    (_, polygon, _), = inside(inside(body, "SKIN")[1][2], "POLY")  # fmt: skip
    pool = inside(body, "VECT")
    _, positions, _ = pool[struct.unpack_from("<I", polygon, 32)[0]]
    kind, dimensions, _, vertices, width = struct.unpack_from("<BBHII", positions)
    assert (kind, dimensions, vertices, width) == (0, 2, 3, 3)
    assert (
        np.frombuffer(positions, "<f4", offset=12).reshape(3, 3).tolist()
        == source.parts[0].positions.tolist()
    )


def test_unknown_chunks_are_skipped_and_named() -> None:
    data = bytearray(write_chunk_file(whole()))
    (length,) = struct.unpack_from("<I", data, 16)
    data[20:20] = b"LODD" + struct.pack("<I", 5) + b"seven\0\0\0"  # 5 bytes, and zeros up to 8
    data[16:20] = struct.pack("<I", length + 16)
    back = read_chunk_file(bytes(data), "whole")
    assert back.notes == ("1 chunk LODD, which statwalk does not know, skipped",)
    assert difference(whole(), back) == ""


def test_a_model_of_chunks_is_the_model_that_was(tmp_path: Path) -> None:
    """From glTF to chunks and back: vertices in every clip are where they were."""
    source = character(MODELS[-1])
    statwalk.convert(source, tmp_path / "a.chunk")
    report = statwalk.convert(tmp_path / "a.chunk", tmp_path / "b.glb")
    assert report.lost == ()
    back = read_model((tmp_path / "b.glb").read_bytes(), source.name)
    for name, clip in source.clips.items():
        for ours, theirs in zip(
            back.vertices(back.clips[name].sample(0.3)), source.vertices(clip.sample(0.3)), strict=True
        ):
            assert np.allclose(ours.positions, theirs.positions, atol=1e-5)


def test_a_chain_of_the_file_is_solved_by_its_name() -> None:
    back = read_chunk_file(write_chunk_file(whole()), "whole")
    assert isinstance(back, Character)
    target = (0.5, 0.5, 0.0)
    ours = back.solve(back.bind_pose, "leg", target, "ccd")
    assert np.array_equal(
        ours.pose.rotation, back.solve(back.bind_pose, ("hip", "knee"), target, "ccd").pose.rotation
    )
    with pytest.raises(statwalk.UnknownNameError, match="leg"):
        back.solve(back.bind_pose, "arm", target)


def test_limits_of_the_file_hold() -> None:
    source = replace(whole(), expressions=())
    back = read_chunk_file(write_chunk_file(source), "whole")
    assert back.limits == source.limits
