/* kuka_kr6_r900: KUKA KR 6 R900
 * Inverse kinematics, generated from robots/kuka_kr6_r900.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/kuka_kr6_r900.yaml. The formulas and where they come from: kuka_kr6_r900.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, in m; angles are in rad.
 * Of a pose, the whole pose is meant; other entries are ignored.
 */
#ifndef KUKA_KR6_R900_H
#define KUKA_KR6_R900_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    KUKA_KR6_R900_DOF = 6,
    KUKA_KR6_R900_ROWS = 8
};

/* What a row of kuka_kr6_r900_ik holds. */
enum {
    KUKA_KR6_R900_OK = 0,            /* joint values */
    KUKA_KR6_R900_UNREACHABLE = 1,   /* NaN: no solution in this branch, or one that a row before it holds */
    KUKA_KR6_R900_FREE_JOINT = 2,    /* joint values; a joint was indeterminate and took the seed's value */
    KUKA_KR6_R900_OUT_OF_LIMITS = 3, /* joint values, of which one is beyond its limits */
    KUKA_KR6_R900_INVALID_POSE = 4   /* NaN: T is no pose */
};

/* The name of every row: left-down-noflip, left-down-flip, left-up-noflip, left-up-flip, right-down-noflip, right-down-flip, right-up-noflip, right-up-flip. */
extern const char *const kuka_kr6_r900_branches[8];

/* T of the joint values q. */
void kuka_kr6_r900_fk(const double q[6], double T[16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, angular velocity. */
void kuka_kr6_r900_jacobian(const double q[6], double J[36]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * (NULL: zeros). Returns the number of rows that are OK or FREE_JOINT, or -KUKA_KR6_R900_INVALID_POSE. */
int kuka_kr6_r900_ik(const double T[16], const double *q_seed,
    double q[8][6], unsigned char status[8]);

/* The solution nearest to q_seed, angles moved by whole turns inside their limits. Returns KUKA_KR6_R900_OK or
 * KUKA_KR6_R900_FREE_JOINT, or minus KUKA_KR6_R900_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE (q is then NaN). */
int kuka_kr6_r900_ik_nearest(const double T[16], const double q_seed[6], double q[6]);

/* kuka_kr6_r900_ik for n poses: T is n x 16, q n x 8 x 6, status n x 8. */
void kuka_kr6_r900_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
