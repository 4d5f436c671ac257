"""Another version of a machine while it is played."""
