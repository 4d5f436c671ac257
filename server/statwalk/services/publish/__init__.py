"""Frames and facts for viewers: encoded once, sent to every viewer."""
