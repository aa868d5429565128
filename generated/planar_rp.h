/* planar_rp: Planar arm with a revolute and a prismatic joint
 * Inverse kinematics, generated from robots/planar_rp.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/planar_rp.yaml. The formulas and where they come from: planar_rp.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, in m; angles are in rad.
 * Of a pose, the coordinates x, y of the position is meant; other entries are ignored.
 */
#ifndef PLANAR_RP_H
#define PLANAR_RP_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    PLANAR_RP_DOF = 2,
    PLANAR_RP_ROWS = 2
};

/* What a row of planar_rp_ik holds. */
enum {
    PLANAR_RP_OK = 0,            /* joint values */
    PLANAR_RP_UNREACHABLE = 1,   /* NaN: no solution in this branch, or one that a row before it holds */
    PLANAR_RP_FREE_JOINT = 2,    /* joint values; a joint was indeterminate and took the seed's value */
    PLANAR_RP_OUT_OF_LIMITS = 3, /* joint values, of which one is beyond its limits */
    PLANAR_RP_INVALID_POSE = 4   /* NaN: T is no pose */
};

/* The name of every row: forward, backward. */
extern const char *const planar_rp_branches[2];

/* T of the joint values q. */
void planar_rp_fk(const double q[2], double T[16]);

/* The geometric Jacobian, 6 x 2 row by row: velocity of the tool's origin, angular velocity. */
void planar_rp_jacobian(const double q[2], double J[12]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * (NULL: zeros). Returns the number of rows that are OK or FREE_JOINT, or -PLANAR_RP_INVALID_POSE. */
int planar_rp_ik(const double T[16], const double *q_seed,
    double q[2][2], unsigned char status[2]);

/* The solution nearest to q_seed, angles moved by whole turns inside their limits. Returns PLANAR_RP_OK or
 * PLANAR_RP_FREE_JOINT, or minus PLANAR_RP_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE (q is then NaN). */
int planar_rp_ik_nearest(const double T[16], const double q_seed[2], double q[2]);

/* planar_rp_ik for n poses: T is n x 16, q n x 2 x 2, status n x 2. */
void planar_rp_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
