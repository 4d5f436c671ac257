"""`python3 server` sets up and runs; `python3 server test` sets up and tests.

Needs nothing but Python 3.11 or newer.

Set-up makes .venv beside this folder, installs the packages of a lock (versions and hashes, `locks/`) and
statwalk into it, which builds the viewer, and remembers what it did, so that the second start goes straight
to the program. Kernels are compiled before the server listens or the tests run. Other arguments are passed
on: `python3 server --port 9000`.
"""

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
VENV = ROOT / ".venv"
LOCKS = ROOT / "server" / "locks"
PYTHON = VENV / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge")
ALONE = "tests/reliability/alone", "tests/browser/alone"
"""tests beside which no other test runs: they count seconds"""
VIEWER_SOURCES = (
    "index.html",
    "package.json",
    "package-lock.json",
    "vite.config.ts",
    "tsconfig.json",
    "src",
    "public",
)


def run(*command: object) -> None:
    """Runs a command in the checkout; its failure ends the program with its exit status."""
    status = subprocess.run([str(part) for part in command], cwd=ROOT).returncode
    if status:
        sys.exit(f"statwalk: this failed with status {status}: {' '.join(str(part) for part in command)}")


def fingerprint(extra: str) -> str:
    """A hash of what the installation was made from: project file, lock, build hook, viewer sources."""
    state = hashlib.sha256(extra.encode() + sys.version.encode())
    lock = f"server/locks/{extra or 'run'}.txt"
    for name in (
        "pyproject.toml",
        lock,
        "server/build_hook.py",
        *(f"static/{name}" for name in VIEWER_SOURCES),
    ):
        path = ROOT / name
        for file in sorted(path.rglob("*")) if path.is_dir() else [path]:
            if file.is_file():
                state.update(file.relative_to(ROOT).as_posix().encode() + file.read_bytes())
    return state.hexdigest()


def make_venv(uv: str | None) -> None:
    """Makes .venv with the Python that runs this; says what to install where Debian left `venv` out."""
    if uv:
        run(uv, "venv", "-q", "--python", sys.executable, VENV)
        return
    try:
        import ensurepip  # noqa: F401  (Debian splits it off)
    except ImportError:
        sys.exit("This Python has no venv. On Debian and Ubuntu: apt-get install python3-venv")
    run(sys.executable, "-m", "venv", VENV)


def install(uv: str | None, *what: object) -> None:
    """Installs packages into .venv, with uv where it is on PATH."""
    if uv:
        run(uv, "pip", "install", "-q", "--python", PYTHON, *what)
    else:
        run(PYTHON, "-m", "pip", "install", "-q", "--disable-pip-version-check", *what)


def set_up(extra: str) -> None:
    """Installs the lock of `extra` (empty: run) and the project into .venv, unless that was done from these
    very sources.
    """
    if sys.version_info < (3, 11):  # noqa: UP036 (an older Python gets as far as here)
        sys.exit(f"Python 3.11 or newer is needed; this is {sys.version.split()[0]}")
    stamp = VENV / f".ready-{extra or 'run'}"
    wanted = fingerprint(extra)
    if stamp.is_file() and stamp.read_text() == wanted:
        return
    sys.stderr.write("statwalk: setting up (about half a minute the first time)\n")
    uv = shutil.which("uv")
    if not PYTHON.exists():
        make_venv(uv)
    install(uv, "--no-deps", "--require-hashes", "-r", LOCKS / f"{extra or 'run'}.txt")
    if not subprocess.run([PYTHON, ROOT / "server" / "build_hook.py"], cwd=ROOT).returncode:
        install(uv, "--no-deps", "--require-hashes", "-r", LOCKS / "node.txt")
    install(uv, "--no-deps", "--no-build-isolation", "-e", ".")
    stamp.write_text(wanted)


def find_browser() -> None:
    """Makes sure that a Chromium is there for the tests of the page: on PATH, else Playwright's, else
    Debian's.
    """
    if any(shutil.which(name) for name in BROWSERS):
        return
    if (
        subprocess.run(
            [PYTHON, "-m", "playwright", "install", "--with-deps", "chromium"], cwd=ROOT
        ).returncode
        == 0
    ):
        return
    if shutil.which("apt-get") and os.geteuid() == 0:
        run("apt-get", "update", "-q")
        run("apt-get", "install", "-y", "-q", "--no-install-recommends", "chromium")
        return
    sys.exit("The tests need a Chromium: install one (Debian: apt-get install chromium) and run this again")


def find_assimp() -> None:
    """Makes sure that assimp is there, the second reader of files that statwalk writes."""
    if shutil.which("assimp"):
        return
    if shutil.which("apt-get") and os.geteuid() == 0:
        run("apt-get", "update", "-q")
        run("apt-get", "install", "-y", "-q", "--no-install-recommends", "assimp-utils")
        return
    sys.exit("The tests need assimp: install it (Debian: apt-get install assimp-utils) and run this again")


def run_tests(arguments: list[str]) -> None:
    """Runs the tests that are asked for; without arguments all tests, those last that count seconds."""
    pytest = PYTHON, "-m", "pytest"
    # the tests start Python hundreds of times: without bytecode each start compiles every module
    os.environ["PYTHONPYCACHEPREFIX"] = str(VENV / "bytecode")
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    if arguments:
        run(*pytest, *arguments)
        return
    workers = "--numprocesses=auto", "--maxprocesses=4", "--dist=loadfile", "--no-loadscope-reorder"
    run(*pytest, *workers, *(f"--ignore={folder}" for folder in ALONE))
    run(*pytest, *ALONE)


def main(arguments: list[str]) -> None:
    """Sets up, then becomes the program asked for."""
    if arguments[:1] == ["test"]:
        set_up("test")
        run(PYTHON, "-m", "statwalk.maths.prepare")
        find_browser()
        find_assimp()
        run_tests(arguments[1:])
        return
    set_up("")
    os.execv(PYTHON, [str(PYTHON), "-m", "statwalk.cli", "serve", *arguments])


main(sys.argv[1:])
