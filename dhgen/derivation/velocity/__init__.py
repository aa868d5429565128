"""How the arm moves: det J in factors, and which motions singular postures lose."""
