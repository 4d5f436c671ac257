"""Records 2,100 runs of generated machines: PYTHONPATH=server:tests python tests/support/record_runs.py

Run the script at the last commit before the core changes. The recordings show what that commit does; their
first line names the last commit that changed server/. The script writes two files into
tests/support/recordings/: machines.txt.xz, where no pose decides, and poses.txt.xz, where conditions, senses
and touches look at poses. The same commit writes the same bytes. An argument from 0 to 1 records that share
of the runs only.
"""

import subprocess
import sys
from collections import Counter
from multiprocessing import Pool
from random import Random

from run_codes import codes
from run_commands import commands
from run_machines import Machine, machine, near
from run_player import is_valid, play
from run_text import FOLDER, Recording, Run, save

FAMILIES = {"machines": (0, 330, 5), "poses": (100_000, 90, 5)}
"""first seed, machines with their near copies, runs over each"""
MOST_VERDICTS = 250


def main(share: float = 1.0) -> None:
    """Records all families and says what they cover."""
    command = ["git", "log", "-1", "--format=%H", "--", "server"]
    commit = subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    for family, (first, count, each) in FAMILIES.items():
        with Pool(2) as pool:
            tasks = [
                (family == "poses", first + number, number, each) for number in range(round(count * share))
            ]
            parts = pool.map(_part, tasks, 4)
        recording = Recording({}, [], {})
        for machines, runs, played in parts:
            recording.machines.update(machines)
            recording.runs.extend(runs)
            recording.played.update(played)
        size = save(FOLDER / f"{family}.txt.xz", f"{family}: recorded at commit {commit}", recording)
        print(
            f"{family}: {len(recording.runs)} runs of {len(recording.machines)} machine files, {size:,} bytes"
        )
        print(coverage(recording))


def _part(task):
    """A machine, its near copy, and all runs over them."""
    poses, seed, number, each = task
    chance = Random(seed)
    one = _valid(chance, lambda: machine(chance, poses))
    two = _valid(chance, lambda: near(chance, one))
    machines = {2 * number: one.text, 2 * number + 1: two.text}
    runs, played = [], {}
    for which in range(each):
        run, ticks = _told(chance, number * each + which, machines, one)
        runs.append(run)
        played[run.number] = ticks
    return machines, runs, played


def _told(chance: Random, number: int, machines: dict[int, str], one: Machine):
    """A run and its ticks; rarely one that fills every tick with changes, which says little at length."""
    while True:
        run = _run(chance, number, tuple(machines), one)
        ticks = play(machines, run)
        if sum(len(tick.verdicts) for tick in ticks) < MOST_VERDICTS or chance.random() < 0.1:
            return run, ticks


def _valid(chance: Random, make) -> Machine:
    return next(one for one in iter(make, None) if is_valid(one.text))


def _run(chance: Random, number: int, machines: tuple[int, int], one: Machine) -> Run:
    actors, ticks, rate = (
        chance.choice([1, 1, 2, 3]),
        chance.randint(40, 90),
        chance.choice([60, 60, 60, 30, 120]),
    )
    seed, casting = chance.randint(0, 999), chance.choice(["one", "one", "two"])
    found = commands(chance, one, [machines[1], machines[0]][: chance.randint(1, 2)], actors, ticks)
    names = enumerate(["Ada", "Bob", "Eve"][:actors])
    adds = [f"add {casting if row else 'one'} {name} {row * 0.45} 0 0 {row}" for row, name in names]
    return Run(number, seed, rate, ticks, machines, {**found, 1: adds + found.get(1, [])})


def coverage(recording: Recording) -> str:
    """How often each verdict, code, command and rare circumstance occurs."""
    verdicts, kinds, rare = Counter(), Counter(), Counter()
    for run in recording.runs:
        kinds.update(line.split()[0] for lines in run.commands.values() for line in lines)
        for tick in recording.played[run.number]:
            verdicts.update(
                (one.verdict, "+".join(codes(one.reason)) or "(no words)") for one in tick.verdicts
            )
            rare["actions"] += len(tick.actions)
            rare["refused commands"] += len(tick.refused)
            rare["state changes"] += sum(bool(one.to_state) for one in tick.verdicts)
            rare["actor-layer-ticks"] += len(tick.where)
    table = [f"{count:>8} {verdict:8} {code}" for (verdict, code), count in verdicts.most_common()]
    return "\n".join([f"{count:>8} {name}" for name, count in (rare + kinds).items()] + table)


if __name__ == "__main__":
    main(*map(float, sys.argv[1:]))
