"""The program: what to compute, in a small language that every target prints.

Read `ir`, the language, with `role` and `reserved`, its names; `interpret`, its meaning, with
`circle`, `completion` and `all_joints`; `building`, how programs are made; `lowering`, how
derivations become programs; `regular`, how a solver becomes the program of regular poses; `policy`,
what is done around the formulas at run time. `walk`, `count`, `arrival`, `text` look at one.
"""
