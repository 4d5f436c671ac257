"""The durable store: stages, their logs and snapshots, and versions of machines, in one SQLite database."""
