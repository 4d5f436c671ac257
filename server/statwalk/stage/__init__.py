"""Stages: actors in casts, the tick, and the log from which all states follow."""
