"""Targets: a program printed as a language, through the templates.

| room      | what is in it                                                                    |
|-----------|----------------------------------------------------------------------------------|
| c         | the header and the source, and what is C's alone: lanes, declarations            |
| python    | the module, and what is Python's alone: formulas of many poses side by side      |
| solver    | what the templates of a solver name in every language                            |
| general   | what those of the general algorithm name, in every language                      |
| numerical | what those of the numerical solver name, in every language                       |

Next to them is what all of them use: `SolverModule`, what is printed; a program as nested loops, as
stages, as lines of a scalar language; layout and constants.
"""
