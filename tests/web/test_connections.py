"""Each address has so many places, and no connection keeps one for ever."""

from typing import Any

from statwalk.services.limits import Limits
from statwalk.web.connections import Connections


class Transport:
    """Only tells whether it was ended."""

    ended = False

    def abort(self) -> None:
        self.ended = True


def opened(connections: Connections, address: str = "192.0.2.1") -> Any:
    return connections.open((address, 1), Transport())  # type: ignore[arg-type]


def test_the_idle_connection_that_is_open_longest_goes() -> None:
    connections = Connections(Limits(connections=3))
    first, second, third = (opened(connections) for _ in range(3))
    first.busy = True
    assert opened(connections) is not None
    assert [place.transport.ended for place in (first, second, third)] == [False, True, False]
    assert connections.count() == 3


def test_busy_connections_stay_and_another_address_has_its_own_places() -> None:
    connections = Connections(Limits(connections=1))
    place = opened(connections)
    place.busy = True
    assert opened(connections) is None
    assert opened(connections, "192.0.2.2") is not None
    connections.close(place)
    assert opened(connections) is not None


def test_nothing_is_left_of_an_address_that_has_gone() -> None:
    connections = Connections(Limits())
    for number in range(100):
        connections.close(opened(connections, f"192.0.2.{number}"))
    assert connections._places == {}
