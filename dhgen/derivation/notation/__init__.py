"""How an arm is written: its letters, cells, polynomials and matrices as formulas.

Read `names`, the letters; then `signs` and `expressions`, cells of the robot file; `polynomial`;
`matrices`.
"""
