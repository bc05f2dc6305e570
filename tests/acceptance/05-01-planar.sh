#!/usr/bin/env bash
# planar sums and morphs: what touches, what is small, room, work that is long
planar() { "$bin/blossom" "$@" --json 2>/dev/null; }
off() { awk -v a="${1:-nan}" -v b="$2" 'BEGIN { d = (a - b) / b; print d < 0 ? -d : d }'; }
cat >"$out/star-hole.svg" <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="12mm" height="12mm" viewBox="-6 -6 12 12"><path fill-rule="evenodd" d="M-6 -6H6V6H-6Z M4 0L0 4L-4 0L0 -4Z"/></svg>
SVG

# 1: a room whose outline and hole touch
equal "1: room for polygon:4:1 where outline and hole touch: area" "$(planar minkowski-difference "$out/star-hole.svg" polygon:4:1 | json area)" 50.0
for r in 0.999 1.001; do
  beside=$(awk -v r=$r 'BEGIN { s = 12 - 2 * r; b = 4 + r - s / 2; print s * s - 2 * (4 + r)^2 + (b > 0 ? 4 * b * b : 0) }')
  at_most "1: a cutter of $r beside it: relative difference of the area" "$(off "$(planar minkowski-difference "$out/star-hole.svg" "polygon:4:$r" | json area)" "$beside")" 1e-4
done

# 2: shapes near and below the tolerance
at_most "2: circle:0.001 + circle:0.001: relative difference of the area" "$(off "$(planar minkowski-sum circle:0.001 circle:0.001 | json area)" 1.2566370614e-5)" 3e-4
equal "2: an explicit tolerance of 0.01 mm for them" "$(planar minkowski-sum circle:0.001 circle:0.001 --tolerance 0.01 | json code)" InvalidParameter
equal "2: the same for squares, which have no curves" "$(planar minkowski-sum rectangle:0.001:0.001 rectangle:0.001:0.001 --tolerance 0.01 | json kind)" region

# 3: room is never overstated
equal "3: rectangle:10:10 - circle:5" "$(planar minkowski-difference rectangle:10:10 circle:5 | json area)" 0.0
for tolerance in 0.1 0.01 0.001; do
  room=$(planar minkowski-difference rectangle:20:16 circle:3 --tolerance $tolerance | json area)
  at_most "3: rectangle:20:16 - circle:3 within $tolerance mm: area" "$room" 140 mm2
  at_least "3:   and hardly less" "$room" "$(awk -v t=$tolerance 'BEGIN { print 140 - 48 * t }')" mm2
done

qtest "1-4: closed forms, lattices, curves of all kinds, cancel, progress" "$build/tests/bin/minkowski_sum_test"
at_most "4: computing time after a sum is cancelled" "$(figure minkowski_sum_test cancel_s)" 0.2 s
qtest "4: ways of a morph and the sums that each takes" "$build/tests/bin/minkowski_morph_test"

# 4: different numbers of a blossom; the named ways stay
equal "4: sums for 15 different blossom numbers, automatically" "$(figure minkowski_morph_test sums_of_15_numbers)" 120
six=(polygon:3:5 star:3:9:3 polygon:3:7 polygon:4:8 polygon:5:9 polygon:3:10)
equal "4: the same for five, on the command line" "$(planar morph "${six[@]}" --blossom 0.1,0.25,0.45,0.7,0.9 | json sums)" 15
equal "4:   and explicitly" "$(planar morph "${six[@]}" --blossom 0.1,0.25,0.45,0.7,0.9 --evaluation explicit | json sums)" 31
stars=(star:3:20:8 star:4:22:7 star:5:24:9)
for way in automatic explicit bottom-up recursive; do
  equal "4: sums for seven frames of three stars, $way" "$(planar morph "${stars[@]}" --frames 7 --evaluation $way | json sums)" $([ $way = bottom-up ] || [ $way = recursive ] && echo 15 || echo 11)
done

# 4: long sums run in the worker; short ones need none
long=(star:400:50:20 star:401:40:10)
equal "4: a short sum where no helper can start" "$(BLOSSOM_WORKER=/nonexistent planar minkowski-sum star:5:20:8 star:6:20:8 | json kind)" region
equal "4: a long sum where no helper can start" "$(BLOSSOM_WORKER=/nonexistent planar minkowski-sum "${long[@]}" | json code)" FileNotFound
"$bin/blossom" minkowski-sum "${long[@]}" --json >/dev/null 2>&1 & pid=$!
sleep 1
started=$(date +%s.%N); kill -TERM $pid; wait $pid
at_most "4: a long sum ends after SIGTERM" "$(awk -v a="$started" -v b="$(date +%s.%N)" 'BEGIN { print b - a }')" 0.5 s

# 4: holes by the thousand
awk 'BEGIN { print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1000mm\" height=\"1000mm\" viewBox=\"0 0 1000 1000\"><path fill-rule=\"evenodd\" d=\"M0 0H1000V1000H0Z"
  for (x = 0; x < 100; x++) for (y = 0; y < 100; y++) printf "M%d %dh4v4h-4z", 10 * x + 3, 10 * y + 3
  print "\"/></svg>" }' >"$out/sieve.svg"
sieve=$(planar minkowski-difference "$out/sieve.svg" rectangle:2:2)
equal "4: a sieve of 10,000 holes - rectangle:2:2: holes" "$(json holes <<<"$sieve")" 10000
at_most "4:   relative difference of the area" "$(off "$(json area <<<"$sieve")" $((998 * 998 - 10000 * 36)))" 1e-12
squares=$(awk 'BEGIN { for (x = 0; x < 26; x++) for (y = 0; y < 26; y++) printf "M%d %dh1v1h-1z", x, y }')
echo "<svg xmlns='http://www.w3.org/2000/svg' width='26mm' height='26mm' viewBox='0 0 26 26'><path fill-rule='nonzero' d='$squares'/></svg>" >"$out/squares.svg"
equal "4: 26 x 26 unit squares and themselves: area" "$(planar minkowski-sum "$out/squares.svg" "$out/squares.svg" | json area)" 2704.0

qtest "against CGAL: 2,000 pairs, sums and differences" "$build/tests/bin/minkowski_cgal_test" BLOSSOM_PLANAR_PAIRS=2000
pairs() { figure minkowski_cgal_test "$1"; }
at_least "  pairs" "$(pairs pairs)" 2000
at_most "  sums: largest relative difference of the areas" "$(pairs sums_worst)" 1e-9
at_most "  differences: largest relative difference of the areas" "$(pairs differences_worst)" 1e-9
equal "  disagreements in which a membership test is against ours" "$(pairs ours_wrong)" 0
report PASS "  disagreements in which it is against CGAL" "$(pairs cgal_wrong)" "told"
