"""Whatever the machine, the events and the edits: the log alone gives the same stage again, and a first
remedy helps.
"""

import random

import pytest
from playing import role_of
from random_machines import machine_text
from statwalk.stage.explain.counterfactual import tried
from statwalk.stage.explain.whynot import whynot
from statwalk.stage.replay import replay
from statwalk.stage.stage import Stage

KINDS = (Stage.send, Stage.send, Stage.hold, Stage.release)


def lived(seed):
    """Three actors who are sent all kinds of things; their machine is edited twice."""
    chance = random.Random(seed)
    texts = [machine_text(chance) for _ in range(3)]
    stage = Stage(seed=seed)
    stage.add_many(role_of(texts[0]), [((x, 0, 0), x) for x in range(3)], ["Ada", None, None])
    for part in range(6):
        if part in (2, 4):
            stage.edit(role_of(texts[part // 2]), texts[part // 2])
        for actor in (1, 2, 3):
            chance.choice(KINDS)(stage, actor, chance.choice(stage.role("tiny").machine.events[:-1]))
            stage.set(actor, "stamina", chance.randint(0, 20))
        stage.step(chance.randint(1, 25))
    return stage, texts[0], chance


@pytest.mark.parametrize("seed", range(3))
def test_the_log_gives_it_again(seed):
    stage, text, chance = lived(seed)
    end = stage.hash
    again = replay(stage.dump(), lambda name, version=text: role_of(version, name.partition("@")[0]))
    assert again.hash == end
    tick = chance.randint(0, stage.head)
    stage.seek(tick)
    again.seek(tick)
    assert again.hash == stage.hash
    stage.seek(stage.head)
    assert stage.hash == end


@pytest.mark.parametrize("seed", range(6, 8))
def test_the_first_remedy_helps(seed):
    stage, _, chance = lived(seed)
    tick, actor = chance.randint(1, stage.head), chance.randint(1, 3)
    event = chance.choice(stage.roles[stage.state_at(tick - 1).find(actor)[0]].machine.events[:-1])
    answer = whynot(stage, actor, event, tick)
    assert answer.fired or answer.remedies
    for one in answer.remedies[:1]:
        assert tried(stage, actor, event, tick, one.change).fired == one.fires
