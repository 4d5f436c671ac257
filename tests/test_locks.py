"""What the two commands install is locked: each package with version and hashes, in step with pyproject.toml;
the bill of materials names the same packages.
"""

import json
import re
import tomllib

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from paths import ROOT

LOCKS = ROOT / "server" / "locks"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
TOOLS = PROJECT["optional-dependencies"]["dev"]
BACKEND = tomllib.loads((ROOT / "pyproject.toml").read_text())["build-system"]["requires"]
WANTED = {
    "run.txt": [*PROJECT["dependencies"], *BACKEND],
    "test.txt": [*PROJECT["dependencies"], *BACKEND, *TOOLS],
    "node.txt": re.findall(r'NODE_FROM_PYPI = "(.+)"', (ROOT / "server" / "build_hook.py").read_text()),
}


def blocks(lock: str) -> list[str]:
    """The packages of a lock, each with its hashes."""
    return (LOCKS / lock).read_text().replace("\\\n", "").splitlines()


def locked(lock: str) -> set[tuple[str, str]]:
    return {(str(canonicalize_name(name)), version) for name, version in pairs(lock)}


def pairs(lock: str) -> list[tuple[str, str]]:
    return [(block.partition("==")[0], block.partition("==")[2].split()[0]) for block in blocks(lock)]


@pytest.mark.parametrize("lock", WANTED)
def test_a_lock_holds_what_the_project_asks_for(lock: str) -> None:
    assert WANTED[lock]
    for requirement in map(Requirement, WANTED[lock]):
        versions = [version for name, version in locked(lock) if name == canonicalize_name(requirement.name)]
        assert versions, requirement
        assert all(requirement.specifier.contains(version) for version in versions), requirement


@pytest.mark.parametrize("lock", WANTED)
def test_a_lock_has_versions_and_hashes_and_no_address(lock: str) -> None:
    for block in blocks(lock):
        assert re.fullmatch(r"[\w.-]+==[\w.+!]+( ; [^;]+?)?\s+(--hash=sha256:[0-9a-f]{64}\s*)+", block), block
    assert "://" not in (LOCKS / lock).read_text()


def test_the_tests_run_on_what_is_served() -> None:
    assert locked("run.txt") <= locked("test.txt")


@pytest.mark.parametrize("name", ["uvicorn", "numba", "schemathesis"])
def test_a_package_whose_inside_is_used_has_an_upper_bound(name: str) -> None:
    (requirement,) = (
        Requirement(line) for line in [*PROJECT["dependencies"], *TOOLS] if Requirement(line).name == name
    )
    assert any(bound.operator == "<" for bound in requirement.specifier)


def test_the_bill_of_materials_names_what_is_locked() -> None:
    bill = json.loads((LOCKS / "sbom.json").read_text())
    packages = json.loads((ROOT / "static" / "package-lock.json").read_text())["packages"]
    viewer = {
        (path.removeprefix("node_modules/"), package["version"])
        for path, package in packages.items()
        if path and not package.get("dev")
    }
    named = {(entry["name"], entry["version"]) for entry in bill["components"]}
    assert named == set(pairs("run.txt")) | viewer
    assert all(entry["purl"].startswith(("pkg:pypi/", "pkg:npm/")) for entry in bill["components"])
    assert bill["metadata"]["component"]["version"] == PROJECT["version"]
