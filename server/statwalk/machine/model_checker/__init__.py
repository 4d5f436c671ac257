"""Timed properties: all that can happen to an actor, tick by tick, and the longest it can take."""
