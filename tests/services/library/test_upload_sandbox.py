"""The child that reads uploads: its answers, and its end at each of its limits."""

import json
import signal
import subprocess
import sys
from pathlib import Path

import pytest
import tiny_model
from statwalk.errors import CancelledError, ContentError, StorageError
from statwalk.files.character_archive import read_character
from statwalk.services.cancel import CancelToken
from statwalk.services.library import upload_sandbox


def child(tmp_path: Path, change: str) -> "subprocess.CompletedProcess[str]":
    """A child with a change to its module."""
    (tmp_path / "upload").write_bytes(tiny_model.model())
    code = (
        f"import sys\nfrom statwalk.services.library import upload_sandbox\n{change}\n"
        "upload_sandbox.main(*sys.argv[1:])"
    )
    return subprocess.run(
        [sys.executable, "-c", code, str(tmp_path / "upload"), str(tmp_path / "out"), "tiny"],
        capture_output=True,
        text=True,
        timeout=200,  # a quiet machine needs two; another may be busy
    )


def test_it_answers_with_facts(tmp_path: Path) -> None:
    (tmp_path / "upload").write_bytes(tiny_model.model())
    facts = upload_sandbox.read_in_child(tmp_path / "upload", tmp_path / "out", "tiny")
    assert facts == {"joints": 3, "clips": 1, "skins": 1, "vertices": 3, "notes": facts["notes"]}
    assert (tmp_path / "out").read_bytes() == tiny_model.model()
    checked = read_character(upload_sandbox.checked_beside(tmp_path / "out"), tiny_model.model())
    assert checked.skeleton.names == ("hip", "knee", "skin")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
def test_a_full_disk_is_no_fault_of_the_file(tmp_path: Path) -> None:
    (tmp_path / "upload").write_bytes(tiny_model.model())
    upload_sandbox.checked_beside(tmp_path / "out").symlink_to("/dev/full")
    with pytest.raises(StorageError) as refused:
        upload_sandbox.read_in_child(tmp_path / "upload", tmp_path / "out", "tiny")
    assert refused.value.is_full


def test_arrays_that_would_fill_the_disk_are_refused(tmp_path: Path) -> None:
    ended = child(tmp_path, "upload_sandbox.archive.LARGEST_UNPACKED_BYTES = 2_000")
    assert json.loads(ended.stdout)["message"] == "its arrays take more than 128 MiB"


def test_it_answers_with_the_place_of_a_fault(tmp_path: Path) -> None:
    (tmp_path / "upload").write_bytes(tiny_model.model()[:100])
    with pytest.raises(ContentError) as refusal:
        upload_sandbox.read_in_child(tmp_path / "upload", tmp_path / "out", "tiny")
    assert refusal.value.place == "byte 8"
    assert not (tmp_path / "out").exists()


def test_it_is_killed_when_nobody_waits_for_its_answer(tmp_path: Path) -> None:
    (tmp_path / "upload").write_bytes(tiny_model.model())
    token = CancelToken()
    token.cancel()
    with pytest.raises(CancelledError):
        upload_sandbox.read_in_child(tmp_path / "upload", tmp_path / "out", "tiny", token)
    assert not (tmp_path / "out").exists()


def test_out_of_memory(tmp_path: Path) -> None:
    ended = child(tmp_path, "upload_sandbox.read_upload = lambda *_: bytearray(upload_sandbox.MEMORY_BYTES)")
    assert json.loads(ended.stdout)["message"] == "reading it takes more than 1024 MiB of memory"


def test_out_of_time(tmp_path: Path) -> None:
    ended = child(
        tmp_path,
        "upload_sandbox.PROCESSOR_SECONDS = 3\ndef spin(*_):\n    while True: pass\n"
        "upload_sandbox.read_upload = spin",
    )
    assert ended.returncode == -signal.SIGXCPU
    assert (
        upload_sandbox.refusal(ended.returncode, b"").message
        == "reading it takes more than 10 s of computing"
    )


def test_a_defect_in_it_is_logged_and_not_told(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    ended = child(tmp_path, "upload_sandbox.read_upload = lambda *_: 1 / 0")
    refusal = upload_sandbox.refusal(ended.returncode, ended.stderr.encode())
    assert refusal.message == "the reader failed on this file; the file is refused"
    assert "ZeroDivisionError" in caplog.text


def test_a_model_of_many_files_that_is_too_large(tmp_path: Path) -> None:
    ended = child(tmp_path, "upload_sandbox.LARGEST_MODEL_BYTES = 1 << 10")
    assert json.loads(ended.stdout)["message"].startswith("the model with its files has")
