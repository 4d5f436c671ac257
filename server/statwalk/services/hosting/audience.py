"""The viewers of one stage as they see each other: names, what they look at, whose camera they follow."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from statwalk.errors import BusyError, UnknownNameError
from statwalk.services.access.authenticator import START_NAME
from statwalk.services.access.roles import Grant
from statwalk.services.hosting.commands import Doer
from statwalk.services.hosting.stage_replies import Camera, Point, Presence, Present
from statwalk.services.publish.fanout import Fanout, Loop
from statwalk.services.publish.outbox import Outbox
from statwalk.services.threads import Now

LIST_SECONDS = 1.0
"""between two lists to all viewers"""
SOMEBODY = "somebody"


def person_of(grant: Grant) -> str:
    """Returns the name of the person whose token a grant is; empty: of no person that the server knows."""
    return "" if grant.stage is not None or grant.name == START_NAME else grant.name


class Audience:
    """Keeps the viewers of one stage, and tells them of each other.

    Call it in the event loop; `present` and `doer` may be asked in any thread.
    """

    def __init__(self, fanout: Fanout, encode: Any, now: Now, most: int) -> None:
        self._fanout, self._encode, self._now, self._most = fanout, encode, now, most
        self._present: dict[Outbox, Presence] = {}
        self._grants: dict[int, Grant] = {}
        self._cameras: dict[int, Camera] = {}
        self._newest, self._told, self._is_changed = 0, float("-inf"), False

    @property
    def present(self) -> Present:
        """The viewers."""
        return Present(tuple(self._present.copy().values()))

    @property
    def count(self) -> int:
        """The number of viewers."""
        return len(self._present)

    @property
    def is_full(self) -> bool:
        """Whether the stage has as many viewers as it may have."""
        return self.count >= self._most

    def doer(self, viewer: int, grant: Grant) -> Doer:
        """Returns who sends a request: the `viewer` that it names, if that has the same grant, else the
        person whose token it has, else a program.
        """
        for presence in self.present.viewers:
            if presence.id == viewer and self._grants.get(presence.id) == grant:
                return Doer(presence.name or presence.person or SOMEBODY, presence.id)
        person = person_of(grant)
        return Doer(person) if person else Doer()

    def join(self, outbox: Outbox, grant: Grant, loop: Loop | None = None) -> None:
        """Adds a viewer that `loop` serves, by default the loop that runs.

        :raises BusyError: when the stage has as many viewers as it may have.
        """
        if self.is_full:
            raise BusyError(f"this stage has {self._most} viewers, and no room for more; try again later")
        self._fanout.join(outbox, loop)
        self._newest += 1
        self._grants = self._grants | {self._newest: grant}
        self._present[outbox] = Presence(self._newest, grant.role, person_of(grant))
        self._change()

    def leave(self, outbox: Outbox) -> None:
        """Removes a viewer; those that follow it follow none."""
        self._fanout.leave(outbox)
        gone = self._present.pop(outbox).id
        self._cameras.pop(gone, None)
        self._grants = {viewer: grant for viewer, grant in self._grants.items() if viewer != gone}
        for other, presence in self._present.items():
            if presence.follows == gone:
                self._present[other] = replace(presence, follows=None)
        self._change()

    def of(self, outbox: Outbox) -> Presence:
        """Returns a viewer."""
        return self._present[outbox]

    def change(self, outbox: Outbox, **members: Any) -> None:
        """Changes members of a viewer."""
        changed = replace(self._present[outbox], **members)
        if changed != self._present[outbox]:
            self._present[outbox] = changed
            self._change()

    def _change(self) -> None:
        self._is_changed = True
        self.tell()

    def tell(self) -> None:
        """Sends the list to all viewers if it has changed, at most once in `LIST_SECONDS`."""
        now = self._now()
        if self._is_changed and now - self._told >= LIST_SECONDS:
            self._is_changed, self._told = False, now
            text = self._encode(self.present)
            for outbox in self._fanout.outboxes:
                outbox.put_newest("viewers", text)

    # --- cameras

    def follow(self, outbox: Outbox, viewer: int | None) -> None:
        """Has a viewer get the cameras of another one from now on; None: of none.

        :raises UnknownNameError: when there is no other viewer of this number.
        """
        others = {str(each.id): each for other, each in self._present.items() if other is not outbox}
        if viewer is not None and str(viewer) not in others:
            raise UnknownNameError("viewer", str(viewer), others)
        self.change(outbox, follows=viewer)
        if viewer in self._cameras:
            outbox.put_newest("camera", self._encode(self._cameras[viewer]))

    def show_camera(self, outbox: Outbox, position: Point, target: Point, actor: int | None) -> None:
        """Keeps the newest camera of a viewer, and sends the camera to the followers of this viewer."""
        viewer = self._present[outbox].id
        camera = self._cameras[viewer] = Camera(viewer, position, target, actor)
        followers = [other for other, each in self._present.items() if each.follows == viewer]
        text = self._encode(camera) if followers else b""
        for follower in followers:
            follower.put_newest("camera", text)
