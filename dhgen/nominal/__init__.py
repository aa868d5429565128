"""Arms that miss a structure by little, and the nearest arm that has one.

Reading order: lines (the axes), table (what is taken as exact), fit (the other numbers), deviation
(how far the two arms are apart), nearest; certificate (where the nearest arm's rows show all of the
arm's), nominal (whether that helps).
"""
