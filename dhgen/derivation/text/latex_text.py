"""Words as LaTeX: what LaTeX would take for its own, and letters that not every font has."""

from __future__ import annotations

_OWN = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "#": r"\#",
    "%": r"\%",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "\u00a0": "~",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    "'": "'",
    "`": r"\textasciigrave{}",
    '"': r"\textquotedbl{}",
}
_GREEK = {
    "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "varepsilon", "ζ": "zeta",
    "η": "eta", "θ": "theta", "κ": "kappa", "λ": "lambda", "μ": "mu", "ν": "nu", "ξ": "xi",
    "π": "pi", "ρ": "rho", "σ": "sigma", "τ": "tau", "φ": "varphi", "χ": "chi", "ψ": "psi",
    "ω": "omega", "Γ": "Gamma", "Δ": "Delta", "Θ": "Theta", "Λ": "Lambda", "Ξ": "Xi", "Π": "Pi",
    "Σ": "Sigma", "Φ": "Phi", "Ψ": "Psi", "Ω": "Omega",
}  # fmt: skip
_MATH = {
    **{letter: rf"\{name}" for letter, name in _GREEK.items()},
    **{letter: f"_{digit}" for letter, digit in zip("₀₁₂₃₄₅₆₇₈₉₋", "0123456789-", strict=True)},
    **{letter: f"^{digit}" for letter, digit in zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-", strict=True)},
    "−": "-",
    "±": r"\pm",
    "×": r"\times",
    "·": r"\cdot",
    "√": r"\surd",
    "≤": r"\le",
    "≥": r"\ge",
    "≠": r"\ne",
    "≈": r"\approx",
    "∈": r"\in",
    "→": r"\to",
    "∞": r"\infty",
    "°": r"^\circ",
    "′": "'",
}
# Where lines go from the middle of a character's cell: up, right, down, left.
_TREE = {
    "─": "0101", "│": "1010", "┌": "0110", "┐": "0011", "└": "1100", "┘": "1001",
    "├": "1110", "┤": "1011", "┬": "0111", "┴": "1101", "┼": "1111",
}  # fmt: skip
_LAST_OF_LATIN = 0x17F  # of the letters that the fonts of every LaTeX have


def latex_text(text: str) -> str:
    """A text in a line; two hyphens remain two."""
    return "".join(map(_letter, text)).replace("--", "-{}-")


def latex_cells(text: str) -> str:
    """A line of a drawing, every character as wide as the others."""
    return "".join(map(_cell, text))


def latex_letters(text: str) -> str:
    """A name as it is in formulas: one letter, or several as one word."""
    shown = "".join(_MATH.get(each) or _OWN.get(each) or each for each in text)
    return shown if len(text) == 1 or not text.isalpha() else rf"\mathit{{{shown}}}"


def _letter(letter: str) -> str:
    if letter in _OWN:
        return _OWN[letter]
    if letter in _MATH:
        return f"${_MATH[letter]}$"
    if ord(letter) <= _LAST_OF_LATIN or letter in "—–‘’“”…":
        return letter
    return rf"\other{{{letter}}}"


def _cell(letter: str) -> str:
    if letter in _TREE:
        return rf"\tree{''.join(f'{{{end}}}' for end in _TREE[letter])}"
    if letter == " ":
        return r"\cell{}"
    return rf"\cell{{{_letter(letter)}}}"
