"""Binds a mesh to bones: weights for vertices that have none (DS4; RTCA 2.3.1)."""
