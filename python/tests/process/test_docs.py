"""The examples of docs/extending/python.md, as they stand there."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT

import shoal
from shoal.gym import ShoalEnv

PORT = 29_980


def _examples() -> list[str]:
    page = (ROOT / "docs/extending/python.md").read_text()
    return re.findall(r"```python\n(.*?)```", page, re.DOTALL)


def _is_simulated(example: str) -> bool:
    """True for examples of missions in the process itself, which load libshoal_sim.so.0."""
    return "shoal.Simulation(" in example or "Env(" in example


def test_the_examples_of_the_page_run_in_order(
    shoal_program: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    subprocess.run(
        [str(shoal_program), "run", str(ROOT / "missions/berta.toml"), "--warp", "max"]
        + ["--record", "runs/mine", "--port", str(PORT)],
        env={**os.environ, "SHOAL_RUN_DIR": str(tmp_path / "run")},
        check=True,
        stdout=subprocess.DEVNULL,
    )
    examples = [each for each in _examples() if not _is_simulated(each)]
    assert len(examples) == 6
    names: dict[str, object] = {}
    for example in examples:
        exec(example, names)
    shown = capsys.readouterr().out
    assert shown.startswith("['alpha', 'bravo'] ")
    assert "report alpha bravo 1199 756 {'out_of_range': 443}" in shown
    assert "True ['every vehicle within 20 m of its return point" in shown
    assert "[10.0, 20.0]" in shown
    assert "NAV_TEST nav_t(utime=0, x_m=3" in shown


def test_its_planner_does_what_the_page_states(shoal_program: Path, tmp_path: Path) -> None:
    page = (ROOT / "docs/extending/python.md").read_text()
    (example,) = re.findall(r"```text\n(me = .*?)```", page, re.DOTALL)
    program = tmp_path / "page.py"
    program.write_text(
        "#!/usr/bin/env python3\nimport sys\n"
        f"sys.path.insert(0, {str(ROOT / 'python')!r})\nimport shoal\n{example}"
    )
    program.chmod(0o755)
    mission = tmp_path / "page.toml"
    mission.write_text(
        '[mission]\nduration_s = 10\n[[vehicle]]\nname = "alpha"\nhelm = "none"\n'
        f'[[participant]]\nname = "page"\ncommand = ["{program}"]\n'
    )
    done = subprocess.run(
        [shoal_program, "run", mission, "--warp", "max", "--port", str(PORT + 10)],
        env={**os.environ, "SHOAL_RUN_DIR": str(tmp_path / "run")},
        stdout=subprocess.PIPE,
        text=True,
    )
    assert done.returncode == 0 and "Reproducible: yes" in done.stdout, done.stdout


def test_missions_in_the_process_run_as_the_page_states(
    simulation_library: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    pytest.importorskip("numpy")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "missions").symlink_to(ROOT / "missions")
    (tmp_path / "mission.toml").write_text(
        '[mission]\nduration_s = 10\n[[vehicle]]\nname = "alpha"\nhelm = "none"\n'
    )
    in_process = (each for each in _examples() if _is_simulated(each))
    simulation, environment, parallel, vector = in_process
    names: dict[str, object] = {"shoal": shoal}
    exec(simulation, names)
    shown = capsys.readouterr().out.splitlines()
    assert shown[0].startswith("0.9 "), shown[0]  # Steps 0 to 9.
    assert any(line.startswith("True ") for line in shown), shown[-20:]
    exec(environment, names)
    assert names["observation"].shape == (3,)  # type: ignore[attr-defined]
    assert names["truncated"] is False
    environment_made = names["env"]
    assert isinstance(environment_made, ShoalEnv)
    assert environment_made.sim is not None
    assert environment_made.sim.step_number > 10
    environment_made.close()
    exec(parallel, names)
    assert list(names["truncations"].values()) == [True]  # type: ignore[attr-defined]
    exec(vector, names)
    assert names["rewards"].shape == (4,)  # type: ignore[attr-defined]
