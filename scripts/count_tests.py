"""Adds up JUnit XML reports and prints the plain line `N passed, N failed[, N skipped]`.

Usage: count_tests.py REPORT_OR_FOLDER...   Exit status 1 when a test failed or none ran.
"""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def reports(arguments):
    for argument in map(Path, arguments):
        yield from sorted(argument.rglob("*.xml")) if argument.is_dir() else [argument]


def main():
    passed = failed = skipped = 0
    for report in reports(sys.argv[1:]):
        for case in ElementTree.parse(report).getroot().iter("testcase"):
            if case.find("failure") is not None or case.find("error") is not None:
                failed += 1
                print(f"FAILED {case.get('classname', '')} {case.get('name')}")
            elif case.find("skipped") is not None or case.get("status") in ("disabled", "notrun"):
                skipped += 1
            else:
                passed += 1
    tail = f", {skipped} skipped" if skipped else ""
    print(f"{passed} passed, {failed} failed{tail}")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
