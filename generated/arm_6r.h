/* arm_6r: Arm with six revolute joints and a spherical wrist
 * Inverse kinematics, generated from robots/arm_6r.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/arm_6r.yaml. The formulas and where they come from: arm_6r.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, in m; angles are in rad.
 * Of a pose, the whole pose is meant; other entries are ignored.
 */
#ifndef ARM_6R_H
#define ARM_6R_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    ARM_6R_DOF = 6,
    ARM_6R_ROWS = 8
};

/* What a row of arm_6r_ik holds. */
enum {
    ARM_6R_OK = 0,            /* joint values */
    ARM_6R_UNREACHABLE = 1,   /* NaN: no solution in this branch, or one that a row before it holds */
    ARM_6R_FREE_JOINT = 2,    /* joint values; a joint was indeterminate and took the seed's value */
    ARM_6R_OUT_OF_LIMITS = 3, /* joint values, of which one is beyond its limits */
    ARM_6R_INVALID_POSE = 4   /* NaN: T is no pose */
};

/* The name of every row: left-down-noflip, left-down-flip, left-up-noflip, left-up-flip, right-down-noflip, right-down-flip, right-up-noflip, right-up-flip. */
extern const char *const arm_6r_branches[8];

/* T of the joint values q. */
void arm_6r_fk(const double q[6], double T[16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, angular velocity. */
void arm_6r_jacobian(const double q[6], double J[36]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * (NULL: zeros). Returns the number of rows that are OK or FREE_JOINT, or -ARM_6R_INVALID_POSE. */
int arm_6r_ik(const double T[16], const double *q_seed,
    double q[8][6], unsigned char status[8]);

/* The solution nearest to q_seed, angles moved by whole turns inside their limits. Returns ARM_6R_OK or
 * ARM_6R_FREE_JOINT, or minus ARM_6R_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE (q is then NaN). */
int arm_6r_ik_nearest(const double T[16], const double q_seed[6], double q[6]);

/* arm_6r_ik for n poses: T is n x 16, q n x 8 x 6, status n x 8. */
void arm_6r_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
