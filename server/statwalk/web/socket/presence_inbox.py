"""Handles what a viewer says of itself to the others: its name, its actor, its camera, whom it follows."""

from __future__ import annotations

from statwalk.services.hosting.audience import Audience
from statwalk.services.publish.outbox import Outbox
from statwalk.web.errors import Problem
from statwalk.web.schemas.viewer_messages import Follow, GiveName, MoveCamera, PresenceMessage, Watch
from statwalk.web.token_bucket import TokenBucket

CAMERAS_PER_SECOND = 10.0


class PresenceInbox:
    """Handles these messages of one viewer."""

    def __init__(self, audience: Audience, outbox: Outbox) -> None:
        self.audience, self.outbox = audience, outbox
        self.cameras = TokenBucket(CAMERAS_PER_SECOND, CAMERAS_PER_SECOND)

    def act(self, message: PresenceMessage) -> None:
        """Does what a message asks.

        :raises UnknownNameError: when the viewer follows a viewer that is not there.
        :raises Problem: 429, when it moves its camera too often.
        """
        match message:
            case GiveName(name=name):
                self.audience.change(self.outbox, name=name.strip())
            case Watch(actor=actor):
                self.audience.change(self.outbox, actor=actor)
            case MoveCamera(position=position, target=target, actor=actor):
                if not self.cameras.spend():
                    detail = f"more than {CAMERAS_PER_SECOND:g} cameras a second; send the newest later"
                    raise Problem(429, detail, field="camera")
                self.audience.show_camera(self.outbox, position, target, actor)
            case Follow(viewer=viewer):
                self.audience.follow(self.outbox, viewer)
