"""Remedies in words."""

from __future__ import annotations

from typing import Any

from statwalk.machine.definition.machine_definition import END
from statwalk.stage.explain.counterfactual import Change
from statwalk.stage.explain.remedies import Question

WORDS = {
    "send": "send {name} in tick {tick}",
    "release": "release {name} first, which is held",
    "set": "{parameter} at {value:g}, not at {now:g}",
    "moment": "{name} in tick {fires}, {when}",
    "hold": "hold {name} down: it fires in tick {fires}, {when}",
    "state": "in {state}, by way of: {way}; {name} then fires in tick {fires}",
    "buffer": "let {name} wait for {seconds:g} s: it fires in tick {fires}, {when}",
    "cell": "{state}/{event}: {text}",
}


def text_of(question: Question, change: Change, fires: int) -> str:
    """Returns a remedy in words."""
    words: dict[str, Any] = {
        **change,
        "tick": change.get("tick", question.tick),
        "fires": fires,
        "name": question.event,
    }
    seconds = (fires - question.tick) / question.stage.rate
    words["when"] = f"{abs(seconds):.2f} s {'later' if seconds > 0 else 'earlier'}"
    words["now"] = dict(question.verdict.values).get(change.get("parameter", ""), 0.0)
    words["way"] = ", ".join(
        "wait for the end" if step["event"] == END else step["event"] for step in change.get("steps", ())
    )
    return WORDS[change["kind"]].format(**words)
