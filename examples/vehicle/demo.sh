# SPDX-License-Identifier: Apache-2.0
# The car of `./dev demo vehicle`: places the welds of its body, runs it into the wall. demo.sh DECKS RESULTS
set -euo pipefail
decks=$1 results=$2
nugget weld "$decks/points.csv" "$decks/sheets.k" -o "$decks/welded.k" --material nrr=9000,nrs=7000,nrt=7000
nugget run "$decks/run.key" -o "$results"
