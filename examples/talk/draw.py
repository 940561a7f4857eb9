# SPDX-License-Identifier: Apache-2.0
"""Runs the decks of the talk, sets them beside what the talk or a formula says, and draws its figures.

    python3 examples/talk/draw.py NUGGET FOLDER [TOPIC...]

Writes FOLDER/NAME.k, runs them into FOLDER/NAME (finished runs are not repeated), prints each number beside its reference, and draws, where
Python has matplotlib, FOLDER/talk_TOPIC.svg. Exits with 1 where a number is outside its gate. `./dev pictures` does all of it.
"""
import pathlib
import sys

import make

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from writer import run  # noqa: E402


def outside(value, reference, gate):
    """Beyond the gate, a share of the reference; of 1 where that is 0."""
    return abs(value - reference) > gate * (abs(reference) or 1.0) + 1e-12


def results_of(nugget, folder, topic):
    folder.mkdir(parents=True, exist_ok=True)
    if hasattr(topic, "prepare"):
        return topic.prepare(nugget, folder)
    return {name: run(nugget, folder, name, deck) for name, deck in topic.decks().items()}


def main(nugget, folder, names):
    folder, failed = pathlib.Path(folder), 0
    for name, topic in make.topics(names).items():
        results = results_of(nugget, folder, topic)
        print(f"\n{topic.__doc__.splitlines()[0]}\n{'':48}{'run':>12}{'reference':>12}{'gate':>9}")
        for what, value, reference, gate, source in topic.rows(results):
            bad = outside(value, reference, gate)
            failed += bad
            print(f"{what:48}{value:12.6g}{reference:12.6g}{gate:9.2g}  {source}{'  OUTSIDE' if bad else ''}")
        try:
            from figures import save
        except ImportError:
            print("no figure: this Python has no matplotlib")
        else:
            save(topic.draw(results), folder / f"talk_{name}.svg")
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3:]))
