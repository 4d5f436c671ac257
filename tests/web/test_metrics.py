"""What the server counts: few labels, whatever clients are called and ask for."""

import pytest
from prometheus_client.parser import text_string_to_metric_families
from stages import registry
from statwalk.services.hosting.commands import AddActor, StageSetup
from statwalk.services.library.catalogue import Catalogue
from statwalk.web.metrics import Metrics, crowd

USERS_NAME = "a-name-that-a-user-has-chosen"


def samples(metrics: Metrics, *stages: object) -> dict[str, dict[tuple[str, ...], float]]:
    """By sample and by the values of its labels."""
    found: dict[str, dict[tuple[str, ...], float]] = {}
    text = metrics.text(stages, {}, {"uploads": 3}).decode()
    for family in text_string_to_metric_families(text):
        for sample in family.samples:
            found.setdefault(sample.name, {})[tuple(sample.labels.values())] = sample.value
    return found


def test_what_is_held_now_is_counted_when_it_is_asked_for() -> None:
    held = registry(Catalogue())
    actors = (AddActor("faq-walker", name=USERS_NAME), AddActor("faq-walker"))
    stage = held.open(StageSetup(clock="manual", actors=actors))
    found = samples(Metrics(), stage)
    assert found["statwalk_held"] == {("stages",): 1, ("actors",): 2, ("viewers",): 0}
    assert found["statwalk_waiting"] == {("uploads",): 3}
    assert USERS_NAME not in str(found)


def test_late_ticks_fall_into_buckets_and_lost_ones_are_summed() -> None:
    metrics = Metrics()
    metrics.measure_ticks([0.003, 0.02, 3.0], 2)
    metrics.measure_ticks([], 5)
    found = samples(metrics)
    buckets = {
        float(labels[0]): count for labels, count in found["statwalk_tick_late_seconds_bucket"].items()
    }
    assert [buckets[bound] for bound in (0.002, 0.004, 0.033, 1.0, float("inf"))] == [0, 1, 2, 2, 3]
    assert found["statwalk_ticks_left_out_total"] == {(): 7}


def test_an_invented_method_is_no_label_of_its_own() -> None:
    metrics = Metrics()
    for method in ("GET", "FILM", "FOLD"):
        metrics.count_answer(method, "other", 405)
    assert samples(metrics)["statwalk_requests_total"] == {
        ("GET", "other", "405"): 1,
        ("other", "other", "405"): 2,
    }


@pytest.mark.parametrize(
    ("viewers", "label"), [(1, "1"), (2, "2-9"), (99, "10-99"), (100, "100+"), (5_000, "100+")]
)
def test_the_number_of_viewers_is_one_of_four_labels(viewers: int, label: str) -> None:
    assert crowd(viewers) == label
