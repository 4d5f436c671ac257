"""Writes the locks and the bill of materials again: `python server/locks/update.py`.

    run.txt    what `python3 server` installs, the build backend included
    test.txt   what `python3 server test` installs: the same, and the test tools
    node.txt   Node, for the build of the viewer where PATH has none
    sbom.json  what run.txt and the viewer contain (CycloneDX)

Each package is there with its version and the hashes of its files, for every platform and Python. You need
the extra `lock` of pyproject.toml. Versions stay as they are while they fit; `--upgrade` takes the newest.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BUILD = ("hatchling>=1.27", "editables")  # the second one: hatchling installs a checkout with it
NODE = re.search(r'NODE_FROM_PYPI = "(.+)"', (HERE.parent / "build_hook.py").read_text())
PACKAGE = re.compile(r"^([A-Za-z0-9._-]+)==([^ ;\\]+)", re.MULTILINE)
SPECIFICATION = "1.6"


def lock(name: str, *sources: str, arguments: list[str]) -> None:
    """Resolves requirements, and writes a lock."""
    command = [sys.executable, "-m", "uv", "pip", "compile", "--quiet", "--universal", "--generate-hashes"]
    shape = ["--no-header", "--no-annotate", "--python-version", "3.11", "--output-file", str(HERE / name)]
    with tempfile.TemporaryDirectory() as folder:
        extra = Path(folder) / "extra.in"
        extra.write_text("\n".join(requirement for requirement in sources if requirement != "pyproject.toml"))
        files = [str(extra), *(str(ROOT / source) for source in sources if source == "pyproject.toml")]
        subprocess.run(
            [*command, *shape, *arguments, *files], cwd=ROOT, check=True, stdout=subprocess.DEVNULL
        )


def component(kind: str, name: str, version: str) -> dict[str, str]:
    """Returns a package as the bill of materials names it."""
    place = f"pkg:{kind}/{name.replace('@', '%40')}@{version}"
    return {"type": "library", "bom-ref": place, "name": name, "version": version, "purl": place}


def viewer_packages() -> list[tuple[str, str]]:
    """Returns name and version of the packages that the built viewer contains."""
    packages = json.loads((ROOT / "static" / "package-lock.json").read_text())["packages"]
    return [
        (path.rpartition("node_modules/")[2], package["version"])
        for path, package in packages.items()
        if path and not package.get("dev")
    ]


def bill_of_materials() -> dict[str, Any]:
    """Returns the CycloneDX document of run.txt and the viewer."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    packages = [("pypi", *found) for found in PACKAGE.findall((HERE / "run.txt").read_text())]
    packages += [("npm", *found) for found in viewer_packages()]
    return {
        "bomFormat": "CycloneDX",
        "specVersion": SPECIFICATION,
        "version": 1,
        "metadata": {
            "component": {
                "type": "application",
                "bom-ref": project["name"],
                "name": project["name"],
                "version": project["version"],
                "licenses": [{"license": {"id": project["license"]}}],
            }
        },
        "components": [component(*package) for package in sorted(packages)],
    }


def main(arguments: list[str]) -> None:
    """Writes all files; stops at a bill of materials that does not fit its schema."""
    from cyclonedx.schema import SchemaVersion
    from cyclonedx.validation.json import JsonStrictValidator

    assert NODE
    lock("run.txt", "pyproject.toml", *BUILD, arguments=arguments)
    in_step = ["--extra", "dev", "--constraint", str(HERE / "run.txt")]
    lock("test.txt", "pyproject.toml", *BUILD, arguments=[*in_step, *arguments])
    lock("node.txt", NODE[1], arguments=arguments)
    text = json.dumps(bill_of_materials(), indent=1) + "\n"
    if wrong := JsonStrictValidator(SchemaVersion.V1_6).validate_str(text):
        sys.exit(f"the bill of materials does not fit CycloneDX: {wrong}")
    (HERE / "sbom.json").write_text(text)


if __name__ == "__main__":
    main(sys.argv[1:])
