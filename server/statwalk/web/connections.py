"""Counts the connections by address, and makes room for a new one by closing one that stands idle."""

from __future__ import annotations

import asyncio

from statwalk.services.limits import Limits
from statwalk.web.client_address import address_of


class Seat:
    """The place of a connection among those of its address; `busy` while it has a request or is a socket."""

    def __init__(self, address: str, transport: asyncio.Transport) -> None:
        self.address, self.transport = address, transport
        self.busy = False


class Connections:
    """The open connections of one server. Use it in the thread of the event loop only."""

    def __init__(self, limits: Limits) -> None:
        self.limits = limits
        self.closed_idle = self.refused = self.timed_out = 0
        self._places: dict[str, dict[Seat, None]] = {}

    def open(self, client: tuple[str, int] | None, transport: asyncio.Transport) -> Seat | None:
        """Returns a place for a new connection; None if its address has the most connections that it may
        have, and none of them is idle.
        """
        address = address_of({"client": client})
        places = self._places.setdefault(address, {})
        if len(places) >= self.limits.connections and not self._close_idle(places):
            self.refused += 1
            return None
        place = Seat(address, transport)
        places[place] = None
        return place

    def close(self, place: Seat) -> None:
        """Gives the place of a closed connection back."""
        places = self._places.get(place.address, {})
        places.pop(place, None)
        if not places:
            self._places.pop(place.address, None)

    def count(self) -> int:
        """Returns the number of open connections."""
        return sum(map(len, self._places.values()))

    def _close_idle(self, places: dict[Seat, None]) -> bool:
        """Closes the connection that has been open longest among the idle ones; returns whether there was
        one.
        """
        idle = next((place for place in places if not place.busy), None)
        if idle is None:
            return False
        idle.transport.abort()
        del places[idle]
        self.closed_idle += 1
        return True
