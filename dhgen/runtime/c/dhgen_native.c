/* SPDX-License-Identifier: MIT
 *
 * dhgen_native: a robot's C as functions of Python, without Python's headers.
 * Part of dhgen, which puts a copy of this file beside the robots that it generates.
 *
 * dhgen_native.py compiles it together with a robot's file, with
 *   -DDHGEN_HEADER='"scara.h"' -DDHGEN_ROBOT=scara -DDHGEN_UPPER=SCARA -DDHGEN_GIVEN=0
 * where DHGEN_GIVEN is how many values the caller gives besides the pose, and makes functions of
 * Python of the functions here. What is declared of Python belongs to its stable ABI: it is there
 * from 3.11 on, and no later version changes it. Builds without a global lock have other objects.
 *
 * Arrays of the right type, shape and layout are handed to the robot's functions as they are.
 * Anything else goes to a method of the function's owner, which is in Python: it converts them, or
 * raises the error. */
#include DHGEN_HEADER

#include <math.h>
#include <stddef.h>
#include <stdint.h>

typedef struct _object PyObject;
typedef ptrdiff_t Py_ssize_t;
typedef struct {
    void *buf;
    PyObject *obj;
    Py_ssize_t len, itemsize;
    int readonly, ndim;
    char *format;
    Py_ssize_t *shape, *strides, *suboffsets;
    void *internal;
} Py_buffer;
extern PyObject _Py_NoneStruct;
int PyObject_GetBuffer(PyObject *owner, Py_buffer *view, int flags);
void PyBuffer_Release(Py_buffer *view);
void PyErr_Clear(void);
PyObject *PyLong_FromLong(long value);
PyObject *PyObject_GetAttrString(PyObject *owner, const char *name);
PyObject *PyObject_Call(PyObject *function, PyObject *arguments, PyObject *named);
PyObject *PyTuple_New(Py_ssize_t size);
PyObject *PyTuple_GetItem(PyObject *tuple, Py_ssize_t place);
int PyTuple_SetItem(PyObject *tuple, Py_ssize_t place, PyObject *item);
Py_ssize_t PyTuple_Size(PyObject *tuple);
PyObject *PyDict_New(void);
int PyDict_SetItem(PyObject *dict, PyObject *key, PyObject *item);
void Py_IncRef(PyObject *object);
void Py_DecRef(PyObject *object);

#define DHGEN_PASTE_(a, b) a##b
#define DHGEN_PASTE(a, b) DHGEN_PASTE_(a, b)
#define DHGEN_CALL(end) DHGEN_PASTE(DHGEN_ROBOT, end)

enum {
    WRITABLE = 0x0001,
    PLAIN = 0x0004 | 0x0038, /* with its format, contiguous row by row */
    DOF = DHGEN_PASTE(DHGEN_UPPER, _DOF),
    ROWS = DHGEN_PASTE(DHGEN_UPPER, _ROWS),
    GIVES = DHGEN_GIVEN > 0,
    MOST = 5 /* arguments */
};

/* What an argument has to be. */
typedef struct {
    int flags;
    char kind; /* of its numbers: d double, B unsigned char */
    int axes;
    Py_ssize_t shape[2];
} Wanted;

static const Wanted JOINTS = { PLAIN, 'd', 1, { DOF, 0 } };
static const Wanted POSE = { PLAIN, 'd', 2, { 4, 4 } };
static const Wanted NEW_POSE = { PLAIN | WRITABLE, 'd', 2, { 4, 4 } };
static const Wanted NEW_JACOBIAN = { PLAIN | WRITABLE, 'd', 2, { 6, DOF } };
static const Wanted GIVEN = { PLAIN, 'd', 1, { DHGEN_GIVEN, 0 } };
static const Wanted NEW_ROWS = { PLAIN | WRITABLE, 'd', 2, { ROWS, DOF } };
static const Wanted NEW_STATUSES = { PLAIN | WRITABLE, 'B', 1, { ROWS, 0 } };

/* Whether an argument is what is wanted; its memory is then held until it is released. */
static int held(PyObject *argument, const Wanted *wanted, Py_buffer *view)
{
    if (PyObject_GetBuffer(argument, view, wanted->flags) != 0) {
        PyErr_Clear();
        return 0;
    }
    int fits = view->format && view->format[0] == wanted->kind && view->format[1] == 0
        && view->ndim == wanted->axes
        && (wanted->kind == 'B' || (uintptr_t)view->buf % sizeof(double) == 0);
    for (int axis = 0; fits && axis < wanted->axes; axis++)
        fits = view->shape[axis] == wanted->shape[axis];
    if (!fits)
        PyBuffer_Release(view);
    return fits;
}

/* Holds as many arguments as are what is wanted; how many these are. */
static int held_all(
    PyObject *const *arguments, const Wanted *const *wanted, int count, Py_buffer *views)
{
    int holds = 0;
    while (holds < count && held(arguments[holds], wanted[holds], views + holds))
        holds++;
    return holds;
}

static void release(Py_buffer *views, int count)
{
    for (int i = 0; i < count; i++)
        PyBuffer_Release(views + i);
}

/* Calls a method of the owner with the arguments as they came. */
static PyObject *by_python(PyObject *owner, const char *method, PyObject *const *arguments,
    Py_ssize_t count, PyObject *names)
{
    const Py_ssize_t named = names ? PyTuple_Size(names) : 0;
    PyObject *function = PyObject_GetAttrString(owner, method);
    PyObject *tuple = PyTuple_New(count), *dict = PyDict_New(), *result = NULL;
    if (function && tuple && dict) {
        int failed = 0;
        for (Py_ssize_t i = 0; i < count; i++) {
            Py_IncRef(arguments[i]); /* the tuple takes one over */
            failed |= PyTuple_SetItem(tuple, i, arguments[i]);
        }
        for (Py_ssize_t i = 0; i < named; i++)
            failed |= PyDict_SetItem(dict, PyTuple_GetItem(names, i), arguments[count + i]);
        if (!failed)
            result = PyObject_Call(function, tuple, dict);
    }
    Py_DecRef(function);
    Py_DecRef(tuple);
    Py_DecRef(dict);
    return result;
}

/* A robot's function from joint values to numbers, which it fills and returns. */
static PyObject *of_joints(PyObject *owner, const char *method,
    void (*function)(const double *, double *), const Wanted *made, PyObject *const *arguments,
    Py_ssize_t count, PyObject *names)
{
    const Wanted *wanted[2] = { &JOINTS, made };
    Py_buffer views[2];
    const int holds = count == 2 && !names ? held_all(arguments, wanted, 2, views) : 0;
    if (holds == 2)
        function((const double *)views[0].buf, (double *)views[1].buf);
    release(views, holds);
    if (holds != 2)
        return by_python(owner, method, arguments, count, names);
    Py_IncRef(arguments[1]);
    return arguments[1];
}

PyObject *dhgen_native_fk(
    PyObject *owner, PyObject *const *arguments, Py_ssize_t count, PyObject *names);
PyObject *dhgen_native_jacobian(
    PyObject *owner, PyObject *const *arguments, Py_ssize_t count, PyObject *names);
PyObject *dhgen_native_ik_into(
    PyObject *owner, PyObject *const *arguments, Py_ssize_t count, PyObject *names);

/* fk(q, T), which fills and returns T. */
PyObject *dhgen_native_fk(
    PyObject *owner, PyObject *const *arguments, Py_ssize_t count, PyObject *names)
{
    return of_joints(owner, "any_fk", DHGEN_CALL(_fk), &NEW_POSE, arguments, count, names);
}

/* jacobian(q, J), which fills and returns J. */
PyObject *dhgen_native_jacobian(
    PyObject *owner, PyObject *const *arguments, Py_ssize_t count, PyObject *names)
{
    return of_joints(
        owner, "any_jacobian", DHGEN_CALL(_jacobian), &NEW_JACOBIAN, arguments, count, names);
}

static int all_finite(const double *values, int count)
{
    for (int i = 0; i < count; i++)
        if (!isfinite(values[i]))
            return 0;
    return 1;
}

/* ik_into(T, q, status, q_seed=None), with what is given after T; how many rows are solutions. */
PyObject *dhgen_native_ik_into(
    PyObject *owner, PyObject *const *arguments, Py_ssize_t count, PyObject *names)
{
#if DHGEN_GIVEN
    const Wanted *wanted[MOST] = { &POSE, &GIVEN, &NEW_ROWS, &NEW_STATUSES, &JOINTS };
#else
    const Wanted *wanted[MOST] = { &POSE, &NEW_ROWS, &NEW_STATUSES, &JOINTS, &GIVEN };
#endif
    const int least = 3 + GIVES;
    const int seeded = count == least + 1 && arguments[least] != &_Py_NoneStruct;
    Py_buffer views[MOST];
    int holds = 0, ready = 0, solutions = 0;
    if (!names && (count == least || count == least + 1)) {
        holds = held_all(arguments, wanted, least + seeded, views);
        ready = holds == least + seeded;
    }
    if (ready && seeded)
        ready = all_finite((const double *)views[least].buf, DOF);
    if (ready)
        solutions = DHGEN_CALL(_ik)((const double *)views[0].buf,
#if DHGEN_GIVEN
            (const double *)views[1].buf,
#endif
            seeded ? (const double *)views[least].buf : NULL, (double(*)[DOF])views[1 + GIVES].buf,
            (unsigned char *)views[2 + GIVES].buf);
    release(views, holds);
    if (!ready)
        return by_python(owner, "any_into", arguments, count, names);
    return PyLong_FromLong(solutions > 0 ? solutions : 0);
}
