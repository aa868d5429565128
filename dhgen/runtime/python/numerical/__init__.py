# SPDX-License-Identifier: MIT
"""Damped least squares: what refines joint values to solutions, and decides which of them are one.

In reading order: places (the numbers of an arm), goal (what is to be met), forward (pose and
Jacobian), descent (steps to a solution), solutions (which of them are one), family (the member of a
continuum that is nearest to the seed), keep (how a solution joins others), search (all joints from
starts alone). For rows of formulas: refine_rows, other_values, split_close_roots, search_lost_rows,
rows_beside, pairs. All of it beforehand: compiled.
"""
