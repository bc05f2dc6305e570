#!/usr/bin/env bash
# Solids: rounded results cross nowhere, results that touch themselves are operands, sums as fast as CGAL's one call
qtest "crossings of meshes against every pair in rational numbers" "$build/tests/bin/geometry_mesh_crossing_test"
qtest "5: dents of 5e-11 stay; results cross nowhere, snapped or refused where rounding makes them" "$build/tests/bin/morphology_rounding_test"
qtest "6: results that touch along edges and in corners as operands; places and names of complaints" "$build/tests/bin/morphology_touching_test"
qtest "7: walls in common planes: counted cells, CGAL, complements" "$build/tests/bin/morphology_arrangement_test"
qtest "solid pairs against CGAL::minkowski_sum_3" "$build/tests/bin/morphology_cgal_test" "BLOSSOM_SOLID_PAIRS=300"
at_least "  pairs" "$(figure morphology_cgal_test cgal_pairs)" 300
at_most "  largest relative difference of volumes" "$(figure morphology_cgal_test cgal_error)" 1e-9
equal "  disagreements in which ours is wrong, or neither is shown to be" "$(figure morphology_cgal_test cgal_disagreements)" 0
for pair in comb6_channel gear8_channel frame_gear8; do
  alone=$(figure morphology_cgal_test ${pair}_cgal)
  if [ -z "$alone" ]; then report SKIP "7: $pair" "no shared data" ""; continue; fi
  at_most "7: ${pair/_/ + }: CGAL's call alone takes $alone s; the sum" "$(figure morphology_cgal_test ${pair}_seconds)" \
    "$(awk -v a="$alone" 'BEGIN { print 1.5 * a + 0.5 }')" s
done
