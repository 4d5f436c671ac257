"""Whom limits count as one client: an address of IPv4, or a network of IPv6."""

from __future__ import annotations

import ipaddress
from collections.abc import Mapping
from typing import Any

PREFIX_BITS = 64
"""of an IPv6 address: a client has all addresses with its prefix"""


def address_of(scope: Mapping[str, Any]) -> str:
    """Returns the client's address; of IPv6 its network. Empty if the connection has none."""
    client = scope.get("client")
    if not client:
        return ""
    try:
        address = ipaddress.ip_address(client[0])
    except ValueError:
        return str(client[0])
    if isinstance(address, ipaddress.IPv4Address):
        return str(address)
    return str(address.ipv4_mapped or ipaddress.ip_network((address, PREFIX_BITS), strict=False))
