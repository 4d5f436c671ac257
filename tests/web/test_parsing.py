"""The child that reads uploads: its answers, and its end at each of its limits."""

import json
import signal
import subprocess
import sys
from pathlib import Path

import pytest
import tinymodel
from statwalk.errors import ContentError
from statwalk.web.keeping import parsing


def child(tmp_path: Path, change: str) -> "subprocess.CompletedProcess[str]":
    """A child with a change to its module."""
    (tmp_path / "upload").write_bytes(tinymodel.model())
    code = f"import sys\nfrom statwalk.web.keeping import parsing\n{change}\nparsing.main(*sys.argv[1:])"
    return subprocess.run(
        [sys.executable, "-c", code, str(tmp_path / "upload"), str(tmp_path / "out"), "tiny"], capture_output=True, text=True, timeout=60
    )


def test_it_answers_with_facts(tmp_path: Path) -> None:
    (tmp_path / "upload").write_bytes(tinymodel.model())
    facts = parsing.read_in_child(tmp_path / "upload", tmp_path / "out", "tiny")
    assert facts == {"joints": 3, "clips": 1, "skins": 1, "vertices": 3, "notes": facts["notes"]}
    assert (tmp_path / "out").read_bytes() == tinymodel.model()


def test_it_answers_with_the_place_of_a_fault(tmp_path: Path) -> None:
    (tmp_path / "upload").write_bytes(tinymodel.model()[:100])
    with pytest.raises(ContentError) as refusal:
        parsing.read_in_child(tmp_path / "upload", tmp_path / "out", "tiny")
    assert refusal.value.place == "byte 8"
    assert not (tmp_path / "out").exists()


def test_out_of_memory(tmp_path: Path) -> None:
    ended = child(tmp_path, "parsing.read_upload = lambda *_: bytearray(parsing.MEMORY_BYTES)")
    assert json.loads(ended.stdout)["message"] == "reading it takes more than 1024 MiB of memory"


def test_out_of_time(tmp_path: Path) -> None:
    ended = child(tmp_path, "parsing.PROCESSOR_SECONDS = 1\ndef spin(*_):\n    while True: pass\nparsing.read_upload = spin")
    assert ended.returncode == -signal.SIGXCPU
    assert parsing.refusal(ended.returncode, b"").message == "reading it takes more than 10 s of computing"


def test_a_defect_in_it_is_logged_and_not_told(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    ended = child(tmp_path, "parsing.read_upload = lambda *_: 1 / 0")
    refusal = parsing.refusal(ended.returncode, ended.stderr.encode())
    assert refusal.message == "the reader failed on this file; it is not taken"
    assert "ZeroDivisionError" in caplog.text


def test_a_model_of_many_files_that_is_too_large(tmp_path: Path) -> None:
    ended = child(tmp_path, "parsing.LARGEST_MODEL_BYTES = 1 << 10")
    assert json.loads(ended.stdout)["message"].startswith("the model with its files has")
