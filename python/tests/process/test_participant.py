"""Programs in Python that take part in missions of `shoal run`."""

from __future__ import annotations

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest
import shoal
from conftest import ROOT

PORT = 29_600

MISSION = """
[mission]
duration_s = 20
on_loss = "{on_loss}"
participant_timeout_s = 2

[[vehicle]]
name = "alpha"
start = {{x_m = 0, y_m = 0, heading_deg = 90}}
helm = "none"

[[participant]]
name = "mine"
command = ["{program}"]
"""

PROGRAM = """#!/usr/bin/env python3
import os, sys, time
sys.path.insert(0, "{package}")
import shoal
me = shoal.Participant()
me.subscribe("NAV_ALPHA")
{code}
"""


@dataclass
class Finished:
    """What came of a mission."""

    code: int
    shown: str
    folder: Path

    @property
    def log(self) -> Path:
        return self.folder / "mission.lcm"

    @property
    def printed(self) -> str:
        return (self.folder / "logs/mine.txt").read_text()


class Runner:
    """Runs missions, each at ports of its own."""

    def __init__(self, program: Path, folder: Path) -> None:
        self._program = program
        self._folder = folder
        self._count = 0

    def run(self, mission: Path, warp: str = "max") -> Finished:
        self._count += 1
        folder = self._folder / f"recording{self._count}"
        done = subprocess.run(
            [str(self._program), "run", str(mission), "--warp", warp]
            + ["--record", str(folder), "--port", str(PORT + 10 * self._count)],
            env={**os.environ, "SHOAL_RUN_DIR": str(self._folder / "run")},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=120,
        )
        return Finished(done.returncode, done.stdout, folder)

    def run_code(self, code: str, on_loss: str = "end", warp: str = "max") -> Finished:
        """Runs a mission of which `code` is a participant."""
        program = self._folder / f"mine{self._count}.py"
        program.write_text(PROGRAM.format(package=ROOT / "python", code=code))
        program.chmod(0o755)
        mission = self._folder / f"mission{self._count}.toml"
        text = MISSION.format(on_loss=on_loss, program=program)
        mission.write_text(text)
        return self.run(mission, warp)


@pytest.fixture
def runner(shoal_program: Path, tmp_path: Path) -> Runner:
    return Runner(shoal_program, tmp_path)


STEER = """
def think(utime):
    me.publish("ACTUATORS_ALPHA", shoal.types.actuators_t(utime=utime, thrust_pct=20))
{more}
me.run(think)
"""


def test_the_example_steers_its_vessel_and_gives_the_same_log_twice(runner: Runner) -> None:
    mission = ROOT / "missions/python_planner.toml"
    first, second = runner.run(mission), runner.run(mission)
    assert first.code == 0, first.shown
    assert "Reproducible: yes" in first.shown
    assert first.log.read_bytes() == second.log.read_bytes()
    verdict = shoal.read(first.folder).verdict()
    assert verdict is not None and verdict.passed and len(verdict.expectations) == 2


def test_each_step_is_taken_once_with_the_messages_of_the_one_before(runner: Runner) -> None:
    done = runner.run_code(
        """
steps = []
def think(utime):
    nav = me.newest("NAV_ALPHA")
    steps.append((utime, None if nav is None else nav.utime))
me.run(think)
assert [utime for utime, _ in steps] == list(range(0, 20_000_001, 100_000)), steps
assert [nav for _, nav in steps[1:]] == [utime for utime, _ in steps[:-1]], steps
print("all is as it should be")
"""
    )
    assert done.code == 0, done.shown + done.printed
    assert done.printed == "all is as it should be\n"


def test_what_it_publishes_is_in_the_log(runner: Runner) -> None:
    done = runner.run_code(STEER.format(more=""))
    assert done.code == 0, done.shown
    actuators = shoal.read(done.folder)["ACTUATORS_ALPHA"]
    assert len(actuators) == 201 and set(actuators.thrust_pct) == {20.0}
    assert shoal.read(done.folder)["NAV_ALPHA"].x_m[-1] > 1


def test_a_crash_ends_the_mission_and_leaves_its_traceback(runner: Runner) -> None:
    done = runner.run_code(STEER.format(more="    if utime == 5_000_000: raise ValueError('why')"))
    assert done.code == 3
    assert "mine" in done.shown
    assert "ValueError: why" in done.printed


def test_a_crash_is_survived_where_the_mission_goes_on_without_it(runner: Runner) -> None:
    more = "    if utime == 5_000_000: raise ValueError('why')"
    done = runner.run_code(STEER.format(more=more), on_loss="continue")
    assert done.code == 0, done.shown
    assert len(shoal.read(done.folder)["NAV_ALPHA"]) == 201


def test_after_a_crash_it_takes_part_again_where_it_is_restarted(runner: Runner) -> None:
    more = """
    mark = __file__ + ".crashed"
    if utime == 5_000_000 and not os.path.exists(mark):
        open(mark, "w").close()
        os._exit(1)
"""
    done = runner.run_code(STEER.format(more=more), on_loss="restart", warp="4")
    assert done.code == 0, done.shown
    times_s = list(shoal.read(done.folder)["ACTUATORS_ALPHA"].time_s)
    assert times_s[:50] == [i / 10 for i in range(50)]
    assert times_s[-1] == 20 and len(times_s) > 60, done.shown


def test_one_that_hangs_is_lost(runner: Runner) -> None:
    done = runner.run_code(STEER.format(more="    if utime == 5_000_000: time.sleep(60)"))
    assert done.code == 3


def test_publishing_outside_of_a_step_is_refused(runner: Runner) -> None:
    done = runner.run_code('me.publish("A", b"")')
    assert done.code != 0
    assert "StepError: A: messages are published within a step only" in done.printed


def test_without_its_variables_it_states_what_sets_them(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(shoal.StepError, match="'SHOAL_PORT'; `shoal run` starts participants"):
        shoal.Participant(environ={})
    variables = {
        "SHOAL_PORT": "7665",
        "SHOAL_MISSION_ID": "1",
        "SHOAL_PARTICIPANT": "mine",
        "SHOAL_VEHICLES": "alpha",
        "SHOAL_LAYOUT": "shared",
    }
    with pytest.raises(shoal.StepError, match="no secret of the mission"):
        shoal.Participant(environ=variables)
    with pytest.raises(shoal.StepError, match="secret cannot be read"):
        shoal.Participant(environ={**variables, "SHOAL_SECRET_FILE": "/nowhere"})
