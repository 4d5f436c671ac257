"""One tick of machines, and what they remember between ticks (spec: "One tick")."""
