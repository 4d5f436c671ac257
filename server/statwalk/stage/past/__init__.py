"""What a stage remembers: its log, the snapshots to go back by, and how a log becomes a stage again."""
