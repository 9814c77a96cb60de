"""A dog that stands, for tests that need one: made once, and copied for each test."""
import openr_host

_standing = {}


def standing(body="ideal"):
    """Returns a copy of a run in which the dog stands.  The caller closes it."""
    if body not in _standing:
        run = openr_host.Run(body=body)
        run.until_standing()
        _standing[body] = run
    return _standing[body].fork()


def close_all():
    while _standing:
        _standing.popitem()[1].close()
