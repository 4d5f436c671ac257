"""Relations between actors: the grid that finds neighbours, collisions, flocks. Arrays in, arrays out."""
