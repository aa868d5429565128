"""Parallel robots: a platform on legs, each of them a serial chain that the rest of dhgen solves.

What a file with `legs` describes is in dhgen/legs. Read `compile`, which solves the legs' chains as
serial arms: `module` has what is printed of these and where they are mounted, `driven` the C of the
driven joints alone, `targets` the files in C and Python. `worked` finds an example, of which
`document` makes the derivation, with its `figure`, and `printing` the formats. `native` has the C
as functions for Python, by which `verify` proves the files.

A driven joint, or drive, is one that a motor moves; a drive's value is called a drive, too. The
robot file lists them under `actuated`. All other joints are passive.
"""
