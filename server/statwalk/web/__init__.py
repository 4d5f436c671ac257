"""The web floor, the only one that knows FastAPI, pydantic and sockets: the app and its door here; `api`, `streaming`, `keeping` beside."""
