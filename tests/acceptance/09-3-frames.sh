#!/usr/bin/env bash
# In-betweens of morphs one after another: what a pair of shapes has in common is computed once
"$build/tests/bin/morph_frames" | tee "$out/morph-frames.txt" >/dev/null
sed 's/^/    /' "$out/morph-frames.txt"
frame_of() { awk -v name="$1" 'index($0, name) { for (i = 1; i < NF; ++i) if ($i == "ms,") print $(i + 1) }' "$out/morph-frames.txt"; }
sequence_of() { awk -v name="$1" 'index($0, name) { for (i = 1; i < NF; ++i) if ($i == "ms,") print $(i - 1) }' "$out/morph-frames.txt"; }
at_most "a frame of a kept pair with 30,000 crossings" "$(frame_of '30,000 crossings')" 16 ms
at_most "a frame of the paper's figure 7" "$(frame_of 'figure 7')" 16 ms
if [ -n "$(sequence_of 'flower to butterfly')" ]; then
  at_most "200 frames from a flower to a butterfly" "$(sequence_of 'flower to butterfly')" 1000 ms
else
  echo "  skipped: drawings of other people are not there"
fi
