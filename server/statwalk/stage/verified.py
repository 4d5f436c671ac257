"""What is wrong with a role, and what refutes its properties as a stage shows it."""

from __future__ import annotations

from collections import defaultdict

from statwalk.character.role import Role
from statwalk.machine.lint.findings import Finding
from statwalk.machine.model_checker.played import Inputs, Play
from statwalk.machine.model_checker.work import Checkpoint, go_on
from statwalk.stage.stage import Stage


def verified(role: Role, checkpoint: Checkpoint = go_on) -> tuple[Finding, ...]:
    """Returns the verifier's findings about a role; each `replay` was played on a stage.

    `checkpoint` ends the verification by raising.
    """
    return role.verify(checkpoint, player(role, checkpoint))


def player(role: Role, checkpoint: Checkpoint = go_on) -> Play:
    """Returns what plays inputs to one actor of a role on a fresh stage."""

    def play(inputs: Inputs, ticks: int) -> list[list[tuple[str, str, str]]]:
        stage, pressed = Stage(), defaultdict[int, list[str]](list)
        stage.before_tick = checkpoint
        actor = stage.add(role)
        for tick, event in inputs:
            pressed[tick].append(event)
        return [_step(stage, actor.id, pressed[tick]) for tick in range(1, ticks + 1)]

    return play


def _step(stage: Stage, actor: int, events: list[str]) -> list[tuple[str, str, str]]:
    """Event, state and new state of what the base layer takes in the next tick."""
    for event in events:
        stage.send(actor, event)
    stage.step()
    return [
        (verdict.event, verdict.from_state, verdict.to_state)
        for verdict in stage.effects.verdicts
        if verdict.layer == 0 and verdict.verdict == "taken"
    ]
