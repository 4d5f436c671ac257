"""Limits rates: of one viewer's messages, of requests and inputs by address and by stage."""

from __future__ import annotations

import time
from collections import OrderedDict
from math import ceil

from statwalk.services.threads import Now

BYTES_OF_A_MESSAGE = 1_024
"""a longer message counts as several"""
MOST_BUCKETS = 4_096


class TokenBucket:
    """A token bucket: `rate` tokens a second, with a reserve of `most`."""

    def __init__(self, rate: float, most: float, now: Now = time.perf_counter) -> None:
        self.rate, self.most, self.now = rate, most, now
        self.left, self.at = most, now()

    def has_one(self) -> bool:
        """Returns whether a token is left."""
        now = self.now()
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

    def seconds_left(self) -> int:
        """Returns the whole seconds until a token is left, at least 1."""
        return max(1, ceil((1 - self.left) / self.rate))


class TokenBuckets:
    """A token bucket for each key; at most `MOST_BUCKETS`, those that were used last."""

    def __init__(self, rate: float, most: float, now: Now = time.perf_counter) -> None:
        self.rate, self.most, self.now = rate, most, now
        self._buckets: OrderedDict[str, TokenBucket] = OrderedDict()

    def of(self, key: str) -> TokenBucket:
        """Returns the bucket of a key."""
        bucket = self._buckets.get(key)
        if bucket is None:
            bucket = self._buckets[key] = TokenBucket(self.rate, self.most, self.now)
            if len(self._buckets) > MOST_BUCKETS:
                self._buckets.popitem(last=False)
        self._buckets.move_to_end(key)
        return bucket


def cost_of(data: str | bytes) -> float:
    """Returns the tokens that a message costs: one, and one more for every KiB."""
    return 1 + len(data) // BYTES_OF_A_MESSAGE
