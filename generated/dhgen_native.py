# SPDX-License-Identifier: MIT
"""The solvers' C behind the functions of their Python: compiled on demand, and kept.

Part of dhgen, which puts a copy of this file beside the robots that it generates.

    import dhgen_native, scara
    robot = dhgen_native.native(scara)  # scara.c and scara.h are next to scara.py
    q, status = robot.ik_all(T)

What comes back is a module like the one given, with the same functions, constants and errors; only
the solving is done in C. It and its functions can be pickled, as multiprocessing does: by how they
were asked for.

On CPython for Linux its functions are Python's own kind of C: a call takes a fifth of a microsecond
besides the solving, and functions of numba can call `ik_into`, with contiguous arrays. Elsewhere,
and in builds of Python without a global lock, calls go through ctypes.

Libraries are kept in $DHGEN_CACHE_DIR, or dhgen/ in the user's cache folder, under the digest of
their source, the compiler, its flags and the processor, and that of their own bytes: one that is
damaged is built again. Any number of processes may build at once.
"""

from __future__ import annotations

import ctypes
import hashlib
import importlib.util
import inspect
import math
import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from contextlib import suppress
from functools import cache, update_wrapper
from pathlib import Path
from types import MethodType, ModuleType
from typing import TYPE_CHECKING

import numpy as np

TypingError: Any
overload: Any = None
register_jitable: Any = lambda function: function  # noqa: E731
with suppress(ImportError):
    from numba.core.errors import TypingError
    from numba.extending import overload, register_jitable

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Function = Callable[..., Any]

FLAGS = tuple(
    shlex.split("-std=c99 -O2 -march=native -fno-math-errno -fno-trapping-math -ffp-contract=fast")
)
# With these flags NaN is lost, which marks rows without a solution.
FORGET_NAN = frozenset({"-ffast-math", "-ffinite-math-only", "-Ofast"})
FLAGS_APART = "its options belong in flags"
WRITABLE = "set DHGEN_CACHE_DIR to a writable folder"
# Where a library may be part of Python: elsewhere it is linked, or objects begin, in another way.
EXTENDS = (
    sys.implementation.name == "cpython"
    and sys.version_info >= (3, 11)
    and sys.platform.startswith("linux")
    and not sysconfig.get_config_var("Py_GIL_DISABLED")
)
FAST_CALL = 0x0080 | 0x0002  # of functions that take an array of arguments, and names


class NoCompiler(RuntimeError):  # noqa: N818
    """There is no C compiler."""


class BuildError(RuntimeError):
    """The compiler rejects the source or its flags; the message is its output."""


def native(
    module: ModuleType, *, compiler: str | None = None, flags: str | Sequence[str] = FLAGS
) -> ModuleType:
    """A robot's module whose solving is done in C.

    Args:
        module: The robot's Python; its C and header are looked for in the same folder.
        compiler: A C compiler that takes the flags of gcc: a name or a path. By default the first
            of $CC, cc, gcc and clang that exists.
        flags: For the compiler, in place of FLAGS: strings, or one that is split as by a shell.

    Raises:
        TypeError: An argument is not a robot's module, a compiler's name or flags.
        NoCompiler: No C compiler was found.
        BuildError: The compiler rejects the source or its flags.
        ValueError: With these flags NaN would mean nothing.
        FileNotFoundError: The C or its header is missing.
        OSError: The folder for libraries can't be written to.
    """
    if hasattr(module, "calibrated"):
        why = f"native takes the module of one arm: the table of {module.NAME} comes at run time"
        raise TypeError(f"{why}; solve in numba by {module.NAME}.calibrated(table), or call its C")
    if hasattr(module, "LEGS"):
        problem = f"native takes the module of a serial arm, and {module.NAME} stands on legs"
        raise TypeError(f"{problem}; call its C, or solve its legs: native({module.CHAINS[0]})")
    is_module = hasattr(module, "ik_all") and hasattr(module, "__file__")  # no arm of a fleet
    if not is_module:
        wanted = "a robot's module, as in 'import scara; dhgen_native.native(scara)'"
        raise TypeError(f"native takes {wanted}, not {module!r}")
    path = Path(str(module.__file__))
    for source in (path.with_suffix(".c"), path.with_suffix(".h")):
        if not source.exists():
            raise FileNotFoundError(f"{source} not found: native needs it next to {path.name}")
    words = shlex.split(flags) if isinstance(flags, str) else flags
    if not isinstance(words, (list, tuple)) or not all(isinstance(word, str) for word in words):
        raise TypeError(f"flags must be a list of strings, or one string, not {flags!r}")
    if wrong := FORGET_NAN.intersection(words):
        refused = " or ".join(sorted(wrong))
        raise ValueError(f"flags must not include {refused}: NaN marks rows without a solution")
    library = _build(module, path.with_suffix(".c"), _compiler(compiler), words)
    # The same text once more: its functions find those of the C where those of numba were.
    spec = importlib.util.spec_from_file_location(module.__name__, path)
    if spec is None or spec.loader is None:
        raise FileNotFoundError(path)
    robot = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(robot)
    vars(robot).update(_asked=(module.__name__, compiler, tuple(words)))
    robot.__class__ = _Robot
    solver = _Solver(robot, ctypes.CDLL(str(library)))
    for name in ("ik_all", "ik", "ik_batch", *(() if EXTENDS else ("ik_into",))):
        setattr(robot, name, _function_of(robot, name))
    vars(robot).update(solver.names(), Unreachable=module.Unreachable)
    vars(robot)["_CALLS"].update(solver.calls(), choice=vars(module)["_CALLS"]["choice"])
    return robot


class _Robot(ModuleType):
    """A module that is pickled by how it was asked for."""

    def __reduce__(self) -> tuple[Callable[..., ModuleType], tuple[Any, ...]]:
        return _again, vars(self)["_asked"]


@cache
def _again(name: str, compiler: str | None, flags: tuple[str, ...]) -> ModuleType:
    """What another process asked for, made once."""
    return native(importlib.import_module(name), compiler=compiler, flags=flags)


def _function_of(robot: ModuleType, name: str) -> MethodType:
    """A function of the robot's, pickled as its: by itself the module's own would be looked up."""
    function = getattr(robot, name)

    def call(_: ModuleType, /, *arguments: Any, **named: Any) -> Any:  # noqa: ANN401
        return function(*arguments, **named)

    update_wrapper(call, function)
    signature = inspect.signature(function)
    itself = inspect.Parameter("robot", inspect.Parameter.POSITIONAL_ONLY)
    taken = signature.replace(parameters=[itself, *signature.parameters.values()])
    vars(call).update(__signature__=taken)
    return MethodType(call, robot)


class _Solver:
    """The functions of a library, called like the functions of the Python module."""

    def __init__(self, robot: ModuleType, library: ctypes.CDLL) -> None:
        self._robot, self._library = robot, library
        self._called: dict[str, Any] = vars(robot)["_CALLS"]
        self._dof, self._rows = robot.DOF, robot.MAX_SOLUTIONS
        self._given = _given(robot)
        self._takes = inspect.signature(robot.ik_into)
        self._fk, self._jacobian = self._function("fk", 2), self._function("jacobian", 2)
        self._ik = self._function("ik", 5 if self._given else 4, ctypes.c_int)
        self._ik_batch = self._function("ik_batch", 5 if self._given else 4)
        self._fk_into, self._jacobian_into = self.any_fk, self.any_jacobian
        if EXTENDS:
            self._fk_into = _extension(self, library, "fk", "")
            self._jacobian_into = _extension(self, library, "jacobian", "")
            *names, seed = self._takes.parameters
            shown = f"ik_into({', '.join(names)}, {seed}=None)"
            text = f"{shown}\n--\n\n{robot.ik_into.__doc__ or ''}"
            self.ik_into = _extension(self, library, "ik_into", text)
            _show_numba(self.ik_into, robot, library)

    def __reduce__(self) -> tuple[Function, tuple[ModuleType, str]]:
        return getattr, (self._robot, "_solver")

    def _function(self, end: str, arguments: int, result: Any = None) -> Function:  # noqa: ANN401
        function = self._library[f"{self._robot.NAME}_{end}"]
        function.argtypes, function.restype = (ctypes.c_void_p,) * arguments, result
        return function

    def names(self) -> dict[str, Any]:
        """The functions of Python that replace the module's."""
        names = ["fk", "jacobian", "joint_velocities", "warm_up"]
        names += ["ik_into"] if EXTENDS else []
        names += ["arm_angle"] if hasattr(self._robot, "arm_angle") else []
        return {"_solver": self, **{name: getattr(self, name) for name in names}}

    def calls(self) -> dict[str, Any]:
        """What the public functions call in place of compiled Python."""
        return {
            "unseeded": self.ik_into if EXTENDS else lambda *each: self.into(*each, None),
            "seeded": self.ik_into if EXTENDS else self.into,
            "look_at": lambda *_: None,  # other types of numbers are converted
            "many": self.batch,
        }

    def fk(self, q: Any) -> Array:  # noqa: ANN401
        """The pose (4, 4) of joint values (n,), or of each in a stack of them."""
        return self._fk_into(q, np.empty((4, 4)))

    def jacobian(self, q: Any) -> Array:  # noqa: ANN401
        """The geometric Jacobian (6, n): velocity of the tool's origin, then angular velocity.

        Of a stack of joint values it is a stack.
        """
        return self._jacobian_into(q, np.empty((6, self._dof)))

    def joint_velocities(self, q: Any, twist: Any) -> Array:  # noqa: ANN401
        """The joint velocities (n,) of a twist (6,) at joint values (n,)."""
        given, joints = self._array(twist, 6, "twist"), self._array(q, self._dof, "q")
        found = np.empty(self._dof)
        velocities = self._function("joint_velocities", 3)
        velocities(joints.ctypes.data, given.ctypes.data, found.ctypes.data)
        return found

    def arm_angle(self, q: Any) -> Any:  # noqa: ANN401
        """The arm angle of joint values (n,), in (-pi, pi], or of each in a stack of them."""
        angle = self._function("arm_angle", 1, ctypes.c_double)
        return self._called["of_each"](lambda each: angle(each.ctypes.data), q, self._dof)

    def any_fk(self, q: Any, T: Array) -> Array:  # noqa: ANN401
        """The pose of joint values of any type, or the poses of a stack."""
        return self._of_each(self._fk, q, T.shape)

    def any_jacobian(self, q: Any, J: Array) -> Array:  # noqa: ANN401
        """The Jacobian of joint values of any type, or the Jacobians of a stack."""
        return self._of_each(self._jacobian, q, J.shape)

    def _of_each(self, function: Function, q: Any, shape: tuple[int, ...]) -> Array:  # noqa: ANN401
        def made(values: Array) -> Array:
            result = np.empty(shape)
            function(values.ctypes.data, result.ctypes.data)
            return result

        return np.asarray(self._called["of_each"](made, q, self._dof))

    def any_into(self, *arguments: Any, **named: Any) -> int:  # noqa: ANN401
        """All solutions into arrays of any type, or what is wrong with them."""
        taken = self._takes.bind(*arguments, **named)
        taken.apply_defaults()
        return self.into(*taken.args)

    def into(self, *arguments: Any) -> int:  # noqa: ANN401
        """All solutions into arrays: T, what is given, q, status, and a seed or None."""
        *inputs, q, status, seed = arguments
        shapes = [(4, 4), (self._given,)] if self._given else [(4, 4)]
        arrays = [np.ascontiguousarray(each, np.float64) for each in inputs]
        rows = (self._rows, self._dof), (self._rows,)
        filled = tuple(getattr(each, "shape", None) for each in (q, status))
        if [each.shape for each in arrays] != shapes or filled != rows:
            wanted = ", ".join(map(str, (*shapes, *rows)))
            first = "T, q_free" if self._given else "T"
            raise ValueError(f"{first}, q and status must have shapes {wanted}")
        if q.dtype.kind != "f" or status.dtype.kind not in "iuf":
            raise ValueError("q must hold floats, status whole numbers or floats")
        values = None if seed is None else self._seed(seed)
        results = _place(q, np.float64), _place(status, np.uint8)
        count = self._ik(
            *(each.ctypes.data for each in arrays),
            None if values is None else values.ctypes.data,
            *(each.ctypes.data for each in results),
        )
        for to, result in zip((q, status), results, strict=True):
            if to is not result:
                to[...] = result
        return max(int(count), 0)

    def batch(self, *arrays: NDArray[Any]) -> None:
        """All solutions of the poses T (N, 4, 4), with what is given, into q and status."""
        self._ik_batch(len(arrays[0]), *(each.ctypes.data for each in arrays))

    def warm_up(self) -> None:
        """Compiles what is left to numba: the choice of the nearest solution."""
        found = np.zeros((self._rows, self._dof)), np.zeros(self._rows, np.uint8)
        self._called["choice"].nearest(found, None, (0, self._rows), limits=True)

    def _array(self, values: Any, length: int, name: str) -> Array:  # noqa: ANN401
        return np.asarray(self._called["array_of"](values, (length,), name))

    def _seed(self, q_seed: Any) -> Array:  # noqa: ANN401
        values = self._array(q_seed, self._dof, "q_seed")
        if not np.isfinite(values).all():
            raise ValueError("q_seed must be finite")
        return values


def _given(robot: ModuleType) -> int:
    """How many values the caller gives besides the pose."""
    return 1 if hasattr(robot, "arm_angle") else len(getattr(robot, "FREE_JOINTS", ()))


def _place(array: NDArray[Any], kind: type) -> NDArray[Any]:
    """The caller's array where C may write into it, or one that is."""
    flags = array.flags
    if array.dtype == kind and flags.c_contiguous and flags.writeable and flags.aligned:
        return array
    return np.empty(array.shape, kind)


class _Method(ctypes.Structure):
    """Python's record of a function in C, its PyMethodDef."""

    _fields_ = (
        ("name", ctypes.c_char_p),
        ("function", ctypes.c_void_p),
        ("flags", ctypes.c_int),
        ("text", ctypes.c_char_p),
    )


# Functions of Python point there for as long as anybody has them.
_METHODS: dict[tuple[str, str, str], _Method] = {}
_new_function = ctypes.PYFUNCTYPE(
    ctypes.py_object, ctypes.POINTER(_Method), ctypes.py_object, ctypes.py_object
)(("PyCFunction_NewEx", ctypes.pythonapi))


def _extension(owner: _Solver, library: ctypes.CDLL, name: str, text: str) -> Function:
    """A function in dhgen_native.c as one of Python, with its docstring."""
    key = (library._name, name, text)  # noqa: SLF001  there is no other way to its path
    if key not in _METHODS:
        address = ctypes.cast(library[f"dhgen_native_{name}"], ctypes.c_void_p)
        _METHODS[key] = _Method(name.encode(), address, FAST_CALL, text.encode())
    function: Function = _new_function(_METHODS[key], owner, __name__)
    return function


def _show_numba(ik_into: Callable[..., int], robot: ModuleType, library: ctypes.CDLL) -> None:
    """Lets functions of numba call `ik_into`: by address, which it keeps in no cache."""
    if overload is None:
        return
    given, dof, rows = _given(robot), robot.DOF, robot.MAX_SOLUTIONS
    inputs, results = [ctypes.c_void_p] * (2 if given else 1), [ctypes.c_void_p] * 2
    takes = ctypes.CFUNCTYPE(ctypes.c_int, *inputs, ctypes.c_size_t, *results)
    ik = takes((f"{robot.NAME}_ik", library))

    def solve(T: Any, q: Any, status: Any, q_seed: Any = None) -> Any:  # noqa: ANN401
        _demand_shapes(T, q, status, rows, dof)
        return max(ik(T.ctypes, _address(q_seed, dof), q.ctypes, status.ctypes), 0)

    def solve_given(T: Any, q_free: Any, q: Any, status: Any, q_seed: Any = None) -> Any:  # noqa: ANN401
        _demand_shapes(T, q, status, rows, dof)
        if q_free.shape != (given,):
            raise ValueError("q_free has another number of values")
        seed = _address(q_seed, dof)
        return max(ik(T.ctypes, q_free.ctypes, seed, q.ctypes, status.ctypes), 0)

    def typed(T: Any, q: Any, status: Any, q_seed: Any = None) -> Any:  # noqa: ANN401
        _demand_types(T, q, status, q_seed)
        return solve

    def typed_given(T: Any, q_free: Any, q: Any, status: Any, q_seed: Any = None) -> Any:  # noqa: ANN401
        _demand_types(T, q, status, q_seed)
        _demand_type("q_free", q_free, "float64", 1)
        return solve_given

    overload(ik_into)(typed_given if given else typed)


@register_jitable  # type: ignore[untyped-decorator]
def _demand_shapes(T: Any, q: Any, status: Any, rows: int, dof: int) -> None:  # noqa: ANN401
    if T.shape != (4, 4) or q.shape != (rows, dof) or status.shape != (rows,):
        raise ValueError("T, q or status has another shape than ik_all takes and returns")


@register_jitable  # type: ignore[untyped-decorator]
def _address(q_seed: Any, dof: int) -> Any:  # noqa: ANN401
    """The address of a seed, which has to be right; zero for none."""
    if q_seed is None:
        return 0
    if q_seed.shape != (dof,):
        raise ValueError("q_seed must have as many values as the arm has joints")
    for value in q_seed:
        if not math.isfinite(value):
            raise ValueError("q_seed must be finite")
    return q_seed.ctypes.data


def _demand_types(T: Any, q: Any, status: Any, q_seed: Any) -> None:  # noqa: ANN401
    """Stops while numba compiles, where an array has another type: numba's message is no help."""
    _demand_type("T", T, "float64", 2)
    _demand_type("q", q, "float64", 2)
    _demand_type("status", status, "uint8", 1)
    if hasattr(q_seed, "dtype"):
        _demand_type("q_seed", q_seed, "float64", 1)
    if not (q.mutable and status.mutable):
        raise TypingError("q and status are filled: they can't be read-only")


def _demand_type(name: str, array: Any, kind: str, axes: int) -> None:  # noqa: ANN401
    plain = getattr(array, "layout", "") == "C" and array.ndim == axes
    if not plain or str(array.dtype) != kind:
        wanted = f"a contiguous array of {kind} with {axes} axes"
        raise TypingError(f"{name} must be {wanted}, not {array}")


def _compiler(wanted: str | None) -> str:
    if not isinstance(wanted, (str, type(None))):
        raise TypeError(f"compiler must be a name or a path, not {wanted!r}: {FLAGS_APART}")
    names = (wanted,) if wanted else (os.environ.get("CC"), "cc", "gcc", "clang")
    for name in names:
        if name and (found := shutil.which(name)):
            return found
    asked = f"{wanted} not found" if wanted else "none of $CC, cc, gcc and clang found"
    if wanted and len(wanted.split()) > 1:
        asked += f" ({FLAGS_APART})"
    raise NoCompiler(f"no C compiler: {asked}; without one use the robot's own module, with numba")


def _build(robot: ModuleType, source: Path, compiler: str, flags: Sequence[str]) -> Path:
    """The library of a source, compiled unless it is kept already."""
    sources = [source, *([source.with_name("dhgen_native.c")] if EXTENDS else [])]
    runtime = sorted(source.with_name("dhgen").rglob("*.[ch]"))
    texts = [each.read_bytes() for each in (*sources, source.with_suffix(".h"), *runtime)]
    # What the compiler defines for itself and for the processor, with these flags.
    texts.append(_run(compiler, *flags, "-dM", "-E", "-x", "c", os.devnull).encode())
    defined = {
        "HEADER": f'"{source.stem}.h"',
        "ROBOT": robot.NAME,
        "UPPER": robot.NAME.upper(),
        "GIVEN": _given(robot),
    }
    flags = [*flags, *(f"-DDHGEN_{name}={text}" for name, text in defined.items() if EXTENDS)]
    flags.append(f"-I{source.parent}")
    texts.append("\n".join((compiler, *flags)).encode())
    digest = _digest(b"\0".join(texts))
    folder, start = cache_folder(), f"{source.stem}-{digest}-"
    for kept in folder.glob(f"{start}*.so"):
        if _is_whole(kept):
            return kept
    with _room(folder) as place:
        made = Path(place) / "made.so"
        files = [*map(str, sources), "-o", str(made), "-lm"]
        _run(compiler, *flags, "-shared", "-fPIC", *files)
        library = folder / f"{start}{_digest(made.read_bytes())}.so"
        return made.replace(library)  # at once: nobody sees half of it


def _is_whole(library: Path) -> bool:
    """Whether it is what was built; opening half of it would end the process."""
    try:
        return library.stem.endswith(_digest(library.read_bytes()))
    except OSError:
        return False


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:24]


def _room(folder: Path) -> tempfile.TemporaryDirectory[str]:
    """A passing folder in the one where libraries are kept."""
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        return tempfile.TemporaryDirectory(dir=folder)
    except OSError as error:
        problem = f"libraries can't be written there ({error.strerror}): {WRITABLE}"
        raise OSError(error.errno, problem, str(folder)) from None


def cache_folder() -> Path:
    """Where libraries are kept, wherever the process goes; it need not be there yet."""
    if chosen := os.environ.get("DHGEN_CACHE_DIR"):
        return Path(chosen).absolute()
    user = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA")
    try:
        return (Path(user).absolute() if user else Path.home() / ".cache") / "dhgen"
    except RuntimeError:
        raise RuntimeError(f"the user has no home folder: {WRITABLE}") from None


def _run(*command: str) -> str:
    # Without a PATH it was found where the system keeps commands; it looks for its own in PATH.
    place = {"PATH": os.environ.get("PATH", os.defpath)}
    done = subprocess.run(  # noqa: S603
        command, env=os.environ | place, capture_output=True, text=True, check=False
    )
    if done.returncode:
        raise BuildError(f"{shlex.join(command)}\n{done.stderr}")
    return done.stdout
