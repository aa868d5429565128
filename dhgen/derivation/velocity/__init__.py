"""How the arm moves: det J in factors, and which motions singular postures lose.

- `columns.py`: what every joint gives the tool of velocity and angular velocity;
- `task_rows.py`: the rows of the Jacobian that a task names, seen from the best frames;
- `triangle.py`: their order in which they are made of square blocks;
- `determinant.py`: the factors of the determinant;
- `irreducible.py`: whether it has any;
- `tall.py`: of an arm with fewer joints than the task has numbers, the determinant of some columns;
- `with_arm_angle.py`: the determinant with a row for the rate of the arm angle;
- `wrist.py`: the Jacobian at the centre of a spherical wrist;
- `posture.py`: a posture in numbers of any kind;
- `lost.py`: the motion that is lost where a factor vanishes.
"""
