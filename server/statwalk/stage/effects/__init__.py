"""The effects of a tick: codes, and sentences that are made when they are read."""
