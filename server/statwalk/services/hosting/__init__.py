"""Stages that run: stage hosts, the registry of hosts, the ticker, versions of machines, recordings."""
