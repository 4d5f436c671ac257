"""The parts of a machine file: each module reads one kind of value from the YAML into its definition."""
