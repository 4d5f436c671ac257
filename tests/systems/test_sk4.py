"""SK4 chains and anchors (FAQ Q3): an end that stays while the rest moves, by hand; gravity against SciPy."""

import numpy as np
import pytest
import statwalk
from chain_bodies import chain_of, lengths, places, role_with
from scipy.linalg import eigh
from scipy.optimize import minimize
from statwalk.errors import MachineError, StatwalkError
from statwalk.stage.replay import replay
from statwalk.stage.stage import Stage

TWO = chain_of((0, 0, 0), (1, 0, 0), (2, 0, 0))
NAMES = ("J0", "J1", "J2")
GRAVITY, UP = 9.81, np.array((0, 2))


@pytest.mark.parametrize("solver", ["two-bone", "ccd", "fabrik", "force"])
def test_the_end_stays_the_start_comes_and_the_root_moves(solver):
    answer = TWO.solve(TWO.bind_pose, NAMES, (1, 1, 0), solver, anchor="J2", pole=(0, 1, 0), iterations=500)
    points = places(TWO, answer.pose)
    assert answer.reached
    np.testing.assert_allclose(points[2], (2, 0, 0), atol=1e-6)  # the anchor
    np.testing.assert_allclose(points[0], (1, 1, 0), atol=2e-4)
    np.testing.assert_allclose(answer.pose.translation[0], (1, 1, 0), atol=2e-4)  # J0 is at the root
    np.testing.assert_allclose(lengths(points), 1, atol=1e-6)
    if solver == "two-bone":
        np.testing.assert_allclose(points[1], (2, 1, 0), atol=1e-6)  # a right angle, on the pole's side


def test_an_anchor_at_the_start_is_the_chain_as_it_was():
    given = {"target": (1, 1, 0), "solver": "fabrik", "iterations": 50}
    named = TWO.solve(TWO.bind_pose, NAMES, anchor="J0", **given)
    usual = TWO.solve(TWO.bind_pose, NAMES, **given)
    assert all((one == other).all() for one, other in zip(named.pose, usual.pose, strict=True))
    np.testing.assert_array_equal(named.pose.translation, TWO.bind_pose.translation)


def test_out_of_reach_the_chain_is_straight_from_its_anchor():
    answer = TWO.solve(TWO.bind_pose, NAMES, (2, 5, 0), "fabrik", anchor="J2")
    np.testing.assert_allclose(places(TWO, answer.pose), [(2, 2, 0), (2, 1, 0), (2, 0, 0)], atol=1e-5)
    assert (bool(answer.reached), answer.distance) == (False, pytest.approx(3, abs=1e-5))


def test_a_part_of_the_way_keeps_the_anchor_too():
    answer = TWO.solve(TWO.bind_pose, NAMES, (1, 1, 0), anchor="J2", pole=(0, 1, 0), weight=0.4)
    points = places(TWO, answer.pose)
    np.testing.assert_allclose(points[2], (2, 0, 0), atol=1e-6)
    assert 0.1 < points[0, 1] < 0.9
    still = TWO.solve(TWO.bind_pose, NAMES, (1, 1, 0), anchor="J2", weight=0)
    assert all((one == other).all() for one, other in zip(still.pose, TWO.bind_pose, strict=True))


def test_a_crowd_gets_the_bits_of_one():
    poses = TWO.clip("rest").sample(np.zeros(21))
    targets = np.random.default_rng(4).normal(size=(21, 3))
    every = TWO.solve(poses, NAMES, targets, "ccd", anchor="J2")
    for row in (0, 7, 20):
        alone = TWO.solve(poses.take(row), NAMES, targets[row], "ccd", anchor="J2")
        assert (alone.pose.rotation == every.pose.rotation[row]).all()
        assert (alone.pose.translation == every.pose.translation[row]).all()


@pytest.mark.parametrize(
    ("anchor", "solver", "words"),
    [
        ("J1", "fabrik", "J1 is no end of the chain; its anchor is J0 or J2"),
        ("J9", "fabrik", "no joint is called 'J9'. There are: Root, J0, J1, J2"),
        ("J2", "look-at", "look-at has no anchor"),
    ],
)
def test_a_wrong_anchor_is_refused(anchor, solver, words):
    with pytest.raises(StatwalkError, match=words):
        TWO.solve(TWO.bind_pose, NAMES, (1, 1, 0), solver, anchor=anchor)


@pytest.mark.parametrize(
    ("lines", "words"),
    [
        (
            "chains:\n  rope: {joints: [J0, J2], anchor: J1}",
            "chains: rope: anchor: J1 is no end of the chain; its",
        ),
        ("chains:\n  rope: {joints: [J0, J2], anchor: J9}", "chains: rope: no joint is called 'J9'"),
        ("chains:\n  rope: {joints: [J0, J7]}", "chains: rope: no joint is called 'J7'"),
        ("chains:\n  rope: {joints: [J2, J0]}", "chains: rope: chain: J0 is not below J2"),
        ("chains:\n  rope: {joints: [J0, J2], anchor: [J0, J1, J2]}", "one anchor or two, not 3"),
        ("chains:\n  rope: {joints: [J0, J2], half_life: 0}", "half_life|0.001"),
        ("chains:\n  rope: {joints: [J0, J2], stiff: 1}", "stiff"),
        (
            "solvers:\n  go: {solver: ccd, chain: [J0, J2], target: grip, anchor: J1}",
            "go: anchor: J1 is no end of the",
        ),
        (
            "solvers:\n  go: {solver: look-at, chain: [J0], target: grip, anchor: J0}",
            "look-at has no `anchor`",
        ),
        ("solvers:\n  go: {solver: ccd, chain: [J0, J2], target: grip, grab: true}", "needs a parameter as"),
    ],
)
def test_a_wrong_chain_of_a_machine_is_refused_with_its_line(lines, words):
    with pytest.raises(MachineError, match=words) as error:
        role_with(TWO, lines)
    assert error.value.place == "line 11"


def test_a_solver_of_a_machine_moves_the_root_and_not_its_anchor():
    go = "go: {solver: fabrik, chain: [J0, J2], target: grip, anchor: J2, iterations: 100}"
    stage = Stage()
    actor = stage.add(role_with(TWO, f"solvers:\n  {go}"), (3.0, 0.0, 1.0), 0.5)
    anchor = actor.world[3, :3, 3].copy()
    goal = anchor + np.array((-0.7, 0.9, 0.4))
    stage.set(actor, "grip", tuple(goal))
    stage.step(3)
    np.testing.assert_allclose(actor.world[3, :3, 3], anchor, atol=1e-5)
    np.testing.assert_allclose(actor.world[1, :3, 3], goal, atol=3e-4)
    assert actor.reached["go"].reached


def hung(points, line, ticks=0, actors=1, rate=60):
    """A stage with actors whose chain hangs, `ticks` later."""
    stage = Stage(rate=rate)
    role = role_with(chain_of(*points), f"chains:\n  rope: {{joints: [J0, J{len(points) - 1}], {line}}}")
    everyone = [stage.add(role, (2.0 * k, 0, 0), 0.3 * k) for k in range(actors)]
    stage.step(ticks)
    return stage, everyone


def joints(actor):
    return actor.world[1:, :3, 3].astype(float)


def test_a_chain_swings_in_its_own_modes():
    """Small swings: masses m and tensions T give the modes of K x = ω² M x."""
    count, bone, mass = 8, 0.25, 3.0
    masses = np.array([1.0] * (count - 1) + [mass])  # of the joints below the anchor
    tension = GRAVITY * np.cumsum(masses[::-1])[::-1] / bone
    stiff = np.diag(tension + np.append(tension[1:], 0)) - np.diag(tension[1:], 1) - np.diag(tension[1:], -1)
    squares, modes = eigh(stiff, np.diag(masses))
    slow, aside = np.sqrt(squares[0]), 0.05 * modes[:, 0] / np.abs(modes[:, 0]).max()
    steps = np.diff(np.append(0.0, aside))
    down = -np.cumsum(np.append(0.0, np.sqrt(bone**2 - steps**2)))
    points = np.stack([np.append(0.0, aside), down, np.zeros(count + 1)], -1)
    rate, seconds = 240, 4 * np.pi / slow
    stage, (actor,) = hung(points, f"mass: {mass}, half_life: 3600", rate=rate)
    seen = []
    for _ in range(int(rate * seconds)):
        stage.step()
        seen.append(joints(actor)[1:, 0])
    times = (1 + np.arange(len(seen))) / rate
    expected = aside * np.cos(slow * times)[:, None]
    assert np.abs(np.array(seen) - expected).max() < 0.08 * np.abs(aside).max()


def test_a_chain_with_two_anchors_hangs_as_low_as_it_can():
    angles = np.radians(np.linspace(-70, 70, 12))
    points = np.concatenate([[[0, 0]], np.cumsum(np.stack([np.cos(angles), np.sin(angles)], -1) * 0.2, 0)])
    points = np.append(points + UP, np.zeros((13, 1)), 1)
    end = points[-1, :2]

    def ends(turns):
        return 0.2 * np.array([np.cos(turns).sum(), np.sin(turns).sum()]) - end + UP

    def height(turns):
        return np.cumsum(np.sin(turns))[:-1].sum()

    given = {"constraints": {"type": "eq", "fun": ends}, "tol": 1e-12, "options": {"maxiter": 1000}}
    found = minimize(height, angles, **given)
    lowest = UP + np.cumsum(0.2 * np.stack([np.cos(found.x), np.sin(found.x)], -1), 0)
    _, (actor,) = hung(points, "anchor: [J0, J12], half_life: 0.2", ticks=900)
    np.testing.assert_allclose(joints(actor)[1:, :2], lowest, atol=1e-3)
    np.testing.assert_allclose(joints(actor)[[0, -1]], points[[0, -1]], atol=1e-5)


def test_a_chain_with_its_anchor_at_the_end_falls_from_the_other():
    points = [(0, 2.0 - 0.25 * k, 0.02 * k) for k in range(7)]
    _, (actor,) = hung(points, "anchor: J6, half_life: 0.3", ticks=900)
    now = joints(actor)
    np.testing.assert_allclose(now[-1], points[-1], atol=1e-5)  # the anchor
    np.testing.assert_allclose(now[:, [0, 2]], np.tile(points[-1], (7, 1))[:, [0, 2]], atol=0.01)
    assert (np.diff(now[:, 1]) > 0.24).all()  # it hangs, upside down


def test_many_hang_as_one_does_and_a_replay_makes_the_same_bits():
    points = [(0.1 * k, 2.0 - 0.2 * k, 0) for k in range(6)]
    _, everyone = hung(points, "mass: 2", ticks=100, actors=19)
    _, (alone,) = hung(points, "mass: 2", ticks=100)
    assert (everyone[0].pose.rotation == alone.pose.rotation).all()
    stage = Stage(seed=3)
    actor = stage.add(statwalk.load("anchor-chain"))
    stage.set(actor, "held", 1)
    stage.set(actor, "anchor", (1.0, 2.0, 0.5))
    stage.step(40)
    stage.set(actor, "held", 0)
    stage.step(40)
    assert replay(stage.dump(), lambda name, *_: statwalk.load(name)).hash == stage.hash


class Ship:
    """The shipped chain."""

    def __init__(self):
        self.stage = Stage()
        self.actor = self.stage.add(statwalk.load("anchor-chain"))
        names = self.actor.role.character.skeleton.names
        self.rows = [names.index(name) for name in names if name.startswith("Link")]
        self.rows += [names.index("Anchor"), names.index("Crown")]
        self.rest, self.ship = self.points(), names.index("Ship")

    def points(self):
        return self.actor.world[self.rows, :3, 3].astype(float)

    def play(self, ticks, *way):
        """Places (ticks, n, 3); `way`: a parameter and its value in each tick."""
        seen = []
        for tick in range(ticks):
            if way:
                self.stage.set(self.actor, way[0], tuple(map(float, way[1](tick))))
            self.stage.step()
            seen.append(self.points())
        return np.array(seen)


def test_links_keep_their_lengths_wherever_the_end_is_dragged():
    ship = Ship()
    ship.stage.set(ship.actor, "held", 1)
    chance = np.random.default_rng(1)
    ways = [
        (120, lambda tick: (np.sin(tick / 9), 1.5 + np.cos(tick / 7), np.sin(tick / 5))),
        (120, lambda tick: (0.1 * tick, 5, -0.1 * tick)),  # out of reach
        (120, lambda tick: (0, 2.75 - 2.2 * np.cos(tick / 12), 0)),  # through the fixed end
        (180, lambda _: chance.normal(size=3) * 3),  # as no hand could
    ]
    seen = np.concatenate([ship.play(ticks, "anchor", way) for ticks, way in ways])
    assert np.isfinite(seen).all()
    np.testing.assert_array_equal(seen[:, 0], np.tile(ship.rest[0], (len(seen), 1)))  # the fixed end
    assert np.abs(lengths(seen) - lengths(ship.rest)).max() < 1e-5


def test_the_end_travels_to_the_pointer_and_is_held_there():
    ship = Ship()
    goal = np.array((1.1, 1.6, 0.4))
    ship.stage.set(ship.actor, "held", 1)
    seen = ship.play(120, "anchor", lambda _: goal)
    steps = np.linalg.norm(np.diff(np.concatenate([ship.rest[None, -1], seen[:, -1]]), axis=0), axis=1)
    assert steps.max() < 0.3  # metres a tick, of 1.6: it does not snap
    np.testing.assert_allclose(seen[-1, -1], goal, atol=2e-4)
    assert ship.actor.reached["drag"].reached
    assert seen[-1, 1:-1, 1].min() < 1.6 - 0.1  # and sags between


def test_let_go_it_swings_past_and_comes_to_rest():
    ship = Ship()
    ship.stage.set(ship.actor, "held", 1)
    ship.play(90, "anchor", lambda _: (1.3, 1.4, 0))
    ship.stage.set(ship.actor, "held", 0)
    end = ship.play(2400)[:, -1]
    assert np.linalg.norm(end[0] - (1.3, 1.4, 0)) < 0.01  # it begins where it was let go
    assert end[:240, 0].min() < -0.4  # past the middle
    assert np.abs(end[-120:, 0]).max() < 0.02
    np.testing.assert_allclose(end[-1], ship.rest[-1], atol=0.02)


def test_moored_the_anchor_stays_where_it_is_while_the_ship_moves():
    ship = Ship()
    ship.stage.send(ship.actor, "MOOR")
    ship.play(180)
    moored = np.array((-1, 1.1, 0.45))
    np.testing.assert_allclose(ship.points()[-1], moored, atol=1e-3)
    ship.stage.set(ship.actor, "sailing", 1)
    seen = ship.play(150, "ship", lambda tick: (-0.5 * np.sin(tick / 30), 2.6, 0.3))
    assert np.abs(seen[:, -1] - moored).max() < 2e-3
    np.testing.assert_allclose(seen[-1, 0], (-0.5 * np.sin(149 / 30), 2.6, 0.3), atol=0.1)
    np.testing.assert_allclose(ship.actor.world[ship.ship, :3, 3] + ship.rest[0], seen[-1, 0], atol=1e-5)
    assert np.abs(lengths(seen) - lengths(ship.rest)).max() < 1e-5
    ship.stage.send(ship.actor, "WEIGH")
    ship.stage.set(ship.actor, "sailing", 0)
    steps = np.linalg.norm(np.diff(ship.play(120), axis=0), axis=2)
    assert steps.max() < 0.15  # nothing jumps
