"""Whether the ends of the ranges of versions that bytes depend on make the bytes of generated/.

    python -m benchmarks.version_ends [--arms NAME ...]

Every package that makes bytes is installed at the first and the last version of its range in
pyproject.toml, each into a folder of its own that goes before everything else on the path, and
`dhgen --check` compares what the compiler makes then. It takes a package index, and a minute for
each of four versions. Exits with 1 where bytes differ.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

from benchmarks.arms import CHECKOUT
from benchmarks.options import robot_names
from benchmarks.report import table

MAKERS = ("sympy", "jinja2")
ARMS = (  # a closed form, a quartic, five joints, general 6R, given joints, the nearest arm
    "scara",
    "puma560",
    "concurrent_345",
    "phantomx",
    "general_6r",
    "kuka_iiwa14",
    "kuka_kr6_r900_calibrated",
)


def ends(package: str) -> tuple[str, str]:
    """What pip is asked for to have the first and the last version of a package's range."""
    project = tomllib.loads((CHECKOUT / "pyproject.toml").read_text("utf-8"))["project"]
    wanted: str = next(each for each in project["dependencies"] if each.startswith(f"{package}>="))
    first = wanted.removeprefix(f"{package}>=").split(",")[0]
    return f"{package}=={first}", wanted


def compared(requirement: str, folder: Path, names: list[str]) -> tuple[str, bool, str]:
    """The version that came, whether bytes are those of generated/, and what was said.

    Args:
        requirement: What pip is asked for.
        folder: Where it is installed.
        names: Robots.
    """
    install = ["install", "--quiet", "--no-deps", "--target", str(folder), requirement]
    subprocess.run([sys.executable, "-m", "pip", *install], check=True)
    version = next(folder.glob("*.dist-info")).name.removesuffix(".dist-info")
    files = [f"robots/{name}.yaml" for name in names]
    path = os.pathsep.join([str(folder), str(CHECKOUT)])
    done = subprocess.run(
        [sys.executable, "-m", "dhgen", "--check", *files],
        cwd=CHECKOUT,
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=False,
    )
    return version, done.returncode == 0, done.stdout + done.stderr


def main() -> int:
    """Prints a line for every version; 1 where bytes differ."""
    options = argparse.ArgumentParser(
        prog="python -m benchmarks.version_ends",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    options.add_argument(
        "--arms", nargs="+", choices=robot_names(), default=list(ARMS), metavar="NAME"
    )
    names = options.parse_args().arms
    rows: list[list[str]] = []
    said: list[str] = []
    for requirement in (each for package in MAKERS for each in ends(package)):
        with tempfile.TemporaryDirectory(prefix="dhgen-ends-") as folder:
            version, is_same, text = compared(requirement, Path(folder), names)
        rows.append([version, str(len(names)), "the same" if is_same else "differ"])
        said += [] if is_same else [f"{version}: {text}"]
    print("\n".join([table(["version", "robots", "bytes"], rows), *said]))
    return 1 if said else 0


if __name__ == "__main__":
    raise SystemExit(main())
