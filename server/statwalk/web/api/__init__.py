"""The REST interface: one file for each thing that has an address."""
