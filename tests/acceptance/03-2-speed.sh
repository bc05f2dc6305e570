#!/usr/bin/env bash
# How fast it comes up, turns, and answers
# Milliseconds from the start of the process to the first frame that shows the sample; the middle one of five starts.
first_frame() {
  for _ in 1 2 3 4 5; do
    with_display timeout 60 "$bin/blossom-workbench" "$root/resources/samples/propeller.json" --size 1280x720 --print-timings \
      --screenshot "$out/first-frame.png" --exit 2>&1 >/dev/null | awk '/first frame with a shape/ { print $1 }'
  done | sort -n | sed -n 3p
}
at_most "first painted frame of the propeller after the start, in software" "$(first_frame)" 1200 ms
with_display "$build/tests/bin/window/view_bench" >"$out/view_bench.log" 2>&1
at_least "turning $(figure view_bench triangles) triangles at 1280x720, in software" "$(figure view_bench orbit_fps)" 20 "frames/s"
at_most "what lies under the mouse is found in" "$(figure view_bench hover_pick_ms)" 5 ms
# A host that takes the processors away stalls everything: the milliseconds it took are told beside the figure.
stolen() { awk '/^cpu / { print $9 * 10 }' /proc/stat; }
before=$(stolen)
qtest "the window's thread while files are opened, saved, drawn and edited" "$build/tests/bin/stall_test"
echo "      the host took $(($(stolen) - before)) ms away meanwhile"
longest=$(grep -ohE 'figure stall_[a-z0-9_-]+_ms [0-9.]+' "$out/stall_test.log" | grep -v computing | awk '$3 > m { m = $3 } END { print m + 0 }')
at_most "longest time that the window's thread was blocked during any of these jobs" "$longest" 50 ms
