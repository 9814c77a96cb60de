"""Threads that run jobs of a script."""
import concurrent.futures


class JobPool(concurrent.futures.ThreadPoolExecutor):
    """A pool for a `with` block; if an exception such as Ctrl-C ends the block, jobs that wait do not begin."""

    def __exit__(self, kind, value, trace):
        self.shutdown(wait=True, cancel_futures=kind is not None)
        return False
