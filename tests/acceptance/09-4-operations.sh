#!/usr/bin/env bash
# The paper whole: repetition, hulls, weights, splines of shapes, sectors, sweeps along outlines, solids, high degree
tests=$build/tests/bin
qtest "algebra of sums, counters of the paper's table 1" "$tests/minkowski_algebra_test"
qtest "hulls, repetition and their bound" "$tests/minkowski_hull_test"
qtest "weights" "$tests/minkowski_weights_test"
qtest "splines of shapes, sectors" "$tests/minkowski_spline_test"
qtest "the ladder of de Casteljau" "$tests/minkowski_ladder_test"
qtest "sweeps along outer and hole boundaries" "$tests/minkowski_outline_test"
qtest "solids between outlines: closed, sections, volume" "$tests/minkowski_solid_test"

"$bin/blossom" morph-solid rectangle:40:40 circle:12 --height 30 --tolerance 0.05 -o "$out/adapter.step" -o "$out/adapter.stl" --json \
  >"$out/adapter.json" 2>/dev/null
equal "a square to a circle as STEP: closed in the file" "$("$bin/blossom" info "$out/adapter.step" --json | json closed)" true
equal "  its volume in the STEP and the STL file" \
  "$("$bin/blossom" info "$out/adapter.step" --json | json volume | xargs printf '%.7g') $("$bin/blossom" info "$out/adapter.stl" --json | json volume | xargs printf '%.7g')" \
  "$(json volume <"$out/adapter.json" | xargs printf '%.7g') $(json volume <"$out/adapter.json" | xargs printf '%.7g')"

# High degree, the start of the program included. A star of seven points has fourteen corners.
seconds() { awk '{ print $1 / 1000 }' <<<"$(json total_ms)"; }
six=$("$bin/blossom" morph star:7:20:8 star:7:18:9 star:7:22:7 star:7:19:8 star:7:21:9 star:7:20:7 --frames 12 --json 2>/dev/null | seconds)
at_most "six stars of 14 corners, 12 frames" "$six" 10 s
six=$("$bin/blossom" morph star:14:20:8 star:14:18:9 star:14:22:7 star:14:19:8 star:14:21:9 star:14:20:7 --frames 12 --json 2>/dev/null | seconds)
at_most "six stars of 28 corners, 12 frames" "$six" 60 s
eight=$("$bin/blossom" morph star:7:20:8 star:7:20:8 star:7:20:8 star:7:20:8 star:7:20:8 star:7:20:8 star:7:20:8 star:7:20:8 --frames 12 --json 2>/dev/null | seconds)
at_most "eight equal stars of 14 corners, 12 frames" "$eight" 10 s
eight=$("$bin/blossom" morph star:14:20:8 star:14:20:8 star:14:20:8 star:14:20:8 star:14:20:8 star:14:20:8 star:14:20:8 star:14:20:8 --frames 12 --json 2>/dev/null | seconds)
at_most "eight equal stars of 28 corners, 12 frames" "$eight" 10 s
