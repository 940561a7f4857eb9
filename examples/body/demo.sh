# SPDX-License-Identifier: Apache-2.0
# The body of `./dev demo body`: places the welds, finds the modes. demo.sh DECKS RESULTS
set -euo pipefail
decks=$1 results=$2
nugget weld "$decks/points.csv" "$decks/body.k" -o "$decks/welded.k"
nugget modes "$decks/welded.k" -n 12 -o "$results"
