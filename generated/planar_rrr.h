/* planar_rrr: Planar arm with three revolute joints
 * Inverse kinematics, generated from robots/planar_rrr.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/planar_rrr.yaml. The formulas and where they come from: planar_rrr.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, in m; angles are in rad.
 * Of a pose, the whole pose is meant; other entries are ignored.
 */
#ifndef PLANAR_RRR_H
#define PLANAR_RRR_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    PLANAR_RRR_DOF = 3,
    PLANAR_RRR_ROWS = 2
};

/* What a row of planar_rrr_ik holds. */
enum {
    PLANAR_RRR_OK = 0,            /* joint values */
    PLANAR_RRR_UNREACHABLE = 1,   /* NaN: no solution in this branch, or one that a row before it holds */
    PLANAR_RRR_FREE_JOINT = 2,    /* joint values; a joint was indeterminate and took the seed's value */
    PLANAR_RRR_OUT_OF_LIMITS = 3, /* joint values, of which one is beyond its limits */
    PLANAR_RRR_INVALID_POSE = 4   /* NaN: T is no pose */
};

/* The name of every row: down, up. */
extern const char *const planar_rrr_branches[2];

/* T of the joint values q. */
void planar_rrr_fk(const double q[3], double T[16]);

/* The geometric Jacobian, 6 x 3 row by row: velocity of the tool's origin, angular velocity. */
void planar_rrr_jacobian(const double q[3], double J[18]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * (NULL: zeros). Returns the number of rows that are OK or FREE_JOINT, or -PLANAR_RRR_INVALID_POSE. */
int planar_rrr_ik(const double T[16], const double *q_seed,
    double q[2][3], unsigned char status[2]);

/* The solution nearest to q_seed, angles moved by whole turns inside their limits. Returns PLANAR_RRR_OK or
 * PLANAR_RRR_FREE_JOINT, or minus PLANAR_RRR_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE (q is then NaN). */
int planar_rrr_ik_nearest(const double T[16], const double q_seed[3], double q[3]);

/* planar_rrr_ik for n poses: T is n x 16, q n x 2 x 3, status n x 2. */
void planar_rrr_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
