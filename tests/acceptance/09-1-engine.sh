#!/usr/bin/env bash
# The engine of planar sums: boundaries against two independent ones, and its speed beside CGAL in the same run
tests=$build/tests/bin
qtest "random and lattice pairs, touching, thin, in parts, with holes: against CGAL's arrangement" "$tests/minkowski_faces_test" BLOSSOM_PLANAR_SUMS=100000
at_least "  pairs" "$(figure minkowski_faces_test sums)" 100000
at_most "  difference of areas, share of size times perimeter" "$(figure minkowski_faces_test area_difference)" 1e-9
at_most "  corners off the other boundary, share of the size" "$(figure minkowski_faces_test boundary_distance)" 1e-9
equal "  pairs with other parts, with other holes" "$(figure minkowski_faces_test other_parts), $(figure minkowski_faces_test other_holes)" "0, 0"
qtest "pairs against two of CGAL's methods" "$tests/minkowski_cgal_test" BLOSSOM_PLANAR_PAIRS=2000
equal "  sums and differences that are wrong" "$(figure minkowski_cgal_test ours_wrong)" 0

"$tests/planar_pairs" | tee "$out/planar-pairs.txt" >/dev/null
sed 's/^/    /' "$out/planar-pairs.txt"
equal "named pairs whose areas differ from CGAL's by more than 1e-9" "$(grep -c AREA "$out/planar-pairs.txt")" 0
at_least "named pairs: geometric mean of the ratios, each 100 at most" "$(awk '/geometric mean/ { print $5 }' "$out/planar-pairs.txt")" 30 times
at_least "  the least" "$(awk '/geometric mean/ { print $8 }' "$out/planar-pairs.txt")" 8 times
at_least "  two threads over one, the least where one needs over 50 ms" "$(grep -oE '[0-9.]+ times one thread' "$out/planar-pairs.txt" | sort -n | head -1 | awk '{ print $1 }')" 1.4 times
