"""Zips and folders of models: what is unpacked, and what is refused before a byte is."""

import contextlib
import stat
import struct
import zipfile

import pytest
import tiny_model
from statwalk.errors import ModelError
from statwalk.files import archive
from statwalk.files.character_file import load_character_file
from zipped import MODEL, packed


def unpacked(data, folder):
    upload = folder / "upload"
    upload.write_bytes(data)
    (folder / "out").mkdir()
    return archive.unpack(upload, folder / "out")


def refused(data, folder):
    with pytest.raises(ModelError) as refusal:
        unpacked(data, folder)
    return refusal.value


def test_a_gltf_with_its_files(tmp_path):
    model = unpacked(packed(MODEL), tmp_path)
    assert model == tmp_path / "out" / "robot" / "robot.gltf"
    assert list(load_character_file(model).clips) == ["Bend"]


def test_a_zip_is_loaded_like_a_model(tmp_path):
    (tmp_path / "robot.zip").write_bytes(packed(MODEL))
    character = load_character_file(tmp_path / "robot.zip")
    assert (character.name, list(character.clips)) == ("robot", ["Bend"])
    assert character.model_glb.startswith(b"glTF")


def test_the_model_of_a_folder_is_the_one_that_lies_highest(tmp_path):
    model = unpacked(packed(MODEL | {"robot/parts/arm.gltf": b"{}"}), tmp_path)
    assert model.name == "robot.gltf"


def test_other_files_are_left_in_the_zip(tmp_path):
    unpacked(
        packed(MODEL | {"readme.txt": b"hello", "__MACOSX/robot.gltf": b"x", "robot/.hidden.gltf": b"x"}),
        tmp_path,
    )
    assert sorted(path.name for path in (tmp_path / "out").rglob("*.*")) == ["robot.bin", "robot.gltf"]


def test_the_model_of_a_machine_is_not_its_table(tmp_path):
    model = unpacked(packed({"machine.yaml": b"initial: A", "character.glb": tiny_model.model()}), tmp_path)
    assert model.name == "character.glb"


@pytest.mark.parametrize(
    "name",
    [
        "../up.bin",
        "/etc/up.bin",
        "a/../../up.bin",
        "C:up.bin",
        "a\\..\\up.bin",
        "a\nb.bin",
        "x" * 300,
        "a/" * 20 + "b",
    ],
)
def test_names_that_lead_elsewhere(tmp_path, name):
    refusal = refused(packed(MODEL | {name: b"x"}), tmp_path)
    assert "relative path" in refusal.message
    assert refusal.place == archive.shown(name)
    assert list((tmp_path / "out").iterdir()) == []


def entry(name, mode=0, **attributes):
    info = zipfile.ZipInfo(name)
    info.external_attr = mode << 16
    for key, value in attributes.items():
        setattr(info, key, value)
    return info


@pytest.mark.parametrize("kind", [stat.S_IFLNK, stat.S_IFIFO, stat.S_IFCHR])
def test_links_and_devices(tmp_path, kind):
    refusal = refused(packed(MODEL | {entry("robot/link.bin", kind | 0o777): b"/etc/passwd"}), tmp_path)
    assert "only plain files" in refusal.message


def test_a_bomb_is_refused_by_what_it_says(tmp_path):
    data = packed(MODEL | {f"bomb{row}.bin": bytes(archive.LARGEST_UNPACKED_BYTES // 4) for row in range(4)})
    assert len(data) < 1 << 20
    assert "at most 128 MiB" in refused(data, tmp_path).message
    assert list((tmp_path / "out").iterdir()) == []


def test_an_entry_that_is_longer_than_it_says(tmp_path):
    data = packed({"a.glb": bytes(100_000)})
    lying = data.replace(struct.pack("<I", 100_000), struct.pack("<I", 10))
    assert lying != data
    assert refused(lying, tmp_path).message.startswith("the zip cannot be read")
    assert sum(path.stat().st_size for path in (tmp_path / "out").iterdir()) <= 10


def test_too_many_entries_are_not_even_listed(tmp_path):
    refusal = refused(packed({f"{row}.bin": b"" for row in range(archive.MOST_ENTRIES + 1)}), tmp_path)
    assert refusal.message == "the zip lists 1001 entries; at most 1000 are read"


def test_a_directory_that_says_less_than_it_holds(tmp_path):
    data = bytearray(packed({f"{row}.bin": b"" for row in range(archive.MOST_ENTRIES + 1)}))
    struct.pack_into("<HH", data, data.rfind(archive.END) + 8, 1, 1)
    assert "1001 entries" in refused(bytes(data), tmp_path).message


def test_the_64_bit_kind(tmp_path):
    data = packed(MODEL)
    at = data.rfind(archive.END)
    assert "64-bit" in refused(data[:at] + archive.ZIP64_LOCATOR + bytes(16) + data[at:], tmp_path).message


def test_a_name_that_stands_twice(tmp_path):
    refusal = refused(packed(MODEL | {"robot/ROBOT.bin": b"x"}), tmp_path)
    assert refusal.message == "the zip holds this name twice; rename or remove one of the two"


def test_a_file_that_is_a_folder_too(tmp_path):
    assert (
        "a file and a folder"
        in refused(packed(MODEL | {"robot.bin": b"x", "robot.bin/a.bin": b"x"}), tmp_path).message
    )


def test_an_encrypted_entry(tmp_path):
    data = bytearray(packed(MODEL))
    struct.pack_into("<H", data, data.find(b"PK\x01\x02") + 8, archive.ENCRYPTED)
    assert "encrypted" in refused(bytes(data), tmp_path).message


def test_another_compression(tmp_path):
    assert "compression 14" in refused(packed(MODEL, zipfile.ZIP_LZMA), tmp_path).message


@pytest.mark.parametrize("count", [1, 4, 30, 100, 300])
def test_a_zip_cut_short(tmp_path, count):
    refusal = refused(packed(MODEL)[:-count], tmp_path)
    assert refusal.place.startswith("byte")


def test_no_model_and_two_models(tmp_path):
    for folder in ("none", "two"):
        (tmp_path / folder).mkdir()
    assert (
        refused(packed({"a.bin": b"x"}), tmp_path / "none").message
        == "the zip holds no model; add one .gltf or .glb file, or a character file (.yaml)"
    )
    assert refused(packed({"a.glb": b"x", "b.gltf": b"x"}), tmp_path / "two").message.endswith(
        "keep only one: a.glb, b.gltf"
    )


@pytest.mark.parametrize("at", range(0, 400, 7))
def test_a_changed_byte_is_no_crash(tmp_path, at):
    data = bytearray(packed(MODEL))
    data[-at - 1] ^= 0xFF
    with contextlib.suppress(ModelError):
        unpacked(bytes(data), tmp_path)
