# SPDX-License-Identifier: Apache-2.0
"""Watches a run, stops it when the first weld has failed, and goes on with it.

    python3 first_failure.py MODEL.k FOLDER
"""
import sys

import nugget

model, folder = sys.argv[1:]
told = []


def watch(time, end_time, cycle, energy_ratio, failed_welds):
    told.append((time, energy_ratio))
    print(f"{100.0 * time / end_time:5.1f} %  cycle {cycle}  {failed_welds} welds failed")
    return failed_welds == 0  # False stops


r = nugget.run(model, directory=f"{folder}/run", threads=2, progress=watch)
print(r.summary["message"] or "no weld failed before the end")
if r.termination == "interrupted":
    r = nugget.resume(f"{folder}/run", threads=2)
print(f"{r.termination} termination; failed: {r.welds['id'][r.welds['failed']]}")
nugget.plot({"energy ratio": tuple(zip(*told))}, abscissa="time [s]", points=("energy ratio",),
            ordinate="energy ratio").save(f"{folder}/first_failure.svg")
