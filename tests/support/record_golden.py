"""Records the golden sessions of the present version: PYTHONPATH=server python tests/support/record_golden.py

Two sessions of each shipped machine and of each scene go into tests/reliability/golden/VERSION, and replace
those of the same version: once before a release, and again when the numbers change on purpose (golden.py
says what the folder holds; CONTRIBUTING.md when to record). The same code writes the same bytes.
"""

import json
import shutil
import tomllib

from golden import GOLDEN, Golden, hashes_of
from paths import ROOT
from random_sessions import CONTENTS, MACHINE_FILE, folder_of, role_of, session
from statwalk.services.library.load import machine_folders
from statwalk.services.library.role_reference import model_digest

SEEDS = (1, 2)
TICKS = 300
TICKS_OF_CROWDS = {"scene-swarm": 100, "scene-geese": 150}


def present_version() -> str:
    """The version that pyproject.toml names, without its last part: `0.1`."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    return ".".join(project["version"].split(".")[:2])


def main() -> None:
    """Writes all sessions, and says how many bytes they take."""
    golden = Golden(GOLDEN / present_version())
    shutil.rmtree(golden.folder, ignore_errors=True)
    (golden.folder / "sessions").mkdir(parents=True)
    sessions = {}
    for content in CONTENTS:
        for seed in SEEDS:
            name = f"{content}-{seed}"
            lines = session(content, seed, TICKS_OF_CROWDS.get(content, TICKS)).dump()
            golden.log(name).write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
            sessions[name] = [found for _, found in hashes_of(lines, role_of)]
    for name, folder in machine_folders().items():
        kept = golden.folder / "machines" / folder_of(name) / MACHINE_FILE
        kept.parent.mkdir(parents=True)
        shutil.copyfile(folder / MACHINE_FILE, kept)
    models = {name: model_digest(role_of(name)).hex() for name in machine_folders()}
    (golden.folder / "hashes.json").write_text(_index(sessions, models))
    sizes = [path.stat().st_size for path in golden.folder.rglob("*") if path.is_file()]
    print(f"{golden.folder.relative_to(ROOT)}: {len(sessions)} sessions, {sum(sizes):,} bytes")


def _index(sessions: dict[str, list[str]], models: dict[str, str]) -> str:
    """The index as JSON, a line for each session and machine."""
    lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(hashes)}" for name, hashes in sessions.items())
    digests = ",\n".join(f"{json.dumps(name)}: {json.dumps(digest)}" for name, digest in models.items())
    return f'{{"models": {{\n{digests}\n}},\n"sessions": {{\n{lines}\n}}}}\n'


if __name__ == "__main__":
    main()
