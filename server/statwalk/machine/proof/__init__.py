"""Properties with a time: all that can happen to an actor, tick by tick, and the longest it can take to get somewhere."""
