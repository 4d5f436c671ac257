"""tests/ mirrors the package: tests/X/test_Y.py tests the module or package X/Y, test_Y_topic.py part of it.

A law that concerns more than one module is in a list.
"""

from fnmatch import fnmatchcase
from pathlib import Path

import pytest
from paths import ROOT

TESTS, PACKAGE = ROOT / "tests", ROOT / "server" / "statwalk"
OUTSIDE = {"browser", "machines", "reliability", "support", "systems"}
"""the viewer, shipped machines, promises, helpers, and the ids of the spec: no folders of the package"""
LAWS = {
    # the repository
    "test_documents.py",
    "test_floors.py",
    "test_left_out.py",
    "test_locks.py",
    "test_mirror.py",
    "test_static_checks.py",
    "test_viewer_checks.py",
    # poses, normals and vertices of all models against three.js
    "character/test_reference_normals.py",
    "character/test_reference_poses.py",
    # the command without a verb: the face of its package
    "cli/test_overview.py",
    # hostile files, other readers, an extension: all modules of the format together
    "files/gltf/test_invalid_corpus.py",
    "files/gltf/test_quantization.py",
    "files/gltf/test_second_reader.py",
    "files/gltf/test_third_reader.py",
    # machine.schema.json against the reader
    "files/machine_yaml/edit/test_edit_laws.py",
    "files/machine_yaml/test_schema.py",
    # the rules of the spec, and one step of a machine as a whole
    "machine/runtime/test_plain_python.py",
    "machine/runtime/test_rule_*.py",
    "machine/test_recorded_runs.py",
    # the same bits on every processor
    "maths/test_same_bits_everywhere.py",
    "maths/test_targets.py",
    # laws of a stage and its tick as a whole
    "stage/test_crossings.py",
    "stage/test_determinism.py",
    "stage/test_determinism_whole.py",
    "stage/test_layers.py",
    "stage/test_layers_change_together.py",
    "stage/test_model_space.py",
    "stage/test_no_jump_in_layers.py",
    "stage/test_random_lives.py",
    "stage/test_random_machines.py",
    # the server as a client sees it
    "web/routes/test_recording.py",
    "web/routes/test_upload_and_walk.py",
    "web/test_actions.py",
    "web/test_any_json.py",
    "web/test_any_message.py",
    "web/test_description.py",
    "web/test_httpx_client.py",
    "web/test_matrix.py",
    "web/test_ready.py",
    "web/test_rooms.py",
    "web/test_serve.py",
    "web/test_shared.py",
    "web/test_slices.py",
}
FILES = [
    path.relative_to(TESTS)
    for path in sorted(TESTS.rglob("test_*.py"))
    if path.relative_to(TESTS).parts[0] not in OUTSIDE
]


def modules_tested(file: Path) -> list[Path]:
    """The modules and packages that a test file may be named after."""
    folder = PACKAGE / file.parent
    modules = [path for path in folder.glob("*") if path.is_dir() or path.suffix == ".py"]
    return [path for path in modules if f"{file.stem}_".startswith(f"test_{path.stem}_")]


@pytest.mark.parametrize("file", FILES, ids=Path.as_posix)
def test_a_test_file_is_named_after_what_it_tests(file: Path) -> None:
    is_law = any(fnmatchcase(file.as_posix(), law) for law in LAWS)
    assert modules_tested(file) or is_law, f"no module {file.parent}/{file.stem.removeprefix('test_')}"


@pytest.mark.parametrize("law", sorted(LAWS))
def test_a_law_has_its_file_and_no_module(law: str) -> None:
    files = [file for file in FILES if fnmatchcase(file.as_posix(), law)]
    assert files
    assert not [file for file in files if modules_tested(file)]
