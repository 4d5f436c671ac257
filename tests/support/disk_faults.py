"""Processes whose system calls fail, as those of a full or broken disk; what they answer meanwhile."""

from __future__ import annotations

import signal
import subprocess
from typing import NamedTuple

from keeper import Plan, keep
from killed_calls import Used, broken_after
from power_cuts import Before, Sample, check
from promised import Promised
from system_calls import WRITING, calls
from traced import CHANGES, Answer, traced

FAILING = "pwrite64,fdatasync,fsync,ftruncate,unlink"
UNTIL_TOLD = 0
REFUSALS = 3
"""after so many refusals the disk works again that was to fail until it is told"""


class Fault(NamedTuple):
    """The nth call of a thread fails with `error`, and the calls after it: `times` in all, or `UNTIL_TOLD`.

    `only`: the calls that fail.
    """

    error: str
    call: int
    times: int = 1
    only: str = FAILING

    def options(self) -> tuple[str, str]:
        """Returns what tells strace."""
        last = "+" if self.times == UNTIL_TOLD else f"..{self.call + self.times - 1}"
        return "-e", f"inject={self.only}:error={self.error}:when={self.call}{last}"


class Outcome(NamedTuple):
    """What came of a fault: how many inputs were acknowledged and how often one was refused; and which
    promise broke, or nothing.
    """

    inputs: int
    refusals: int
    broken: str


class _Watch:
    """Ends the fault after some refusals."""

    def __init__(self, fault: Fault) -> None:
        self.fault, self.refusals = fault, 0

    def __call__(self, answer: Answer, tracer: subprocess.Popen[str]) -> None:
        self.refusals += _is_refusal(answer)
        if self.fault.times == UNTIL_TOLD and self.refusals == REFUSALS and tracer.poll() is None:
            tracer.send_signal(signal.SIGINT)


def _is_refusal(answer: Answer) -> bool:
    return "refused" in answer or "disk" in answer


def outcome(used: Used, fault: Fault, plan: Plan) -> Outcome:
    """Lets a process keep its stages through a fault: it must come to the end of its plan, so it recovers
    without a new start. A power cut after any of its calls must leave what is acknowledged; so must its end.
    """
    trace = used.folder.parent / "trace"
    before = Before({path.name: path.read_bytes() for path in used.folder.iterdir()}, used.answers)
    options = (*WRITING, "-e", f"trace={CHANGES}", *fault.options(), "-o", str(trace))
    done = traced(used.folder, keep, plan, *options, watch=_Watch(fault))
    promised = Promised()
    for answer in used.answers + done.answers:
        promised.add(answer)
    refusals = sum(map(_is_refusal, done.answers))
    if done.status != 0 and done.answers:  # without answers it has refused to start
        return Outcome(promised.inputs, refusals, f"the process ended with {done.status}")
    cuts = check(calls([trace]), used.folder, Sample(plan.seed, draws=0), before)
    found = [*cuts.broken[:1], broken_after(used.folder, promised)]
    return Outcome(promised.inputs, refusals, "; ".join(filter(None, found)))
