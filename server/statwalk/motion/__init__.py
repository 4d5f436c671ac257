"""Clips of key frames, their sampling, and the offsets that make transitions continuous."""
