"""Counts the results of a test of a script: verdict() counts, finish() prints "N passed, N failed, N skipped"."""

_counts = {True: 0, False: 0}


def verdict(name, good, said=""):
    """Counts a pass, or a failure, which prints the name and what was said instead."""
    _counts[bool(good)] += 1
    if not good:
        print(f"FAILED: {name}\n{said}")


def finish(skipped=0):
    """Prints the last line; returns the exit status."""
    print(f"{_counts[True]} passed, {_counts[False]} failed" + (f", {skipped} skipped" if skipped else ""))
    return 1 if _counts[False] else 0
