"""Processes that keep a stage and post to it as fast as they are answered, until they are killed."""

import json
import multiprocessing
import os
import random
import sys
from multiprocessing import forkserver
from multiprocessing.connection import Connection
from pathlib import Path
from typing import NamedTuple
from unittest.mock import patch

from keeping import keeping
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.store.kept_log import KeptLog
from statwalk.services.library.catalogue import Catalogue

CATALOGUE = Catalogue()
"""read once by the process from which the others fork"""
CATALOGUE.role("elbow")
EVENTS = "STRETCH", "BEND"
LONGEST_SECONDS = 0.25
CONTEXT = multiprocessing.get_context("forkserver")
CONTEXT.set_forkserver_preload(["killed"])


class Kill(NamedTuple):
    """The stage of a process that was killed, and the numbers of the inputs that it acknowledged."""

    stage: str
    acknowledged: list[int]


def post_for_ever(folder: Path, is_honest: bool, answers: Connection) -> None:
    """Sends the id of the stage, then for each answer its number in the log; without honesty it does not wait
    for the disk.
    """
    if not is_honest:
        KeptLog.durable = lambda *_: True  # type: ignore[method-assign]
    with keeping(folder, CATALOGUE) as held:
        host = held.open(StageSetup(clock="manual", actors=(AddActor("elbow"),)))
        answers.send(host.id)
        number = 0
        while True:
            number += 1
            post = ask.Post((SendEvent(EVENTS[number % 2]),), key=f"post {number}")
            answers.send(host.handle(post).seq)
            if number % 5 == 0:
                host.handle(ask.Step(2))


def start_forks() -> None:
    """Starts the process from which the others fork; it finds this module by PYTHONPATH only."""
    with patch.dict(os.environ, {"PYTHONPATH": os.pathsep.join(sys.path)}):
        forkserver.ensure_running()


def killed(folder: Path, seed: int, is_honest: bool = True) -> Kill:
    """Kills a process at a random instant after its first answer."""
    answers, told = CONTEXT.Pipe(duplex=False)
    process = CONTEXT.Process(target=post_for_ever, args=(folder, is_honest, told))
    process.start()
    told.close()
    kill = Kill(answers.recv(), [answers.recv()])
    process.join(random.Random(seed).uniform(0, LONGEST_SECONDS))
    process.kill()
    process.join()
    try:
        while True:
            kill.acknowledged.append(answers.recv())
    except EOFError:
        return kill


def logged(folder: Path, stage: str) -> list[int]:
    """The numbers of the inputs in the log of the stage after a start."""
    with keeping(folder, CATALOGUE) as held:
        lines = map(json.loads, held.find(stage).handle(ask.Log())[1:])
        return [line["number"] for line in lines if line["kind"] == "press"]
