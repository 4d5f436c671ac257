"""Stages: actors in casts, the tick, and the log that everything follows from."""
