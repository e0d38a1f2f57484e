"""Finds the missions that this user runs: a file for each in the run folder.

docs/inside/security.md describes the folder.
"""

from __future__ import annotations

import os
import stat
from dataclasses import dataclass

from .errors import BusError
from .ports import PortPlan

_LARGEST_ENTRY = 1 << 20  # Bytes.


@dataclass(frozen=True)
class RunningMission:
    """A mission that runs."""

    name: str
    file: str  #: Absolute path of the mission file.
    folder: str  #: The working folder in which it was started.
    mission_id: int
    pid: int  #: Of its launcher.
    ports: PortPlan

    def __str__(self) -> str:
        return f"{self.name} ({self.file}), ports from {self.ports.base}, started in {self.folder}"


def run_folder() -> str:
    """Returns the folder of running missions."""
    own = os.environ.get("SHOAL_RUN_DIR")
    if own:
        return own.rstrip("/") or "/"
    runtime = os.environ.get("XDG_RUNTIME_DIR")
    return f"{runtime}/shoal" if runtime else f"/tmp/shoal-{os.geteuid()}"


def running_missions() -> list[RunningMission]:
    """Returns the missions of this user whose launchers are alive, in order of port.

    Raises:
        BusError: the folder is another user's, or others can write it, so that it is not trusted.
    """
    path = run_folder()
    try:
        folder = os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC)
    except FileNotFoundError:
        return []
    except OSError as error:
        raise BusError(f"cannot use {path} as the folder of running missions: {error}") from error
    try:
        status = os.fstat(folder)
        if status.st_uid != os.geteuid() or stat.S_IMODE(status.st_mode) & 0o022:
            raise BusError(
                f"the folder of running missions, {path}, is not yours alone, so that what it "
                "holds cannot be trusted; name one of your own in SHOAL_RUN_DIR"
            )
        names = [each for each in os.listdir(folder) if each.endswith(".run")]
        found = [_read_entry(folder, each) for each in names]
    finally:
        os.close(folder)
    return sorted((each for each in found if each), key=lambda each: each.ports.base)


def _read_entry(folder: int, name: str) -> RunningMission | None:
    """Returns the mission of an entry; None if it is not one, or its launcher is gone."""
    try:
        flags = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC
        with open(os.open(name, flags, dir_fd=folder), "rb") as file:
            text = file.read(_LARGEST_ENTRY).decode("utf-8", "replace")
    except OSError:
        return None
    values: dict[str, str] = {}
    vehicles = []
    for line in text.split("\n"):
        key, _, value = line.partition(" ")
        values[key] = value
        if key == "vehicle":
            vehicles.append(value)
    try:
        mission = RunningMission(
            name=values.get("name", ""),
            file=values.get("file", ""),
            folder=values.get("folder", ""),
            mission_id=int(values["mission_id"]),
            pid=int(values["pid"]),
            ports=PortPlan(
                int(values["port_base"]), values.get("layout") == "communities", tuple(vehicles)
            ),
        )
        os.kill(mission.pid, 0)  # Whether it is there; of another user: it is not the launcher.
    except (KeyError, ValueError, OverflowError, OSError):
        return None
    ports = mission.ports
    return mission if ports.base >= 1024 and ports.data_ports.stop <= 65536 else None


def choose_mission(
    missions: list[RunningMission], port: int | None, commands: bool
) -> RunningMission:
    """Chooses the mission at `port`; without one that of this folder, or, to look at, the only one.

    Raises:
        BusError: there is none or more than one; the text lists them.
    """
    if not missions:
        raise BusError("no mission is running on this machine; start one with `shoal run FILE`")
    try:
        here = os.getcwd()
    except OSError:  # It has been removed.
        here = ""
    wanted = [each for each in missions if each.ports.base == port]
    if port is None:
        wanted = [each for each in missions if here and each.folder == here]
        if not wanted and not commands:
            wanted = missions
    if len(wanted) == 1:
        return wanted[0]
    listed = "".join(f"\n  port={each.ports.base}: {each}" for each in missions)
    if port is not None:
        raise BusError(f"no mission runs at port {port}; running:{listed}")
    if not wanted:
        raise BusError(f"no mission was started in this folder ({here}); name its port:{listed}")
    raise BusError(f"several missions are running; choose one by its port:{listed}")
