"""A process finds compiled code of its own sources, libraries and processor, and no other code."""

import json
import os
import shutil
import subprocess
import sys
import time

import pytest
from statwalk.maths import code_folder

REPORT = """
import json, sys
from statwalk.maths import code_folder, compiling
names = []
with compiling.announced(lambda number, name: names.append(name)):
    from statwalk.motion.keys import _kernels
print(json.dumps([str(code_folder.folder()), names]))
"""


def started(**variables):
    """Folder and names of compiled kernels of a process that imports the kernels of keys."""
    path = os.pathsep.join(filter(None, sys.path))
    environment = {
        **os.environ,
        "PYTHONPATH": path,
        **{name: str(value) for name, value in variables.items()},
    }
    told = subprocess.run(
        [sys.executable, "-c", REPORT], env=environment, capture_output=True, text=True, check=True
    )
    return json.loads(told.stdout)


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    """A copy of the package's sources."""
    copied = tmp_path_factory.mktemp("sources") / "statwalk"
    return shutil.copytree(
        code_folder.PACKAGE, copied, ignore=lambda _, names: [name for name in names if name == "__pycache__"]
    )


def changed(package, name, old, new):
    """The fingerprint with one text of one file replaced."""
    path = package / name
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    try:
        return code_folder.fingerprint(package)
    finally:
        path.write_text(text)


def kernel_file(name):
    """The path of a file with compiled code, wherever it lies in the package."""
    return next(
        path.relative_to(code_folder.PACKAGE)
        for path in code_folder.compiled_sources(code_folder.PACKAGE)
        if path.name == name
    )


def test_the_same_sources_elsewhere_share_a_folder(package):
    assert code_folder.fingerprint(package) == code_folder.fingerprint(code_folder.PACKAGE)


@pytest.mark.parametrize(
    ("name", "old", "new"), [("repair.py", "abs(x)", "abs(y)"), ("lanes.py", '"fadd"', '"fsub"')]
)
def test_a_change_in_what_is_compiled_into_others_changes_the_folder(package, name, old, new):
    assert changed(package, kernel_file(name), old, new) != code_folder.fingerprint(package)


def test_a_change_elsewhere_does_not(package):
    assert changed(package, "web/page.py", "page", "Page") == code_folder.fingerprint(package)


def test_constants_that_kernels_import_belong_to_them(tmp_path):
    package = tmp_path / "statwalk"
    (package / "rig").mkdir(parents=True)
    (package / "kernels.py").write_text(
        "from statwalk.rig import (\n    sizes,\n)\n@kernel()\ndef step(): ...\n"
    )
    (package / "rig" / "sizes.py").write_text("import statwalk.rig.numbers\n")
    (package / "rig" / "numbers.py").write_text("SIZE = 3\n")
    (package / "page.py").write_text("from statwalk import kernels\n")
    assert [path.name for path in code_folder.compiled_sources(package)] == [
        "kernels.py",
        "numbers.py",
        "sizes.py",
    ]


def test_the_processor_belongs_to_the_folder(tmp_path):
    folders = {
        started(STATWALK_CACHE=tmp_path, STATWALK_COMPILED=0, **cpu)[0]
        for cpu in ({}, {"NUMBA_CPU_NAME": "haswell"})
    }
    assert len(folders) == 2


def test_a_second_start_compiles_nothing(tmp_path):
    first, second = started(STATWALK_CACHE=tmp_path), started(STATWALK_CACHE=tmp_path)
    assert (first[1], second[1]) == (["gathered", "constant", "lines", "turns"], [])
    assert first[0] == second[0]
    assert first[0].startswith(str(tmp_path))


def test_damaged_code_is_compiled_again(tmp_path):
    folder = started(STATWALK_CACHE=tmp_path)[0]
    for name in os.listdir(folder):
        if name.startswith("_kernels.gathered"):
            with open(os.path.join(folder, name), "wb") as file:
                file.write(b"damaged")
    assert [started(STATWALK_CACHE=tmp_path)[1] for _ in range(2)] == [["gathered"], []]


def test_without_a_folder_to_write_in_a_temporary_one_serves_the_process_and_its_children(
    tmp_path, monkeypatch
):
    blocked = tmp_path / "a file"
    blocked.write_text("no folder")
    monkeypatch.setenv(code_folder.VARIABLE, str(blocked))
    code_folder.folder.cache_clear()
    try:
        folder = code_folder.folder()
        assert started()[1] == ["gathered", "constant", "lines", "turns"]
        assert started() == [str(folder), []]
        assert folder.is_relative_to(os.environ[code_folder.VARIABLE])
    finally:
        code_folder.folder.cache_clear()


@pytest.mark.parametrize(("days", "left"), [(0, 12), (2, 8)])
def test_old_folders_go_when_more_than_a_few_lie_there(tmp_path, monkeypatch, days, left):
    monkeypatch.setenv(code_folder.VARIABLE, str(tmp_path))
    for number in range(11):
        folder = tmp_path / "kernels" / f"old{number}"
        folder.mkdir(parents=True)
        os.utime(folder, (time.time() - 86_400 * days - number,) * 2)
    code_folder.folder.cache_clear()
    try:
        assert code_folder.folder().is_dir()
        assert len(list((tmp_path / "kernels").iterdir())) == left
    finally:
        code_folder.folder.cache_clear()


def test_a_folder_that_only_others_may_write_serves_if_there_is_code_in_it(tmp_path, monkeypatch):
    monkeypatch.setattr(code_folder.tempfile, "TemporaryFile", refused)
    monkeypatch.setenv(code_folder.VARIABLE, str(tmp_path))
    kept = tmp_path / "kernels" / code_folder.fingerprint(code_folder.PACKAGE)
    kept.mkdir(parents=True)
    (kept / "step.nbi").touch()
    code_folder.folder.cache_clear()
    try:
        assert code_folder.folder() == kept
    finally:
        code_folder.folder.cache_clear()


def refused(**_):
    """What root may do, and others may not."""
    raise PermissionError


@pytest.mark.parametrize(
    ("variable", "expected"),
    [("/a/cache", "/a/cache"), ("relative", "/a/home/.cache"), ("", "/a/home/.cache")],
)
def test_the_cache_folder_of_the_user(monkeypatch, variable, expected):
    monkeypatch.setenv("XDG_CACHE_HOME", variable)
    monkeypatch.setenv("HOME", "/a/home")
    assert str(code_folder.user_cache_folder()) == expected
