"""The Python target: a module of numba functions that are plain Python where numba is absent.

Read `files`, what is written, with `texts`, `table` and `literal`; `language` and `assignments`,
how formulas look; `formulas`, regular poses. `whole` and `nearest` are for arms without a closed
form, `calibrated` for tables that come at run time; `single_file` puts the runtime into the module.
"""
