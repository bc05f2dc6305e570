#!/usr/bin/env bash
# Speed, as ratios in one run
BLOSSOM_SHARED_DATA=$data "$root/tests/bench/run" "$build" >"$out/bench.txt" 2>/dev/null
ratio_of() { grep -F "$1" "$out/bench.txt" | tail -1 | sed -E 's/ +asked:.*//' | awk '{ print $NF }'; }
at_least "factored grid with normals against OCCT's D1" "$(ratio_of 'OCCT D1 /')" 50 times
at_least "factored grid with normals against GeomAdaptor_Surface" "$(ratio_of 'GeomAdaptor D1 /')" 10 times
at_most "product of 8x8 cubic spans against the factored grid" "$(ratio_of 'product of 8x8')" 3 times
at_most "opening a STEP file of 1 MB against OCCT's own reader, less 0.1 s" "$(ratio_of 'open STEP')" 1.10 times
