"""How an arm is written: its letters, cells, polynomials and matrices as formulas."""
