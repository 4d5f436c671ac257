"""Who may reach a server: only programs of this computer, or others with a token and over TLS.

A server is shared as soon as others can reach it: at an address that is not loopback, or behind a proxy.
"""

from __future__ import annotations

import ipaddress
import re
import ssl
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple
from urllib.parse import urlsplit

from statwalk.errors import ContentError
from statwalk.services.access.access_file import AccessFile
from statwalk.services.access.authenticator import Authenticator
from statwalk.web.same_origin import OwnNames, authority
from statwalk.web.server import TlsFiles
from statwalk.web.settings import LOOPBACK

PUBLIC_URL = re.compile(r"https://([^/?#@]+)/?")


class Exposure(NamedTuple):
    """The options of `statwalk serve` that say who may reach it."""

    host: str
    token: bool = False
    tls_cert: Path | None = None
    tls_key: Path | None = None
    behind_proxy: bool = False
    public_url: str = ""

    def check(self, file: AccessFile) -> None:
        """Checks that nobody gets in without a token, and that no token travels in the clear.

        :raises ContentError: when something must be added; the message says all of it.
        """
        if self.tls:
            _check_pair(self.tls)
        if self.public_url and not _is_address(self.public_url):
            raise ContentError(
                f"--public-url must be an address like https://anim.example, not {self.public_url[:200]!r}"
            )
        if self.is_shared and (missing := list(self._missing(file))):
            where = "this server through its proxy" if self.behind_proxy else self.host
            raise ContentError(f"other computers can reach {where}: add {'; and '.join(missing)}")

    def _missing(self, file: AccessFile) -> Iterator[str]:
        if not (self.tls or self.behind_proxy):
            yield "--tls-cert FILE --tls-key FILE, or (with a proxy that does TLS) --behind-proxy"
        if not self.public_url and (self.behind_proxy or _is_wildcard(self.host)):
            yield "--public-url https://NAME, the address that clients use"
        if not self.token and not file.people():
            yield "a person (statwalk access add NAME --role admin), or --token"

    @property
    def is_shared(self) -> bool:
        """Returns whether anything but programs of this computer can reach the server."""
        named = self.tls_cert or self.tls_key or self.behind_proxy or self.public_url
        return bool(named) or not _is_loopback(self.host)

    @property
    def tls(self) -> TlsFiles | None:
        """Returns the files for TLS; None if they are not both named."""
        return TlsFiles(self.tls_cert, self.tls_key) if self.tls_cert and self.tls_key else None

    def names(self, port: int) -> OwnNames:
        """Returns the names of a server that listens on a port."""
        name = f"[{self.host.lower()}]" if ":" in self.host else self.host.lower()
        if not self.is_shared:
            return OwnNames((*LOOPBACK.hosts, name))
        url = (self.public_url or f"https://{name}:{port}").rstrip("/").lower()
        public = authority(urlsplit(url).netloc, "")
        return OwnNames((*LOOPBACK.hosts, name, *(public[:1] if public else ())), url)

    def address(self, port: int, authenticator: Authenticator | None) -> str:
        """Returns the address that opens the page, with the token of this start if it has one."""
        name = f"[{self.host}]" if ":" in self.host else self.host
        page = f"{self.names(port).public_url or f'http://{name}:{port}'}/"
        token = authenticator.start_token if authenticator else ""
        return f"{page}?token={token}" if token else page

    def authenticator(self, file: AccessFile) -> Authenticator | None:
        """Returns what knows the tokens; None if the server asks for none."""
        return Authenticator(file, self.token) if self.token or self.is_shared else None


def _is_loopback(host: str) -> bool:
    """Returns whether only this computer can reach the address."""
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def _is_wildcard(host: str) -> bool:
    return host in ("", "0.0.0.0", "::")  # noqa: S104 - it is compared, not bound


def _is_address(url: str) -> bool:
    match = PUBLIC_URL.fullmatch(url)
    return match is not None and authority(match[1], "443") is not None


def _check_pair(tls: TlsFiles) -> None:
    """Checks the files for TLS.

    :raises ContentError: when they cannot be read, or do not belong together.
    """
    try:
        ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER).load_cert_chain(*tls)
    except (OSError, ssl.SSLError) as error:
        raise ContentError(f"--tls-cert {tls.certificate} with --tls-key {tls.key}: {error}") from None
