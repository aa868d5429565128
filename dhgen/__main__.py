"""`python -m dhgen`."""

import sys

from dhgen.cli import main

sys.exit(main())
