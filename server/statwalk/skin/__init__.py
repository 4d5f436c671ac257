"""Vertices that follow bones: rigid parts, rigid and soft skin, morph targets, normals."""
