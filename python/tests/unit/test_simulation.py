"""Missions in this process: the same log as `shoal sim`, observations and actions by name."""

from __future__ import annotations

import gc
import math
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

import shoal
from shoal import columns
from shoal.gym import Box, ShoalEnv

ALPHA = ROOT / "missions/alpha.toml"
STEERED = """
[mission]
duration_s = 20
[[vehicle]]
name = "alpha"
helm = "none"
[[vehicle]]
name = "bravo"
helm = "none"
start = {x_m = 50, y_m = 0, heading_deg = 90}
[[expect]]
kind = "arrival"
vehicle = "alpha"
point = [0, 0]
within_m = 5
by_s = 20
"""


pytestmark = pytest.mark.usefixtures("simulation_library")


@pytest.fixture
def steered(tmp_path: Path) -> Path:
    mission = tmp_path / "steered.toml"
    mission.write_text(STEERED)
    return mission


def test_the_log_is_that_of_shoal_sim(shoal_program: Path, tmp_path: Path) -> None:
    berta = ROOT / "missions/berta.toml"
    with shoal.Simulation(
        berta, overrides={"comms.comms_range": 180}, seed=7, log=tmp_path / "python.lcm"
    ) as sim:
        observer = sim.observer(["alpha.x_m", "HELM_STATE_BRAVO.state"])
        assert math.isnan(observer()[0])
        while sim.step(7):
            observer()
        assert sim.has_ended
    command: list[str | Path] = [shoal_program, "sim", berta, "--log", tmp_path / "sim.lcm"]
    command += ["--set", "comms.comms_range=180", "--set", "mission.seed=7"]
    subprocess.run(command, stdout=subprocess.DEVNULL, check=False)
    log = (tmp_path / "sim.lcm").read_bytes()
    assert len(log) > 1_000_000
    assert (tmp_path / "python.lcm").read_bytes() == log


def test_observations_have_names() -> None:
    with shoal.Simulation(ALPHA, watch=["NODE_REPORT_LOCAL"]) as sim:
        assert sim.vehicles == ["alpha"]
        assert (sim.step_number, sim.tick_s, sim["alpha"]) == (-1, 0.1, None)
        observer = sim.observer(["alpha.speed_mps", "NAV_ALPHA.x_m", "HELM_STATE_ALPHA.vehicle"])
        assert sim.step(300) == 300
        speed_mps, x_m, _ = observer()
        nav = sim["alpha"]
        assert (speed_mps, x_m) == (nav.speed_mps, nav.x_m)
        assert speed_mps > 0.5
        assert nav.utime == sim.utime - 100_000
        assert sim.message("NODE_REPORT_LOCAL").name.lower() == "alpha"
        assert "INCOMPLETE" in sim.summary()


def test_every_message_of_a_collected_channel_is_taken_once(tmp_path: Path) -> None:
    taken = []
    log = tmp_path / "collected.lcm"
    with shoal.Simulation(ALPHA, collect=["NODE_REPORT_LOCAL"], log=log) as sim:
        while sim.step(50):
            taken += [(each.utime, each.name) for each in sim.messages("NODE_REPORT_LOCAL")]
        with pytest.raises(shoal.SimulationError, match="NAV_ALPHA is not collected"):
            sim.messages("NAV_ALPHA")
        assert sim.messages("NODE_REPORT_LOCAL") == []
    reports = shoal.read(log)["NODE_REPORT_LOCAL"]
    assert len(taken) > 100
    assert taken == [(each.utime, each.name) for each in reports]


def test_actuators_hold_until_they_are_set_again(steered: Path) -> None:
    with shoal.Simulation(steered) as sim:
        sim.act({"bravo.thrust_pct": 50})
        sim.step(100)
        moved_m, speed_mps, still_m = sim.observe("bravo.x_m", "bravo.speed_mps", "alpha.x_m")
        assert moved_m > 53 and speed_mps > 0.5 and still_m == 0
        sim.act({"bravo.thrust_pct": 0})
        sim.step(60)
        assert sim.observe("bravo.speed_mps")[0] < speed_mps / 2


def test_a_helm_takes_commands() -> None:
    with shoal.Simulation(ALPHA) as sim:
        sim.step(100)
        sim.command("alpha", "goto", 300, 300)
        sim.step(600)
        assert sim["alpha"].y_m > 40  # Its own course keeps it below 0.


def test_errors_state_what_is_wrong(steered: Path) -> None:
    with pytest.raises(shoal.SimulationError, match="nowhere.toml"):
        shoal.Simulation("nowhere.toml")
    with pytest.raises(shoal.SimulationError, match="mission.sed"):
        shoal.Simulation(ALPHA, overrides=["mission.sed=1"])
    with pytest.raises(shoal.SimulationError, match="2\\^64"):
        shoal.Simulation(ALPHA, seed=-1)
    with shoal.Simulation(steered) as sim:
        with pytest.raises(KeyError, match="charlie"):
            sim["charlie"]
        with pytest.raises(KeyError, match="no 'z'"):
            sim.observer(["alpha.z"])
        with pytest.raises(KeyError, match="thrust_pct, rudder_deg"):
            sim.act({"alpha.thrust": 1})
        sim.step(1)
        with pytest.raises(shoal.SimulationError, match="before the first step"):
            sim.observer(["HELM_STATE_ALPHA.state"])
    with pytest.raises(shoal.SimulationError):
        sim.step(1)


def test_a_missing_library_is_named() -> None:
    code = "import shoal; shoal.Simulation('x')"
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "SHOAL_SIM_LIBRARY": "/nowhere.so", "PYTHONPATH": str(ROOT / "python")},
        stderr=subprocess.PIPE,
        text=True,
    )
    assert "SimulationError: cannot load libshoal_sim.so.0: /nowhere.so" in done.stderr


def test_an_environment_is_stepped_to_its_end(steered: Path, each_kind_of_column: str) -> None:
    env = ShoalEnv(
        steered,
        vehicles=["bravo"],
        observations=("x_m", "speed_mps"),
        steps=50,
        reward=lambda env: env.value("bravo.x_m"),
        terminated=lambda env: env.value("bravo.x_m") > 1000,
    )
    if env.action_space.__class__ is not Box and columns.numpy is None:
        pytest.skip("gymnasium needs numpy")
    observation, info = env.reset(seed=3)
    assert env.names == ["bravo.x_m", "bravo.speed_mps"]
    assert list(observation) == [50, 0] and info["utime"] == 100_000
    rewards, steps, truncated = [], 0, False
    while not truncated:
        observation, reward, terminated, truncated, info = env.step([60, 0])
        assert observation in env.observation_space and not terminated
        rewards.append(reward)
        steps += 1
    assert steps == 4 and rewards == sorted(rewards) and rewards[-1] > 60
    assert observation[0] == pytest.approx(rewards[-1])
    assert info["passed"] is True
    env.close()
    with pytest.raises(RuntimeError, match="reset"):
        env.step([0, 0])


def test_episodes_are_the_same_for_the_same_seed(steered: Path) -> None:
    def episode(env: Any, seed: int | None) -> list[float]:
        env.reset(seed=seed)
        env.action_space.seed(5)
        for _ in range(10):
            observation, *_ = env.step(env.action_space.sample())
        return [float(each) for each in observation]

    env = ShoalEnv(steered)
    assert env.action_space.shape == (4,) and env.observation_space.shape == (8,)
    first = episode(env, 1)
    assert episode(ShoalEnv(steered), 1) == first
    env.close()


def test_a_vehicle_with_a_helm_is_refused_and_overrides_take_the_helm_out() -> None:
    with pytest.raises(ValueError, match=r'overrides=\{"vehicle.alpha.helm": "none"\}'):
        ShoalEnv(ALPHA)
    ShoalEnv(ALPHA, actions=())  # To be observed alone.
    env = ShoalEnv(ALPHA, observations=("speed_mps",), overrides={"vehicle.alpha.helm": "none"})
    speeds = []
    for thrust in (0.0, 60.0):
        env.reset(seed=1)
        observation, *_ = env.step([thrust, 0.0])
        speeds.append(float(observation[0]))
    env.close()
    assert speeds[0] == pytest.approx(0.0, abs=0.01) and speeds[1] > 0.1


def test_wrong_arguments_of_an_environment_name_themselves(steered: Path) -> None:
    with pytest.raises(KeyError, match="no vehicle 'charlie'; the mission has alpha, bravo"):
        ShoalEnv(steered, vehicles=["charlie"])
    with pytest.raises(KeyError, match="no vehicle 'charlie'"):
        ShoalEnv(steered, vehicles=["charlie"], observations=(), actions=())
    with pytest.raises(ValueError, match="steps is 0"):
        ShoalEnv(steered, steps=0)
    with pytest.raises(shoal.SimulationError, match=r"none\.toml: cannot be read"):
        ShoalEnv("none.toml")
    env = ShoalEnv(steered, vehicles="alpha")
    env.reset(seed=1)
    with pytest.raises(ValueError, match="1 numbers; it needs 2: alpha.thrust_pct, alpha.rudder"):
        env.step([1.0])
    with pytest.raises(ValueError, match="has 1 numbers"):
        env.step(5.0)
    for wrong in (math.nan, math.inf, "fast", None):
        with pytest.raises(ValueError, match="'alpha.rudder_deg' is set to .*; it takes a finite"):
            env.step([1.0, wrong])
    env.close()


def test_a_box_knows_its_bounds() -> None:
    box = Box([-1, -math.inf], [1, math.inf])
    assert [0.5, 1e9] in box and [1.5, 0] not in box and [0] not in box
    box.seed(1)
    samples = [box.sample() for _ in range(100)]
    assert all(each in box for each in samples)
    assert len({float(each[0]) for each in samples}) == 100


def _resident_kib() -> int:
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * (os.sysconf("SC_PAGE_SIZE") // 1024)


@pytest.mark.skipif(
    "san" in os.environ.get("LD_PRELOAD", ""),
    reason="this machine cannot measure it: a sanitizer keeps what is freed",
)
def test_a_thousand_resets_take_no_more_memory_than_a_hundred(steered: Path) -> None:
    env = ShoalEnv(steered)
    before_kib = 0
    for number in range(1000):
        if number == 100:
            gc.collect()
            before_kib = _resident_kib()
        env.reset(seed=number)
        env.step(env.action_space.sample())
    gc.collect()
    assert _resident_kib() - before_kib < 1024
    env.close()


def test_gymnasiums_own_checker_accepts_it(steered: Path) -> None:
    checker = pytest.importorskip(
        "gymnasium.utils.env_checker", reason="this machine cannot have it: not in Debian"
    )
    checker.check_env(ShoalEnv(steered))
