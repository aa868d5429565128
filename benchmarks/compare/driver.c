/* Calls of one solver for many poses, and their CPU time.
 *
 * Compiled beside the solver's own file, once for each:
 *   -DHEADER='"scara.h"' -DROBOT=scara -DUPPER=SCARA -DREAL=double -DGIVEN=0
 * GIVEN is how many numbers the caller gives besides the pose. Arrays lie pose after pose.
 */
#define _POSIX_C_SOURCE 199309L
#include HEADER
#include <stddef.h>
#include <time.h>

#define PASTE_(a, b) a##b
#define PASTE(a, b) PASTE_(a, b)
#define CALL(end) PASTE(ROBOT, end)
enum { DOF = PASTE(UPPER, _DOF), ROWS = PASTE(UPPER, _ROWS) };

#if GIVEN
#define WITH(k) given + GIVEN * (k),
#define WITH_ALL given,
#else
#define WITH(k)
#define WITH_ALL
#endif

void compare_fk(size_t n, const REAL *q, REAL *T);
void compare_jacobian(size_t n, const REAL *q, REAL *J);
void compare_ik(
    size_t n, const REAL *T, const REAL *given, const REAL *seed, REAL *q, unsigned char *status,
    int *returned);
void compare_nearest(
    size_t n, const REAL *T, const REAL *given, const REAL *seed, REAL *q, int *returned);
void compare_batch(size_t n, const REAL *T, const REAL *given, REAL *q, unsigned char *status);
double compare_time(
    int batch, size_t n, size_t repeats, const REAL *T, const REAL *given, REAL *q,
    unsigned char *status);

void compare_fk(size_t n, const REAL *q, REAL *T)
{
    for (size_t k = 0; k < n; k++)
        CALL(_fk)(q + DOF * k, T + 16 * k);
}

void compare_jacobian(size_t n, const REAL *q, REAL *J)
{
    for (size_t k = 0; k < n; k++)
        CALL(_jacobian)(q + DOF * k, J + 6 * DOF * k);
}

/* Without a seed where it is NULL. */
void compare_ik(
    size_t n, const REAL *T, const REAL *given, const REAL *seed, REAL *q, unsigned char *status,
    int *returned)
{
    (void)given;
    for (size_t k = 0; k < n; k++)
        returned[k] = CALL(_ik)(
            T + 16 * k, WITH(k) seed ? seed + DOF * k : NULL,
            (REAL(*)[DOF])(q + ROWS * DOF * k), status + ROWS * k);
}

void compare_nearest(
    size_t n, const REAL *T, const REAL *given, const REAL *seed, REAL *q, int *returned)
{
    (void)given;
    for (size_t k = 0; k < n; k++)
        returned[k] = CALL(_ik_nearest)(T + 16 * k, WITH(k) seed + DOF * k, q + DOF * k);
}

void compare_batch(size_t n, const REAL *T, const REAL *given, REAL *q, unsigned char *status)
{
    (void)given;
    CALL(_ik_batch)(n, T, WITH_ALL q, status);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* CPU seconds of solving n poses so many times, at once or one after another. */
double compare_time(
    int batch, size_t n, size_t repeats, const REAL *T, const REAL *given, REAL *q,
    unsigned char *status)
{
    const double start = now();
    (void)given;
    for (size_t again = 0; again < repeats; again++) {
        if (batch)
            CALL(_ik_batch)(n, T, WITH_ALL q, status);
        else
            for (size_t k = 0; k < n; k++)
                (void)CALL(_ik)(T + 16 * k, WITH(k) NULL, (REAL(*)[DOF])q, status);
    }
    return now() - start;
}
