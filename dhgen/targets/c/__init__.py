"""The C target: a header and a C99 source that needs nothing but <math.h>."""
