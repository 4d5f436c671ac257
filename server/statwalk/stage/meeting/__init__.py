"""What happens between actors: touches, events that one raises on another, flocks."""
