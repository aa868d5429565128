"""A Cortex-M board: solvers compiled for it, and run in QEMU."""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray


HERE = Path(__file__).parent
COMPILER = "arm-none-eabi-gcc"
EMULATOR = "qemu-system-arm"
MISSING = [tool for tool in (COMPILER, EMULATOR) if shutil.which(tool) is None]
SECONDS = 120


@dataclass(frozen=True)
class Board:
    """A board that QEMU knows.

    Attributes:
        machine: QEMU's name.
        flags: What its processor is to the compiler.
    """

    machine: str
    flags: tuple[str, ...]


CORTEX_M4 = Board(  # its floating-point unit knows single precision only
    "mps2-an386", ("-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16")
)
CORTEX_M7 = Board(
    "mps2-an500", ("-mcpu=cortex-m7", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv5-d16")
)


@dataclass(frozen=True)
class Answer:
    """What a solver on the board says to one pose.

    Attributes:
        count: What _ik returned.
        status: (B,).
        q: (B, n).
        nearest: (n,).
        T: The pose of the generating joint values by _fk, (4, 4).
    """

    count: int
    status: NDArray[np.uint8]
    q: FloatArray
    nearest: FloatArray
    T: FloatArray


def compiled(board: Board, source: Path, target: Path, *flags: str) -> Path:
    """An object of a C file; the solver's headers lie beside it."""
    command = [COMPILER, *board.flags, "-std=c99", "-Wall", "-Wextra", "-Werror", *flags]
    run = [*command, "-x", "c", "-c", str(source), "-o", str(target), f"-I{target.parent}"]
    subprocess.run(run, check=True, cwd=target.parent)
    return target


def answers(
    board: Board, solver: Path, rows: int, q: FloatArray, T: FloatArray, real: type
) -> list[Answer]:
    """What a solver says to poses (N, 4, 4) with the generating joint values (N, n) as seeds.

    Args:
        board: Where it runs.
        solver: Its C; the header lies beside it, and so will all that is made here.
        rows: Number of branches.
        q: The joint values.
        T: The poses.
        real: np.float32 or np.float64, as the solver has it.
    """
    folder, name = solver.parent, solver.stem
    word = "float" if real is np.float32 else "double"
    values = {"poses": T.reshape(len(T), 16), "joints": q}
    tables = [_table(name_, table.astype(real), word) for name_, table in values.items()]
    (folder / "poses.h").write_text("\n".join(tables), encoding="utf-8")
    sizes = {"NAME": name, "ROWS": rows, "DOF": q.shape[1], "POSES": len(T), "REAL": word}
    main = (HERE / "main.c.txt").read_text(encoding="utf-8").replace('"NAME.h"', f'"{name}.h"')
    (folder / "main.c").write_text(main, encoding="utf-8")
    define = [f"-D{key}={value}" for key, value in sizes.items()]
    objects = [
        compiled(board, solver, folder / "solver.o", "-O2"),
        compiled(board, folder / "main.c", folder / "main.o", "-O2", *define),
        compiled(board, HERE / "startup.c.txt", folder / "startup.o", "-O2"),
    ]
    script = HERE / "board.ld.txt"
    image = folder / "image.elf"
    link = [COMPILER, *board.flags, "-nostartfiles", "-T", str(script), *map(str, objects)]
    subprocess.run([*link, "-lm", "-o", str(image)], check=True)
    return _read(_run(board, image), rows, q.shape[1], real)


def _run(board: Board, image: Path) -> list[bytes]:
    command = [EMULATOR, "-M", board.machine, "-display", "none", "-monitor", "none"]
    semihosting = ["-semihosting-config", "enable=on,target=native", "-kernel", str(image)]
    done = subprocess.run(
        [*command, *semihosting], capture_output=True, text=True, timeout=SECONDS, check=False
    )
    lines = (done.stdout + done.stderr).split()
    assert done.returncode == 0, lines[-3:]
    return [bytes.fromhex(line) for line in lines]


def _read(lines: list[bytes], rows: int, dof: int, real: type) -> list[Answer]:
    size = rows + 5
    found = []
    for start in range(0, len(lines), size):
        count, status, *numbers = lines[start : start + size]
        values = [np.frombuffer(line, real).astype(np.float64) for line in numbers]
        table = np.array(values[:rows]).reshape(rows, dof)
        T = np.concatenate(values[rows + 1 :]).reshape(4, 4)
        answer = int.from_bytes(count, "little", signed=True)
        found.append(Answer(answer, np.frombuffer(status, np.uint8), table, values[rows], T))
    return found


def _table(name: str, values: NDArray[np.floating], word: str) -> str:
    end = "f" if word == "float" else ""
    lines = ["    { " + ", ".join(f"{v!s}{end}" for v in row) + " }," for row in values]
    head = f"static const {word} {name}[{len(values)}][{values.shape[1]}] = {{"
    return "\n".join([head, *lines, "};"])
