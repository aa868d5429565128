"""From a solver to its program for regular poses, which has no branches that end.

Read `regular` and `unguarded`, which do it; `assumptions`, what is assumed there; `reach_boundary`,
`limits` and `directions`, how poses are found for which it isn't true; `signed`, `rewriting` and
`expansion`, with `coefficient`, how values get short; `flatten`, the same without loops.
"""
