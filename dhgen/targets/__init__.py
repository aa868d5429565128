"""Targets: a program printed as a language, through the templates.

| room    | what is in it                                                                    |
|---------|----------------------------------------------------------------------------------|
| c       | the header and the source, and what is C's alone: lanes, declarations            |
| python  | the module, and what is Python's alone: formulas of many poses side by side      |
| solver  | what the templates of a solver name in every language                            |
| general | what those of the general algorithm name, in every language                      |

Next to them is what all of them use: `emit`, all targets at once; `module`, what is printed; a
program as nested loops (`nest`), as `stages`, as lines of a language (`scalar`) in its words
(`dialect`), with `families` of values that share a statement; `layout`, `constants` and `reserved`
names; `coupled` drives; `calibrated`, arms whose tables come at run time.
"""
