"""A proxy that cuts every connection after a number of bytes, in either direction."""

import asyncio
import random
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress

PIECE = 4_096


class CuttingProxy:
    """Passes bytes on to `target`; each connection ends, with a reset, after 1 to `longest` bytes."""

    def __init__(self, target: str, longest: int, seed: int) -> None:
        host, port = target.split(":")
        self.target, self.longest = (host, int(port)), longest
        self.dice, self.cuts = random.Random(seed), 0

    @asynccontextmanager
    async def open(self) -> AsyncIterator[str]:
        """Listens; yields its address."""
        server = await asyncio.start_server(self._serve, "127.0.0.1", 0)
        async with server:
            host, port = server.sockets[0].getsockname()
            yield f"{host}:{port}"

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        to_server, from_server = self.dice.randint(1, self.longest), self.dice.randint(1, self.longest)
        answers, requests = await asyncio.open_connection(*self.target)
        ways = [
            asyncio.create_task(self._pass_on(reader, requests, to_server)),
            asyncio.create_task(self._pass_on(answers, writer, from_server)),
        ]
        await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
        for way in ways:
            way.cancel()
        for end in (writer, requests):
            end.transport.abort()

    async def _pass_on(self, source: asyncio.StreamReader, target: asyncio.StreamWriter, left: int) -> None:
        with suppress(ConnectionError):
            while data := await source.read(min(left, PIECE)):
                target.write(data)
                await target.drain()
                left -= len(data)
                if not left:
                    self.cuts += 1
                    return
