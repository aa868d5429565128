"""How complete solvers are: `dhgen survey`.

Read `sources`, what is surveyed; `survey`, which goes through all arms; `trial`, a solver at work;
`ask`, with `singular`, what it is asked; `recall`, the same of very many poses; `table`, the text.
`parallel` is about the legs of parallel robots.
"""
