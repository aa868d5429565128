"""Arms that miss a structure by little, and the nearest arm that has one.

Reading order: lines (the axes), table (what is taken as exact), fit (the other numbers), deviation
(how far the two arms are apart), nearest; bounds (how far values may be away then), certificate
(where all of the arm's solutions lie next to the nearest arm's rows), nominal (whether that helps);
rows (their names), postures (the rows of solutions).
"""
