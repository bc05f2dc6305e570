#!/usr/bin/env bash
# Surfaces that cross themselves are told, with place, cause and remedy; those that do not are left alone
tests=$build/tests/bin
qtest "200 crossings and 200 clean shapes of sweep, revolve, loft, taper, pipe" "$tests/modeling_crossing_test"
at_least "  crossings deeper than 1/1000 of the size" "$(figure modeling_crossing_test crossings_drawn)" 200
at_most "  of them missed" "$(figure modeling_crossing_test crossings_missed)" 0
at_least "  clean ones, as near as 1/10,000 of the size" "$(figure modeling_crossing_test clean_drawn)" 200
at_most "  of them flagged" "$(figure modeling_crossing_test clean_flagged)" 2
at_most "  place and parameters off those of the construction" "$(figure modeling_crossing_test crossing_place_off)" 1e-6
qtest "what is refused and what stays" "$tests/modeling_sound_test"
qtest "causes that are told: bends, far parts, corners, weights; double cones, turned rings" "$tests/sweep_warnings_test"

# On the command line: a coil whose layers pass through each other at half its height, and one whose layers do not
coil() { # radius at the outer end of the upper edge
  local rows_r= rows_s= i half
  for i in 0 1 2 3 4 5 6 7 8; do
    half=$(awk -v i="$i" 'BEGIN { h = i * 3.14159265358979323846 / 6; printf "[%.17g, 0, 0, %.17g]", cos(h), sin(h) }')
    rows_r+="${rows_r:+, }[$half, $half]"
    rows_s+="${rows_s:+, }$(awk -v i="$i" -v e="$1" 'BEGIN { a = 10 + i / 6; b = 10 + e * i / 6; printf "[[%.17g, %.17g, %.17g, 1], [%.17g, %.17g, %.17g, 1]]", a, a, a, b, b, b }')"
  done
  local knots='[[0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 8], [0, 0, 1, 1]]'
  printf '{"trajectory": {"degree": 1, "knots": [0, 0, 1, 1], "poles": [[0, 0, 0], [0, 0, 20]]},
 "orientation": {"degree": [1, 1], "knots": %s, "poles": [%s]},
 "scaling": {"degree": [1, 1], "knots": %s, "poles": [%s]},
 "point": [1, 0, 0]}\n' "$knots" "$rows_r" "$knots" "$rows_s"
}
coil -1 >"$out/through.json"
coil 1 >"$out/beside.json"
answer=$("$bin/blossom" sweep "$out/through.json" -o "$out/through.step" --json 2>"$out/crossing.log")
equal "a coil through itself: in the result" "$(json crosses_itself <<<"$answer")" true
at_least "  its depth" "$(json crossing_depth <<<"$answer")" 0.02 mm
equal "  the warning: place, cause, remedy" "$(grep -oE 'crosses itself near \(' <<<"$answer" | head -1), $(grep -oE 'the section at v = 0.5 crosses itself|Even out its scaling' <<<"$answer" | sort -u | wc -l)" "crosses itself near (, 2"
at_most "  no more than its depth: the depth in the warning" "$(grep -oE 'by at least [-+0-9.e]+ mm' <<<"$answer" | head -1 | awk '{ print $4 }')" "$(json crossing_depth <<<"$answer")" mm
at_most "  export deviation" "$(json export_deviation <<<"$answer")" 1e-10 mm
answer=$("$bin/blossom" sweep "$out/beside.json" -o "$out/beside.step" --json 2>>"$out/crossing.log")
equal "a coil beside itself: in the result" "$(json crosses_itself <<<"$answer")" false
equal "  warnings of a crossing" "$(grep -c 'crosses itself near' <<<"$answer")" 0
for sample in cylinder twisted-tube; do
  answer=$("$bin/blossom" sweep "$root/resources/samples/$sample.json" -o "$out/$sample.step" --json 2>>"$out/crossing.log")
  equal "sample $sample: crosses itself" "$(json crosses_itself <<<"$answer")" false
done

# Cost, measured in one run: at most a fifth of the building time or 100 ms, the larger
"$tests/crossing_bench" --benchmark_repetitions=3 --benchmark_report_aggregates_only=true --benchmark_color=false 2>/dev/null |
  awk '$1 ~ /_median$/ { sub(/_median$/, "", $1); print $1, $2 }' >"$out/crossing-cost.txt"
milliseconds() { awk -v name="$1" '$1 == name { print $2 }' "$out/crossing-cost.txt"; }
for kind in Sweep Revolve Loft Taper Pipe; do
  cost=$(milliseconds "BM_Crossing$kind")
  bound=$(awk -v w="$(milliseconds "BM_Whole$kind")" -v c="$cost" 'BEGIN { b = (w - c) / 5; print (b > 100 ? b : 100) }')
  at_most "cost of the test: $kind" "$cost" "$bound" ms
done
