"""Key frames: channels, sets of channels that share key times, and their packed form for sampling."""
