"""Checks the promises with the numbers that a release needs: `python benchmarks/reliability.py CHECK …`.

    python benchmarks/reliability.py api --cases 50000 --seed 1

The tests in tests/reliability/ run the same checks with small numbers. Each check is a module in
`reliability_checks/` with `add_options` and `main`, which returns whether the promise held.
"""

from __future__ import annotations

import argparse
import sys
from importlib import import_module
from pathlib import Path

HERE = Path(__file__).resolve().parent
CHECKS = sorted(path.stem for path in (HERE / "reliability_checks").glob("*.py"))


def main() -> None:
    """Runs the check that the command line names; the exit status is 1 if the promise did not hold."""
    sys.path[:0] = [str(HERE / "reliability_checks"), str(HERE.parent / "tests" / "support")]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    commands = parser.add_subparsers(dest="check", required=True)
    asked = next((word for word in sys.argv[1:] if word in CHECKS), "")
    for name in CHECKS:
        command = commands.add_parser(name)
        if name == asked:
            import_module(name).add_options(command)
    options = parser.parse_args()
    sys.exit(not import_module(options.check).main(options))


if __name__ == "__main__":
    main()
