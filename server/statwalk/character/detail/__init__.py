"""Level of detail of a character: the poses that count, the order of collapses, coarser characters."""
