"""Verification of the files as they will be written, on ordinary, singular and impossible poses.

Read `verify`, which goes through it all; `samples` and `singular`, the joint values that are tried;
`native`, `languages` and `compiled`, the written files at work; `demands` and `measures`, what
their answers have to be. `single` is for single precision, `calibrated` for tables that come at run
time.
"""
