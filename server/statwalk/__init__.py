"""statwalk animates characters from state tables."""
