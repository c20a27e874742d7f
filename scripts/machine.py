"""The machine that figures were measured on."""

import os
import platform
from pathlib import Path


def processor():
    """Its processor's name, as the kernel gives it."""
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def name():
    return f"{processor()}, {os.cpu_count()} processors"
