# SPDX-License-Identifier: Apache-2.0
"""Shortens the output of a build to what a person wants to see: how far it is and how long it will still take.

    NINJA_STATUS='[%f/%t %e] ' cmake --build build 2>&1 | python3 tools/build_progress.py

On a terminal one line that is written over, elsewhere (a log) a line every 30 seconds. Everything else that the build says,
its errors above all, goes through as it is. The time left is what the steps done so far took, times those that are left:
an estimate that becomes better as it goes. The status of the build is that of the pipe (`set -o pipefail`).
"""
import re
import sys

STEP = re.compile(r"\[(\d+)/(\d+) ([\d.]+)\] ")
QUIET = 30.0  # seconds between two lines of a log


def spell(seconds: float) -> str:
    """A duration as one says it: `40 s`, `3 min 20 s`, `1 h 5 min`."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60} s"
    return f"{whole // 3600} h {whole % 3600 // 60} min"


def progress(done: int, total: int, elapsed: float) -> str:
    left = elapsed / done * (total - done)
    return f"building: {done} of {total} steps, {spell(elapsed)} so far, about {spell(left)} left"


def main(lines, out, terminal: bool) -> None:
    reported = 0.0
    shown = False  # whether a line that is to be written over stands on the terminal
    for line in lines:
        step = STEP.match(line)
        if not step:
            out.write(("\r\x1b[K" if shown else "") + line)
            shown = False
            out.flush()
            continue
        done, total, elapsed = int(step[1]), int(step[2]), float(step[3])
        if done == 0:
            continue
        if terminal:
            out.write("\r\x1b[K" + progress(done, total, elapsed))
            shown = True
        elif elapsed - reported >= QUIET and done < total:
            out.write(progress(done, total, elapsed) + "\n")
            reported = elapsed
        out.flush()
    if shown:
        out.write("\r\x1b[K")
        out.flush()


if __name__ == "__main__":
    main(sys.stdin, sys.stdout, sys.stdout.isatty())
