"""Why an event did what it did, and what would have made it fire."""
