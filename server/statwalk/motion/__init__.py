"""Clips of key frames, how they are sampled, and what keeps one from jumping into the next."""
