"""openr_host: runs of openr-host from Python (docs/python.md).

    import openr_host
    with openr_host.Run(body="ode", seed=1) as run:
        run.until_standing()
        print(run.value("height_mm"))
"""
from .build import build
from .env import AiboEnv
from .errors import BuildFailed, Error, NotMet, Refused, RunEnded, ProcessError
from .finding import Finding
from .parallel import parallel
from .remote import Remote, RemoteError
from .run import Connection, Message, Replay, Run, State, default_motion, replay

__all__ = ["AiboEnv", "BuildFailed", "Connection", "Error", "Finding", "Message", "NotMet", "Refused", "Remote",
           "RemoteError", "Replay", "Run", "RunEnded", "State", "ProcessError", "build", "default_motion", "parallel", "replay"]
