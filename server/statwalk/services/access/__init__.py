"""Who may do what: roles, tokens, the file of people, share links, and what a token grants."""
