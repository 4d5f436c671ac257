"""Says what a token grants, and disconnects viewers whose access has ended."""

from __future__ import annotations

import hmac
from collections.abc import Collection, Iterator
from contextlib import contextmanager

from statwalk.services.access.access_file import AccessFile, Person
from statwalk.services.access.roles import Grant, digest_of, new_token
from statwalk.services.access.share_links import ShareLinks
from statwalk.services.publish.outbox import Outbox

START_NAME = "the link of this start"


class Authenticator:
    """The tokens of a server: one for this start (if it has one), those of the file, those of share links.

    Use it in the event loop's thread only; `now` is in seconds of the monotonic clock.
    """

    def __init__(self, file: AccessFile, with_start_token: bool = False) -> None:
        self.file, self.links = file, ShareLinks()
        self.start_token = new_token() if with_start_token else ""
        self._start = Grant(START_NAME, "admin", digest=digest_of(self.start_token))
        self._read: tuple[Person, ...] = ()
        self._of_people: list[Grant] = []
        self._viewers: dict[Outbox, Grant] = {}

    def grant_of(self, token: str, now: float) -> Grant | None:
        """Returns what a token allows, None if it is unknown or has ended.

        It compares with every hash, each in constant time: how long it takes says nothing about the token.
        """
        digest, found = digest_of(token), None
        for grant in self._grants(now):
            if hmac.compare_digest(grant.digest, digest):
                found = grant
        return found

    def _grants(self, now: float) -> list[Grant]:
        """Returns what all tokens allow now; a link ends with the access of its maker."""
        people = self._people()
        return people + [link.grant() for link in self.links.all(now) if link.maker in people]

    def _people(self) -> list[Grant]:
        people = self.file.people_or_nobody()
        if people is not self._read:
            self._read = people
            self._of_people = [Grant(line.name, line.role, digest=line.digest) for line in people]
        return [self._start, *self._of_people] if self.start_token else self._of_people

    @contextmanager
    def watching(self, outbox: Outbox, grant: Grant) -> Iterator[None]:
        """Disconnects a viewer when its access ends."""
        self._viewers[outbox] = grant
        try:
            yield
        finally:
            del self._viewers[outbox]

    def disconnect_ended(self, now: float, stages: Collection[str] | None = None) -> None:
        """Disconnects the viewers whose tokens no longer grant what they did; forgets the links of stages
        other than `stages`.
        """
        self.links.drop_ended(now, stages)
        grants = set(self._grants(now))
        for outbox, grant in self._viewers.items():
            if grant not in grants:
                outbox.cut("access ended", "your access to this server has ended")
