# SPDX-License-Identifier: MIT
"""numba or plain Python: how functions of the runtime and of robots are compiled.

A file gets its own way of compiling with `of_file(__file__)`. numba keeps what it compiles under
the name of a function: here a name with the digest of the file and of the whole runtime, because
numba itself looks at the text of one file only, and at no value of a global. What it keeps is found
again by whatever name the file is imported, be it by two names in one process.
"""

from __future__ import annotations

import hashlib
import sys
import warnings
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from . import DIGEST, INTERFACE

if TYPE_CHECKING:
    from collections.abc import Callable

F = TypeVar("F")


def _plain(*_positional: Any, **_named: Any) -> Any:  # noqa: ANN401
    return lambda function: function


def _plain_room(_: Any, size: int) -> Any:  # noqa: ANN401
    return np.zeros(size)


carray: Any
cgutils: Any
config: Any
errors: Any
intrinsic: Any
njit: Any
normalize_signature: Any
overload: Any
types: Any
try:
    from numba import config, njit, types
    from numba.core import cgutils, errors
    from numba.core.sigutils import normalize_signature
    from numba.extending import intrinsic, overload
    from numba.np.numpy_support import carray

    COMPILED = not config.DISABLE_JIT  # for debuggers
except ImportError:
    COMPILED = False
if not COMPILED:  # plain Python, only slower
    njit, overload, carray = _plain, _plain, _plain_room

# Without `forceinline: False` a function is inlined by force into functions that are themselves
# inlined by force. Roots of negative numbers are NaN, as they are in C.
_OPTIONS = {"error_model": "numpy", "forceinline": False}
# Only compiled code may call these: what Python would need is not made, which is much of the work.
_INNER = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}


_KEEPS: dict[Path, bool] = {}  # folders, and whether numba can keep what it compiles of their files


def _keeps(file: Path) -> bool:
    """Whether numba can keep what it compiles of a file; warned of once for all around it."""
    if not COMPILED or not file.is_file():
        return False
    folder = file.parent
    if folder not in _KEEPS:
        is_new = all(_KEEPS.get(outer, True) for outer in folder.parents)
        _KEEPS[folder] = _can_keep(str(file))
        if is_new and not _KEEPS[folder]:
            warnings.warn(
                f"numba can't cache what it compiles of {file}, neither next to it nor in the "
                "user's cache folder, and compiles it again in every process: set NUMBA_CACHE_DIR "
                f"to a writable folder (the same holds for all files in {folder})",
                stacklevel=5,
            )
    return _KEEPS[folder]


def _can_keep(path: str) -> bool:
    def probe() -> None: ...

    probe.__code__ = probe.__code__.replace(co_filename=path)
    try:
        njit(cache=True)(probe)
    except RuntimeError:
        return False
    return True


def digest_of(path: Path) -> str:
    """The digest of a file and of the whole runtime."""
    text = path.read_bytes() if path.is_file() else b""
    return hashlib.sha256(DIGEST.encode() + text).hexdigest()[:16]


class Compiling:
    """How the functions of one file are compiled.

    Attributes:
        key: The name in sys.modules under which compiled code finds the file, and no other text
            of it.
        digest: The digest of the file and of the whole runtime, in the names of its functions.
    """

    def __init__(self, path: Path) -> None:
        """Registers the file.

        Args:
            path: The file; need not exist, and is compiled anew in every process then.
        """
        # The path of a file that holds the whole runtime ends with "#" and the name of the module.
        file = path if path.is_file() else Path(str(path).rpartition("#")[0])
        self.digest = digest_of(file)
        self._cache = _keeps(file)
        # A dot would be one between packages.
        self.key = f"{path.name.replace('.', ' ')} {self.digest}"
        # A second import of the text finds the functions of the first.
        module = sys.modules.setdefault(self.key, ModuleType(self.key)) if COMPILED else None
        self._apart: dict[str, tuple[Any, Any]] = (
            vars(module).setdefault("apart", {}) if module else {}
        )
        if module:
            vars(module)["address"] = self.address

    def owned(self, function: F) -> F:
        """A function, known to numba as one of this text.

        Compiled code imports the module of a function when it comes out of the cache; the name by
        which the file was imported then may be another one than now.
        """
        if COMPILED:
            named: Any = function
            named.__module__ = self.key
            named.__qualname__ = f"{named.__qualname__} {self.digest}"
        return function

    def njit(self, **options: Any) -> Callable[[F], F]:  # noqa: ANN401
        """Compiles a function, with options of numba's."""
        if not COMPILED:
            return lambda function: function
        options = {**_OPTIONS, "cache": self._cache, **options}
        return lambda function: njit(**options)(self.owned(function))

    def jit(self, function: F) -> F:
        """Compiles a function that Python may call."""
        return self.njit()(function)

    def inner(self, function: F) -> F:
        """Compiles a function that only compiled code calls."""
        return self.njit(**_INNER)(function)

    def merged(self, function: F) -> F:
        """Compiles a function into those that call it."""
        return self.njit(forceinline=True, **_INNER)(function)

    def apart(self, signature: str) -> Callable[[F], F]:
        """Compiles a function apart from its callers.

        numba copies what a function calls into it, with all that this calls, and optimises
        everything anew in each caller. Of these functions a caller has the address, which it looks
        up at its first call, because the address is not in the cache.

        Args:
            signature: The types of what it returns and takes, in numba's words.
        """
        if not COMPILED:
            return self._known
        arguments, result = normalize_signature(signature)

        def decorate(function: Any) -> Any:  # noqa: ANN401
            name = function.__name__
            self.register(name, self.inner(function), signature)

            def code(context: Any, builder: Any, called: Any, values: Any) -> Any:  # noqa: ANN401
                given = zip(
                    cgutils.unpack_tuple(builder, values[0]), called.args[0], arguments, strict=True
                )
                cast = [context.cast(builder, *each) for each in given]
                address = _address_once(context, builder, self.key, name)
                return _call_at(context, builder, address, result, arguments, cast)

            return intrinsic(lambda _, *values: (result(types.StarArgTuple(values)), code))

        return decorate

    def _known(self, function: F) -> F:
        """Returns the function itself, registered by its name in place of an address."""
        named: Any = function
        self._apart[named.__name__] = function, ()
        return function

    def register(self, name: str, function: Any, signature: str) -> None:  # noqa: ANN401
        """Makes a compiled function known by its name, to be called at its address.

        Args:
            name: Of the function.
            function: As numba compiles it.
            signature: The types of what it returns and takes, in numba's words.
        """
        arguments = normalize_signature(signature)[0] if COMPILED else ()
        self._apart.setdefault(name, (function, arguments))

    def addresses(self, *names: str | None) -> Callable[[], tuple[int, ...]]:
        """A function of compiled code that gives the addresses of functions, for `calling`.

        In plain Python it gives the functions themselves.

        Args:
            names: Of functions made by `apart` or registered; None for one that is never called.
        """
        if not COMPILED:
            none = None, ()
            found = tuple(self._apart.get(name or "", none)[0] for name in names)
            return lambda: found

        def code(context: Any, builder: Any, called: Any, _: Any) -> Any:  # noqa: ANN401
            number = context.get_value_type(types.int64)
            places = [
                builder.ptrtoint(_address_once(context, builder, self.key, name), number)
                if name
                else number(0)
                for name in names
            ]
            return context.make_tuple(builder, called.return_type, places)

        made: Any = intrinsic(lambda _: (types.UniTuple(types.int64, len(names))(), code))
        return made  # type: ignore[no-any-return]

    def compile_apart(self) -> None:
        """Compiles all functions that are called by address, or loads them from numba's cache."""
        for name in list(self._apart) if COMPILED else ():
            self.address(name)

    def address(self, name: str) -> int:
        """Where the code of a function is that is compiled apart."""
        function, arguments = self._apart[name]
        function.compile(arguments)
        compiled = function.overloads[arguments]
        return int(compiled.library.get_pointer_to_function(compiled.fndesc.llvm_func_name))


def of_file(path: str, *, interface: int = INTERFACE) -> Compiling:
    """How the functions of a file are compiled.

    Args:
        path: The file's `__file__`.
        interface: What the file was generated for.

    Raises:
        ImportError: The file was generated for another version of the runtime.
    """
    if interface != INTERFACE:
        raise ImportError(
            f"{path} was generated for version {interface} of dhgen_runtime, which is version "
            f"{INTERFACE} here: run dhgen on its robot file again"
        )
    return Compiling(Path(path).resolve())


def _address_once(context: Any, builder: Any, key: str, name: str) -> Any:  # noqa: ANN401
    """The address of a function made by `apart`, looked up once."""
    place = cgutils.add_global_variable(builder.module, cgutils.voidptr_t, f"address of {name}")
    place.initializer, place.linkage = cgutils.get_null_value(cgutils.voidptr_t), "internal"
    with builder.if_then(cgutils.is_null(builder, builder.load(place)), likely=False):
        _ask(context, builder, key, name, place)
    address = builder.load(place)
    with builder.if_then(cgutils.is_null(builder, address), likely=False):
        context.call_conv.return_exc(builder)
    return address


def _ask(context: Any, builder: Any, key: str, name: str, place: Any) -> None:  # noqa: ANN401
    """Looks up the address of a function made by `apart`; an error leaves null."""
    api = context.get_python_api(builder)
    lock = api.gil_ensure()
    module = api.import_module(context.insert_const_string(builder.module, key))
    with builder.if_then(cgutils.is_not_null(builder, module)):
        asked = api.string_from_string(context.insert_const_string(builder.module, name))
        answer = api.call_method(module, "address", (asked,))
        with builder.if_then(cgutils.is_not_null(builder, answer)):
            builder.store(api.long_as_voidptr(answer), place)
            api.decref(answer)
        api.decref(module)
    api.gil_release(lock)


def calling(signature: str) -> Callable[..., Any]:
    """A function of compiled code that calls another one at an address, which it gets first.

    In plain Python it gets the function itself.

    Args:
        signature: The types of what the other one returns and takes, in numba's words.
    """
    if not COMPILED:
        return lambda function, *values: function(*values)
    arguments, result = normalize_signature(signature)

    def code(context: Any, builder: Any, called: Any, values: Any) -> Any:  # noqa: ANN401
        given = zip(
            cgutils.unpack_tuple(builder, values[1]), called.args[1], arguments, strict=True
        )
        cast = [context.cast(builder, *each) for each in given]
        return _call_at(context, builder, values[0], result, arguments, cast)

    def typed(_: Any, __: Any, *values: Any) -> Any:  # noqa: ANN401
        return result(types.int64, types.StarArgTuple(values)), code

    made: Any = intrinsic(typed)
    return made  # type: ignore[no-any-return]


def _call_at(
    context: Any,  # noqa: ANN401
    builder: Any,  # noqa: ANN401
    address: Any,  # noqa: ANN401
    result: Any,  # noqa: ANN401
    arguments: Any,  # noqa: ANN401
    values: Any,  # noqa: ANN401
) -> Any:  # noqa: ANN401
    """Calls a function at an address."""
    kind = context.call_conv.get_function_type(result, arguments).as_pointer()
    is_number = address.type == context.get_value_type(types.int64)
    function = (builder.inttoptr if is_number else builder.bitcast)(address, kind)
    status, value = context.call_conv.call_function(builder, function, result, arguments, values)
    with cgutils.if_unlikely(builder, status.is_error):
        context.call_conv.return_status_propagate(builder, status)
    return value


def _stack_room(*, wide: bool) -> Any:  # noqa: ANN401
    """A function of compiled code: the address of room for so many numbers on its caller's stack.

    Args:
        wide: Whether the caller works on it with vectors as wide as there are: LLVM prefers 256
            bits on machines with 512, a tenth slower.
    """
    if not COMPILED:
        return lambda size: size

    def code(context: Any, builder: Any, signature: Any, _: Any) -> Any:  # noqa: ANN401
        attributes = builder.function.attributes
        if wide and isinstance(attributes, set):
            set.add(attributes, '"prefer-vector-width"="512"')
        number = context.get_value_type(types.float64)
        return cgutils.alloca_once(builder, number, signature.args[0].literal_value)

    return intrinsic(prefer_literal=True)(
        lambda _, size: (types.CPointer(types.float64)(size), code)
    )


room, wide_room = _stack_room(wide=False), _stack_room(wide=True)


def _lending(kind: str, axes: int) -> Callable[[F], F]:
    """Lends arrays of a kind of number, with so many axes, and refuses others.

    An array is lent without a hold on its memory, which its owner keeps until the call is over:
    counting who holds it takes processors longer than solving a pose.
    """
    refusal = f"something else where an array of {kind} with {axes} axes is taken"

    def in_plain_python(array: Any) -> Any:  # noqa: ANN401
        if not isinstance(array, np.ndarray) or (str(array.dtype), array.ndim) != (kind, axes):
            raise ValueError(refusal)
        return array

    def lent(_: Any, array: Any) -> Any:  # noqa: ANN401
        if not isinstance(array, types.Array) or (str(array.dtype), array.ndim) != (kind, axes):
            raise errors.TypingError(refusal)

        def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:  # noqa: ANN401
            lent = context.make_array(signature.return_type)(context, builder, args[0])
            lent.meminfo = lent.meminfo.type(None)
            return lent._getvalue()  # noqa: SLF001  numba has no public way

        return array(array), code

    made: Any = intrinsic(prefer_literal=False)(lent) if COMPILED else in_plain_python
    return made  # type: ignore[no-any-return]


lent_rows, lent_values = _lending("float64", 2), _lending("float64", 1)
lent_statuses = _lending("uint8", 1)
