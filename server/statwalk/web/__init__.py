"""The REST interface and the WebSocket; no other package imports FastAPI or pydantic."""
