"""Runs several functions at a time, each with runs of its own."""
from __future__ import annotations

import concurrent.futures
import os
from typing import Callable, Iterable, Optional, TypeVar

Item = TypeVar("Item")
Result = TypeVar("Result")


def parallel(function: Callable[[Item], Result], items: Iterable[Item],
             jobs: Optional[int] = None) -> list[Result]:
    """Calls `function` for each item, `jobs` of them at a time, and returns the results in order.

    Runs are processes, and Python only waits for them, so threads are enough to use all cores: each
    call makes, or forks, runs of its own.
    """
    with concurrent.futures.ThreadPoolExecutor(jobs or os.cpu_count() or 1) as pool:
        return list(pool.map(function, items))
