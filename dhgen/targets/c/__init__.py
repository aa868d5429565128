"""The C target: a header and a C99 source that needs nothing but <math.h>.

Read `files`, what is written, with `texts`, `calls` and `table`; `language` and `declared`, how
formulas look, with `fitting`; `motion` and `links`, kinematics. Regular poses are in `regular`:
`lanes`, `wide`, `shared`, `packing`, `turns`, `irregular` and `rows`. `general`, `descents` and
`nearest` are for arms without a closed form, `calibrated` for tables that come at run time;
`single_precision` and `runtime` write another kind of source.
"""
