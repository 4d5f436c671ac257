"""Content by name: machines, characters, scenes, uploads."""
