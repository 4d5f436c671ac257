"""What lies between actors: the grid that finds who is near, collisions, flocks. Arrays in, arrays out."""
