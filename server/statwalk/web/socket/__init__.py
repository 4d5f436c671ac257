"""The WebSocket of a viewer: it sends frames and facts, and receives inputs."""
