"""Several missions at once as one environment: the vector form of Gymnasium.

    from shoal.vector import ShoalVectorEnv
    envs = ShoalVectorEnv(8, "mission.toml", vehicles=["alpha"])
    observations, infos = envs.reset(seed=1)             # the missions get the seeds 1 to 8
    observations, rewards, terminations, truncations, infos = envs.step(envs.action_space.sample())

Where gymnasium is installed, it is a gymnasium.vector.VectorEnv. Where it is not, it is a class
with the same methods. An episode that has ended begins again in the next step, whose action does
not count for it (autoreset "NextStep" of Gymnasium 1).
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

from . import columns
from .columns import Vector
from .gym import Box, ShoalEnv, gymnasium

_Base: Any = object if gymnasium is None else gymnasium.vector.VectorEnv


def _rows(rows: Sequence[Any]) -> Any:
    """Returns rows as an array of numpy, or as a list where numpy is not installed."""
    numpy: Any = getattr(columns, "numpy")
    return list(rows) if numpy is None else numpy.stack(list(rows))


def _flags(flags: Sequence[bool]) -> Any:
    numpy: Any = getattr(columns, "numpy")
    return list(flags) if numpy is None else numpy.array(flags, dtype=bool)


class Boxes:
    """The space of one Box for each environment; its shape is (environments, numbers)."""

    def __init__(self, box: Box, num_envs: int) -> None:
        self.box = box
        self.shape = (num_envs, *box.shape)

    def seed(self, seed: int | None = None) -> None:
        self.box.seed(seed)

    def sample(self) -> Any:
        return _rows([self.box.sample() for _ in range(self.shape[0])])

    def contains(self, value: Any) -> bool:
        return len(value) == self.shape[0] and all(self.box.contains(each) for each in value)

    def __contains__(self, value: Any) -> bool:
        return self.contains(value)


def _batched(space: Any, num_envs: int) -> Any:
    if gymnasium is None:
        return Boxes(space, num_envs)
    return gymnasium.vector.utils.batch_space(space, num_envs)


class ShoalVectorEnv(_Base):  # type: ignore[misc]
    """`num_envs` environments of one mission file, each with a seed of its own.

    Attributes:
        envs: The environments, shoal.gym.ShoalEnv.
        single_observation_space, single_action_space: Those of one of them.
        observation_space, action_space: Those of all: a row for each environment.
    """

    metadata: dict[str, Any] = {"render_modes": []}
    render_mode = None

    def __init__(self, num_envs: int, mission: str | os.PathLike[str], **arguments: Any) -> None:
        """`arguments` are those of ShoalEnv, whose errors are raised too.

        Raises:
            ValueError: `num_envs` is below 1.
        """
        if num_envs < 1:
            raise ValueError(f"num_envs is {num_envs}; it must be 1 or more")
        self.num_envs = num_envs
        self.envs = [ShoalEnv(mission, **arguments) for _ in range(num_envs)]
        if gymnasium is not None:
            autoreset = getattr(gymnasium.vector, "AutoresetMode", None)
            mode = "NextStep" if autoreset is None else autoreset.NEXT_STEP
            self.metadata = {**self.metadata, "autoreset_mode": mode}
        self.single_observation_space = self.envs[0].observation_space
        self.single_action_space = self.envs[0].action_space
        self.observation_space = _batched(self.single_observation_space, num_envs)
        self.action_space = _batched(self.single_action_space, num_envs)
        self._has_ended = [False] * num_envs

    def reset(
        self,
        *,
        seed: int | Sequence[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Any, dict[str, Any]]:
        """Begins an episode in each environment.

        Args:
            seed: One for each; or that of the first, to which the others add 1, 2, ...
            options: Not used.

        Raises:
            ValueError: the number of seeds is not that of the environments.
        """
        if seed is None or isinstance(seed, int):
            seeds = [None if seed is None else seed + i for i in range(self.num_envs)]
        else:
            seeds = list(seed)
        if len(seeds) != self.num_envs:
            raise ValueError(f"there are {len(seeds)} seeds for {self.num_envs} environments")
        begun = [env.reset(seed=each) for env, each in zip(self.envs, seeds, strict=True)]
        self._has_ended = [False] * self.num_envs
        return _rows([observation for observation, _ in begun]), _infos([info for _, info in begun])

    def step(self, actions: Any) -> tuple[Any, Any, Any, Any, dict[str, Any]]:
        """Steers all environments, each by its row of `actions`.

        Returns:
            Observations, rewards, terminations, truncations, each with one element or row for each
            environment; and {"utime": ..., "passed": ...}, likewise.

        Raises:
            ValueError: the number of rows is not that of the environments.
        """
        if len(actions) != self.num_envs:
            raise ValueError(f"there are {len(actions)} actions for {self.num_envs} environments")
        steps = [self._step(i, action) for i, action in enumerate(actions)]
        observations, rewards, terminated, truncated, infos = zip(*steps, strict=True)
        self._has_ended = [a or b for a, b in zip(terminated, truncated, strict=True)]
        numpy: Any = getattr(columns, "numpy")
        gained = list(rewards) if numpy is None else numpy.array(rewards, dtype=float)
        return _rows(observations), gained, _flags(terminated), _flags(truncated), _infos(infos)

    def _step(self, i: int, action: Any) -> tuple[Vector, float, bool, bool, dict[str, Any]]:
        if not self._has_ended[i]:
            return self.envs[i].step(action)
        observation, info = self.envs[i].reset()
        return observation, 0.0, False, False, info

    def close(self, **arguments: Any) -> None:
        """Ends all episodes. `arguments` of Gymnasium are not used."""
        for env in self.envs:
            env.close()


def _infos(infos: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Returns what the environments report, by name: a list with one element for each."""
    return {key: [info[key] for info in infos] for key in infos[0]}
