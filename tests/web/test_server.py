"""The socket that the server listens on, and what the connections that it accepts have of it."""

import asyncio
import socket

import pytest
from statwalk.web.server import listening_socket


@pytest.mark.parametrize("host", ["127.0.0.1", "::1"])
def test_what_is_small_is_sent_at_once(host: str) -> None:
    """Nagle's algorithm would keep a frame back until the one before it is acknowledged: some 30 ms."""

    async def accepted_without_delay() -> int:
        told: asyncio.Future[int] = asyncio.get_running_loop().create_future()

        async def accept(_: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            told.set_result(
                writer.get_extra_info("socket").getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY)
            )
            writer.close()

        listener = listening_socket(host, 0)
        async with await asyncio.start_server(accept, sock=listener):
            with socket.create_connection(listener.getsockname()[:2]):
                return await told

    assert asyncio.run(accepted_without_delay()) != 0
