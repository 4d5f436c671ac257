"""One tick of a machine, compiled: the state of its actors, the rules in their order, and the effects."""
