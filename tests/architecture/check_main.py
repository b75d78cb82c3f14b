"""The end of every check here: prints what was found, counts it, and gives the exit code."""
import sys


def end(failures):
    for failure in failures:
        print(failure)
    print(f"0 passed, {len(failures)} failed" if failures else "1 passed, 0 failed")
    sys.exit(1 if failures else 0)
