"""The C's own arctangent: within 3 units in the last place, signs of zero kept, NaN handed on."""

from __future__ import annotations

import re
import subprocess

import pytest

from dhgen.runtime import c_runtime_files
from tests.runtime.arctangent import STEEP, arctangent_coefficients
from tests.structures import first_of
from tests.targets.made import folder, made

DRIVER = """
#include "scara.c"
#include <stdio.h>
#if DHGEN_LANES > 1
static double found(double y, double x)
{
    const dhgen_four a = dhgen_atan2_four(dhgen_all_four(y), dhgen_all_four(x));
    const dhgen_wide b = dhgen_atan2_wide(dhgen_all_wide(y), dhgen_all_wide(x));
    return a[1] == b[2] || (a[1] != a[1] && b[2] != b[2]) ? a[3] : 1e9;
}
#else
static double found(double y, double x) { return dhgen_atan2_wide(y, x); }
#endif
int main(void)
{
    long double worst = 0;
    unsigned long long state = 88172645463325252ULL;
    for (int k = 0; k < 400000; k++) {
        double v[2];
        for (int i = 0; i < 2; i++) {
            state ^= state << 13; state ^= state >> 7; state ^= state << 17;
            v[i] = (double)(long long)state * 0x1p-63;
            if (k % 4 == 1) v[i] = ldexp(v[i], (int)(state % 120) - 60);
            if (k % 4 == 2) v[i] = (v[i] < 0 ? -1.0 : 1.0) * (1.0 + 1e-7 * v[i]);
            if (k % 4 == 3 && i) v[1] = v[0] * (0.41421356237309503 + 1e-9 * v[1]);
        }
        const double y = k % 8 < 4 ? v[0] : v[1], x = k % 8 < 4 ? v[1] : v[0];
        const long double exact = atan2l(y, x), miss = fabsl(found(y, x) - exact);
        const double size = fabs((double)exact);
        const long double ulps = miss / (nextafter(size, HUGE_VAL) - size);
        worst = ulps > worst ? ulps : worst;
    }
    const double zero = found(0.0, 1.0), minus = found(-0.0, 1.0);
    const double half = found(0.0, -1.0), back = found(-0.0, -1.0);
    const int signs = zero == 0.0 && !signbit(zero) && minus == 0.0 && signbit(minus)
        && half == atan2(0.0, -1.0) && back == -half
        && found(1.0, 0.0) == atan2(1.0, 0.0) && found(-1.0, -0.0) == atan2(-1.0, -0.0);
    const int nan = isnan(found(NAN, 1.0)) && isnan(found(1.0, NAN)) && isnan(found(NAN, NAN))
        && isnan(found(-0.5, NAN)) && isnan(found(NAN, 0.0));
    printf("%Lf %d %d\\n", worst, signs, nan);
    return 0;
}
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    "flags", first_of(["-O3 -march=native", "-O1", "-O3 -mavx2 -mfma", "-O2 -DSCARA_LIBM"])
)
def test_arctangent(flags: str) -> None:
    made("scara")
    (folder() / "arctangent.c").write_text(DRIVER)
    program = folder() / f"arctangent{flags.replace(' ', '')}"
    fast = ["-fno-math-errno", "-fno-trapping-math", "-ffp-contract=fast"]
    command = ["gcc", "-std=c99", *flags.split(), *fast, "arctangent.c", "-o", str(program), "-lm"]
    subprocess.run(command, check=True, cwd=folder())
    done = subprocess.run([program], check=True, capture_output=True, text=True)
    worst, signs, nan = done.stdout.split()
    assert 0.4 < float(worst) < 3.0
    assert (signs, nan) == ("1", "1")


def test_its_coefficients_are_those_of_all_languages() -> None:
    """They stand in a fixed file; where they come from is written in Python."""
    table = re.search(
        r"dhgen_arctangent\[11\] = \{([^}]*)\}", c_runtime_files()["dhgen/arctangent_series.h"]
    )
    assert table is not None
    assert tuple(map(float, re.findall(r"[-\d.]+", table[1]))) == arctangent_coefficients()
    assert f"most * {STEEP!r};" in c_runtime_files()["dhgen/arctangent.h"]
