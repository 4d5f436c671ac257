"""Limits the rate of one viewer's messages."""

from __future__ import annotations

import time

BYTES_OF_A_MESSAGE = 1_024
"""a longer message counts as several"""


class TokenBucket:
    """A token bucket: `rate` tokens a second, with a reserve of `most`."""

    def __init__(self, rate: float, most: float) -> None:
        self.rate, self.most = rate, most
        self.left, self.at = most, time.monotonic()

    def has_one(self) -> bool:
        """Returns whether a token is left."""
        now = time.monotonic()
        self.left, self.at = min(self.most, self.left + (now - self.at) * self.rate), now
        return self.left >= 1

    def spend(self, cost: float = 1.0) -> bool:
        """Takes `cost` tokens, perhaps more than are left; returns False if not even one is left."""
        if not self.has_one():
            return False
        self.left -= cost
        return True

    def give_back(self) -> None:
        """Puts one token back."""
        self.left += 1


def cost_of(data: str | bytes) -> float:
    """Returns the tokens that a message costs: one, and one more for every KiB."""
    return 1 + len(data) // BYTES_OF_A_MESSAGE
