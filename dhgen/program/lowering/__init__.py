"""From a derivation to a program, step by step; and from joint values to pose and Jacobian.

Read `programs` and `lower`, which go through it all. What a step works with is in `context`, with
`target`, `angles`, `polynomials` and `arm_scale`; `types` lower a step each, with `coefficients`,
`roots`, `set_angle`, `distances` and `frame_columns`; `shoulder` is for arms with an arm angle,
with `vectors`, `yaw` for tasks that name it. `final_check` and `checks` are about rows that miss
their pose, `postures` names rows. `forward` and `arm_angle` are the programs from joint values.
"""
