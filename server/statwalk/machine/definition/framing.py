"""How much of a character a camera shows."""

from __future__ import annotations

from typing import Literal, get_args

Framing = Literal["whole", "upper body", "face", "wide"]
FRAMINGS: tuple[Framing, ...] = get_args(Framing)
