"""How programs are built: nodes, every expression once, and the statements that they become.

Read `graph`, the nodes; `builder`, the operators, with `tolerance_constants`; `schedule`, the
statements.
"""
