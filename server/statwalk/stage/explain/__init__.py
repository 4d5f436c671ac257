"""Explanations: why an event was taken, waits or was dropped, and which single changes would have made it
fire.
"""
