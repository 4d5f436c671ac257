"""The socket: what viewers are shown, and what they say."""
