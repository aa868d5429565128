"""dhgen in Python: `arm = dhgen.load("ur5.urdf")`, `solver = arm.build()`, `solver.ik_all(T)`.

Read `load`, the front door; `arm`, what is there at once; `solver`, what a build gives; `kept`, the
folder in which builds are kept; `progress`, messages in the meantime; `wording`, the command's
advice in the words of Python; `documents`, what is shown in a terminal and in a notebook.

`import dhgen` is quick: what needs sympy or numba is imported on first use.
"""
