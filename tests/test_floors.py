"""The house stands: imports point down, no room imports its sibling, there is no cycle, and no file has outgrown its idea."""

import ast
from graphlib import TopologicalSorter
from pathlib import Path

import pytest
from where import ROOT

PACKAGE = ROOT / "server" / "statwalk"
FLOORS = (
    {"errors"},
    {"maths"},
    {"rig", "motion", "machine", "skin", "world"},
    {"character"},
    {"files", "stage"},
    {"loading"},
    {"web"},
    {"cli"},
)
FLOOR_OF = {room: floor for floor, rooms in enumerate(FLOORS) for room in rooms}
ROOF = {"statwalk", "statwalk.__main__"}  # the face of the package: it may name any room
LONGEST_FILE = 250


def module_name(path: Path) -> str:
    parts = ("statwalk", *path.relative_to(PACKAGE).with_suffix("").parts)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {module_name(path): path for path in sorted(PACKAGE.rglob("*.py"))}


def is_for_types_only(node: ast.AST) -> bool:
    return isinstance(node, ast.If) and "TYPE_CHECKING" in ast.dump(node.test)


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


def room(module: str) -> str:
    return module.split(".")[1]


@pytest.mark.parametrize("name", [name for name in MODULES if name not in ROOF])
def test_imports_point_down(name: str) -> None:
    for other in IMPORTS[name]:
        assert other not in ROOF, f"{name} imports the package's face"
        same_room = room(other) == room(name)
        assert same_room or FLOOR_OF[room(other)] < FLOOR_OF[room(name)], f"{name} imports {other}, which is not below it"


def test_no_cycle() -> None:
    TopologicalSorter(IMPORTS).prepare()


@pytest.mark.parametrize("path", MODULES.values(), ids=MODULES)
def test_file_has_one_idea(path: Path) -> None:
    assert len(path.read_text().splitlines()) <= LONGEST_FILE
