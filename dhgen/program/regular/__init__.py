"""From a solver to its program for regular poses, which has no branches that end."""
