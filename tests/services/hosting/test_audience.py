"""The viewers of a stage as they see each other."""

import asyncio

import pytest
from statwalk.errors import BusyError, UnknownNameError
from statwalk.services.access.authenticator import START_NAME
from statwalk.services.access.roles import EVERYTHING, Grant
from statwalk.services.hosting.audience import LIST_SECONDS, Audience
from statwalk.services.hosting.commands import Doer
from statwalk.services.publish.fanout import Fanout
from statwalk.services.publish.outbox import Outbox

pytestmark = pytest.mark.anyio
ADA, BOB = Grant("ada", "admin", digest="1"), Grant("bob", "view", digest="2")
GUEST, START = Grant("link 1a", "view", stage="main", digest="3"), Grant(START_NAME, "admin", digest="4")
MOST = 4


class Stage:
    """An audience, its clock, and viewers."""

    def __init__(self) -> None:
        self.now = 0.0
        self.audience = Audience(Fanout(), lambda told: told, lambda: self.now, MOST)

    def viewer(self, grant: Grant = EVERYTHING) -> Outbox:
        outbox = Outbox("pose")
        self.audience.join(outbox, grant, asyncio.get_running_loop())
        return outbox


@pytest.fixture
def anyio_backend() -> str:
    return "asyncio"


@pytest.fixture
def stage() -> Stage:
    return Stage()


async def test_the_list_goes_to_all_when_it_changes(stage: Stage) -> None:
    first = stage.viewer()
    stage.now += LIST_SECONDS
    second = stage.viewer()
    for outbox in (first, second):
        (told,) = outbox.take_texts()
        assert [viewer.id for viewer in told.viewers] == [1, 2]  # type: ignore[attr-defined]


async def test_many_changes_are_one_list_a_second(stage: Stage) -> None:
    viewer = stage.viewer()
    viewer.take_texts()
    for tick in range(100):
        stage.audience.change(viewer, tick=tick)
        stage.audience.tell()
    assert viewer.take_texts() == []
    stage.now += LIST_SECONDS
    stage.audience.tell()
    (told,) = viewer.take_texts()
    assert told.viewers[0].tick == 99  # type: ignore[attr-defined]


async def test_a_list_that_stays_the_same_is_not_sent_again(stage: Stage) -> None:
    viewer = stage.viewer()
    viewer.take_texts()
    stage.now += LIST_SECONDS
    stage.audience.change(viewer, name="")
    stage.audience.tell()
    assert viewer.take_texts() == []


PERSONS = {
    "a person": (ADA, "ada"),
    "a link": (GUEST, ""),
    "this start": (START, ""),
    "all": (EVERYTHING, ""),
}


@pytest.mark.parametrize(("grant", "person"), PERSONS.values(), ids=PERSONS)
async def test_a_person_is_whose_token_it_is(stage: Stage, grant: Grant, person: str) -> None:
    presence = stage.audience.of(stage.viewer(grant))
    assert (presence.person, presence.role) == (person, grant.role)


async def test_the_newest_camera_goes_to_those_who_follow(stage: Stage) -> None:
    shown, follower, other = (stage.viewer() for _ in range(3))
    stage.audience.show_camera(shown, (0.0, 1.0, 3.0), (0.0, 1.0, 0.0), 1)
    stage.audience.follow(follower, 1)
    stage.audience.show_camera(shown, (9.0, 1.0, 3.0), (0.0, 1.0, 0.0), None)
    cameras = [text for text in follower.take_texts() if hasattr(text, "target")]
    assert [(camera.viewer, camera.position[0]) for camera in cameras] == [(1, 9.0)]
    assert not any(hasattr(text, "target") for text in (*shown.take_texts(), *other.take_texts()))


async def test_who_follows_gets_the_newest_camera_at_once(stage: Stage) -> None:
    shown, follower = stage.viewer(), stage.viewer()
    stage.audience.show_camera(shown, (5.0, 1.0, 3.0), (0.0, 1.0, 0.0), None)
    stage.audience.follow(follower, 1)
    assert follower.take_texts()[-1].position[0] == 5.0  # type: ignore[attr-defined]


async def test_who_follows_no_more_gets_no_camera(stage: Stage) -> None:
    shown, follower = stage.viewer(), stage.viewer()
    stage.audience.follow(follower, 1)
    stage.audience.follow(follower, None)
    follower.take_texts()
    stage.audience.show_camera(shown, (0.0, 1.0, 3.0), (0.0, 1.0, 0.0), None)
    assert follower.take_texts() == []


@pytest.mark.parametrize("viewer", [2, 7], ids=["itself", "nobody"])
async def test_only_another_viewer_can_be_followed(stage: Stage, viewer: int) -> None:
    _, follower = stage.viewer(), stage.viewer()
    with pytest.raises(UnknownNameError, match=str(viewer)):
        stage.audience.follow(follower, viewer)


async def test_who_follows_a_viewer_that_leaves_follows_nobody(stage: Stage) -> None:
    shown, follower = stage.viewer(), stage.viewer()
    stage.audience.follow(follower, 1)
    stage.audience.leave(shown)
    (left,) = stage.audience.present.viewers
    assert (left.id, left.follows) == (2, None)


async def test_numbers_of_viewers_are_not_used_again(stage: Stage) -> None:
    stage.audience.leave(stage.viewer())
    assert stage.audience.of(stage.viewer()).id == 2


async def test_who_acts_on_the_clock(stage: Stage) -> None:
    ada, _ = stage.viewer(ADA), stage.viewer(GUEST)
    doer = stage.audience.doer
    assert doer(1, ADA) == Doer("ada", 1)
    stage.audience.change(ada, name="Ada L.")
    assert doer(1, ADA) == Doer("Ada L.", 1)
    assert doer(2, GUEST) == Doer("somebody", 2)
    assert doer(0, BOB) == doer(7, BOB) == Doer("bob")
    assert doer(0, EVERYTHING) == doer(0, GUEST) == Doer("a program")


async def test_nobody_acts_in_the_name_of_a_viewer_with_another_token(stage: Stage) -> None:
    stage.viewer(ADA)
    assert stage.audience.doer(1, BOB) == Doer("bob")


async def test_a_full_audience_has_room_again_when_a_viewer_leaves(stage: Stage) -> None:
    viewers = [stage.viewer() for _ in range(MOST)]
    assert stage.audience.is_full
    with pytest.raises(BusyError, match=f"has {MOST} viewers"):
        stage.viewer()
    stage.audience.leave(viewers[0])
    assert not stage.audience.is_full
