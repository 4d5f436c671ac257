"""The past of a stage: its log, its snapshots, its timeline."""
