#!/usr/bin/env bash
# minkowski: membership, areas against two of CGAL's methods, table 1, both ends
qtest "x is in A+B exactly when A meets x-B, decided without the sum" "$build/tests/bin/minkowski_membership_test"
membership() { figure minkowski_membership_test "$1"; }
at_least "  random pairs" "$(membership membership_pairs)" 500
at_least "  of them with holes" "$(membership membership_pairs_with_holes)" 125
at_least "  of them with several components" "$(membership membership_pairs_with_several_parts)" 125
at_least "  points a pair" "$(membership membership_points_a_pair)" 1000
at_least "  points within 1e-6 of the boundary" "$(membership membership_near_percent)" 50 %
equal "  points on the wrong side" "$(membership membership_wrong)" 0
equal "  of differences, points on the wrong side" "$(membership difference_wrong)" 0

qtest "areas against CGAL's reduced convolution and vertical decomposition" "$build/tests/bin/minkowski_cgal_test"
cgal() { figure minkowski_cgal_test "$1"; }
at_least "  random pairs" "$(cgal cgal_pairs)" 100
at_most "  largest relative difference of the areas" "$(cgal cgal_worst)" 1e-9
at_least "  pairs in which the reduced convolution gives this area" "$(cgal cgal_reduced_convolution_agrees)" 95
at_least "  pairs in which the vertical decomposition gives this area" "$(cgal cgal_vertical_decomposition_agrees)" 95

qtest "closed forms of sums and differences; a lattice counted" "$build/tests/bin/minkowski_sum_test"
qtest "morphs and their blossoms" "$build/tests/bin/minkowski_morph_test"
qtest "the command line, rubbish and samples" "$build/tests/bin/minkowski_cli_test" BLOSSOM_SHARED_DATA="$data"

# Table 1 of the paper for N in-betweens of degree n; the first and the last of N + 2 frames are no in-betweens.
morph_sums() { # evaluation shapes..
  local evaluation=$1; shift
  "$bin/blossom" morph "$@" --frames 12 --evaluation "$evaluation" --json | json sums
}
stars=(star:3:20:8 star:4:22:7 star:5:24:9 star:6:20:6) round=(star:3:20:8 circle:9 polygon:5:12 star:5:24:9)
for n in 1 2 3; do
  shapes=("${stars[@]:0:n+1}") convex=("${round[@]:0:n}" "${round[3]}") N=10
  equal "table 1, n = $n, N = $N: pure recursion, (2^n - 1) N" "$(morph_sums recursive "${shapes[@]}")" $(((2 ** n - 1) * N))
  equal "table 1, n = $n, N = $N: bottom-up, n (n+1) N / 2" "$(morph_sums bottom-up "${shapes[@]}")" $((n * (n + 1) * N / 2))
  equal "table 1, n = $n, N = $N: explicit, n N + 2^n - n - 1" "$(morph_sums explicit "${shapes[@]}")" $((n * N + 2 ** n - n - 1))
  equal "table 1, n = $n, N = $N: explicit, convex between the ends, n N" "$(morph_sums convex "${convex[@]}")" $((n * N))
done
table=$((4 * 10 + 2 ** 4 - 4 - 1))
at_most "  n = 4: doubling chains need fewer sums than the table" "$(morph_sums explicit "${stars[@]}" star:7:20:6)" $((table - 1))

# The ends are the control shapes themselves.
areas=("$("$bin/blossom" circle --radius 15 -o "$out/shape-0.svg" --json | json area)"
  "$("$bin/blossom" star --points 5 --outer 24 --inner 9 -o "$out/shape-1.svg" --json | json area)")
for t in 0 1; do
  end=$("$bin/blossom" morph circle:15 star:4:9:5 star:5:24:9 --t $t -o "$out/end-$t.svg" --json)
  equal "C($t): area of that control shape" "$(json area <<<"$end")" "${areas[$t]}"
  equal "C($t): its file is that of the shape" "$(cmp "$out/end-$t.svg" "$out/shape-$t.svg" && echo the same)" "the same"
done
for t in 1e-9 0.999999999; do
  near=$("$bin/blossom" morph polygon:7:15 star:4:9:5 star:5:24:9 --t $t --json | json area)
  wanted=$("$bin/blossom" morph polygon:7:15 star:4:9:5 star:5:24:9 --t "$(printf %.0f $t)" --json | json area)
  at_most "C($t) comes to it: relative difference of the areas" "$(awk -v a="$near" -v b="$wanted" 'BEGIN { d = (a - b) / b; print d < 0 ? -d : d }')" 1e-7
done
