"""shoal for Python: logs, the live bus, participants and results of campaigns.

    import shoal
    log = shoal.read("mission.lcm")
    log["NAV_ALPHA"].x_m

Pure standard library; columns are numpy's arrays where numpy is installed. docs/extending/python.md
shows all of it.
"""

from __future__ import annotations

from .bus import Bus, Received
from .errors import (
    BusError,
    DecodeError,
    Error,
    LcmFileError,
    LogError,
    LogWarning,
    ResultsError,
    SimulationError,
    StepError,
)
from .links import Link, MediumCount
from .log import Log, Record, read
from .message import Message
from .participant import Participant
from .recording import Expectation, Run, Verdict
from .results import Results, campaign
from .running import RunningMission, running_missions
from .simulation import Simulation
from .table import Row, Table
from .type_set import Types, own_types

__all__ = [
    "Bus",
    "BusError",
    "DecodeError",
    "Error",
    "Expectation",
    "LcmFileError",
    "Link",
    "Log",
    "LogError",
    "LogWarning",
    "MediumCount",
    "Message",
    "Participant",
    "Received",
    "Record",
    "Results",
    "ResultsError",
    "Row",
    "Run",
    "RunningMission",
    "Simulation",
    "SimulationError",
    "StepError",
    "Table",
    "Types",
    "Verdict",
    "campaign",
    "read",
    "running_missions",
    "types",
]

#: shoal's own message types: shoal.types.nav_t(x_m=3.0), shoal.types.decode(data).
types: Types = own_types()
