# SPDX-License-Identifier: MIT
"""All solutions of arms of six joints, two slides at most, without closed form.

M. Raghavan and B. Roth, Inverse kinematics of the general 6R manipulator and related linkages
(1993): six equations in one joint, the hidden one, and two partners; their determinant is a
trigonometric polynomial of degree 8 in the hidden joint. Here it is sampled on the circle. For
offset wrists and arms with two slides the polynomial is known in closed form.

In reading order: places (the numbers of an arm), tables (numbers that belong to no arm), loop (the
arm as a closed loop J(q1) K0 J(q2) ... K4 J(q6) = P), equations (of a formulation, and their
determinant), circle (real roots of a polynomial on the circle), moebius (a lens on the circle),
wrist and four_turns (polynomials in closed form), roots (all real roots of either), recover (joints
from a root), refine (Newton's steps), candidates (what becomes a solution), attempts (one
formulation), correct (from near all solutions to these), search (all of them), rows (solutions of
the arm); near (joint values near all solutions, by the nearest arm with a structure), postures
(rows of that arm); compiled (all of it beforehand).
"""
