"""What a token grants, and when that ends: on a clock of one's own."""

import asyncio
from pathlib import Path

import pytest
from statwalk.errors import LimitError, UnknownNameError
from statwalk.services.access import share_links
from statwalk.services.access.access_file import AccessFile
from statwalk.services.access.authenticator import Authenticator
from statwalk.services.access.roles import Grant
from statwalk.services.publish.outbox import Outbox


def tokens_of(authenticator: Authenticator, seconds: float = 60.0) -> tuple[str, Grant, str]:
    """The token of a person, what it grants, and the token of a link that the person makes at 0."""
    person = authenticator.file.add("ada", "drive")
    grant = authenticator.grant_of(person, 0.0)
    assert grant
    return person, grant, authenticator.links.make("main", "view", seconds, grant, 0.0)[1]


def test_each_start_has_another_token(tmp_path: Path) -> None:
    first, second = (Authenticator(AccessFile(tmp_path), with_start_token=True) for _ in range(2))
    assert first.grant_of(first.start_token, 0.0)
    assert first.grant_of(second.start_token, 0.0) is None


@pytest.mark.parametrize("token", ["", "x", "\ud800", "\0", "x" * 100_000])
def test_without_a_start_token_nothing_is_a_token(tmp_path: Path, token: str) -> None:
    assert Authenticator(AccessFile(tmp_path)).grant_of(token, 0.0) is None


def test_a_link_grants_its_role_on_its_stage_for_its_time(tmp_path: Path) -> None:
    authenticator = Authenticator(AccessFile(tmp_path))
    _, _, link = tokens_of(authenticator)
    grant = authenticator.grant_of(link, 59.9)
    assert grant
    assert (grant.role, grant.stage) == ("view", "main")
    assert authenticator.grant_of(link, 60.0) is None


def test_a_link_ends_with_the_access_of_its_maker(tmp_path: Path) -> None:
    authenticator = Authenticator(AccessFile(tmp_path))
    person, _, link = tokens_of(authenticator)
    authenticator.file.revoke("ada")
    assert (authenticator.grant_of(person, 1.0), authenticator.grant_of(link, 1.0)) == (None, None)


def test_a_link_ends_with_its_stage(tmp_path: Path) -> None:
    authenticator = Authenticator(AccessFile(tmp_path))
    _, _, link = tokens_of(authenticator)
    authenticator.disconnect_ended(1.0, ["main"])
    assert authenticator.grant_of(link, 1.0)
    authenticator.disconnect_ended(1.0, ["other"])
    assert authenticator.grant_of(link, 1.0) is None


def test_links_are_few_and_revoked_one_by_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    authenticator = Authenticator(AccessFile(tmp_path))
    monkeypatch.setattr(share_links, "MOST_LINKS", 1)
    _, grant, _ = tokens_of(authenticator)
    with pytest.raises(LimitError):
        authenticator.links.make("main", "view", 60.0, grant, 59.0)
    second, token = authenticator.links.make("main", "view", 60.0, grant, 60.0)  # the first has ended
    with pytest.raises(UnknownNameError):
        authenticator.links.revoke("other", second.id, 60.0)
    authenticator.links.revoke("main", second.id, 60.0)
    assert authenticator.grant_of(token, 60.0) is None


def test_viewers_are_disconnected_when_their_access_ends(tmp_path: Path) -> None:
    async def run() -> None:
        authenticator = Authenticator(AccessFile(tmp_path), with_start_token=True)
        person, _, link = tokens_of(authenticator)
        tokens = (authenticator.start_token, person, link)
        grants = [authenticator.grant_of(token, 1.0) for token in tokens]
        owner, of_person, of_link = (Outbox("pose") for _ in grants)
        assert all(grants)
        with (
            authenticator.watching(owner, grants[0]),
            authenticator.watching(of_person, grants[1]),
            authenticator.watching(of_link, grants[2]),
        ):
            authenticator.disconnect_ended(59.0)
            assert [box.closing for box in (owner, of_person, of_link)] == [None] * 3
            authenticator.disconnect_ended(60.0)
            assert of_link.closing
            assert of_link.closing[0] == "access ended"
            assert of_person.closing is None
            authenticator.file.revoke("ada")
            authenticator.disconnect_ended(61.0)
            assert of_person.closing
            assert owner.closing is None

    asyncio.run(run())


def test_a_role_that_changes_ends_the_old_connection(tmp_path: Path) -> None:
    async def run() -> None:
        authenticator = Authenticator(AccessFile(tmp_path))
        person, grant, _ = tokens_of(authenticator)
        outbox = Outbox("pose")
        with authenticator.watching(outbox, grant):
            file = authenticator.file.path
            file.write_text(file.read_text().replace('"drive"', '"view"'))
            authenticator.disconnect_ended(1.0)
            assert outbox.closing
        changed = authenticator.grant_of(person, 1.0)
        assert changed
        assert changed.role == "view"

    asyncio.run(run())
