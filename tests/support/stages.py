"""Stages behind their hosts, as the server holds them, without a server."""

import pickle

from statwalk.services.hosting.registry import Registry
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.limits import Limits


def registry(catalogue: Catalogue, **limits: int | float) -> Registry:
    """Nobody is to read what its viewers are told."""
    return Registry(catalogue, pickle.dumps, Limits(**limits))
