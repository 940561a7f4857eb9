# SPDX-License-Identifier: Apache-2.0
# The first joint of `./dev demo first_joint`: its three mistakes are what it shows. demo.sh DECKS RESULTS
set -euo pipefail
decks=$1 results=$2
nugget check "$decks/joint.k" -o "$results" || (($? == 1))
echo "joint.k is refused, as it should be: docs/tutorials/first_deck.md mends it"
