"""How complete solvers are: `dhgen survey`."""
