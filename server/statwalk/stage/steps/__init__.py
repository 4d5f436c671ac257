"""The steps of the tick, one file a step."""
