"""Who can reach an actor, worked out by hand; and that all others make no difference to it, to the bit."""

import statwalk
from playing import role_of, text_of
from statwalk.stage.explain.influencing_actors import InfluencingActors
from statwalk.stage.stage import Stage

WALKER = "colliders: {body: {sphere: 0.4}}\nsenses: {HOP: {touch: [body, ball]}}"
CANNON = "colliders: {ball: {sphere: 0.1}}"
COIN = "colliders: {coin: {sphere: 0.3}}\nsenses: {HOP: {touch: [coin, body]}}"
CLOCK = "colliders: {hand: {sphere: 0.1}}"
RINGS = 'cells:\n  STAND/GO: {to: WALK, action: "raise(RING, all)"}'
FLOCK = "flock: {}\n"


def influences(name, **machines):
    roles = {key: role_of(text_of(more=more), key) for key, more in machines.items()}
    return InfluencingActors(roles, 1, name)


def test_who_is_touched_reaches_and_who_only_touches_does_not():
    machines = {"walker": WALKER, "cannon": CANNON, "coin": COIN, "clock": CLOCK}
    assert influences("coin", **machines).names == {"coin", "walker", "cannon"}
    assert influences("walker", **machines).names == {"walker", "cannon"}
    assert influences("cannon", **machines).names == {"cannon"}


def test_who_raises_an_event_reaches_whoever_knows_it_and_hears_whether_anybody_does():
    bell = role_of(text_of(more=RINGS.replace("RING", "STRIKE")), "bell")
    table = "state | STRIKE | END\nSTAND | HOP    |\nHOP   |        | STAND"
    states = "states: {STAND: {motion: stand, loop: true}, HOP: {motion: hop}}"
    clock = role_of(text_of(table, states=states), "clock")
    roles = {"bell": bell, "clock": clock, "walker": role_of(text_of(more=WALKER), "walker")}
    assert InfluencingActors(roles, 1, "clock").names == {"clock", "bell"}
    assert InfluencingActors(roles, 1, "bell").names == {"clock", "bell"}
    assert InfluencingActors(roles, 1, "walker").names == {"walker"}


def test_fellows_count_where_they_reach_one_another():
    assert not influences("coin", coin=COIN, walker=WALKER).counts_fellows
    assert influences("coin", coin=COIN.replace("body", "coin")).counts_fellows
    assert influences("coin", coin=COIN, walker=WALKER.replace("ball", "coin")).counts_fellows
    assert influences("coin", coin=FLOCK).counts_fellows


def test_an_actor_of_the_playground_goes_through_the_same_states_among_those_that_reach_it():
    stage = statwalk.load_scene("playground").open()
    stage.hold(stage.actors[0], "FORWARD")
    stage.step(30)
    expected, alone = stage.fork(), {}
    for actor in stage.actors:
        influences = InfluencingActors(stage.roles, actor.id, actor.role.name)
        alone[actor.id] = stage.fork_from(influences.only(stage.state.copy()))
    expected.step(300)
    for actor in expected.actors:
        alone[actor.id].step(300)
        assert alone[actor.id].actor(actor.id).hash == actor.hash
    assert len({len(fork.actors) for fork in alone.values()}) > 1


def test_nobody_is_left_out_where_all_are_fellows():
    stage = Stage()
    stage.add_many(role_of(text_of(more=FLOCK)), [((x, 0, 0), 0) for x in range(3)])
    influences = InfluencingActors(stage.roles, 2, "tiny")
    assert influences.only(stage.state).ids == [1, 2, 3]
