"""Mutates valid files of all formats by chance, reads them, and prints what broke, with its seed.

    python tests/support/torture/mutate.py                       # 20,000 files of each format
    python tests/support/torture/mutate.py bvh x --count 500     # of two formats
    python tests/support/torture/mutate.py bvh --count 1 --seed 4711

Each file ends in a Character that moves and has finite numbers only, or in an error of statwalk's that names
a place, within 5 s; no other exception.
"""

import argparse
import resource
import sys
import time
import traceback
from collections import Counter
from pathlib import Path

import numpy as np

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from torture.capture_files import BVH, TRC
from torture.chunk_files import CHUNK
from torture.detail_files import CHUNK_DETAIL, GLTF_DETAIL
from torture.faq_files import FAQ_CHARACTER, FAQ_CONSTRAINTS, FAQ_KEYS, FAQ_SKELETON, FAQ_SKIN
from torture.gltf_files import GLTF_MODEL
from torture.md2_files import MD2
from torture.mutator import Mutator
from torture.outcomes import memory
from torture.x_files import X

MUTATORS = {
    "gltf": GLTF_MODEL,
    "gltf-detail": GLTF_DETAIL,
    "chunk": CHUNK,
    "chunk-detail": CHUNK_DETAIL,
    "x": X,
    "md2": MD2,
    "bvh": BVH,
    "trc": TRC,
    "faq-skeleton": FAQ_SKELETON,
    "faq-keys": FAQ_KEYS,
    "faq-skin": FAQ_SKIN,
    "faq-constraints": FAQ_CONSTRAINTS,
    "faq-character": FAQ_CHARACTER,
}
WARM = 200
"""files after which memory is measured first"""


def run(name: str, mutator: Mutator, count: int, first: int) -> int:
    """Runs the seeds first … first + count; prints what broke and what came of the rest."""
    results, slowest, before = Counter[str](), (0.0, 0), memory()
    began = time.perf_counter()
    for seed in range(first, first + count):
        data, start = mutator.mutated(seed), time.perf_counter()
        try:
            results[mutator.outcome(data)] += 1
        except Exception:
            results["broken"] += 1
            print(f"{name}, seed {seed}:\n{traceback.format_exc(limit=-4)}", flush=True)
        slowest = max(slowest, (time.perf_counter() - start, seed))
        before = memory() if seed == first + WARM else before
    more, seconds = (memory() - before) / 2**20, time.perf_counter() - began
    print(
        f"{name}: {dict(results)} in {seconds:.0f} s; slowest {slowest[0]:.2f} s (seed {slowest[1]}); "
        f"memory {more:+.0f} MiB, peak {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 10} MiB",
        flush=True,
    )
    return results["broken"]


def main() -> None:
    parser = argparse.ArgumentParser(description="mutates valid files by chance and reads them")
    parser.add_argument("formats", nargs="*", help=f"some of {', '.join(MUTATORS)}; all by default")
    parser.add_argument("--count", type=int, default=20_000)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    with np.errstate(all="ignore"):
        broken = [
            run(name, MUTATORS[name], options.count, options.seed) for name in options.formats or MUTATORS
        ]
    sys.exit(sum(broken) > 0)


if __name__ == "__main__":
    main()
