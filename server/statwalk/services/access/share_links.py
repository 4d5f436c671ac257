"""Links that let others see or drive one stage for a while; they end with the server."""

from __future__ import annotations

import secrets
from collections.abc import Collection
from dataclasses import dataclass

from statwalk.errors import LimitError, existing
from statwalk.services.access.roles import AccessRole, Grant, digest_of, new_token

MOST_LINKS = 200


@dataclass(frozen=True)
class ShareLink:
    """A link: it ends at `until`, in seconds of the monotonic clock, or with the access of its `maker`."""

    id: str
    stage: str
    role: AccessRole
    until: float
    maker: Grant
    digest: str

    def grant(self) -> Grant:
        """Returns what the link allows."""
        return Grant(f"link {self.id}", self.role, self.stage, self.digest)


class ShareLinks:
    """The links of a server. Use it in the event loop's thread only; `now` is on the monotonic clock."""

    def __init__(self) -> None:
        self._links: dict[str, ShareLink] = {}

    def make(
        self, stage: str, role: AccessRole, seconds: float, maker: Grant, now: float
    ) -> tuple[ShareLink, str]:
        """Returns a new link and its token, which is kept nowhere.

        :raises LimitError: when the server has the most links that it may have.
        """
        self.drop_ended(now)
        if len(self._links) >= MOST_LINKS:
            raise LimitError(f"the server has {MOST_LINKS} links, and no more; delete one first")
        token = new_token()
        link = ShareLink(secrets.token_hex(4), stage, role, now + seconds, maker, digest_of(token))
        self._links[link.id] = link
        return link, token

    def all(self, now: float) -> list[ShareLink]:
        """Returns the links that count now."""
        return [link for link in self._links.values() if now < link.until]

    def of_stage(self, stage: str, now: float) -> dict[str, ShareLink]:
        """Returns a stage's links that count now, by id."""
        return {link.id: link for link in self.all(now) if link.stage == stage}

    def revoke(self, stage: str, link_id: str, now: float) -> None:
        """Removes a link.

        :raises UnknownNameError: when the stage has no such link.
        """
        existing("link", link_id, self.of_stage(stage, now))
        del self._links[link_id]

    def drop_ended(self, now: float, stages: Collection[str] | None = None) -> None:
        """Forgets the links whose time is over, and (with `stages`) those of other stages."""
        self._links = {link.id: link for link in self.all(now) if stages is None or link.stage in stages}
