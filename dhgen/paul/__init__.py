"""Paul's method as data: the pool of equations, the types, the search, the derivation."""
