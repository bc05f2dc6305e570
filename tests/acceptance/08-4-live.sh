#!/usr/bin/env bash
# Live picture of a sweep: what a drag changes, and nothing else, within a frame
tests=$build/tests/bin
qtest "live grids: parts that edits reach, bit for bit; parts they do not, untouched" "$tests/sweep_live_test"
qtest "curvature: sphere, torus, cylinder, catenoid, helicoid, product surface" "$tests/sweep_curvature_test"
at_most "  random motions: curvature off that of the product surface by a share of at most" "$(figure sweep_curvature_test curvature_share)" 1e-8

# Speed, as ratios in one run: a drag inside a span, whose edit reaches 7 x 7 of the 8 x 8 spans
BLOSSOM_SHARED_DATA=$data "$root/tests/bench/run" "$build" >"$out/bench.txt" 2>"$out/bench.log"
ratio_of() { grep -F "$1" "$out/bench.txt" | tail -1 | sed -E 's/ +asked:.*//' | awk '{ print $NF }'; }
at_least "scaling edit to points and normals against GeomAdaptor_Surface" "$(ratio_of '/ live scaling edit')" 120 times
at_least "orientation edit to points and normals against GeomAdaptor_Surface" "$(ratio_of '/ live orientation edit')" 120 times
at_least "trajectory edit, for the record" "$(ratio_of '/ live trajectory edit')" 1 times
