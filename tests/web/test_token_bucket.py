"""A reserve that fills at a rate, and says when the next token comes."""

from statwalk.web import token_bucket
from statwalk.web.token_bucket import TokenBucket, TokenBuckets


def test_the_reserve_is_spent_and_comes_back_at_the_rate() -> None:
    bucket = TokenBucket(rate=0.1, most=3)
    assert [bucket.spend() for _ in range(4)] == [True, True, True, False]
    assert bucket.seconds_left() in (9, 10)
    bucket.at -= 25.0  # as if 25 s had passed
    assert [bucket.spend() for _ in range(3)] == [True, True, False]


def test_who_waits_is_told_of_a_second_at_least() -> None:
    assert TokenBucket(rate=1_000, most=1).seconds_left() == 1


def test_each_key_has_a_bucket_and_the_oldest_goes(monkeypatch) -> None:
    monkeypatch.setattr(token_bucket, "MOST_BUCKETS", 2)
    buckets = TokenBuckets(rate=0.001, most=1)
    assert [buckets.of(key).spend() for key in ("a", "b", "a")] == [True, True, False]
    assert buckets.of("c").spend()  # b, the one that was used longest ago, is forgotten
    assert [buckets.of(key).spend() for key in ("a", "b")] == [False, True]
