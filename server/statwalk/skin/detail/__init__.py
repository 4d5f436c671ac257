"""Level of detail: the order in which the vertices of a surface collapse, and how far each level is off."""
