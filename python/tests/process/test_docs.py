"""The examples of docs/python.md, as they stand there."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT

PORT = 29_980


def test_the_examples_of_the_page_run_in_order(
    shoal_program: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    subprocess.run(
        [shoal_program, "run", ROOT / "missions/berta.toml", "--warp", "max"]
        + ["--record", "runs/mine", "--port", str(PORT)],
        env={**os.environ, "SHOAL_RUN_DIR": str(tmp_path / "run")},
        check=True,
        stdout=subprocess.DEVNULL,
    )
    page = (ROOT / "docs/python.md").read_text()
    examples = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
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
    page = (ROOT / "docs/python.md").read_text()
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
