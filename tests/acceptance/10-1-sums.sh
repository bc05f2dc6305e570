#!/usr/bin/env bash
# Sums of solids: their oracles, and their speed beside CGAL in the same run
tests=$build/tests/bin
qtest "prisms: closed forms, turned solids, CGAL" "$tests/morphology_prism_test"
qtest "convex solids: hulls of all sums" "$tests/morphology_convex_test"
qtest "any solids: counted cells, CGAL, complements" "$tests/morphology_arrangement_test"
qtest "solids that touch themselves" "$tests/morphology_touching_test"
qtest "any solids against CGAL::minkowski_sum_3" "$tests/morphology_cgal_test" "BLOSSOM_SOLID_PAIRS=300"
at_least "  pairs" "$(figure morphology_cgal_test cgal_pairs)" 300
at_most "  largest relative difference of volumes" "$(figure morphology_cgal_test cgal_error)" 1e-9
equal "  disagreements in which ours is wrong, or neither is shown to be" "$(figure morphology_cgal_test cgal_disagreements)" 0
qtest "results fed back as operands" "$tests/morphology_results_test" "BLOSSOM_SOLID_RESULTS=1000"
at_least "  results" "$(figure morphology_results_test solid_results)" 1000
equal "  results with faces that cross" "$(figure morphology_results_test solid_results_crossing)" 0
equal "  refused" "$(figure morphology_results_test solid_results_refused)" 0
if [ -f "$data/solids/gear8.off" ]; then
  "$tests/solid_pairs" "$data/solids" | tee "$out/solid-pairs.txt" >/dev/null
  sed 's/^/    /' "$out/solid-pairs.txt"
  times() { grep -F "$1" "$out/solid-pairs.txt" | grep -oE '[0-9.]+ times' | head -1 | awk '{ print $1 }'; }
  ours() { grep -F "$1" "$out/solid-pairs.txt" | grep -oE '[0-9.]+ ms' | head -1 | awk '{ print $1 }'; }
  equal "named pairs whose volumes differ from CGAL's by more than 1e-9" "$(grep -c VOLUME "$out/solid-pairs.txt")" 0
  least_times() { grep -oE "[0-9.]+ times one thread" "$out/solid-pairs.txt" | awk '{ print $1 }' | sort -g | head -1; }
  at_least "two threads, where one needs over 100 ms: times as fast, at least" "$(least_times)" 1.4 times
  at_least "gear8 + channel, times as fast as CGAL" "$(times "gear8 + channel")" 30 times
  at_least "frame + gear8" "$(times "frame + gear8")" 30 times
  at_least "comb6 + channel" "$(times "comb6 + channel")" 10 times
  at_least "gear8 + ico80" "$(times "gear8 + ico80")" 100 times
  at_least "torus256 + ico80" "$(times "torus256 + ico80")" 100 times
  at_most "torus1024 + ico320" "$(ours "torus1024 + ico320")" 2000 ms
  at_most "bumpy1280 + ico80" "$(ours "bumpy1280 + ico80")" 3000 ms
  at_most "ball:5:4 + ball:2:4" "$(ours "ball:5:4 + ball:2:4")" 50 ms
else
  report SKIP "named pairs beside CGAL" "no ../shared/data" ""
fi
