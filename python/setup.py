"""Takes the version and the message types from the checkout that this folder is in."""

import re
import shutil
from pathlib import Path

from setuptools import setup  # type: ignore[import]
from setuptools.command.build_py import build_py  # type: ignore[import]

ROOT = Path(__file__).resolve().parent.parent


class BuildWithTypes(build_py):  # type: ignore[misc]
    """Installs lcmtypes/*.lcm with the package."""

    def run(self) -> None:
        super().run()
        sources = sorted((ROOT / "lcmtypes").glob("*.lcm"))
        if not sources:
            raise SystemExit(f"no .lcm files in {ROOT / 'lcmtypes'}; install from a checkout of shoal")
        folder = Path(self.build_lib) / "shoal" / "lcmtypes"
        folder.mkdir(parents=True, exist_ok=True)
        for source in sources:
            shutil.copy2(source, folder)


def version() -> str:
    text = (ROOT / "CMakeLists.txt").read_text()
    found = re.search(r"project\(shoal VERSION ([\d.]+)", text)
    assert found, "CMakeLists.txt has no version"
    return found[1]


setup(version=version(), cmdclass={"build_py": BuildWithTypes})
