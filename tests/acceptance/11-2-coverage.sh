#!/usr/bin/env bash
# The area of a part: cut, out of reach, left on purpose, missed; each measured by a way of its own
qtest "shares of the area, and dots that tell why" "$build/tests/bin/pocket_coverage_test"
at_most "cut + reported beside the part, as a share of it" "$(figure pocket_coverage_test coverage_shares_off)" 1e-4
at_most "cut beside an independent sweep of the moves" "$(figure pocket_coverage_test coverage_cut_off)" 1e-4
