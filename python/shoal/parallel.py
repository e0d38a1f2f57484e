"""A mission as an environment for several agents: PettingZoo's parallel form, a vehicle an agent.

    from shoal.parallel import ShoalParallelEnv
    env = ShoalParallelEnv("mission.toml", reward=lambda env, agent: -env.value(agent, "speed_mps"))
    observations, infos = env.reset(seed=1)
    while env.agents:
        actions = {agent: env.action_space(agent).sample() for agent in env.agents}
        observations, rewards, terminations, truncations, infos = env.step(actions)

Where pettingzoo is installed, it is a pettingzoo.ParallelEnv. Where it is not, it is a class with
the same methods. Spaces are those of shoal.gym.
"""

from __future__ import annotations

import importlib
import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from .columns import Vector
from .gym import ShoalEnv, box_of_actions, box_of_observations

_parallel_env: Any
try:
    _parallel_env = importlib.import_module("pettingzoo").ParallelEnv
except ImportError:
    _parallel_env = object


class ShoalParallelEnv(_parallel_env):  # type: ignore[misc]
    """A mission whose vehicles are steered by one agent each. An agent has its vehicle's name.

    A vehicle whose agent has terminated gets zeros for its actuators from then on.

    Attributes:
        possible_agents: The steered vehicles, in the mission's order or that of `vehicles`.
        agents: Those whose episode goes on; empty before the first reset and at the end.
    """

    metadata: dict[str, Any] = {"render_modes": [], "name": "shoal_v0"}
    render_mode = None

    def __init__(
        self,
        mission: str | os.PathLike[str],
        *,
        vehicles: Iterable[str] | None = None,
        observations: Iterable[str] = ("x_m", "y_m", "heading_deg", "speed_mps"),
        actions: Iterable[str] = ("thrust_pct", "rudder_deg"),
        steps: int = 10,
        reward: Callable[[ShoalParallelEnv, str], float] | None = None,
        terminated: Callable[[ShoalParallelEnv, str], bool] | None = None,
        overrides: Mapping[str, object] | Iterable[str] = (),
        watch: Iterable[str] = (),
    ) -> None:
        """Opens the mission once, to see that it is right.

        Args and errors are those of shoal.gym.ShoalEnv, but for `reward` and `terminated`, which
        are given the environment and the name of an agent.
        """
        actions, observations = tuple(actions), tuple(observations)
        self._env = ShoalEnv(
            mission,
            vehicles=vehicles,
            observations=observations,
            actions=actions,
            steps=steps,
            overrides=overrides,
            watch=watch,
        )
        self._reward = reward
        self._terminated = terminated
        self._num_actions = len(actions)
        self._num_observations = len(observations)
        self.possible_agents = list(self._env.vehicles)
        self.agents: list[str] = []
        self.observation_spaces = {
            agent: box_of_observations(self._num_observations) for agent in self.possible_agents
        }
        self.action_spaces = {agent: box_of_actions(actions) for agent in self.possible_agents}

    @property
    def sim(self) -> Any:
        """The shoal.Simulation of this episode; None before the first reset."""
        return self._env.sim

    @property
    def num_agents(self) -> int:
        return len(self.agents)

    @property
    def max_num_agents(self) -> int:
        return len(self.possible_agents)

    def observation_space(self, agent: str) -> Any:
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Any:
        return self.action_spaces[agent]

    def reset(
        self, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[dict[str, Vector], dict[str, dict[str, Any]]]:
        """Begins an episode; `seed` as that of ShoalEnv.reset. `options` are not used."""
        observation, info = self._env.reset(seed=seed)
        self.agents = list(self.possible_agents)
        return self._by_agent(observation), {agent: dict(info) for agent in self.agents}

    def step(
        self, actions: Mapping[str, Any]
    ) -> tuple[
        dict[str, Vector],
        dict[str, float],
        dict[str, bool],
        dict[str, bool],
        dict[str, dict[str, Any]],
    ]:
        """Steers all vehicles, each by the action of its agent, for `steps` steps.

        Returns:
            Observations, rewards, whether an agent has terminated, whether the mission has ended
            before that, and {"utime": ..., "passed": ...}: for each agent that had an action.

        Raises:
            KeyError: an agent of `agents` has no action.
        """
        moving = list(self.agents)
        wanted: list[float] = []
        for agent in self.possible_agents:
            wanted += list(actions[agent]) if agent in moving else [0.0] * self._num_actions
        observation, _, _, truncated, info = self._env.step(wanted)
        observations = {agent: self._by_agent(observation)[agent] for agent in moving}
        rewards = {agent: self._reward_of(agent) for agent in moving}
        terminations = {agent: self._has_terminated(agent) for agent in moving}
        truncations = {agent: truncated and not terminations[agent] for agent in moving}
        self.agents = [] if truncated else [each for each in moving if not terminations[each]]
        infos = {agent: dict(info) for agent in moving}
        return observations, rewards, terminations, truncations, infos

    def _by_agent(self, observation: Vector) -> dict[str, Vector]:
        size = self._num_observations
        return {
            agent: observation[i * size : (i + 1) * size]
            for i, agent in enumerate(self.possible_agents)
        }

    def _reward_of(self, agent: str) -> float:
        return 0.0 if self._reward is None else float(self._reward(self, agent))

    def _has_terminated(self, agent: str) -> bool:
        return self._terminated is not None and bool(self._terminated(self, agent))

    def value(self, agent: str, member: str) -> float:
        """Returns a member of an agent's NAV, such as "x_m", for `reward` and `terminated`."""
        return self._env.value(f"{agent}.{member}")

    def render(self) -> None:
        """Shows nothing: `shoal view` shows a log."""

    def close(self) -> None:
        """Ends the episode."""
        self._env.close()
        self.agents = []
