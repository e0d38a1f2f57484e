"""Environments for several agents (PettingZoo's parallel form) and several missions at once."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from shoal.parallel import ShoalParallelEnv
from shoal.vector import ShoalVectorEnv

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
"""
NOT_INSTALLED = "this machine cannot have it: not in Debian"

pytestmark = pytest.mark.usefixtures("simulation_library")


@pytest.fixture
def steered(tmp_path: Path) -> Path:
    path = tmp_path / "steered.toml"
    path.write_text(STEERED)
    return path


@pytest.fixture
def agents(steered: Path) -> Iterator[ShoalParallelEnv]:
    env = ShoalParallelEnv(
        steered,
        observations=("x_m", "speed_mps"),
        actions=("thrust_pct",),
        reward=lambda env, agent: env.value(agent, "speed_mps"),
        terminated=lambda env, agent: agent == "bravo" and env.value(agent, "x_m") > 55,
    )
    yield env
    env.close()


def test_each_agent_is_a_vehicle_with_spaces_of_its_own(agents: ShoalParallelEnv) -> None:
    assert agents.possible_agents == ["alpha", "bravo"]
    assert agents.agents == [] and agents.num_agents == 0 and agents.max_num_agents == 2
    observations, infos = agents.reset(seed=3)
    assert agents.agents == ["alpha", "bravo"]
    assert list(observations) == list(infos) == ["alpha", "bravo"]
    for agent in agents.agents:
        assert agents.action_space(agent).shape == (1,)
        assert agents.observation_space(agent).shape == (2,)
        assert agents.action_space(agent) is agents.action_space(agent)
        assert agents.observation_space(agent).contains(observations[agent])
    assert float(observations["bravo"][0]) == 50


def test_agents_leave_when_they_terminate_and_all_leave_at_the_end(
    agents: ShoalParallelEnv,
) -> None:
    agents.reset(seed=1)
    left: list[list[str]] = []
    speeds = []
    while agents.agents:
        before = list(agents.agents)
        actions = {agent: [100.0] for agent in before}
        observations, rewards, terminations, truncations, infos = agents.step(actions)
        assert list(observations) == list(rewards) == list(infos) == before
        assert list(terminations) == list(truncations) == before
        speeds.append(rewards["alpha"])
        gone = [agent for agent in before if terminations[agent] or truncations[agent]]
        assert agents.agents == [agent for agent in before if agent not in gone]
        if gone:
            left.append(gone)
        assert not any(terminations[agent] and truncations[agent] for agent in before)
    assert left == [["bravo"], ["alpha"]]
    assert max(speeds) > 1 and infos["alpha"]["utime"] == 20_000_000


def test_an_agent_without_an_action_is_an_error(agents: ShoalParallelEnv) -> None:
    agents.reset(seed=1)
    with pytest.raises(KeyError, match="bravo"):
        agents.step({"alpha": [0.0]})


def test_pettingzoos_own_test_accepts_it(agents: ShoalParallelEnv) -> None:
    api = pytest.importorskip("pettingzoo.test", reason=NOT_INSTALLED)
    api.parallel_api_test(agents, num_cycles=50)


@pytest.fixture
def three(steered: Path) -> Iterator[ShoalVectorEnv]:
    envs = ShoalVectorEnv(
        3,
        steered,
        vehicles=["alpha"],
        observations=("x_m", "y_m"),
        actions=("thrust_pct", "rudder_deg"),
        steps=100,
        reward=lambda env: env.value("alpha.y_m"),
    )
    yield envs
    envs.close()


def numbers(values: Any) -> list[list[float]]:
    return [[float(each) for each in row] for row in values]


def test_environments_have_a_row_each(three: ShoalVectorEnv) -> None:
    assert three.num_envs == 3
    assert three.single_observation_space.shape == (2,)
    assert three.observation_space.shape == (3, 2)
    assert three.action_space.shape == (3, 2)
    assert three.action_space.contains(three.action_space.sample())
    observations, infos = three.reset(seed=[4, 5, 6])
    assert len(observations) == 3 and len(infos["utime"]) == 3
    answer = three.step([[100.0, 0.0], [0.0, 0.0], [50.0, 30.0]])
    observations, rewards, terminations, truncations, infos = answer
    rows = numbers(observations)
    assert rows[0][1] > rows[2][1] > rows[1][1] == 0
    assert [float(each) for each in rewards] == pytest.approx([row[1] for row in rows], rel=1e-6)
    assert list(terminations) == list(truncations) == [False] * 3
    assert infos["utime"] == [infos["utime"][0]] * 3


def test_an_episode_that_has_ended_begins_again_in_the_next_step(three: ShoalVectorEnv) -> None:
    three.reset(seed=1)
    ahead = [[100.0, 0.0]] * 3
    truncations: Any = [False]
    steps = 0
    while not any(truncations):
        observations, _, _, truncations, _ = three.step(ahead)
        steps += 1
        assert steps < 10
    assert list(truncations) == [True] * 3
    assert min(row[1] for row in numbers(observations)) > 10
    observations, rewards, _, truncations, infos = three.step(ahead)
    assert [math.hypot(*row) for row in numbers(observations)] == [0, 0, 0]
    assert list(rewards) == [0, 0, 0] and not any(truncations) and max(infos["utime"]) < 1_000_000


def test_wrong_numbers_of_environments_actions_and_seeds_are_errors(
    three: ShoalVectorEnv, steered: Path
) -> None:
    with pytest.raises(ValueError, match="num_envs is 0; it must be 1 or more"):
        ShoalVectorEnv(0, steered)
    with pytest.raises(ValueError, match="2 seeds for 3 environments"):
        three.reset(seed=[1, 2])
    three.reset(seed=1)
    with pytest.raises(ValueError, match="1 actions for 3 environments"):
        three.step([[0.0, 0.0]])


def test_it_is_a_vector_environment_where_gymnasium_is(three: ShoalVectorEnv) -> None:
    gymnasium = pytest.importorskip("gymnasium", reason=NOT_INSTALLED)
    assert isinstance(three, gymnasium.vector.VectorEnv)
