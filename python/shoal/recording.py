"""The files beside a recorded log: mission.toml, run.txt, summary.txt (docs/missions/logs.md).

A log holds messages only: neither the mission's text nor its verdict. `shoal run --record` writes
both beside it; a log of `shoal sim --log` has neither.
"""

from __future__ import annotations

import os
import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .errors import Error

_LARGEST_FILE = 4 << 20  #: Bytes; of a mission file and of run.txt, as shoal has it.
_EXPECTATION = re.compile(r"    (pass|FAIL) (.*)")


@dataclass(frozen=True)
class Run:
    """How a recorded mission was run."""

    version: str = ""  #: Of shoal.
    mission_file: str = ""  #: The path that it had.
    seed: int | None = None
    warp: str = ""
    overrides: tuple[str, ...] = ()  #: `--set`, as given.


@dataclass(frozen=True)
class Expectation:
    """One [[expect]] of the mission."""

    passed: bool
    text: str  #: What was expected and what came of it, as the summary has it.


@dataclass(frozen=True)
class Verdict:
    """How a recorded mission ended, as the terminal showed it."""

    passed: bool
    line: str  #: The summary's last line: "PASS", or why not.
    expectations: tuple[Expectation, ...] = field(default=())


def _text_beside(log: str, name: str) -> str | None:
    """Returns the text of a file of a recording; None where the log is not in one."""
    folder = Path(log).parent
    if not (folder / "mission.toml").is_file() or not (folder / name).is_file():
        return None
    path = folder / name
    try:
        with open(path, "rb") as file:
            data = file.read(_LARGEST_FILE + 1)
    except OSError as error:
        raise Error(f"{path}: cannot be read: {error.strerror}") from None
    if len(data) > _LARGEST_FILE:
        raise Error(f"{path}: larger than 4 MiB")
    return data.decode("utf-8", "replace")


def mission_beside(log: str) -> dict[str, Any] | None:
    """Returns the mission file as it was, without overrides. Raises Error if it is not TOML."""
    text = _text_beside(log, "mission.toml")
    if text is None:
        return None
    try:
        return tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise Error(f"{os.path.join(os.path.dirname(log), 'mission.toml')}: {error}") from error


def run_beside(log: str) -> Run | None:
    text = _text_beside(log, "run.txt")
    if text is None:
        return None
    values: dict[str, str] = {}
    overrides = []
    for line in text.splitlines():
        key, _, value = line.partition(" ")
        if key == "set":
            overrides.append(value)
        else:
            values[key] = value
    seed = values.get("seed", "")
    return Run(
        version=values.get("shoal_version", ""),
        mission_file=values.get("mission_file", ""),
        seed=int(seed) if seed.isdecimal() and seed.isascii() and len(seed) <= 20 else None,
        warp=values.get("warp", ""),
        overrides=tuple(overrides),
    )


def verdict_beside(log: str) -> Verdict | None:
    text = _text_beside(log, "summary.txt")
    lines = [] if text is None else [line for line in text.splitlines() if line.strip()]
    if not lines:
        return None
    begin = lines.index("Expectations") + 1 if "Expectations" in lines else len(lines)
    found = [_EXPECTATION.match(line) for line in lines[begin:]]
    return Verdict(
        passed=lines[-1] == "PASS",
        line=lines[-1],
        expectations=tuple(Expectation(m[1] == "pass", m[2]) for m in found if m),
    )
