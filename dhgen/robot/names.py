"""Names that a file may give: they end up in Python, in C and in file names."""

from __future__ import annotations

import keyword
import re
import unicodedata
from typing import Literal, TypeAlias

LengthUnit: TypeAlias = Literal["m", "dm", "cm", "mm", "um", "in", "ft"]

MAX_ROBOT_NAME = 48
MAX_PARAMETER_NAME = 32
MAX_JOINT_NAME = 64
JOINT_NAME = r"[A-Za-z0-9_/][A-Za-z0-9_/:. +-]*"  # what URDF and MJCF files hold; harmless in code
# Texts that YAML reads as something else where they are not in quotes.
YAML_WORDS = frozenset({"null", "true", "false", "yes", "no", "on", "off", "y", "n"})
RESERVED = ("q", "pi", "deg", "sqrt", "sin", "cos")

# What lies beside every robot, and what its files include: dhgen_runtime/, dhgen_ik, DHGEN_OK.
_OWN = re.compile(r"dhgen(_|$)", re.IGNORECASE)
_IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*", re.ASCII)
# What the generator itself writes: c1 s23 q4 theta2 t06, and the field's matrices.
_GENERATED = re.compile(r"[csq]\d+|theta\d*|t\d\d|[TUR]", re.ASCII)

_CONTROL = ("Cc", "Cs", "Zl", "Zp")
# Marks that make a text read otherwise than it is.
_BIDIRECTIONAL = frozenset("\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e") | frozenset(
    "\u2066\u2067\u2068\u2069"
)


def why_no_robot_name(name: str) -> str | None:
    """Why a robot can't be called so, or None."""
    if _OWN.match(name):
        return "dhgen's own files, functions and macros have such names: dhgen, dhgen_..."
    if name.casefold() in FILES:
        return "it is the name of a library or a device, so generated files can't have it"
    return _why_no_identifier(name, MAX_ROBOT_NAME)


def why_no_joint_name(name: str) -> str | None:
    """Why a joint can't be called so, or None."""
    if len(name) > MAX_JOINT_NAME:
        return f"it has {len(name)} characters; at most {MAX_JOINT_NAME} are allowed"
    if not re.fullmatch(JOINT_NAME, name, re.ASCII) or name.endswith(" "):
        return (
            "it must be plain: letters from a to z without accents, digits and _ / : . + - with "
            "blanks between them"
        )
    return None


def why_no_parameter_name(name: str) -> str | None:
    """Why a parameter can't be called so, or None."""
    if name in RESERVED:
        return f"it is reserved ({', '.join(RESERVED)} have their own meaning)"
    if _GENERATED.fullmatch(name):
        return "the derivation uses such names itself (c1, s23, q4, theta2, t06, T, U, R)"
    if name in PYTHON:
        return "the generated Python needs this name"
    return _why_no_identifier(name, MAX_PARAMETER_NAME)


def why_no_text(text: str, longest: int) -> str | None:
    """Why a text for people can't be used, or None."""
    if len(text) > longest:
        return f"it has {len(text)} characters; at most {longest} are allowed"
    for character in text:
        if unicodedata.category(character) in _CONTROL:
            return f"it contains the control character U+{ord(character):04X}"
        if character in _BIDIRECTIONAL:
            return f"it contains U+{ord(character):04X}, which changes the reading direction"
    return None


def _why_no_identifier(name: str, longest: int) -> str | None:
    checks = {
        "a name is made of a-z, A-Z, 0-9 and _, and starts with a letter": (
            not _IDENTIFIER.fullmatch(name)
        ),
        f"it has {len(name)} characters; at most {longest} are allowed": len(name) > longest,
        "a leading or double underscore is reserved": name.startswith("_") or "__" in name,
        "it is a keyword of Python": keyword.iskeyword(name),
        "it is a keyword of C or C++": name in C_KEYWORDS,
        "it is a name of the C library": name in C_LIBRARY,
    }
    return next((reason for reason, applies in checks.items() if applies), None)


# C99 to C23, and C++ since the header is read there too.
_KEYWORDS = """
alignas alignof and and_eq asm atomic auto bitand bitor bool break case catch char class
co_await co_return co_yield compl complex concept const const_cast consteval constexpr constinit
continue decltype default delete do double dynamic_cast else enum explicit export extern false
far float for fortran friend generic goto if imaginary inline int linux long mutable namespace
near new noexcept noreturn not not_eq nullptr operator or or_eq private protected public
register reinterpret_cast requires restrict return short signed sizeof static static_assert
static_cast struct switch template this thread_local throw true try typedef typeid typename
typeof typeof_unqual union unix unsigned using virtual void volatile wchar_t while xor xor_eq
"""

# <math.h>; each also with the endings f and l.
_MATH = """
acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf erfc exp exp2 expm1 fabs
fdim floor fma fmax fmin fmod frexp hypot ilogb ldexp lgamma llrint llround log log10 log1p log2
logb lrint lround modf nan nearbyint nextafter nexttoward pow remainder remquo rint round
scalbln scalbn sin sinh sqrt tan tanh tgamma trunc
"""

# Of the other headers, and what compilers define without a header.
_LIBRARY = """
abort abs assert atexit atof atoi atol atoll bsearch calloc clock div DOMAIN double_t EOF errno
exit fclose feof ferror fflush fgetc fgets float_t fopen fpclassify fprintf fputc fputs fread
free fscanf fseek ftell fwrite gamma getc getchar getenv gets HUGE_VAL index INFINITY int16_t
int32_t int64_t int8_t isfinite isgreater isinf isless isnan isnormal isunordered j0 j1 jn labs
ldiv llabs lldiv longjmp M_PI main malloc memchr memcmp memcpy memmove memset NAN NULL offsetof
OVERFLOW perror printf ptrdiff_t putc putchar puts qsort raise rand realloc remove rename rewind
scanf setjmp signal signbit significand size_t snprintf sprintf srand sscanf stderr stdin stdout
strcat strchr strcmp strcpy strcspn strerror strlen strncat strncmp strncpy strpbrk strrchr
strspn strstr strtod strtok strtol strtoul system time tmpfile tolower toupper uint16_t uint32_t
uint64_t uint8_t ungetc va_arg va_end va_list va_start vprintf y0 y1 yn
"""

# As file names these hide what the generated files include, or the C library's own headers, or open
# a device.
_FILES = """
alloca arm_neon aux cmath com0 com1 com2 com3 com4 com5 com6 com7 com8 com9 complex con ctype endian
errno features fenv float immintrin inttypes iso646 limits locale lpt0 lpt1 lpt2 lpt3 lpt4 lpt5 lpt6
lpt7 lpt8 lpt9 math mm_malloc nul prn setjmp signal stdalign stdarg stdatomic stdbool stddef stdint
stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype
"""

# Libraries that the modules beside robots import, and numpy, numba, PyTorch, JAX and CuPy in their
# turn, be it to see whether they are installed; and what Python itself looks for when it starts.
_LIBRARIES = """
cffi charset_normalizer colorama coverage cuda cupy cupy_backends cupyx cython ipython jax jaxlib
llvmlite ml_dtypes numba numpy nvidia opt_einsum pkg_resources psutil pycparser scipy setuptools
sitecustomize threadpoolctl torch torchgen typing_extensions usercustomize warp yaml
"""

# Python's standard modules (3.11 to 3.14, small letters), which numpy, or the caller, would not
# find behind a robot's file. A fixed table: what is allowed must not depend on the running Python.
_MODULES = """
abc aifc annotationlib antigravity argparse array ast asynchat asyncio asyncore atexit audioop
base64 bdb binascii bisect builtins bz2 calendar cgi cgitb chunk cmd code codecs codeop collections
colorsys compileall compression concurrent configparser contextlib contextvars copy copyreg
cprofile crypt csv ctypes curses dataclasses datetime dbm decimal difflib dis distutils doctest
email encodings ensurepip enum faulthandler fcntl filecmp fileinput fnmatch fractions ftplib
functools gc genericpath getopt getpass gettext glob graphlib grp gzip hashlib heapq hmac html http
idlelib imaplib imghdr imp importlib inspect io ipaddress itertools json keyword lib2to3 linecache
logging lzma mailbox mailcap marshal mimetypes mmap modulefinder msilib msvcrt multiprocessing
netrc nis nntplib nt ntpath nturl2path numbers opcode operator optparse os ossaudiodev pathlib pdb
pickle pickletools pipes pkgutil platform plistlib poplib posix posixpath pprint profile pstats pty
pwd py_compile pyclbr pydoc pydoc_data pyexpat queue quopri random re readline reprlib resource
rlcompleter runpy sched secrets select selectors shelve shlex shutil site smtpd smtplib sndhdr
socket socketserver spwd sqlite3 sre_compile sre_constants sre_parse ssl stat statistics stringprep
struct subprocess sunau symtable sys sysconfig syslog tabnanny tarfile telnetlib tempfile termios
textwrap this threading timeit tkinter token tokenize tomllib trace traceback tracemalloc tty
turtle turtledemo types typing unicodedata unittest urllib uu uuid venv warnings wave weakref
webbrowser winreg winsound wsgiref xdrlib xml xmlrpc zipapp zipfile zipimport zlib zoneinfo
"""

# A parameter becomes a name of the generated Python, which needs these for itself.
_PYTHON = """
all any bool dict enumerate filter float int isinstance iter len list map math max min next np
numba numpy object open print range repr reversed round set slice sorted str sum super tuple type
vars zip
"""

C_KEYWORDS = frozenset(_KEYWORDS.split())
C_LIBRARY = frozenset(
    (*_LIBRARY.split(), *(name + end for name in _MATH.split() for end in ("", "f", "l")))
)
FILES = frozenset(f"{_FILES} {_LIBRARIES} {_MODULES}".split())
PYTHON = frozenset(_PYTHON.split())
