"""The house stands: imports point down, also inside folders; no folder imports its sibling, and no file has
outgrown its idea.
"""

import ast
from collections import Counter
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest
from paths import ROOT

PACKAGE = ROOT / "server" / "statwalk"
FLOORS = (
    {"errors"},
    {"maths"},
    {"rig", "motion", "machine", "skin", "solve", "world"},
    {"character"},
    {"files", "stage"},
    {"services"},
    {"web"},
    {"cli"},
)
FLOOR_OF = {folder: floor for floor, folders in enumerate(FLOORS) for folder in folders}
FACE = {"statwalk", "statwalk.__main__"}  # the face of the package: it may name any folder
LONGEST_FILE = 250
MAY_SHARE_A_NAME = {"__init__", "_kernels"}
BEAR_THE_NAME_OF_WHAT_THEY_ASK_FOR = {"statwalk.services.hosting.stage_messages"}


def module_name(path: Path) -> str:
    parts = ("statwalk", *path.relative_to(PACKAGE).with_suffix("").parts)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {module_name(path): path for path in sorted(PACKAGE.rglob("*.py"))}
FOLDERS = sorted({path.parent for path in MODULES.values()})


def imports_of(path: Path, name: str) -> set[str]:
    """The modules of this package that a file imports, wherever in the file it does so."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names if alias.name.split(".")[0] == "statwalk"}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            if (node.module or "").split(".")[0] == "statwalk":
                whole = {f"{node.module}.{alias.name}" for alias in node.names}
                found |= {module if module in MODULES else str(node.module) for module in whole}
    return found - {name}


IMPORTS = {name: imports_of(path, name) for name, path in MODULES.items()}


def folder(module: str) -> str:
    return module.split(".")[1]


def entry(path: Path, inside: Path) -> str:
    """The file or sub-folder of `inside` that a path lies in."""
    return path.relative_to(inside).parts[0]


def arrows(inside: Path) -> dict[str, set[str]]:
    """What each file and sub-folder of a folder imports of its neighbours there; the folder's own `__init__`
    is its face.
    """
    found: dict[str, set[str]] = {}
    for name, path in MODULES.items():
        if inside not in path.parents or path == inside / "__init__.py":
            continue
        others = {MODULES[other] for other in IMPORTS[name] if other in MODULES}
        near = {
            entry(other, inside)
            for other in others
            if inside in other.parents and other != inside / "__init__.py"
        }
        found.setdefault(entry(path, inside), set()).update(near - {entry(path, inside)})
    return found


@pytest.mark.parametrize("name", [name for name in MODULES if name not in FACE])
def test_imports_point_down(name: str) -> None:
    for other in IMPORTS[name]:
        assert other not in FACE, f"{name} imports the package's face"
        same_folder = folder(other) == folder(name)
        assert same_folder or FLOOR_OF[folder(other)] < FLOOR_OF[folder(name)], (
            f"{name} imports {other}, which is not below it"
        )


@pytest.mark.parametrize("name", [name for name in MODULES if name.startswith("statwalk.web.")])
def test_the_web_knows_a_stage_by_its_host_only(name: str) -> None:
    assert IMPORTS[name] & {"statwalk.stage.stage", "statwalk.services.hosting.live_stage"} == set()


@pytest.mark.parametrize("inside", FOLDERS, ids=lambda path: path.relative_to(PACKAGE.parent).as_posix())
def test_files_and_sub_folders_form_no_circle(inside: Path) -> None:
    if inside == PACKAGE:
        return
    try:
        TopologicalSorter(arrows(inside)).prepare()
    except CycleError as error:
        pytest.fail(f"{inside.name}: {' <- '.join(error.args[1])}")


def test_no_cycle() -> None:
    TopologicalSorter(IMPORTS).prepare()


@pytest.mark.parametrize("folders", FLOORS, ids=lambda folders: "-".join(sorted(folders)))
def test_no_two_modules_of_a_floor_share_a_name(folders: set[str]) -> None:
    names = Counter(
        path.stem for name, path in MODULES.items() if name not in FACE and folder(name) in folders
    )
    assert [name for name, count in names.items() if count > 1 and name not in MAY_SHARE_A_NAME] == []


def test_no_two_public_classes_share_a_name() -> None:
    names = Counter(
        node.name
        for name, path in MODULES.items()
        if name not in BEAR_THE_NAME_OF_WHAT_THEY_ASK_FOR
        for node in ast.parse(path.read_text()).body
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_")
    )
    assert [name for name, count in names.items() if count > 1] == []


@pytest.mark.parametrize("path", MODULES.values(), ids=MODULES)
def test_file_has_one_idea(path: Path) -> None:
    assert len(path.read_text().splitlines()) <= LONGEST_FILE
