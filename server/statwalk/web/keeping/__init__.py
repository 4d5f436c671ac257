"""What the server holds: machines and their versions, characters, stages."""
