"""Arms that no order of steps solves: the general algorithms for 6R, 5R1P and 4R2P.

Read `arm`, whether an arm is one; `links` and `loop`, its closed loop, with `virtual_joint` for an
arm with one joint too few; `formulation`, the ways to hide one joint, with `hidden_slide` and
`four_turns` for slides; `setup`, the choice of formulations, by `trial`, `circle` and `determined`,
with `vanishing` for joints whose values are given; `kernel`, what comes out, with `offset_wrist`;
`runtime_loop`, the numbers that the runtime gets.
"""
