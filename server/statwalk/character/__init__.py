"""A character (skeleton, clips, skins), and a role: a character together with its machine."""
