"""An arm that was loaded: what is there at once, and what a build makes of it."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np

from dhgen.errors import CommandError, DhgenError, VerificationError, about
from dhgen.library.documents import (
    Document,
    as_markdown,
    as_text,
    escaped,
    kind_line,
    parameters_line,
    table_rows,
)
from dhgen.library.progress import no_progress, show_progress
from dhgen.library.wording import note_for_python
from dhgen.robot.robot import JointKind
from dhgen.runtime.python.arguments import numbers

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike

    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation
    from dhgen.kinematics.numeric import NumericArm
    from dhgen.library.solver import Solver
    from dhgen.robot_files import RobotFile

_ENDLESS = (-math.inf, math.inf)


@dataclass(frozen=True, repr=False)
class Arm:
    """An arm, as `dhgen.load` gives it.

    Attributes:
        file: Its robot file, read.
        label: What messages call it: the path that was loaded, or the name of a dict's robot.
    """

    file: RobotFile
    label: str

    @property
    def name(self) -> str:
        """The robot's identifier."""
        return self.file.robot.name

    @property
    def text(self) -> str:
        """The robot file (YAML); of a description, the one that `dhgen import` writes."""
        return self.file.text

    @property
    def notes(self) -> tuple[str, ...]:
        """What was chosen, taken as exact, or looks like a slip."""
        return tuple(map(str, self.file.robot.notices))

    @property
    def dof(self) -> int:
        """The number of joints."""
        return len(self.file.robot.joints)

    @property
    def joint_types(self) -> str:
        """R or P for every joint."""
        turn = JointKind.REVOLUTE
        return "".join("R" if each.kind is turn else "P" for each in self.file.robot.joints)

    @property
    def joint_names(self) -> tuple[str, ...]:
        """What the joints are called: as in the robot file, or joint1, joint2 and so on."""
        joints = enumerate(self.file.robot.joints, 1)
        return tuple(joint.name or f"joint{number}" for number, joint in joints)

    @property
    def joint_limits(self) -> tuple[tuple[float, float], ...]:
        """Lowest and highest value of every joint, infinite without one."""
        return tuple(joint.limits or _ENDLESS for joint in self.file.robot.joints)

    @property
    def free(self) -> tuple[int, ...] | Literal["arm_angle"]:
        """The joints, from 1, whose values the caller gives; or "arm_angle", as `load` takes it."""
        return "arm_angle" if self.file.robot.arm_angle else self.file.robot.free

    def fk(self, q: ArrayLike) -> FloatArray:
        """The pose of the tool, (4, 4), of joint values (n,); or a stack of both."""
        return self._model.pose(self._joint_values(q))

    def jacobian(self, q: ArrayLike) -> FloatArray:
        """The geometric Jacobian (6, n): velocity of the tool's origin, then angular velocity."""
        return self._model.jacobian(self._joint_values(q))

    def frames(self, q: ArrayLike) -> FloatArray:
        """Where the base, the link of every row and the tool are, (n + 2, 4, 4), or a stack.

        Those of the links are the table's own, with a further one for each passive row; of an arm
        given by axes they are at the axes' points, parallel to the base's frame at q = 0.
        """
        return self._frames(self._joint_values(q))

    def derivation(self, language: Literal["en", "fr"] = "en") -> Document:
        """The derivation of the inverse kinematics, in Markdown, with its figures.

        Args:
            language: English, or French with decimal commas.

        Raises:
            ValueError: There is no derivation in that language.
            UnsolvedError: No derivation solves the arm; the message names the reason.
            PrecisionError: The robot file asks for single precision, which this arm can't have.
        """
        from dhgen.library.kept import folder_of, is_whole  # noqa: PLC0415

        if language == "fr":
            return self._in_french()
        if language != "en":
            raise ValueError(f"language is 'en' or 'fr', not {language!r}")
        folder, name = folder_of(self.file), f"{self.name}.md"
        if is_whole(folder):
            paths = (path.relative_to(folder).as_posix() for path in folder.rglob("*.svg"))
            figures = {path: (folder / path).read_text("utf-8") for path in sorted(paths)}
            return Document((folder / name).read_text("utf-8"), figures)
        files = self._compilation.files
        return Document(files[name], {p: files[p] for p in sorted(files) if p.endswith(".svg")})

    def _in_french(self) -> Document:
        from dhgen.compiler import source_name  # noqa: PLC0415
        from dhgen.derivation import derivation_files  # noqa: PLC0415
        from dhgen.derivation.languages import language_of  # noqa: PLC0415

        made, path = self._compilation, self.file.path
        language = language_of("fr")
        figures = derivation_files(made.story, source_name(path, path.parent), language)
        for sentence in language.untranslated:
            warnings.warn(f"no French for this sentence: {sentence}", stacklevel=3)
        return Document(figures.pop(f"{self.name}.md"), figures)

    def build(
        self, *, progress: Callable[[str], None] | None = show_progress, native: bool = True
    ) -> Solver:
        """The solver: derived, verified and kept, or the one that was kept before.

        That takes 10 to 90 s the first time, and a second from then on, also in other processes:
        solvers are kept in $DHGEN_CACHE_DIR, or dhgen/ in the user's cache folder, by their
        content. Another version of dhgen builds anew.

        Args:
            progress: Called with what is being done; by default it is written to stderr, where a
                person waits there. None for nobody.
            native: Whether C solves where there is a C compiler, which takes no time to warm up;
                else it is Python, with numba.

        Raises:
            CommandError: progress is no function, or native neither True nor False.
            UnsolvedError: No derivation solves the arm; the message names the reason.
            PrecisionError: The robot file asks for single precision, which this arm can't have.
            VerificationError: The solver does not do what it promises: a bug in dhgen.
            CompilerError: The C compiler can't build anything.
            OSError: The cache folder can't be written to.
        """
        from dhgen.library.kept import folder_of, is_whole  # noqa: PLC0415
        from dhgen.library.solver import Solver  # noqa: PLC0415

        if progress is not None and not callable(progress):
            raise CommandError(f"progress takes a function of a text, or None, not {progress!r}")
        if not isinstance(native, (bool, np.bool_)):
            raise CommandError(f"native is True or False, not {native!r}")
        folder = folder_of(self.file)
        if not is_whole(folder):
            self._build(folder, progress or no_progress)
        return Solver(self, folder, in_c=bool(native))

    def _build(self, folder: Path, progress: Callable[[str], None]) -> None:
        from dhgen.compiler import verified  # noqa: PLC0415
        from dhgen.library.kept import keep, room_for  # noqa: PLC0415
        from dhgen.verify.compiled import keep_compiled  # noqa: PLC0415

        room_for(folder).cleanup()  # nobody waits a minute to learn that nothing can be kept
        progress(f"building the solver of {self.name}, once; deriving")
        compilation = self._compilation
        try:
            report = verified(compilation, progress)
        except VerificationError as error:
            for doubt in self.file.robot.doubts:
                error.add_note(f"note: {doubt}")
            raise
        keep(folder, compilation.files)
        for name, code in report.code.items():
            keep_compiled(code, folder / f"{name}.py")

    @cached_property
    def _model(self) -> NumericArm:
        from dhgen.kinematics.build import build_chain  # noqa: PLC0415
        from dhgen.kinematics.numeric import numeric_arm  # noqa: PLC0415

        return numeric_arm(build_chain(self.file.robot))

    @cached_property
    def _frames(self) -> Callable[[FloatArray], FloatArray]:
        from dhgen.kinematics.link_table import link_table  # noqa: PLC0415
        from dhgen.runtime.python.frames import frames_of  # noqa: PLC0415

        table = link_table(self.file.robot)
        return frames_of(
            types=table.types,
            table=table.rows,
            convention=table.convention,
            drives=table.drives,
            base=table.base,
            tool=table.tool,
        )

    @cached_property
    def _compilation(self) -> Compilation:
        from dhgen.compiler import compile_loaded  # noqa: PLC0415

        path = self.file.path  # files call it by its name alone: the folder is the cache's affair
        try:
            with about(Path(self.label)):
                return compile_loaded(self.file, out=path.parent)
        except DhgenError as error:
            for note in self.notes:
                error.add_note(f"note: {note}")
            note_for_python(error, repr(self.label) if str(path) == self.label else "...")
            raise

    def _joint_values(self, q: ArrayLike) -> FloatArray:
        values = numbers(q, (self.dof,), "q")
        if values.shape[-1:] != (self.dof,):
            n = self.dof
            wanted = f"q must hold {n} joint values, with shape ({n},) or (..., {n})"
            raise ValueError(f"{wanted}, not {values.shape}")
        return values

    def __reduce__(self) -> tuple[type[Arm], tuple[RobotFile, str]]:
        return Arm, (self.file, self.label)

    def __repr__(self) -> str:
        return f"<dhgen.Arm {self.name}: {kind_line(self.file.robot)}>"

    def __str__(self) -> str:
        robot = self.file.robot
        head = f"{self.name}: {kind_line(robot)}"
        remarks = [f"note: {note}" for note in self.notes]
        beside = [robot.source, parameters_line(robot), *remarks]
        return "\n".join([head, *as_text(table_rows(robot)), *filter(None, beside)])

    def _repr_markdown_(self) -> str:
        """The table, the lengths in it and the tool's pose at zero, as a notebook shows it."""
        from dhgen.derivation import tool_at_zero  # noqa: PLC0415

        robot = self.file.robot
        head = f"**{escaped(robot.title)}**: {escaped(kind_line(robot))}"
        remarks = [f"note: {note}" for note in self.notes]
        at_zero = tool_at_zero(self._model.chain, robot.length_unit)
        beside = filter(None, [robot.source, parameters_line(robot), at_zero, *remarks])
        return "\n\n".join([head, as_markdown(table_rows(robot)), *map(escaped, beside)])
