"""Why an arm is not solved, in words, and what its user may do instead.

Read `size_limits` and `drives`, arms that are not tried; `redundancy`, arms that move without
moving what the task names, with `free_joint_advice` on joints that the caller might give and
`other_convention` on tables that are labelled wrongly; `unsolved`, arms for which no order of
equations is found.
"""
