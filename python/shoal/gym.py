"""A mission as an environment of Gymnasium, for one vehicle or many.

    from shoal.gym import ShoalEnv
    env = ShoalEnv("mission.toml", observations=("x_m", "y_m"), actions=("thrust_pct",))
    observation, info = env.reset(seed=1)
    observation, reward, terminated, truncated, info = env.step(env.action_space.sample())

Where gymnasium is installed, ShoalEnv is a gymnasium.Env and its spaces are gymnasium's. Where it
is not, it is a class of its own with the same methods, and spaces that do what is used here.
"""

from __future__ import annotations

import importlib
import math
import os
import random
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from . import columns
from .columns import Vector
from .simulation import Simulation

gymnasium: Any
try:
    gymnasium = importlib.import_module("gymnasium")
except ImportError:
    gymnasium = None

#: The range of each actuator; vehicles limit them further by their own models.
ACTUATOR_LIMITS = {
    "thrust_pct": 100.0,
    "rudder_deg": 60.0,
    "stern_plane_deg": 30.0,
    "propeller_rpm": 2000.0,
}


class Box:
    """Numbers between bounds, where gymnasium.spaces.Box is not installed."""

    def __init__(self, low: Sequence[float], high: Sequence[float]) -> None:
        self.low = list(low)
        self.high = list(high)
        self.shape = (len(self.low),)
        self._draw = random.Random()

    def seed(self, seed: int | None = None) -> None:
        self._draw = random.Random(seed)

    def sample(self) -> Vector:
        """Returns numbers drawn evenly; normally where a bound is infinite."""
        return _numbers(
            [
                self._draw.uniform(low, high)
                if math.isfinite(low) and math.isfinite(high)
                else self._draw.gauss(0.0, 1.0)
                for low, high in zip(self.low, self.high, strict=True)
            ]
        )

    def contains(self, value: Any) -> bool:
        if len(value) != len(self.low):
            return False
        return all(
            low <= float(each) <= high
            for low, each, high in zip(self.low, value, self.high, strict=True)
        )

    def __contains__(self, value: Any) -> bool:
        return self.contains(value)


def _numbers(values: Sequence[float]) -> Vector:
    """Returns numpy's array of float32, or a list where numpy is not installed."""
    numpy: Any = getattr(columns, "numpy")  # As `columns` found it.
    made: Any = list(values) if numpy is None else numpy.asarray(values, dtype=numpy.float32)
    return made  # type: ignore[no-any-return]


def _box(low: Sequence[float], high: Sequence[float]) -> Any:
    if gymnasium is None:
        return Box(low, high)
    return gymnasium.spaces.Box(_numbers(low), _numbers(high), dtype="float32")


def box_of_actions(actuators: Sequence[str]) -> Any:
    """Returns the space of these actuators of one or several vehicles: a Box."""
    high = [ACTUATOR_LIMITS[each] for each in actuators]
    return _box([-each for each in high], high)


def box_of_observations(size: int) -> Any:
    """Returns the space of `size` observations without bounds: a Box."""
    return _box([-math.inf] * size, [math.inf] * size)


_Base: Any = object if gymnasium is None else gymnasium.Env


class ShoalEnv(_Base):  # type: ignore[misc]
    """A mission whose vehicles are steered by actions.

    An observation is a vector: for each vehicle, in order, its observations; an action the same
    with its actuators. A vehicle that is steered has no helm: helm = "none" in the mission file, or
    overrides={"vehicle.alpha.helm": "none"}.

    Attributes:
        sim: The shoal.Simulation of this episode; None before the first reset.
        names: What each element of an observation is, such as "alpha.x_m".
    """

    metadata: dict[str, Any] = {"render_modes": []}
    render_mode = None

    def __init__(
        self,
        mission: str | os.PathLike[str],
        *,
        vehicles: Iterable[str] | None = None,
        observations: Iterable[str] = ("x_m", "y_m", "heading_deg", "speed_mps"),
        actions: Iterable[str] = ("thrust_pct", "rudder_deg"),
        steps: int = 10,
        reward: Callable[[ShoalEnv], float] | None = None,
        terminated: Callable[[ShoalEnv], bool] | None = None,
        overrides: Mapping[str, object] | Iterable[str] = (),
        watch: Iterable[str] = (),
    ) -> None:
        """Opens the mission once, to see that it is right.

        Args:
            mission: The mission file.
            vehicles: Those that are observed and steered; all by default.
            observations: Members of NAV, of each vehicle.
            actions: Members of ACTUATORS, of each vehicle.
            steps: Steps of the mission for one of the environment.
            reward: Given the environment after a step; 0 by default.
            terminated: Whether the episode has reached its end; never by default.
            overrides: As shoal.Simulation takes them.
            watch: Further channels, for `reward` and `terminated`: env.sim.message(channel).

        Raises:
            KeyError: a vehicle, an actuator or a member of NAV that is not there.
            ValueError: `steps` below 1, or a vehicle to be steered that has a helm.
            SimulationError: what is wrong with the mission file.
        """
        if isinstance(vehicles, str):
            vehicles = (vehicles,)
        if steps < 1:
            raise ValueError(f"steps is {steps}; it must be 1 or more")
        self._mission = mission
        self._overrides = overrides if isinstance(overrides, Mapping) else tuple(overrides)
        self._watch = tuple(watch)
        self._steps = steps
        self._reward = reward
        self._terminated = terminated
        self._seeds = random.Random(0)
        self.sim: Simulation | None = None
        actions, observations = tuple(actions), tuple(observations)
        if unknown := [each for each in actions if each not in ACTUATOR_LIMITS]:
            known = ", ".join(ACTUATOR_LIMITS)
            raise KeyError(f"'{unknown[0]}' is not an actuator; these are: {known}")
        with self._open(None) as sim:
            self.vehicles = list(sim.vehicles if vehicles is None else vehicles)
            for name in self.vehicles:
                sim[name]  # Raises KeyError where there is no such vehicle.
            if actions:
                self._refuse_helms(sim)
            self.names = [f"{name}.{each}" for name in self.vehicles for each in observations]
            sim.observer(self.names)  # Raises KeyError for a name that is not there.
        self._actuators = [f"{name}.{each}" for name in self.vehicles for each in actions]
        self.action_space = box_of_actions([each for _ in self.vehicles for each in actions])
        self.observation_space = box_of_observations(len(self.names))

    def _refuse_helms(self, sim: Simulation) -> None:
        """A helm sets its vehicle's actuators in each step, and would undo every action."""
        states = {name: f"HELM_STATE_{name.upper()}" for name in self.vehicles}
        for channel in states.values():
            sim.watch(channel)
        sim.step(2)  # What a helm publishes in the first step is read in the second.
        steered = [name for name, channel in states.items() if sim.data(channel) is not None]
        if steered:
            remedy = ", ".join(f'"vehicle.{name}.helm": "none"' for name in steered)
            raise ValueError(
                f"actions would be without effect on {', '.join(steered)}, steered by a helm; take "
                f'the helm out with overrides={{{remedy}}}, or helm = "none" in the mission file'
            )

    def _open(self, seed: int | None) -> Simulation:
        return Simulation(self._mission, overrides=self._overrides, seed=seed, watch=self._watch)

    def reset(
        self, *, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[Vector, dict[str, Any]]:
        """Begins an episode.

        Args:
            seed: The mission's seed, and that of the seeds of the episodes after it, until the next
                one given. By default they are drawn, the same ones in each process.
            options: Not used.
        """
        if gymnasium is not None:
            super().reset(seed=seed)
        if seed is not None:
            self._seeds = random.Random(seed)
        self.close()
        self.sim = self._open(self._seeds.getrandbits(32) if seed is None else seed)
        self._observe = self.sim.observer(self.names)
        self.sim.step(2)  # What vehicles publish in the first step is read in the second.
        return self._observation(), self._info()

    def step(self, action: Any) -> tuple[Vector, float, bool, bool, dict[str, Any]]:
        """Steers with this action for `steps` steps.

        Returns:
            The observation; the reward; whether the episode has reached its end; whether the
            mission has ended before that; and {"utime": ..., "passed": ...}.
        """
        if self.sim is None:
            raise RuntimeError("call reset() before step()")
        self.sim.act(dict(zip(self._actuators, self._checked(action), strict=True)))
        truncated = self.sim.step(self._steps) < self._steps
        reward = 0.0 if self._reward is None else float(self._reward(self))
        terminated = self._terminated is not None and bool(self._terminated(self))
        return self._observation(), reward, terminated, truncated, self._info()

    def _checked(self, action: Any) -> list[float]:
        try:
            values = list(action)
        except TypeError:
            values = [action]
        if len(values) != len(self._actuators):
            raise ValueError(
                f"the action has {len(values)} numbers; it needs {len(self._actuators)}: "
                f"{', '.join(self._actuators)}"
            )
        return values

    def _observation(self) -> Vector:
        return _numbers(self._observe())

    def _info(self) -> dict[str, Any]:
        assert self.sim is not None
        return {"utime": self.sim.utime, "passed": self.sim.passed}

    def value(self, name: str) -> float:
        """Returns one value by name, such as "alpha.x_m", for `reward` and `terminated`."""
        if self.sim is None:
            raise RuntimeError("call reset() before value()")
        return float(self.sim.observe(name)[0])

    def render(self) -> None:
        """Shows nothing: `shoal view` shows a log."""

    def close(self) -> None:
        """Ends the episode."""
        if self.sim is not None:
            self.sim.close()
        self.sim = None
