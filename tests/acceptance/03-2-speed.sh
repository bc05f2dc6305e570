#!/usr/bin/env bash
# How fast it comes up, turns, and answers
# Milliseconds from the start of the process to the first frame that shows the sample; the middle one of five starts.
first_frame() {
  for _ in 1 2 3 4 5; do
    with_display timeout 60 "$bin/blossom-workbench" "$root/resources/samples/propeller.json" --size 1280x720 --print-timings --exit 2>/dev/null |
      awk '/first frame with the document/ { print $(NF - 1) }'
  done | sort -n | sed -n 3p
}
at_most "first painted frame of the propeller after the start, in software" "$(first_frame)" 1200 ms
qtest "the view draws 130,000 triangles at 1280x720" "$build/tests/bin/view_speed_test"
at_least "  turning them, in software" "$(figure view_speed_test orbit_fps)" 20 "frames/s"
at_most "  what lies under the mouse is found in" "$(figure view_speed_test hover_ms)" 5 ms
longest=0
for log in "$out"/*_test.log; do
  stall=$(figure "$(basename "$log" .log)" longest_stall_ms)
  longest=$(awk -v a="$longest" -v b="${stall:-0}" 'BEGIN { print (b > a) ? b : a }')
done
at_most "longest time that the window's thread was blocked during any job of the tests" "$longest" 50 ms
