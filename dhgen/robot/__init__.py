"""The robot file: from YAML text to a validated, frozen Robot.

Read `robot` and `task`, what comes out, and `load`, which makes it. The text: `source`, `syntax`,
`nodes`, `reader`, `report`. Keys: `schema`, `shape`, `names`. Cells: `tokens`, `arithmetic`,
`expression`, `exact`, `angles`, `units`, `lengths`, `cell_notes`, `cells`. Put together: `frames`,
`couplings`, `passive`, `joints`, `sums`, `assemble`; of a dict, `mapping`.
"""
