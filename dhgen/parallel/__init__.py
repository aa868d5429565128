"""Parallel robots: a platform on legs, each of them a serial chain that the rest of dhgen solves.

Read `robot`, what a file with `legs` describes, `mobility`, how freedoms are counted, and `read`,
which makes it. `compile` solves the legs' chains as serial arms and prints what joins them:
`module` says of what, `targets` in which languages. `verify` proves the files.
"""
