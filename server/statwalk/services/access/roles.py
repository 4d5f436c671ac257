"""The roles of access, and the tokens that prove them.

A token has 256 random bits; the server keeps only its SHA-256. Nobody can guess one, so that the hash needs
no salt and no slow function.
"""

from __future__ import annotations

import hashlib
import secrets
from dataclasses import dataclass
from typing import Literal, get_args

AccessRole = Literal["view", "drive", "admin"]
"""`view`: see; `drive`: also events, steps, and stages; `admin`: also uploads, edits, and deletions"""
ACCESS_ROLES: tuple[AccessRole, ...] = get_args(AccessRole)
"""each may do what the ones before it may"""
TOKEN_BYTES = 32


@dataclass(frozen=True)
class Grant:
    """What a token allows: the `role`, on all stages or (with `stage`) on one; `digest` is the token's hash,
    empty where the server asks for no token.
    """

    name: str
    role: AccessRole
    stage: str | None = None
    digest: str = ""

    def allows(self, role: AccessRole) -> bool:
        """Returns whether the grant's role may do what `role` may."""
        return ACCESS_ROLES.index(self.role) >= ACCESS_ROLES.index(role)


EVERYTHING = Grant("", "admin")
"""what everyone may do where the server asks for no token"""


def new_token() -> str:
    """Returns a new random token, which can be part of an address."""
    return secrets.token_urlsafe(TOKEN_BYTES)


def digest_of(token: str) -> str:
    """Returns the hash by which a token is known."""
    return hashlib.sha256(token.encode(errors="surrogatepass")).hexdigest()
