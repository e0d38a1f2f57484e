"""The package as a whole: its types, and what it imports."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
from conftest import ROOT

PACKAGE = ROOT / "python/shoal"


def test_all_of_it_is_typed() -> None:
    if subprocess.run([sys.executable, "-m", "mypy", "--version"], capture_output=True).returncode:
        pytest.skip("mypy is not installed; scripts/setup --with-tests installs it")
    tests = ROOT / "python/tests"
    shown = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--cache-dir=/dev/null"]
        + ["--explicit-package-bases", PACKAGE, tests, ROOT / "python/setup.py"],
        env={**os.environ, "MYPYPATH": f"{tests}:{tests / 'unit'}"},
        cwd=ROOT / "python",
        stdout=subprocess.PIPE,
        text=True,
    )
    assert shown.returncode == 0, shown.stdout


def test_it_works_without_numpy() -> None:
    code = "import sys; sys.modules['numpy'] = None; import shoal; print(shoal.types.nav_t().x_m)"
    shown = subprocess.run(
        [sys.executable, "-c", code], cwd=PACKAGE.parent, check=True, stdout=subprocess.PIPE
    )
    assert shown.stdout == b"0.0\n"


def test_lines_and_files_are_not_too_long() -> None:
    for path in [*PACKAGE.rglob("*.py"), *(ROOT / "python/tests").rglob("*.py")]:
        lines = path.read_text().splitlines()
        assert len(lines) <= 450, path
        assert [line for line in lines if len(line) > 100] == [], path
