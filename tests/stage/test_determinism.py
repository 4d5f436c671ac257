"""Same log, same poses, bit for bit: alone and in a crowd, in this process and in another."""

import os
import subprocess
import sys

import pytest
from builders import role
from paths import ROOT
from statwalk.stage.replay import replay
from statwalk.stage.stage import Stage

ROLE = role()
ROLES = {"tiny": ROLE}
REPLAY = """
import sys
from builders import role
from statwalk.stage.replay import replay
print(replay(sys.stdin, {"tiny": role()}.__getitem__).hash)
"""


def played(stage, actor, others=()):
    """A short life: turn, walk, faster, stop, hop; the others do something else."""
    for other in others[::3]:
        stage.send(other, "GO")
    for event in ("TURN", "GO", "HOP"):
        stage.send(actor, event)
        stage.step(17)
    stage.set(actor, "pace", 1.5)
    stage.hold(actor, "GO")
    stage.step(40)
    return stage


def test_one_actor_is_the_same_alone_and_among_a_thousand():
    alone, crowd = Stage(), Stage()
    one = alone.add(ROLE, heading=0.3)
    many = [crowd.add(ROLE, heading=0.3 if i == 500 else i) for i in range(1000)]
    played(alone, one)
    played(crowd, many[500], many[:500])
    assert all((a == b).all() for a, b in zip(one.pose, many[500].pose, strict=True))
    assert one.hash == many[500].hash


@pytest.fixture(scope="module")
def logged():
    stage = Stage(seed=4)
    actor = stage.add(ROLE)
    other = stage.add(ROLE, position=(1, 0, 0))
    played(stage, actor)
    stage.remove(other)
    stage.add(ROLE)
    stage.step(20)
    return stage


def test_a_log_gives_the_same_stage(logged):
    assert replay(logged.dump(), ROLES.__getitem__).hash == logged.hash


def test_a_replay_can_stop_before_the_end(logged):
    fork = logged.fork()
    fork.seek(50)
    assert replay(logged.dump(), ROLES.__getitem__, until=50).hash == fork.hash


@pytest.mark.parametrize("hash_seed", ["0", "77"])
def test_a_new_process_gives_the_same_hash(logged, hash_seed):
    environment = os.environ | {"PYTHONHASHSEED": hash_seed, "PYTHONPATH": str(ROOT / "tests" / "support")}
    command = [sys.executable, "-c", REPLAY]
    done = subprocess.run(
        command, input="\n".join(logged.dump()), env=environment, capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == logged.hash


def test_a_log_can_lie_in_a_file(logged, tmp_path):
    path = tmp_path / "log.jsonl"
    path.write_text("\n".join(logged.dump()))
    assert replay(path, ROLES.__getitem__).head == logged.head
