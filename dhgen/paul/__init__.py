"""Paul's method as data: from a chain to the ordered steps that solve it.

Read `problem` and `equation`, what is asked and what is written down; `pool`, all equations, with
`mixed_forms`, `further_forms`, `arm_plane` and `tool_axis`, where they come from; `knowledge`,
`form` and `form_reader`, how they look when some joints are known; `kind`, `step` and `types`,
which of them give an unknown; `search`, the cheapest order of steps; `derivation`, what comes out;
`derive` does all of this. Beside them `witness`, with `samples`, makes sure that coefficients do
not vanish; `degeneracy`, with `common_zeros`, finds where they do, and `fallback_equation` a second
equation there; `common_factor` sees which share no factor; `close_roots` decides whether a quartic
is of use. `mobility` and `refusal` are for arms that have no solution of this kind.
"""
